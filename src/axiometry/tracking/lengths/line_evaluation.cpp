// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: Lee et al. subtract nominal distances along the line; here they are those of the planned
// coordinates, so that a station which was located anew, or stands beside the line, is no error.
#include "axiometry/tracking/lengths/line_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/tracking/lengths/one_line.h"
#include "axiometry/tracking/lengths/reading_name.h"
#include "axiometry/tracking/lengths/reading_order.h"
#include "axiometry/tracking/lines/seven_lines.h"

namespace axiometry::tracking {
namespace {

constexpr double length_limit_mm = 1e6;  // a kilometre, beyond any instrument

using Numbers = std::map<std::string, std::size_t>;

Result<Numbers> check_plan(const TrackingPlan& plan) {
  Numbers numbers;
  for (const TrackingLine& line : plan.lines) {
    AXIOMETRY_TRY_VOID(check_sound(line.plan));
    if (!numbers.emplace(line.id, numbers.size()).second)
      return fail(fmt::format("found line {} twice in the plan, expected each once", text::quoted(line.id)));
  }
  if (numbers.empty()) return fail("found a plan without lines, expected at least one");
  return numbers;
}

Result<void> check_readings(const TrackingPlan& plan, std::span<const LengthReading> readings, const Numbers& numbers) {
  if (readings.empty()) return fail("found no lengths, expected at least two for a line");
  std::set<std::tuple<std::size_t, std::size_t, Direction, std::size_t>> seen;
  for (const LengthReading& r : readings) {
    const auto line = numbers.find(r.line);
    if (line == numbers.end()) {
      std::string ids;
      for (const TrackingLine& l : plan.lines) ids += fmt::format("{}{}", ids.empty() ? "" : ", ", l.id);
      return fail(
          fmt::format("found a length of the line {}, expected one of the plan's: {}", text::quoted(r.line), ids));
    }
    const Plan& own = plan.lines[line->second].plan;
    if (r.approach.target >= own.targets.size())
      return fail(fmt::format("found a length at target {} of line {}, expected 1 to {}", r.approach.target + 1, r.line,
                              own.targets.size()));
    if (!(std::abs(r.length_difference_mm) <= length_limit_mm))
      return fail(fmt::format("found a length of {} mm at {}, expected one up to 1e6 mm", r.length_difference_mm,
                              reading_name_with_line(r)));
    if (!seen.emplace(line->second, r.approach.target, r.approach.direction, r.approach.run).second)
      return fail(fmt::format("found {} twice, expected each reading once", reading_name_with_line(r)));
  }
  return {};
}

/// Readings of every line in the order of measurement: that of the plan's approaches, so that a sorted table does no
/// harm; runs beyond the plan stand behind in their order. Where all times are known they decide.
struct Ordered {
  std::vector<LengthReading> readings;
  std::vector<double> times_s;
};

Ordered ordered(const TrackingPlan& plan, std::span<const LengthReading> readings, const Numbers& numbers,
                std::span<const double> times_s) {
  std::vector<std::map<std::tuple<std::size_t, Direction, std::size_t>, std::size_t>> ranks;
  for (const TrackingLine& line : plan.lines) {
    auto& rank = ranks.emplace_back();
    for (const Approach& a : approaches(line.plan)) rank.emplace(std::tuple{a.target, a.direction, a.run}, rank.size());
  }
  const bool timed =
      times_s.size() == readings.size() && std::ranges::none_of(times_s, [](double t) { return std::isnan(t); });
  std::vector<std::tuple<std::size_t, double, std::size_t>> order;  // line, time or rank, place in the file
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const LengthReading& r = readings[k];
    const std::size_t line = numbers.at(r.line);
    const auto rank = ranks[line].find({r.approach.target, r.approach.direction, r.approach.run});
    const auto at =
        rank != ranks[line].end() ? static_cast<double>(rank->second) : static_cast<double>(ranks[line].size() + k);
    order.emplace_back(line, timed ? times_s[k] : at, k);
  }
  std::ranges::sort(order);
  Ordered result;
  for (const auto& [line, at, k] : order) {
    result.readings.push_back(readings[k]);
    if (times_s.size() == readings.size()) result.times_s.push_back(times_s[k]);
  }
  return result;
}

struct StretchOfLine {
  std::size_t begin = 0;
  std::size_t count = 0;
};

/// Where the readings of each line stand, in the order in which people look for lines: x, y, z, xy, … and what is none
/// of the seven behind, as it was driven.
std::vector<StretchOfLine> stretches_of_lines(std::span<const LengthReading> readings) {
  std::vector<StretchOfLine> stretches;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    if (k == 0 || readings[k].line != readings[k - 1].line) stretches.push_back({k, 0});
    ++stretches.back().count;
  }
  std::ranges::stable_sort(stretches, {}, [&](const StretchOfLine& s) {
    return std::ranges::find(seven_lines, std::string_view(readings[s.begin].line)) - seven_lines.begin();
  });
  return stretches;
}

/// As they would be shown by an instrument that counts up when the reflector recedes.
std::vector<LengthReading> turned(std::vector<LengthReading> readings, bool reversed) {
  for (LengthReading& r : readings)
    if (reversed) r.length_difference_mm = -r.length_difference_mm;
  return readings;
}

void add_squareness(LinesEvaluation& evaluation, std::vector<LineSlope> slopes, const TrackingSetup& setup) {
  if (slopes.size() < 2) return;
  evaluation.squareness = estimate_squareness(slopes, setup.ranging.per_length.in_um_per_m() / 2.0);
}

std::vector<Finding> findings_on_lines(const TrackingPlan& plan, std::span<const LengthReading> readings) {
  std::set<std::string> measured;
  for (const LengthReading& r : readings) measured.insert(r.line);
  std::vector<Finding> findings;
  for (const TrackingLine& line : plan.lines)
    if (!measured.contains(line.id))
      findings.push_back({"lines-without-readings", false,
                          fmt::format("line {} of the plan has no readings and is left out", line.id)});
  for (const LostLine& lost : plan.lost)
    findings.push_back({"lines-lost", false, fmt::format("line {} could not be measured: {}", lost.id, lost.reason)});
  return findings;
}

}  // namespace

Result<LinesEvaluation> evaluate_lines(const TrackingPlan& plan, std::span<const LengthReading> readings,
                                       const LineEvaluationOptions& options) {
  AXIOMETRY_TRY(const Numbers numbers, check_plan(plan));
  AXIOMETRY_TRY_VOID(check_readings(plan, readings, numbers));
  const Ordered in_order = ordered(plan, readings, numbers, options.times_s);
  AXIOMETRY_TRY_VOID(check_order(plan, turned(in_order.readings, options.reversed), options.in_program_order));
  TrackingSetup setup = plan.setup;
  LineEvaluationOptions of_lines = options;
  if (of_lines.metadata.machine.name.empty()) of_lines.metadata.machine.name = plan.machine;
  if (options.station_covariance_mm2) setup.station.covariance_mm2 = options.station_covariance_mm2;
  LinesEvaluation evaluation;
  evaluation.findings = findings_on_lines(plan, readings);
  if (!is_aligned(setup) && !setup.station.covariance_mm2)
    evaluation.findings.push_back(
        {"lines-station-uncertainty", false,
         "the uncertainty of the station is not known: the length difference it causes is not judged"});
  std::vector<LineSlope> slopes;
  for (const auto& [begin, count] : stretches_of_lines(in_order.readings)) {
    const std::string& id = in_order.readings[begin].line;
    const std::span times(in_order.times_s);
    const LineInput input{plan.lines[numbers.at(id)], setup, std::span(in_order.readings).subspan(begin, count),
                          times.empty() ? times : times.subspan(begin, count), of_lines};
    AXIOMETRY_TRY(LineOutcome outcome, evaluate_line(input));
    slopes.push_back({id, outcome.direction, outcome.line.slope_um_per_m, outcome.line.slope_uncertainty_um_per_m,
                      outcome.line.test.series.travel_native(), outcome.line.slope_degrees_of_freedom});
    evaluation.lines.push_back(std::move(outcome.line));
    for (Finding& finding : outcome.findings) evaluation.findings.push_back(std::move(finding));
  }
  add_squareness(evaluation, std::move(slopes), setup);
  return evaluation;
}

}  // namespace axiometry::tracking
