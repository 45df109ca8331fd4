// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/order_by_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/model/plan.h"
#include "axiometry/standards/iso230_2/programme.h"
#include "axiometry/standards/iso230_2/rules/message.h"

namespace axiometry::iso230_2 {
namespace {

double time_of(const Test& test, const Approach& a) {
  const Series& series = test.series;
  return test
      .times_s[(static_cast<std::size_t>(a.direction) * series.target_count() + a.target) * series.run_count() + a.run];
}

/// The readings whose times are known, in the order of a cycle.
std::vector<Approach> timed_in_order_of(const Test& test, TestCycle cycle) {
  Plan plan;
  plan.cycle = cycle;
  plan.runs = test.series.run_count();
  plan.targets.assign(test.series.targets().begin(), test.series.targets().end());
  std::vector<Approach> order = approaches(plan);
  std::erase_if(order, [&](const Approach& a) { return std::isnan(time_of(test, a)); });
  return order;
}

/// The first reading of the order that was taken before the one that it follows.
std::optional<std::size_t> first_too_early(const Test& test, const std::vector<Approach>& order) {
  for (std::size_t k = 1; k < order.size(); ++k)
    if (time_of(test, order[k]) < time_of(test, order[k - 1])) return k;
  return std::nullopt;
}

std::string reading_text(const Approach& a) {
  return fmt::format("target {} {} run {}", a.target + 1, arrow(a.direction), a.run + 1);
}

std::optional<Finding> other_order(const Test& test) {
  const TestCycle cycle = test.metadata.conditions.cycle_or_standard();
  if (cycle == TestCycle::user_defined) return std::nullopt;
  const std::vector<Approach> order = timed_in_order_of(test, cycle);
  const auto early = first_too_early(test, order);
  if (!early) return std::nullopt;
  const std::string clause =
      programme_clause(programme_of(test.metadata.axis.kind, Position::native(test.series.travel_native())));
  for (const TestCycle other : {TestCycle::standard, TestCycle::step, TestCycle::pilgrim})
    if (other != cycle && !first_too_early(test, timed_in_order_of(test, other)))
      return rules::departure("order-by-times", clause,
                              fmt::format("the times of the readings tell the {} cycle, expected that of the {} cycle",
                                          cycle_name(other), cycle_name(cycle)));
  return rules::departure(
      "order-by-times", clause,
      fmt::format("the times of the readings tell another order than that of the {} cycle: {} was read before {}",
                  cycle_name(cycle), reading_text(order[*early]), reading_text(order[*early - 1])));
}

std::optional<Finding> too_quick(const Test& test) {
  constexpr double share = 0.5;  // of the rest: times may be rounded
  const auto& dwell = test.metadata.conditions.dwell;
  if (!dwell) return std::nullopt;
  std::vector<double> times = test.times_s;
  std::erase_if(times, [](double t) { return std::isnan(t); });
  std::ranges::sort(times);
  double least = dwell->in_s();
  for (std::size_t k = 1; k < times.size(); ++k)
    if (const double between = times[k] - times[k - 1]; between > 0.0) least = std::min(least, between);
  if (least >= share * dwell->in_s()) return std::nullopt;
  return rules::departure("rest-by-times", "5.1",
                          fmt::format("the times of the readings are {} s apart where they are nearest, expected more "
                                      "than the rest of {} s that is stated for each target",
                                      format_rounded(least), format_rounded(dwell->in_s())));
}

}  // namespace

std::vector<Finding> order_findings(const Test& test) {
  std::vector<Finding> findings;
  if (test.times_s.empty()) return findings;
  for (auto* rule : {other_order, too_quick})
    if (auto finding = rule(test)) findings.push_back(*std::move(finding));
  return findings;
}

}  // namespace axiometry::iso230_2
