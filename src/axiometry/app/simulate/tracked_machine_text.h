// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/simulation/tracked_machine.h"

/// The errors of a simulated machine and of its tracking interferometer as people write them: "--scale y=100um/m",
/// "--squareness C0Y=20urad".
namespace axiometry::app {

struct TrackedTruth {
  simulation::TrackedMachine machine;
  simulation::VirtualTracker tracker;
};

/// One option: its values, its help, and what it does.
struct TrackedOption {
  std::string_view name;    ///< "--scale"
  std::string_view values;  ///< "AXIS=ERROR"
  std::string_view help;
  std::string_view group;

  /// Puts one value into the truth, beside what others said. Fails on a text that is not of the form of `values`.
  Result<void> (*apply)(std::string_view text, TrackedTruth& truth);
};

std::span<const TrackedOption> tracked_options();

/// "100um/m", "100ppm", "0.01%" or a bare number: 1e-4.
Result<RelativeLength> parse_relative(std::string_view text);
/// "x", "Y": 0 to 2.
Result<std::size_t> parse_axis(std::string_view text);

}  // namespace axiometry::app
