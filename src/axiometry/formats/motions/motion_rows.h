// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/motion_series.h"
#include "axiometry/model/test.h"

/// What the rows of a straightness or a rotation say beside their readings.
namespace axiometry::formats {

/// A run in one direction.
using MotionRun = std::pair<std::size_t, Direction>;

/// The order in which the positions of each run stand in a file.
class MotionRowOrder {
 public:
  void take(const MotionRun& run, double position_mm);

  /// With a column of directions: tells where rows of runs, ↑ and ↓, go the other way than it says; a table
  /// that is sorted by positions says nothing. Without one: tells that all readings are taken as positive approaches,
  /// and whether the rows speak against it. Fails where some runs rise and others fall: these were hardly approached
  /// from one side.
  Result<void> put_remark(bool has_directions, std::vector<SourceRemark>& remarks) const;

 private:
  struct Course {
    double last_mm = 0.0;
    bool rises = false, falls = false;
  };
  std::map<MotionRun, Course> runs_;
};

/// Runs of which all cells were empty, in order.
std::vector<MotionRun> runs_without_reading(const std::set<MotionRun>& empty, std::span<const MotionReading> readings);

/// "found rows without any reading of the runs 1 ↓, 3 ↑: …"; at least one.
SourceRemark left_out_runs(std::span<const MotionRun> runs);

/// Positions at which cells were empty and no reading stands, in order.
std::vector<double> positions_without_reading(const std::set<double>& empty_mm,
                                              std::span<const MotionReading> readings);

/// "no reading was taken at 300, 400 mm: …"; at least one.
SourceRemark left_out_positions(std::span<const double> positions_mm);

/// Fails on a key of `# key: value` that is misspelt: "postive: -Y", "Error2: EYX", "machine.nam". Words that change
/// what the readings are have a value of theirs: "Errors: none" is a comment. A known key must not be asked about.
Result<void> check_unknown_motion_key(std::string_view key, std::string_view value);

}  // namespace axiometry::formats
