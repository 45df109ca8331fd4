// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/number_text.h"
#include "axiometry/nc/script.h"

namespace axiometry::nc {
namespace {

/// Without acceleration, and from the first overrun on: where the axis stands before is not known.
Duration duration(const Plan& plan) {
  double way = 0.0;
  std::size_t readings = 0;
  const std::vector<PlannedMove> list = moves(plan);
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (k > 0) way += std::abs(list[k].to.in_native() - list[k - 1].to.in_native());
    readings += list[k].approach.has_value();
  }
  return Duration::s(60.0 * way / plan.feed + static_cast<double>(readings) * plan.dwell.in_s());
}

std::string duration_text(Duration d) {
  const double minutes = d.in_s() / 60.0;
  return minutes < 1.0 ? fmt::format("{:.0f} S", d.in_s()) : fmt::format("{:.0f} MIN", minutes);
}

std::string_view directions(const Plan& plan) {
  switch (plan.cycle) {
    case TestCycle::unidirectional: return " UP";
    case TestCycle::user_defined: return "";
    default: return " UP AND DOWN";
  }
}

}  // namespace

std::vector<std::string> headlines(const Plan& plan) {
  const std::string_view unit = plan.axis.kind == AxisKind::linear ? "MM" : "DEG";
  const auto native = [](Position p) { return format_exact(std::round(p.in_native() * 1e6) / 1e6 + 0.0); };
  std::vector<std::string> lines;
  lines.push_back(plan.clause.empty() ? "TEST " + plan.standard
                                      : fmt::format("TEST {}, {}", plan.standard, plan.clause));
  if (!cycle_label(plan.cycle).empty()) lines.emplace_back(cycle_label(plan.cycle));
  if (!plan.title.empty()) lines.push_back("PART " + plan.title);
  if (!plan.machine.empty()) lines.push_back("MACHINE " + plan.machine);
  if (!plan.date.empty()) lines.push_back("DATE " + plan.date);
  lines.push_back(fmt::format("AXIS {}, {}", plan.axis.name, axis_kind_name(plan.axis.kind)));
  lines.push_back(fmt::format("{} TARGETS FROM {} TO {} {}", plan.targets.size(), native(plan.targets.front()),
                              native(plan.targets.back()), unit));
  lines.push_back(fmt::format("{} RUNS{}{}", plan.runs, directions(plan),
                              plan.warm_up_runs > 0 ? fmt::format(" AFTER {} FOR WARM-UP", plan.warm_up_runs) : ""));
  const Reach ends = reach(plan);
  lines.push_back(
      fmt::format("FEED {} {}/MIN, DWELL {} S", format_exact(plan.feed), unit, format_exact(plan.dwell.in_s())));
  lines.push_back(fmt::format("THE AXIS MOVES FROM {} TO {} {}", native(ends.lowest), native(ends.highest), unit));
  lines.push_back("DURATION ABOUT " + duration_text(duration(plan)));
  lines.emplace_back("POSITIONS IN THE WORK OFFSET THAT IS ACTIVE");
  return lines;
}

}  // namespace axiometry::nc
