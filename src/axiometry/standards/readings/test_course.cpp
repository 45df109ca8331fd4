// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/readings/test_course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"
#include "axiometry/model/plan.h"

namespace axiometry {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::size_t dense_size(const Series& series) { return 2 * series.target_count() * series.run_count(); }

std::size_t dense_place(const Series& series, const Approach& a) {
  return (static_cast<std::size_t>(a.direction) * series.target_count() + a.target) * series.run_count() + a.run;
}

/// Nothing where a reading has no time or all have the same.
std::optional<TestCourse> measured_course(const Test& test) {
  const Series& series = test.series;
  if (test.times_s.empty()) return std::nullopt;
  AXIOMETRY_CONTRACT(test.times_s.size() == dense_size(series));
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const auto cell = series.cell(i, direction);
      for (std::size_t j = 0; j < cell.size(); ++j) {
        if (std::isnan(cell[j])) continue;
        const double time = test.times_s[dense_place(series, {i, direction, j})];
        if (!std::isfinite(time)) return std::nullopt;
        first = std::min(first, time);
        last = std::max(last, time);
      }
    }
  if (!(last > first) || !std::isfinite(last - first)) return std::nullopt;
  TestCourse course{{}, Duration::s(last - first), series.reading_count() - 1, "the times of the readings"};
  course.share.reserve(test.times_s.size());
  for (const double time : test.times_s) course.share.push_back((time - first) / (last - first));
  return course;
}

/// Whether the cycle tells the order of the readings.
bool tells_order(const Test& test) {
  const TestCycle cycle = test.metadata.conditions.cycle_or_standard();
  const bool both = test.series.has_both_directions();
  return cycle != TestCycle::user_defined && !(cycle == TestCycle::unidirectional && both);
}

std::vector<Approach> sequence_of(const Series& series, TestCycle cycle) {
  Plan plan;
  plan.cycle = cycle;
  plan.targets.assign(series.targets().begin(), series.targets().end());
  plan.runs = series.run_count();
  std::vector<Approach> sequence = approaches(plan);
  if (cycle == TestCycle::unidirectional && series.has(Direction::down))
    for (Approach& a : sequence) a = {series.target_count() - 1 - a.target, Direction::down, a.run};
  const bool up = series.has(Direction::up), down = series.has(Direction::down);
  std::erase_if(sequence, [&](const Approach& a) { return a.direction == Direction::up ? !up : !down; });
  return sequence;
}

}  // namespace

TestCourse course_of(const Test& test) {
  if (auto course = measured_course(test)) return *std::move(course);
  const bool known = tells_order(test);
  const TestCycle cycle = known ? test.metadata.conditions.cycle_or_standard() : TestCycle::standard;
  const auto sequence = sequence_of(test.series, cycle);
  const bool both = test.series.has_both_directions();
  const bool of_runs = !both && cycle == TestCycle::standard;
  const std::string order = of_runs ? "the runs" : fmt::format("the {} cycle", cycle_name(cycle));
  const bool assumed = !of_runs && !test.metadata.conditions.cycle;
  TestCourse course{std::vector<double>(dense_size(test.series), unknown), std::nullopt, sequence.size() - 1,
                    fmt::format("readings equally far apart in the order of {}{}", order,
                                assumed ? ", none being stated"
                                : known ? ""
                                        : ", their own not being known"),
                    known};
  for (std::size_t k = 0; k < sequence.size(); ++k)  // m ≥ 2, so that there are two steps at least
    course.share[dense_place(test.series, sequence[k])] = static_cast<double>(k) / static_cast<double>(course.steps);
  return course;
}

}  // namespace axiometry
