// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Which approach a length belongs to, where a file gives lengths in the order of the program, and whether lengths fit
/// the approaches they are said to belong to. Judged by the geometry alone: from one reading to the next the length
/// must change as the distance from the station does.
namespace axiometry::tracking {

/// A length in the order in which it was taken.
struct OrderedLength {
  double length_difference_mm = 0.0;
  std::size_t segment = 0;
  bool missing = false;  ///< the program stopped there, but no reading was taken
};

/// Every approach of the plan, in the order in which it is driven: line by line, as approaches() has them. Needs sound
/// plans.
std::vector<LengthReading> approaches_of(const TrackingPlan& plan);

/// Lengths in the order of the program, each at its approach; missing ones are left out. Fails when there are more or
/// fewer than the plan has approaches, naming how many were found and expected and, where the lengths tell it, at which
/// reading (counted from 1) the order is lost.
Result<std::vector<LengthReading>> assign_in_order(const TrackingPlan& plan, std::span<const OrderedLength> lengths);

/// Fails when lengths change by another factor than distances do (sign reversed, units, another plan), and when from
/// some reading on they fit the approaches before or after theirs (one reading too few or too many), naming it, be it
/// for a while only (one too few here, one too many there). Line and reading are counted in the order given.
/// `in_program_order`: the readings have no label but their order, so that a single jump by a whole interval of targets
/// is taken for a lost reading and not for a break of the beam.
Result<void> check_order(const TrackingPlan& plan, std::span<const LengthReading> readings, bool in_program_order);

}  // namespace axiometry::tracking
