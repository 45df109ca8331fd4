// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/result_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/text/simulated_note.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"

namespace axiometry::app {
namespace {

bool is_error_name(const std::string& text) {
  const auto names = volumetric::error_names();
  return std::ranges::find(names, text) != names.end();
}

/// Of every file that a result names, as "sha256", "machine_sha256", ….
void add_hashes(const json::Value& value, std::vector<std::string>& hashes) {
  if (value.is(json::Kind::array))
    for (const json::Value& item : value.items()) add_hashes(item, hashes);
  if (!value.is(json::Kind::object)) return;
  for (const auto& [key, member] : value.members())
    if (member.is(json::Kind::text) && key.ends_with("sha256"))
      hashes.push_back(member.text());
    else
      add_hashes(member, hashes);
}

}  // namespace

Result<KeptModel> kept_model(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  return kept_model(GivenFile{file, bytes});
}

Result<KeptModel> kept_model(const GivenFile& file) {
  AXIOMETRY_TRY(const json::Value root, in_file(json::parse(file.bytes), file.name));
  AXIOMETRY_TRY(volumetric::ErrorModel model, in_file(formats::error_model_of(root), file.name));
  KeptModel kept{std::move(model), findings_against(kept_findings(root)), sha256(file.bytes)};
  for (NamedFinding& note : remarks_of_singles(root)) kept.against.push_back(std::move(note));
  add_hashes(root, kept.made_from);
  return kept;
}

bool is_of_singles(const json::Value& result) {
  const json::Value* name = result.is(json::Kind::object) ? result.find("result") : nullptr;
  return name != nullptr && name->is(json::Kind::text) && name->text() == "volumetric-assembled";
}

std::vector<NamedFinding> remarks_of_singles(const json::Value& result) {
  const json::Value* remarks = is_of_singles(result) ? result.find("remarks") : nullptr;
  return remarks != nullptr && remarks->is(json::Kind::array) ? notes_of_remarks(*remarks)
                                                              : std::vector<NamedFinding>();
}

std::vector<NamedFinding> notes_of_remarks(const json::Value& remarks) {
  const auto text_of = [](const json::Value* value) {
    return value != nullptr && value->is(json::Kind::text) ? value->text() : std::string();
  };
  std::vector<std::pair<std::string, std::string>> told;  // names and what is said of them
  for (const json::Value& remark : remarks.items()) {
    const std::string text = text_of(&remark);
    const std::size_t colon = text.find(": ");
    const bool is_named = colon == 3 && is_error_name(text.substr(0, colon));
    const std::string name = is_named ? text.substr(0, colon) : "", words = is_named ? text.substr(colon + 2) : text;
    const auto same = std::ranges::find_if(told, [&](const auto& t) { return is_named && t.second == words; });
    if (words.empty()) continue;
    if (same == told.end())
      told.emplace_back(name, words);
    else
      same->first += ", " + name;
  }
  std::vector<NamedFinding> notes;
  for (const auto& [names, words] : told)
    notes.push_back({"volumetric-singles-remark", false,
                     fmt::format("{} ({}of the errors measured singly, from which this was made)", words,
                                 names.empty() ? "" : names + ", ")});
  return notes;
}

std::vector<NamedFinding> findings_against(std::span<const KeptFinding> of_result) {
  std::vector<NamedFinding> against;
  for (const KeptFinding& finding : of_result) {
    if (finding.id == "volumetric-simulated" || finding.message == formats::simulated_lengths)
      against.push_back(
          {"volumetric-simulated", false, "the result was made from simulated lengths, not from measured ones"});
    if (finding.severity == "serious" && finding.id != "volumetric-unseen-errors")
      against.push_back(
          {finding.id, true, "the result from which this was made should not be used as it is: " + finding.message});
  }
  return against;
}

std::string warning_of(std::span<const NamedFinding> against) {
  std::vector<std::string> names;
  for (const NamedFinding& finding : against)
    if (finding.serious && std::ranges::find(names, finding.id) == names.end()) names.push_back(finding.id);
  const bool simulated = std::ranges::find(against, "volumetric-simulated", &NamedFinding::id) != against.end();
  if (names.empty()) return simulated ? "DO NOT USE AS IT IS: made from simulated lengths, not from measured ones" : "";
  std::string text = "DO NOT USE AS IT IS: serious findings speak against the result this was made from:";
  for (const std::string& name : names) text += (name == names.front() ? " " : ", ") + name;
  return text;
}

void put_first(std::span<const NamedFinding> against, std::vector<NamedFinding>& findings) {
  findings.insert(findings.begin(), against.begin(), against.end());
}

Result<std::size_t> tool_of_model(const volumetric::ErrorModel& model, std::string_view name) {
  const auto& tools = model.machine().tools;
  if (name.empty() && tools.size() == 1) return std::size_t{0};
  if (const auto tool = model.machine().tool_named(name)) return *tool;
  std::string known;
  for (const volumetric::Tool& t : tools) known += (known.empty() ? "" : ", ") + t.name;
  return fail(name.empty() ? fmt::format("found no tool, expected one of {}", known)
                           : fmt::format("found the tool {}, expected one of {}", text::quoted(name), known));
}

}  // namespace axiometry::app
