// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/devices/renishaw_rtl_runs.h"

#include <fmt/format.h>

#include <algorithm>

namespace axiometry::formats {
namespace {

enum class Order { unknown, along, against, mixed };  ///< of the target numbers within a run, as they were measured

struct Runs {
  std::vector<Order> orders;        ///< order of each run
  std::vector<bool> all_zero;       ///< whether all readings of a run are zero
  std::vector<TextPosition> first;  ///< where each run begins
};

Runs runs_of(std::span<const RtlReading> rows) {
  const std::size_t count = rtl_run_count(rows);
  Runs runs{std::vector<Order>(count), std::vector<bool>(count, true), std::vector<TextPosition>(count)};
  std::vector<std::size_t> last(count);
  for (const RtlReading& row : rows) {
    const std::size_t k = row.run - 1;
    if (last[k] == 0) runs.first[k] = row.at;
    const Order step = row.target > last[k] ? Order::along : Order::against;
    if (last[k] != 0 && row.target != last[k])
      runs.orders[k] = runs.orders[k] == Order::unknown || runs.orders[k] == step ? step : Order::mixed;
    last[k] = row.target;
    if (row.value != 0.0) runs.all_zero[k] = false;
  }
  return runs;
}

}  // namespace

std::size_t rtl_run_count(std::span<const RtlReading> rows) {
  std::size_t runs = 0;
  for (const RtlReading& row : rows) runs = std::max(runs, row.run);
  return runs;
}

Result<RtlRunRule> rtl_run_rule(std::span<const RtlReading> rows, std::optional<bool> unidirectional) {
  const Runs runs = runs_of(rows);
  const std::size_t count = runs.orders.size();
  const bool one_way_file = unidirectional == true;
  const bool two_way_file = unidirectional == false;
  RtlRunRule rule{.absent = std::vector<bool>(count)};
  std::size_t even = 0;
  std::size_t even_along = 0;
  std::size_t even_zero = 0;
  std::size_t odd_zero = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (runs.first[k].line == 0) continue;
    if (k % 2 == 0) {
      odd_zero += runs.all_zero[k];
      continue;
    }
    ++even;
    even_along += runs.orders[k] == Order::along;
    even_zero += runs.all_zero[k];
  }
  if (one_way_file && even > 0 && even_zero == even) {
    for (std::size_t k = 1; k < count; k += 2) rule.absent[k] = true;
    rule.remarks.push_back(
        {false, "found return runs of zeros alone in a unidirectional file; they were taken as not measured"});
    even_along = 0;
  } else if (odd_zero > 0) {
    rule.remarks.push_back({false, "found runs whose readings are all zero; they were taken as measured"});
  } else if (even_zero > 0) {
    rule.remarks.push_back({false, "found return runs whose readings are all zero; they were taken as measured"});
  }
  const bool all_even_along = even > 0 && even_along == even;
  rule.one_way = all_even_along && one_way_file;
  for (std::size_t k = 0; k < count; ++k) {
    const bool returns = !rule.one_way && k % 2 == 1;
    const Order expected = returns ? Order::against : Order::along;
    const Order found = runs.orders[k];
    if (rule.absent[k] || found == Order::unknown || found == expected) continue;
    const bool sorted_by_target = returns && all_even_along && two_way_file;
    if (sorted_by_target || (found == Order::mixed && two_way_file)) continue;
    return fail(
        fmt::format("found run {} with its targets listed {}, expected {} ones to go {} the list of targets", k + 1,
                    found == Order::mixed   ? "to and fro"
                    : found == Order::along ? "along"
                                            : "backwards",
                    k % 2 == 1 ? "even" : "odd", returns ? "back along" : "along"),
        runs.first[k]);
  }
  if (all_even_along && !rule.one_way)
    rule.remarks.push_back({false,
                            "found the readings of even runs in the order of the targets; they were taken as return "
                            "runs, because the flags say that the test is bidirectional"});
  if (one_way_file && even > 0 && even_zero < even && !rule.one_way)
    rule.remarks.push_back(
        {false,
         "found flags of a unidirectional test, but even runs that go back along the list of targets; "
         "they were taken as return runs"});
  if (std::ranges::find(runs.orders, Order::mixed) != runs.orders.end())
    rule.remarks.push_back({false, "found runs whose readings stand in no order; they were placed by their targets"});
  return rule;
}

}  // namespace axiometry::formats
