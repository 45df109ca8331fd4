// SPDX-License-Identifier: Apache-2.0
#include "cli/archive_proof.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/seal_key.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/json/json.h"
#include "axiometry/report/drawing/utf8.h"
#include "cli/failure.h"
#include "cli/seal_stamp.h"

namespace axiometry::cli {
namespace {

using report::printable;

struct ReadSeal {
  SealFile file;
  store::Seal seal;
};

Result<ReadSeal> seal_in(const std::string& file) {
  AXIOMETRY_TRY(std::string bytes, app::whole_file(file));
  AXIOMETRY_TRY(store::Seal seal, app::in_file(store::read_seal(bytes), file));
  return ReadSeal{{file, std::move(bytes)}, std::move(seal)};
}

Result<std::vector<ReadSeal>> seals_of(const ProofFlags& flags) {
  std::vector<ReadSeal> seals;
  for (const std::string& file : flags.seals) {
    AXIOMETRY_TRY(ReadSeal read, seal_in(file));
    if (!flags.public_key.empty() && read.seal.public_key != flags.public_key)
      return std::unexpected(
          Error{fmt::format("found a seal of the key {}, expected one of {}", read.seal.public_key, flags.public_key),
                file,
                {}});
    seals.push_back(std::move(read));
  }
  return seals;
}

std::vector<store::Seal> without_files(const std::vector<ReadSeal>& read) {
  std::vector<store::Seal> seals;
  for (const ReadSeal& each : read) seals.push_back(each.seal);
  return seals;
}

/// Sentences of the moment at which seals were there.
struct Moments {
  std::vector<std::string> proved{};
  std::vector<std::string> unproved{};
  std::vector<std::string> notes{};
};

Result<Moments> moments_of(const std::vector<ReadSeal>& seals, const ProofFlags& flags) {
  Moments moments;
  for (const auto& [file, seal] : seals) {
    if (!flags.authority.empty()) {
      AXIOMETRY_TRY(const FoundStamp found, stamp_of(file, flags.authority));
      moments.proved.push_back(
          fmt::format("the seal of {} was there at {}, says {}", seal.at, found.stamp.at, found.stamp.authority));
      if (found.file != stamp_name(file.name))
        moments.notes.push_back(
            fmt::format("{}: found the time stamp of the seal of {} here, expected it in {}: its writing was "
                        "interrupted, and the next seal in its place puts it right",
                        found.file, seal.at, stamp_name(file.name)));
    } else if (has_stamp(file)) {
      moments.unproved.push_back(
          fmt::format("when the seal of {} was there: a time stamp lies beside it, whose authority's certificate is to "
                      "be named (--authority)",
                      seal.at));
    }
  }
  return moments;
}

/// A seal proves as much as is known of who made it.
std::vector<std::string> unproved(const store::Verification& found, const std::vector<store::Seal>& seals,
                                  const Moments& moments, const ProofFlags& flags) {
  std::vector<std::string> sentences = found.unproved;
  sentences.insert(sentences.end(), moments.unproved.begin(), moments.unproved.end());
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
  root.add("extras", array_of(found.extras));
  root.add("proved", array_of(found.proved));
  root.add("not_proved", array_of(not_proved));
  return root;
}

std::string conclusion_of(const store::Verification& found) {
  if (!found.problems.empty()) return counted(found.problems.size(), "problem");
  return found.last_change_is_lost ? "all but the last change is as it was written"
                                   : "all that is there is as it was written";
}

void print(const store::Verification& found, const std::string& location, const std::vector<std::string>& not_proved) {
  const auto say = [](std::string_view what, const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) fmt::print("{}\n", in_language_asked(what, sentence));
  };
  for (const std::string& problem : found.problems) fmt::print("{}\n", in_language_asked(problem));
  say("noted: ", found.notes);
  say("noted: ", found.extras);
  say("proved: ", found.proved);
  say("not proved: ", not_proved);
  if (found.head.entries > 0)
    fmt::print("{}\n", in_language_asked(fmt::format("head: entry {}, {}", found.head.entries, found.head.sha256)));
  fmt::print("{}: {}\n", printable(location),
             in_language_asked(fmt::format("contents {}, tests {}, lines of audit trail {}: {}", found.contents,
                                           found.tests, found.entries, conclusion_of(found))));
}

/// A seal with a stamp beside it is replaced by none without: the stamp would be another's.
Result<std::optional<std::string>> stamp_for(const SealFlags& flags, const SealFile& earlier, const std::string& seal) {
  if (flags.authority.empty() && has_stamp(earlier))
    return std::unexpected(
        Error{"found the time stamp of the seal that is there, expected --time-stamp for the new one "
              "too, or another name for it",
              stamp_name(flags.file),
              {}});
  if (flags.authority.empty()) return std::optional<std::string>();
  AXIOMETRY_TRY(std::string stamp, asked_stamp(flags.authority, seal));
  return std::optional(std::move(stamp));
}

}  // namespace

Result<int> verify_archive(const store::Store& archive, const ProofFlags& flags) {
  AXIOMETRY_TRY(const std::vector<ReadSeal> read, seals_of(flags));
  const std::vector<store::Seal> seals = without_files(read);
  std::vector<store::Head> heads;
  for (const std::string& text : flags.heads) {
    AXIOMETRY_TRY(heads.emplace_back(), store::read_short_head(text));
  }
  AXIOMETRY_TRY(const Moments moments, moments_of(read, flags));
  AXIOMETRY_TRY(store::Verification found, archive.verify(seals, heads));
  found.proved.insert(found.proved.end(), moments.proved.begin(), moments.proved.end());
  found.notes.insert(found.notes.end(), moments.notes.begin(), moments.notes.end());
  const std::vector<std::string> not_proved = unproved(found, seals, moments, flags);
  const std::string location = archive.info().location;
  if (flags.json)
    fmt::print("{}\n", json::dump(json_of(found, location, not_proved)));
  else
    print(found, location, not_proved);
  return found.problems.empty() ? exit_done : exit_exceeded;
}

Result<int> seal_archive(const store::Store& archive, const SealFlags& flags) {
  std::optional<store::Seal> earlier;
  SealFile there{flags.file, ""};
  std::error_code ignored;
  if (std::filesystem::exists(flags.file, ignored)) {
    AXIOMETRY_TRY(ReadSeal read, seal_in(flags.file));
    earlier = std::move(read.seal);
    there = std::move(read.file);
  }
  AXIOMETRY_TRY_VOID(settle_stamp(flags.file));
  std::string key_file = flags.key;
  if (key_file.empty()) {
    AXIOMETRY_TRY(key_file, app::default_key_file(archive.info()));
  }
  // Where a seal is to be followed its key must be there: a new one could never be the same.
  const bool goes_on = earlier && !flags.change_key;
  AXIOMETRY_TRY(const SigningKey key, goes_on ? app::read_key(key_file) : app::key_in(key_file));
  AXIOMETRY_TRY(const store::Seal seal, archive.seal(key, {earlier, flags.change_key}));
  AXIOMETRY_TRY(const auto stamp, stamp_for(flags, there, store::text_of(seal)));
  if (stamp)
    AXIOMETRY_TRY_VOID(write_stamped(flags.file, {store::text_of(seal), *stamp}));
  else
    AXIOMETRY_TRY_VOID(app::write_file(flags.file, store::text_of(seal)));
  fmt::print(
      "{}: entry {}, {}{}\nkey: {} ({})\n", printable(flags.file), seal.head.entries, seal.head.sha256,
      earlier ? fmt::format(", {} after the seal of {}", seal.head.entries - earlier->head.entries, earlier->at) : "",
      seal.public_key, printable(key_file));
  if (stamp) fmt::print("time stamp: {}\n", printable(stamp_name(flags.file)));
  return exit_done;
}

}  // namespace axiometry::cli
