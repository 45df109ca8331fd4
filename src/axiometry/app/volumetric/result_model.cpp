// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/result_model.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/json.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"

namespace axiometry::app {

Result<KeptModel> kept_model(const std::string& file) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(file));
  AXIOMETRY_TRY(const json::Value root, in_file(json::parse(bytes), file));
  AXIOMETRY_TRY(volumetric::ErrorModel model, in_file(formats::error_model_of(root), file));
  return KeptModel{std::move(model), findings_against(kept_findings(root))};
}

std::vector<NamedFinding> findings_against(std::span<const KeptFinding> of_result) {
  std::vector<NamedFinding> against;
  for (const KeptFinding& finding : of_result)
    if (finding.severity == "serious" && finding.id != "volumetric-unseen-errors")
      against.push_back(
          {finding.id, true, "the result from which this was made should not be used as it is: " + finding.message});
  return against;
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
