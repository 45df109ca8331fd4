// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/captured_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/numeric/median.h"

namespace axiometry::capture {
namespace {

constexpr double feed_alike = 0.05;       // share: half a step of an override
constexpr double feed_steps_share = 0.1;  // of the step in time over the time of a way
constexpr double coarse = 0.06;           // share, of what a feed is known to
constexpr double rest_alike = 0.1;        // share: a control waits until the axis is in position, and calculates
constexpr double rest_decimals = 10.0;

/// To three significant figures, to two where it is known to so little.
double known_figures(double x, double known_to) {
  const double last = known_to > coarse ? 1.0 : 2.0;
  const double places = last - std::floor(std::log10(x));
  if (const double per_unit = std::pow(10.0, places); places > 0.0) return std::round(x * per_unit) / per_unit;
  const double unit = std::pow(10.0, -places);
  return std::round(x / unit) * unit;
}

/// The feed between the targets.
std::optional<SourceRemark> take_feed(const Plan& plan, const CaptureResult& result, TestConditions& conditions) {
  std::vector<double> even, all, known_to;
  for (const CapturedReading& r : result.readings) {
    if (!r.standstill.speed) continue;
    const double per_minute = r.standstill.speed->per_s * 60.0;
    all.push_back(per_minute);
    known_to.push_back(r.standstill.speed->known_to);
    if (r.standstill.speed->even) even.push_back(per_minute);
  }
  const std::string unit = fmt::format("{}/min", position_unit(plan.axis.kind));
  if (all.empty())
    return SourceRemark{false, fmt::format("too few samples lie on the ways between the targets to show the feed: the "
                                           "{} {} that are stated are those of the plan",
                                           format_exact(plan.feed), unit)};
  const double slack = feed_alike + feed_steps_share * numeric::median(std::move(known_to));
  const bool is_feed = !even.empty();
  const double fastest = std::ranges::max(all);
  const double seen = numeric::median(is_feed ? std::move(even) : std::move(all));
  if (!is_feed && seen < plan.feed && fastest < (1.0 - slack) * plan.feed)
    return SourceRemark{false, fmt::format("the ways between the targets are too short to show the feed, {0} {1} at "
                                           "most were seen: the {2} {1} that are stated are those of the plan",
                                           format_exact(known_figures(fastest, slack)), unit, format_exact(plan.feed))};
  if (std::abs(seen - plan.feed) <= slack * plan.feed || (!is_feed && seen < plan.feed)) return std::nullopt;
  conditions.feed = known_figures(seen, slack);
  return SourceRemark{false, fmt::format("between the targets the axis moved at {0} {1}, where the plan has {2} {1}: "
                                         "the feed is that of the recording",
                                         format_exact(*conditions.feed), unit, format_exact(plan.feed))};
}

/// The mean of those that differ from the middle one by no more than they are known to: each is a whole number of
/// cells.
double usual_rest(std::vector<double> rests_s, double edge_s) {
  const double middle = numeric::median(rests_s);
  double sum = 0.0, count = 0.0;
  for (const double rest : rests_s) {
    if (std::abs(rest - middle) > 1.5 * edge_s) continue;
    sum += rest;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : middle;
}

/// The time at rest.
std::optional<SourceRemark> take_dwell(const Plan& plan, const CaptureResult& result, TestConditions& conditions) {
  std::vector<double> rests_s;
  double edge_s = 0.0;
  for (const CapturedReading& r : result.readings) {
    if (r.standstill.cut_off) continue;
    rests_s.push_back(r.standstill.end_s - r.standstill.begin_s + r.standstill.edge_s);
    edge_s = r.standstill.edge_s;
  }
  const double planned_s = plan.dwell.in_s();
  if (rests_s.empty() || !(planned_s > 0.0)) return std::nullopt;
  const double seen_s = usual_rest(std::move(rests_s), edge_s);
  if (std::abs(seen_s - planned_s) <= rest_alike * planned_s + edge_s) return std::nullopt;
  conditions.dwell = Duration::s(std::round(rest_decimals * seen_s) / rest_decimals);
  return SourceRemark{false,
                      fmt::format("the axis usually rested {} s at the targets, where the plan has {} s: the dwell is "
                                  "that of the recording",
                                  format_fixed(seen_s, 1), format_exact(planned_s))};
}

std::optional<SourceRemark> take_warm_up(const Plan& plan, const CaptureResult& result, TestConditions& conditions) {
  const std::size_t runs = result.full_ways_before / 2;
  if (plan.warm_up_runs == 0) return std::nullopt;
  if (runs == 0)
    return SourceRemark{false, fmt::format("the recording shows no warm-up over all targets before the first reading, "
                                           "where the plan has {}: how the machine was warmed up is left open",
                                           counted(plan.warm_up_runs, "run"))};
  conditions.warm_up = fmt::format("as recorded: {} there and back over all targets before the first reading",
                                   runs == 1 ? "once" : fmt::format("{} times", runs));
  if (runs >= plan.warm_up_runs) return std::nullopt;
  return SourceRemark{false, fmt::format("the recording shows {} of {} for warm-up before the first reading: what is "
                                         "stated is what was recorded",
                                         runs, counted(plan.warm_up_runs, "run"))};
}

}  // namespace

CapturedConditions captured_conditions(const Plan& plan, const CaptureResult& result) {
  CapturedConditions captured;
  Metadata& metadata = captured.metadata;
  metadata.axis = plan.axis;
  metadata.machine.name = plan.machine;
  metadata.conditions.cycle = plan.cycle;
  metadata.conditions.feed = plan.feed;
  metadata.conditions.dwell = plan.dwell;
  for (const auto take : {take_feed, take_dwell, take_warm_up})
    if (auto remark = take(plan, result, metadata.conditions)) captured.remarks.push_back(std::move(*remark));
  return captured;
}

}  // namespace axiometry::capture
