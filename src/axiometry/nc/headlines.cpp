// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/number_text.h"
#include "axiometry/nc/script.h"

namespace axiometry::nc {
namespace {

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

std::vector<std::string> headlines(const Plan& plan, const ProgramOptions& options) {
  const std::string_view unit = plan.axis.kind == AxisKind::linear ? "MM" : "DEG";
  const auto native = [](Position p) { return format_exact(std::round(p.in_native() * 1e6) / 1e6 + 0.0); };
  std::vector<std::string> lines;
  lines.push_back(plan.clause.empty() ? "TEST " + plan.standard
                                      : fmt::format("TEST {}, {}", plan.standard, plan.clause));
  if (!cycle_label(plan.cycle).empty()) lines.emplace_back(cycle_label(plan.cycle));
  if (!plan.title.empty()) lines.push_back("TITLE " + plan.title);
  if (!plan.machine.empty()) lines.push_back("MACHINE " + plan.machine);
  if (!plan.date.empty()) lines.push_back("DATE " + plan.date);
  lines.push_back(fmt::format("AXIS {}, {}", plan.axis.name, axis_kind_name(plan.axis.kind)));
  lines.push_back(fmt::format("{} TARGETS FROM {} TO {} {}", plan.targets.size(), native(plan.targets.front()),
                              native(plan.targets.back()), unit));
  lines.push_back(fmt::format("{} RUN{}{}{}", plan.runs, plan.runs == 1 ? "" : "S", directions(plan),
                              plan.warm_up_runs > 0 ? fmt::format(" AFTER {} FOR WARM-UP", plan.warm_up_runs) : ""));
  const Reach ends = reach(plan);
  lines.push_back(
      fmt::format("FEED {} {}/MIN, DWELL {} S", format_exact(plan.feed), unit, format_exact(plan.dwell.in_s())));
  lines.push_back(fmt::format("THE AXIS MOVES FROM {} TO {} {}", native(ends.lowest), native(ends.highest), unit));
  if (options.duration) lines.push_back("DURATION ABOUT " + duration_text(*options.duration));
  lines.emplace_back("POSITIONS IN THE WORK OFFSET THAT IS ACTIVE");
  return lines;
}

}  // namespace axiometry::nc
