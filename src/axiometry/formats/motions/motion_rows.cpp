// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/motions/motion_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t named_most = 6;  // the others are counted

/// Metadata keys have a group: "machine.nam" is meant as one of them, "v1.2" is not.
bool begins_like_a_field(std::string_view key) {
  const std::size_t dot = key.find('.');
  return dot != std::string_view::npos && std::ranges::any_of(metadata_fields(), [&](const Field& field) {
           return text::equal_ignoring_case(field.key.substr(0, dot + 1), key.substr(0, dot + 1));
         });
}

/// Of the two words that change what the readings are, by its letters, where the value is one that it may have: beside
/// any other it is a comment, as "Error 1: spike at 300 mm" is.
std::optional<std::string_view> word_meant(std::string_view key, std::string_view value) {
  std::string letters = text::to_lower(key);
  std::erase_if(letters, [](char c) { return c < 'a' || c > 'z'; });
  const auto near = text::nearest(letters, {"error", "positive", "position", "mirror"});
  const bool meant = (near == "error" && motion_name(value)) || (near == "positive" && reading_sense(value));
  return meant ? near : std::nullopt;
}

/// "1 ↑, 3 ↓".
std::string run_names(std::span<const MotionRun> runs) {
  std::string names;
  for (const auto& [run, direction] : runs.first(std::min(runs.size(), named_most)))
    names += fmt::format("{}{} {}", names.empty() ? "" : ", ", run, arrow(direction));
  return runs.size() > named_most ? names + ", …" : names;
}

}  // namespace

void MotionRowOrder::take(const MotionRun& run, double position_mm) {
  const auto [at, is_first] = runs_.try_emplace(run, Course{.last_mm = position_mm});
  Course& course = at->second;
  if (is_first) return;
  course.rises |= position_mm > course.last_mm;
  course.falls |= position_mm < course.last_mm;
  course.last_mm = position_mm;
}

Result<void> MotionRowOrder::put_remark(bool has_directions, std::vector<SourceRemark>& remarks) const {
  if (has_directions) {
    std::vector<MotionRun> with, against;
    bool both = false;
    for (const auto& [run, course] : runs_) {
      both = both || run.second != runs_.begin()->first.second;
      if (course.rises == course.falls) continue;
      (course.falls == (run.second == Direction::up) ? against : with).push_back(run);
    }
    const auto is_of = [](Direction direction) {
      return [=](const MotionRun& run) { return run.second == direction; };
    };
    // A table that is sorted by positions says nothing of one direction.
    const bool is_sorted =
        std::ranges::none_of(against, is_of(Direction::up)) || std::ranges::none_of(against, is_of(Direction::down));
    if (both && !against.empty() && !is_sorted)
      remarks.push_back({false, with.empty()
                                    ? "the rows of all runs go the other way than their directions say: the sign "
                                      "of the reversal depends on which of them is right"
                                    : fmt::format("the rows of the runs {} go the other way than their "
                                                  "directions say, those of others do not: the reversal and "
                                                  "the repeatability may mix both directions",
                                                  run_names(against))});
    return {};
  }
  const auto rising = std::ranges::find_if(runs_, [](const auto& r) { return r.second.rises && !r.second.falls; });
  const auto falling = std::ranges::find_if(runs_, [](const auto& r) { return r.second.falls && !r.second.rises; });
  if (rising != runs_.end() && falling != runs_.end())
    return fail(
        fmt::format("found rising positions in run {} and falling ones in run {} and no column direction, "
                    "expected one: it tells from which side each was approached",
                    rising->first.first, falling->first.first));
  remarks.push_back({false, falling == runs_.end()
                                ? "no column direction: all readings are taken as positive approaches"
                                : "no column direction, and the positions fall from row to row: all readings are taken "
                                  "as positive approaches all the same"});
  return {};
}

std::vector<double> positions_without_reading(const std::set<double>& empty_mm,
                                              std::span<const MotionReading> readings) {
  std::set<double> left = empty_mm;
  for (const MotionReading& r : readings) left.erase(r.position_mm);
  return {left.begin(), left.end()};
}

std::vector<MotionRun> runs_without_reading(const std::set<MotionRun>& empty, std::span<const MotionReading> readings) {
  std::set<MotionRun> left = empty;
  for (const MotionReading& r : readings) left.erase({r.run, r.direction});
  return {left.begin(), left.end()};
}

SourceRemark left_out_runs(std::span<const MotionRun> runs) {
  return {false,
          fmt::format("found rows without any reading of the runs {}: these count as not driven", run_names(runs))};
}

SourceRemark left_out_positions(std::span<const double> positions_mm) {
  std::string places;
  for (const double mm : positions_mm.first(std::min(positions_mm.size(), named_most)))
    places += fmt::format("{}{}", places.empty() ? "" : ", ", format_exact(mm));
  if (positions_mm.size() > named_most) places += ", …";
  return {false, fmt::format("no reading was taken at {} mm: the figures are those of the other positions", places)};
}

Result<void> check_unknown_motion_key(std::string_view key, std::string_view value) {
  if (const auto word = word_meant(key, value))
    return fail(fmt::format("found the unknown key {}, expected perhaps {}", text::quoted(key), *word));
  if (!begins_like_a_field(key)) return {};
  Metadata none;
  return set_field_text(none, key, "");
}

}  // namespace axiometry::formats
