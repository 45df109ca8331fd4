// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "axiometry/base/text/number_text.h"
#include "axiometry/nc/script.h"

namespace axiometry::nc {
namespace {

std::string duration_text(Duration d) {
  const double minutes = d.in_s() / 60.0;
  return minutes < 1.0 ? fmt::format("{:.0f} S", d.in_s()) : fmt::format("{:.0f} MIN", minutes);
}

/// Of X, Y and Z.
struct TravelRange {
  Vector3 lowest{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vector3 highest{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

std::string_view directions(const Plan& plan) {
  switch (plan.cycle) {
    case TestCycle::unidirectional: return " UP";
    case TestCycle::user_defined: return "";
    default: return " UP AND DOWN";
  }
}

std::string native(double mm_or_deg) { return format_exact(std::round(mm_or_deg * 1e6) / 1e6 + 0.0); }

constexpr char axis_letters[] = {'X', 'Y', 'Z'};

/// "X 0.707107 Y 0.707107 Z 0"
std::string xyz(Vector3 v) { return fmt::format("X {} Y {} Z {}", native(v.x), native(v.y), native(v.z)); }

/// A standard for positions says nothing of other errors.
std::string test_line(const Plan& plan) {
  if (!measures_positions(plan)) return "READINGS OF " + errors_text(plan);
  return plan.clause.empty() ? "TEST " + plan.standard : fmt::format("TEST {}, {}", plan.standard, plan.clause);
}

void add_standing(std::vector<std::string>& lines, const PlanStanding& standing) {
  const auto counted = [](std::size_t n, std::string_view word) {
    return fmt::format("{} {}{}", n, word, n == 1 ? "" : "S");
  };
  if (standing.departures > 0) lines.push_back("NOT IN ACCORDANCE, " + counted(standing.departures, "DEPARTURE"));
  if (standing.missing > 0) lines.push_back("NOT YET IN ACCORDANCE, " + counted(standing.missing, "POINT") + " OPEN");
}

/// Of a plan without and with a line in space.
void add_movement(std::vector<std::string>& lines, const Plan& plan) {
  const std::string_view unit = plan.axis.kind == AxisKind::linear ? "MM" : "DEG";
  const auto line = spatial_line(plan.axis);
  if (line)
    lines.push_back(fmt::format("DIRECTION {}", xyz(line->direction)));
  else
    lines.push_back(fmt::format("AXIS {}, {}", plan.axis.name, axis_kind_name(plan.axis.kind)));
  lines.push_back(fmt::format("{} TARGETS FROM {} TO {} {}{}", plan.targets.size(),
                              native(plan.targets.front().in_native()), native(plan.targets.back().in_native()), unit,
                              line ? " ALONG THE LINE" : ""));
  lines.push_back(fmt::format("{} RUN{}{}{}", plan.runs, plan.runs == 1 ? "" : "S", directions(plan),
                              plan.warm_up_runs > 0 ? fmt::format(" AFTER {} FOR WARM-UP", plan.warm_up_runs) : ""));
  lines.push_back(fmt::format("FEED {} {}/MIN{}, DWELL {} S", format_exact(plan.feed), unit,
                              line ? " ALONG THE PATH" : "", format_exact(plan.dwell.in_s())));
  const Reach ends = reach(plan);
  if (!line) {
    lines.push_back(fmt::format("THE AXIS MOVES FROM {} TO {} {}", native(ends.lowest.in_native()),
                                native(ends.highest.in_native()), unit));
    return;
  }
  lines.push_back(fmt::format("THE AXES MOVE FROM {}", xyz(line->at(ends.lowest))));
  lines.push_back(fmt::format("TO {} MM", xyz(line->at(ends.highest))));
  const auto points = [](std::size_t n) { return fmt::format("{} POINT{}", n, n == 1 ? "" : "S"); };
  if (!plan.way_in_mm.empty()) lines.push_back(fmt::format("WAY IN OVER {}", points(plan.way_in_mm.size())));
  if (!plan.way_out_mm.empty()) lines.push_back(fmt::format("WAY OUT OVER {}", points(plan.way_out_mm.size())));
}

/// Between which coordinates the axes move, ways included.
TravelRange travel_range(std::span<const Plan> plans) {
  TravelRange range;
  const auto take = [&](Vector3 p) {
    for (std::size_t k = 0; k < 3; ++k) {
      range.lowest[k] = std::min(range.lowest[k], p[k]);
      range.highest[k] = std::max(range.highest[k], p[k]);
    }
  };
  for (const Plan& plan : plans) {
    const auto line = spatial_line(plan.axis);
    const Reach ends = reach(plan);
    for (Position end : {ends.lowest, ends.highest}) take(line->at(end));
    for (const auto* way : {&plan.way_in_mm, &plan.way_out_mm})
      for (Vector3 point : *way) take(point);
  }
  return range;
}

void add_once(std::vector<std::string>& lines, const Plan& plan) {
  if (!plan.rule.empty()) lines.push_back("CYCLE ASKED FOR " + plan.rule);
  if (!plan.machine.empty()) lines.push_back("MACHINE " + plan.machine);
  if (!plan.date.empty()) lines.push_back("DATE " + plan.date);
}

void add_end(std::vector<std::string>& lines, const ProgramOptions& options, std::string_view frame,
             const Plan& first) {
  if (options.duration) lines.push_back("DURATION ABOUT " + duration_text(*options.duration));
  if (options.duration && options.acceleration)
    lines.push_back(fmt::format("AT AN ACCELERATION OF {} {}/S2", format_exact(*options.acceleration),
                                first.axis.kind == AxisKind::linear ? "MM" : "DEG"));
  lines.emplace_back(frame);
  const auto line = spatial_line(first.axis);
  if (!line) return;
  lines.emplace_back("ALL WAYS ARE STRAIGHT, AT FEED, AND MUST BE FREE");
  const Vector3 begin = first.way_in_mm.empty() ? line->at(reach(first).lowest) : first.way_in_mm.front();
  lines.push_back("THE FIRST FROM WHERE THE AXES STAND TO " + xyz(begin));
}

}  // namespace

std::string line_name(const Plan& line) { return line.axis.name.empty() ? "THE LINE" : "LINE " + line.axis.name; }

std::vector<std::string> headlines(const Plan& plan, const ProgramOptions& options, std::string_view frame) {
  const bool in_space = spatial_line(plan.axis).has_value();
  std::vector<std::string> lines;
  if (in_space && !plan.axis.name.empty()) lines.push_back(line_name(plan));
  lines.push_back(test_line(plan));
  add_standing(lines, options.standing);
  if (!cycle_label(plan.cycle).empty()) lines.emplace_back(cycle_label(plan.cycle));
  if (!plan.title.empty()) lines.push_back("TITLE " + plan.title);
  add_once(lines, plan);
  add_movement(lines, plan);
  add_end(lines, options, frame, plan);
  return lines;
}

std::vector<std::string> headlines(std::span<const Plan> plans, const ProgramOptions& options, std::string_view frame) {
  std::vector<std::string> lines;
  if (!options.title.empty()) lines.push_back(fmt::format("TITLE {}", options.title));
  add_once(lines, plans.front());
  std::string names;
  for (const Plan& plan : plans) names += (names.empty() ? "" : ", ") + (plan.axis.name.empty() ? "-" : plan.axis.name);
  lines.push_back(fmt::format("{} LINES, {}", plans.size(), names));
  const TravelRange range = travel_range(plans);
  for (std::size_t k = 0; k < 3; ++k)
    lines.push_back(
        fmt::format("{} MOVES FROM {} TO {} MM", axis_letters[k], native(range.lowest[k]), native(range.highest[k])));
  add_end(lines, options, frame, plans.front());
  return lines;
}

std::vector<std::string> line_headlines(const Plan& line) {
  std::vector<std::string> lines = {test_line(line)};
  if (!cycle_label(line.cycle).empty()) lines.emplace_back(cycle_label(line.cycle));
  if (!line.title.empty()) lines.push_back("TITLE " + line.title);
  add_movement(lines, line);
  return lines;
}

}  // namespace axiometry::nc
