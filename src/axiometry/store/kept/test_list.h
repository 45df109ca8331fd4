// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/store/kept/test_versions.h"

/// Lists of tests and histories of axes. They are read from narrow rows that follow from the latest versions.
namespace axiometry::store {

/// Puts a new test into the lists; or brings its rows there into line with its latest version.
Result<void> list_test(Connection& connection, const TestHead& head, const TestVersion& latest);
Result<void> relist_test(Connection& connection, const TestHead& head, const TestVersion& latest);

/// As list_test() would write them; the words that are searched come last.
std::vector<Cell> list_cells(const TestHead& head, const TestVersion& latest, const std::string& machine_name,
                             const std::string& axis_name, const std::string& axis_kind);

/// The same cells as they stand in the lists, by test, from `first` to `last`.
Result<Rows> listed(Connection& connection, Id first, Id last);

Result<void> rename_machine_in_lists(Connection& connection, Id machine, const std::string& name);
Result<void> rename_axis_in_lists(Connection& connection, Id axis, const AxisRecord& now);

/// As store.h's tests() and trend(), within a transaction.
Result<TestPage> find_tests(Connection& connection, const TestFilter& filter);
Result<std::vector<TrendPoint>> find_trend(Connection& connection, Id axis, std::span<const std::string> parameters,
                                           std::int64_t limit);

}  // namespace axiometry::store
