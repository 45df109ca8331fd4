// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/capture_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/capture/captured_conditions.h"

namespace axiometry::capture {
namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// Where targets of another plan lie in the windows of this one, readings fill them; those of an axis lie close
/// together, even with another zero. A twentieth of them at each end may be anything, and so may all of them where
/// targets are so dense (Annex C) that the error of the axis itself fills the window.
Result<void> check_closeness(const Plan& plan, const CaptureResult& result) {
  constexpr double most = 0.4;             // of the window; evenly spread readings take 1.8
  constexpr double always_possible = 0.1;  // mm or °
  std::vector<double> deviations;
  for (const CapturedReading& r : result.readings) deviations.push_back(r.deviation.in_native());
  std::ranges::sort(deviations);
  const std::size_t cut = deviations.size() / 20;
  const double lowest = deviations[cut], highest = deviations[deviations.size() - 1 - cut];
  const double limit =
      std::max(most * result.window.in_native(), always_possible) * deviation_per_position(plan.axis.kind);
  if (highest - lowest <= limit) return {};
  return fail(
      fmt::format("found deviations from {} to {} {} from the targets, expected a range of {} {} at most: the "
                  "recording belongs to another plan, or the window around the targets is too narrow for this axis",
                  format_fixed(lowest, 1), format_fixed(highest, 1), deviation_unit(plan.axis.kind),
                  format_fixed(limit, 1), deviation_unit(plan.axis.kind)));
}

std::vector<SourceRemark> remarks_of(const CaptureResult& result, const std::vector<std::size_t>& left_out) {
  std::vector<SourceRemark> remarks;
  if (result.readings.size() < result.approaches)
    remarks.push_back({false, fmt::format("the recording gave {} of the {} readings of the plan",
                                          result.readings.size(), result.approaches)});
  if (!left_out.empty()) {
    std::string numbers;
    for (std::size_t i : left_out) numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", i + 1);
    remarks.push_back({true, fmt::format("found no reading at target {} of the plan, expected one from every approach: "
                                         "left out of the test",
                                         numbers)});
  }
  for (const CaptureEvent& event : result.events)
    if (event.kind != EventKind::incomplete)
      remarks.push_back({false, fmt::format("{}: {}", event_name(event.kind), event.message)});
  for (const CapturedReading& reading : result.readings)
    for (const std::string& remark : reading.remarks)
      remarks.push_back({false, fmt::format("{}: {}", approach_name(reading.approach), remark)});
  return remarks;
}

}  // namespace

Result<void> check_fit(const Plan& plan, const CaptureResult& result) {
  if (2 * result.readings.size() >= std::max<std::size_t>(result.standstills, 1)) return {};
  if (result.standstills == 0)
    return fail(
        fmt::format("found no standstill that is long enough and not at a turning point, expected one at each of the "
                    "{} approaches of the plan, targets {} to {} {}: shorter and less quiet ones are taken with a "
                    "smaller shortest standstill and a larger threshold of rest",
                    result.approaches, format_exact(plan.targets.front().in_native()),
                    format_exact(plan.targets.back().in_native()), position_unit(plan.axis.kind)));
  std::string seen;
  std::size_t named = 0;
  for (const CaptureEvent& event : result.events)
    if ((event.kind == EventKind::unexpected || event.kind == EventKind::wrong_direction) && named++ < 3)
      seen += fmt::format("; {}", event.message);
  return fail(fmt::format(
      "found {} of {} standstills at the approaches of the plan, expected most of them ({} approaches, targets {} to "
      "{} {}): the recording belongs to another plan, or the zero or sign of the instrument differ{}",
      result.readings.size(), result.standstills, result.approaches, format_exact(plan.targets.front().in_native()),
      format_exact(plan.targets.back().in_native()), position_unit(plan.axis.kind), seen));
}

std::string_view event_name(EventKind kind) {
  switch (kind) {
    case EventKind::zero: return "zero";
    case EventKind::missed: return "missed";
    case EventKind::repeated: return "repeated";
    case EventKind::wrong_direction: return "wrong direction";
    case EventKind::too_short: return "too short";
    case EventKind::signal_lost: return "signal lost";
    case EventKind::unexpected: return "unexpected";
    case EventKind::unseen: return "not seen";
    case EventKind::restarted: return "restarted";
    case EventKind::off_zero: return "off zero";
    case EventKind::incomplete: return "incomplete";
    case EventKind::unsteady: return "unsteady";
    case EventKind::doubtful: return "doubtful";
    case EventKind::skipped: return "skipped";
    case EventKind::undone: return "taken back";
  }
  return "";
}

std::string approach_name(const Approach& approach) {
  return fmt::format("target {}{} run {}", approach.target + 1, arrow(approach.direction), approach.run + 1);
}

std::string ended_before(const Approach& approach, std::size_t behind) {
  const std::string first = approach_name(approach);
  return behind == 0 ? fmt::format("the recording ended before {}", first)
                     : fmt::format("the recording ended before {} and the {} behind it", first, behind);
}

Result<Test> captured_test(const Plan& plan, const CaptureResult& result) {
  AXIOMETRY_TRY_VOID(check_fit(plan, result));
  std::vector<bool> reached(plan.targets.size());
  std::size_t runs = 0;
  for (const CapturedReading& r : result.readings) {
    reached[r.approach.target] = true;
    runs = std::max(runs, r.approach.run + 1);
  }
  std::vector<Position> targets;
  std::vector<std::size_t> place(plan.targets.size()), left_out;
  for (std::size_t i = 0; i < plan.targets.size(); ++i) {
    place[i] = targets.size();
    reached[i] ? targets.push_back(plan.targets[i]) : left_out.push_back(i);
  }
  if (targets.size() < 2)
    return fail(fmt::format("found readings at {} of {} targets in {} standstills, expected at least two",
                            targets.size(), plan.targets.size(), result.standstills));
  AXIOMETRY_TRY_VOID(check_closeness(plan, result));
  const std::size_t m = targets.size();
  std::vector<double> deviations(2 * m * runs, not_known), times(2 * m * runs, not_known);
  for (const CapturedReading& r : result.readings) {
    const auto& [target, direction, run] = r.approach;
    const std::size_t cell = (static_cast<std::size_t>(direction) * m + place[target]) * runs + run;
    deviations[cell] = r.deviation.in_native();
    times[cell] = 0.5 * (r.standstill.used_from_s + r.standstill.used_to_s);
  }
  AXIOMETRY_TRY(Series series, Series::make_dense(std::move(targets), runs, std::move(deviations)));
  CapturedConditions conditions = captured_conditions(plan, result);
  Test test{std::move(conditions.metadata), std::move(series), {}};
  test.provenance.remarks = remarks_of(result, left_out);
  std::ranges::move(conditions.remarks, std::back_inserter(test.provenance.remarks));
  std::vector<SourceRemark> of_rest = rest_remarks(plan, result);
  std::ranges::move(of_rest, std::back_inserter(test.provenance.remarks));
  test.times_s = std::move(times);
  return test;
}

}  // namespace axiometry::capture
