// SPDX-License-Identifier: Apache-2.0
#include "archive_proof.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "axiometry/app/output.h"
#include "axiometry/app/seal_key.h"
#include "axiometry/app/whole_file.h"
#include "axiometry/base/json.h"
#include "axiometry/report/utf8.h"

namespace axiometry::cli {
namespace {

using report::printable;

Result<store::Seal> seal_in(const std::string& file) {
  AXIOMETRY_TRY(const std::string text, app::whole_file(file));
  return app::in_file(store::read_seal(text), file);
}

Result<std::vector<store::Seal>> seals_of(const ProofFlags& flags) {
  std::vector<store::Seal> seals;
  for (const std::string& file : flags.seals) {
    AXIOMETRY_TRY(store::Seal seal, seal_in(file));
    if (!flags.public_key.empty() && seal.public_key != flags.public_key)
      return std::unexpected(Error{
          fmt::format("found a seal of the key {}, expected one of {}", seal.public_key, flags.public_key), file, {}});
    seals.push_back(std::move(seal));
  }
  return seals;
}

/// A seal proves as much as is known of who made it.
std::vector<std::string> unproved(const store::Verification& found, const std::vector<store::Seal>& seals,
                                  const ProofFlags& flags) {
  std::vector<std::string> sentences = found.unproved;
  if (flags.public_key.empty())
    for (const store::Seal& seal : seals)
      sentences.push_back(
          fmt::format("who made the seal of {}: its key is {}, to be compared with one that was noted "
                      "elsewhere (--public-key)",
                      seal.at, seal.public_key));
  return sentences;
}

json::Value array_of(const std::vector<std::string>& texts) {
  json::Value array = json::Value::array();
  for (const std::string& text : texts) array.push(text);
  return array;
}

json::Value json_of(const store::Verification& found, const std::string& location,
                    const std::vector<std::string>& not_proved) {
  const auto number = [](std::int64_t value) { return json::Value(static_cast<double>(value)); };
  json::Value root = json::Value::object();
  root.add("location", location);
  root.add("contents", number(found.contents));
  root.add("tests", number(found.tests));
  root.add("entries", number(found.entries));
  root.add("schema_parts", number(found.parts));
  json::Value& head = root.add("head", json::Value::object());
  head.add("entry", number(found.head.entries));
  head.add("sha256", found.head.sha256);
  head.add("at", found.head.at);
  root.add("problems", array_of(found.problems));
  root.add("notes", array_of(found.notes));
  root.add("proved", array_of(found.proved));
  root.add("not_proved", array_of(not_proved));
  return root;
}

void print(const store::Verification& found, const std::string& location, const std::vector<std::string>& not_proved) {
  for (const std::string& problem : found.problems) fmt::print("{}\n", printable(problem));
  for (const std::string& note : found.notes) fmt::print("noted: {}\n", printable(note));
  for (const std::string& sentence : found.proved) fmt::print("proved: {}\n", printable(sentence));
  for (const std::string& sentence : not_proved) fmt::print("not proved: {}\n", printable(sentence));
  if (found.head.entries > 0) fmt::print("head: entry {}, {}\n", found.head.entries, found.head.sha256);
  fmt::print("{}: contents {}, tests {}, lines of audit trail {}: {}\n", printable(location), found.contents,
             found.tests, found.entries,
             found.problems.empty() ? "all that is there is as it was written"
                                    : fmt::format("{} problems", found.problems.size()));
}

}  // namespace

Result<int> verify_archive(const store::Store& archive, const ProofFlags& flags) {
  AXIOMETRY_TRY(const std::vector<store::Seal> seals, seals_of(flags));
  AXIOMETRY_TRY(const store::Verification found, archive.verify(seals));
  const std::vector<std::string> not_proved = unproved(found, seals, flags);
  const std::string location = archive.info().location;
  if (flags.json)
    fmt::print("{}\n", json::dump(json_of(found, location, not_proved)));
  else
    print(found, location, not_proved);
  return found.problems.empty() ? exit_done : exit_exceeded;
}

Result<int> seal_archive(const store::Store& archive, const SealFlags& flags) {
  std::optional<store::Seal> earlier;
  std::error_code ignored;
  if (std::filesystem::exists(flags.file, ignored)) {
    AXIOMETRY_TRY(earlier, seal_in(flags.file));
  }
  std::string key_file = flags.key;
  if (key_file.empty()) {
    AXIOMETRY_TRY(key_file, app::default_key_file(archive.info()));
  }
  AXIOMETRY_TRY(const SigningKey key, app::key_in(key_file));
  AXIOMETRY_TRY(const store::Seal seal, archive.seal(key, earlier));
  AXIOMETRY_TRY_VOID(app::write_file(flags.file, store::text_of(seal)));
  fmt::print(
      "{}: entry {}, {}{}\nkey: {} ({})\n", printable(flags.file), seal.head.entries, seal.head.sha256,
      earlier ? fmt::format(", {} after the seal of {}", seal.head.entries - earlier->head.entries, earlier->at) : "",
      seal.public_key, printable(key_file));
  return exit_done;
}

}  // namespace axiometry::cli
