// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/motion_series.h"
#include "axiometry/model/test.h"

/// What the rows of a straightness or a rotation say beside their readings.
namespace axiometry::formats {

/// The order in which the positions of each run stand in a file that tells no direction.
class MotionRowOrder {
 public:
  void take(std::size_t run, double position_mm);

  /// Tells that all readings are taken as positive approaches, and whether the rows speak against it. Fails where some
  /// runs rise and others fall: these were hardly approached from one side.
  Result<void> put_remark(std::vector<SourceRemark>& remarks) const;

 private:
  struct Course {
    double last_mm = 0.0;
    bool rises = false, falls = false;
  };
  std::map<std::size_t, Course> runs_;
};

/// Positions at which cells were empty and no reading stands, in order.
std::vector<double> positions_without_reading(const std::set<double>& empty_mm,
                                              std::span<const MotionReading> readings);

/// "no reading was taken at 300, 400 mm: …"; at least one.
SourceRemark left_out_positions(std::span<const double> positions_mm);

/// Fails on a key of `# key: value` that is misspelt: "postive: -Y", "Error2: EYX", "machine.nam". Words that change
/// what the readings are have a value of theirs: "Errors: none" is a comment. A known key must not be asked about.
Result<void> check_unknown_motion_key(std::string_view key, std::string_view value);

}  // namespace axiometry::formats
