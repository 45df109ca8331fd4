// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/store/records.h"

/// The latest tests of machines and axes, by which the overview says what is to be looked at. Those that are withdrawn
/// do not count.
namespace axiometry::store {

class Connection;

/// A test counts by the day of measurement or, where that is not known, of arrival; of several on a day the one that
/// arrived last is the latest.
struct LatestTest {
  Id test = 0;
  std::string measured_on;  ///< empty: not known
  std::string received_at;
  std::string verdict;

  std::string day() const { return measured_on.empty() ? received_at.substr(0, 10) : measured_on; }
};

struct MachineTests {
  Id machine = 0;
  std::int64_t total = 0;  ///< never 0
  LatestTest latest;
};

struct AxisLatest {
  Id machine = 0;
  Id axis = 0;
  LatestTest latest;
};

/// Of all machines that have tests, by id, or of one.
Result<std::vector<MachineTests>> find_machine_tests(Connection& connection, std::optional<Id> machine);

/// Of all axes that have tests, by machine and id, or of those of one machine.
Result<std::vector<AxisLatest>> find_axes_latest(Connection& connection, std::optional<Id> machine);

}  // namespace axiometry::store
