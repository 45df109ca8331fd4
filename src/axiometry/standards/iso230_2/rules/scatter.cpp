// SPDX-License-Identifier: Apache-2.0
//
// Clauses 3.18 and 4.3: readings that do not scatter as the others do. They are told with what they do to a parameter,
// and all parameters keep them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"

namespace axiometry::iso230_2::rules {
namespace {

constexpr double least_change = 0.01;  // smallest relative change of a parameter that is told
constexpr double of_rounding = 1e-9;   // µm or ″: no reading tells it, but sums of equal ones may be off by as much

/// "R↑ would be 2.1 µm instead of 9.7 µm", of the parameter that changes most; "" where none does.
Message without_text(const Case& c, const AxisParameters& without) {
  const ParameterInfo* most = nullptr;
  double largest = least_change;
  for (const ParameterInfo& parameter : parameters) {
    const auto& before = c.evaluation.parameters.*parameter.member;
    const auto& after = without.*parameter.member;
    if (!before || !after || !(std::abs(before->in_native()) > 0.0)) continue;
    if (size_text(after->in_native()) == size_text(before->in_native())) continue;  // the change is rounding
    const double change = std::abs(after->in_native() / before->in_native() - 1.0);
    if (change > largest && parameter.member != &AxisParameters::B_mean) largest = change, most = &parameter;
  }
  if (most == nullptr) return "";
  return message("{} would be {} instead of {}", most->symbol,
                 deviation_message(c, (without.*most->member)->in_native()),
                 deviation_message(c, (c.evaluation.parameters.*most->member)->in_native()));
}

Message consequence(const Case& c, const AxisParameters& without, std::string_view of) {
  const Message text = without_text(c, without);
  if (text.text.empty()) return message("no parameter depends on {} by more than 1 %", of);
  return message("without {} {}", of, text);
}

/// The position of an outlier as it would be without it.
PositionResult position_without(const Series& series, const OutlyingReading& outlier) {
  const std::span<const double> readings = series.cell(outlier.target, outlier.direction);
  std::vector<double> others(readings.begin(), readings.end());
  others[outlier.run] = std::numeric_limits<double>::quiet_NaN();
  const Position& target = series.targets()[outlier.target];
  return outlier.direction == Direction::up
             ? evaluate_position(target, others, series.cell(outlier.target, Direction::down))
             : evaluate_position(target, series.cell(outlier.target, Direction::up), others);
}

Finding outlier_finding(const Case& c, const OutlyingReading& outlier, const AxisParameters& without) {
  const double distance = outlier.distance.in_native();
  return note("outlying-reading", "3.18",
              message("found an outlier at {} {} run {}: a reading of {}, which lies {} {} what the other readings of "
                      "target and run let expect ({}); {}, and nothing is removed",
                      target_text(c, outlier.target), arrow(outlier.direction), outlier.run + 1,
                      deviation_message(c, outlier.deviation.in_native()), deviation_message(c, std::abs(distance)),
                      distance > 0.0 ? "above" : "below", format_chance(outlier.p), consequence(c, without, "it")));
}

/// The positions without those of the part that scatters more, for R of the rest.
AxisParameters rest_of(const Case& c, const UnevenScatter& uneven) {
  std::vector<PositionResult> rest;
  for (std::size_t i = 0; i < c.evaluation.positions.size(); ++i)
    if (i < uneven.first || i > uneven.last) rest.push_back(c.evaluation.positions[i]);
  AxisParameters parameters;
  for (const PositionResult& p : rest) {
    const auto larger = [](std::optional<Deviation>& of, const std::optional<Deviation>& than) {
      if (than && (!of || than->in_native() > of->in_native())) of = than;
    };
    if (uneven.direction != Direction::down) larger(parameters.R_up, p.R_up);
    if (uneven.direction != Direction::up) larger(parameters.R_down, p.R_down);
  }
  return parameters;
}

std::string place_text(const Case& c, const UnevenScatter& uneven) {
  const std::string where = uneven.first == uneven.last
                                ? target_text(c, uneven.first)
                                : fmt::format("targets {} to {}", uneven.first + 1, uneven.last + 1);
  return uneven.direction ? fmt::format("{} {}", where, arrow(*uneven.direction)) : where;
}

/// "; s_i go from 1.0 µm to 51 µm", "" where an evaluation of means alone has none.
Message range_text(const Case& c) {
  double least = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (const PositionResult& p : c.evaluation.positions)
    for (const auto& s : {p.s_up, p.s_down})
      if (s) least = std::min(least, s->in_native()), largest = std::max(largest, s->in_native());
  if (least > largest) return "";
  return message("; s_i go from {} to {}", deviation_message(c, least), deviation_message(c, largest));
}

/// `tilted`: the scatter is that beside the slopes of the runs, which s_i hold.
Finding uneven_finding(const Case& c, const UnevenScatter& uneven, bool tilted) {
  const double within = uneven.within.in_native(), elsewhere = uneven.elsewhere.in_native();
  const std::string chance = format_chance(uneven.p);
  const bool whole = uneven.first == 0 && uneven.last + 1 == c.evaluation.positions.size();
  if (whole && uneven.direction) {
    const AxisParameters& p = c.evaluation.parameters;
    return note(
        "uneven-scatter", "3.18",
        message("found readings that scatter by {} {} and by {} {} ({}): R↑ is {} and R↓ {}{}",
                deviation_message(c, within), arrow(*uneven.direction), deviation_message(c, elsewhere),
                uneven.direction == Direction::up ? "↓" : "↑", chance, deviation_message(c, p.R_up->in_native()),
                deviation_message(c, p.R_down->in_native()), tilted ? Message("") : range_text(c)));
  }
  const Message times = elsewhere > 0.0 ? message("{} times as much as the {} elsewhere", size_text(within / elsewhere),
                                                  deviation_message(c, elsewhere))
                                        : Message("where they do not scatter elsewhere");
  const std::string_view of = uneven.first == uneven.last ? "this target" : "these targets";
  return note("uneven-scatter", "3.18",
              message("found readings that scatter by {} at {}, {} ({}){}; {}", deviation_message(c, within),
                      place_text(c, uneven), times, chance, tilted ? Message("") : range_text(c),
                      consequence(c, rest_of(c, uneven), of)));
}

Finding shifts_finding(const Case& c, const RunShifts& shifts) {
  const Message effect =
      consequence(c, evaluate(without_shifts(c.series)).parameters, shifts.ordered ? "this drift" : "these shifts");
  const Message within = deviation_message(c, shifts.within.in_native());
  if (shifts.ordered) {
    const double drift = shifts.drift.in_native();
    return note("ordered-progression", progression_clause,
                message("found the readings {} from run to run, by {} from the first run to the last, where they "
                        "scatter by {} about target and run ({}): a sign that the machine was not thermally stable; "
                        "{}, and nothing is removed",
                        drift > 0.0 ? "rising" : "falling", deviation_message(c, std::abs(drift)), within,
                        format_chance(shifts.p), effect));
  }
  const double shift = shifts.shift.in_native();
  return note("shifted-runs", "3.18",
              message("found the readings of a run shifted as a whole, by {} from run to run (standard deviation), "
                      "where they scatter by {} about target and run ({}); run {} lies {} {} the mean; {}, and "
                      "nothing is removed",
                      deviation_message(c, shifts.between.in_native()), within, format_chance(shifts.p), shifts.run + 1,
                      deviation_message(c, std::abs(shift)), shift > 0.0 ? "above" : "below", effect));
}

/// "3", "3, ↑ and ↓ together," or "3 ↑, with 4 ↓," where each direction has numbers of its own.
Message run_of_tilt(const TiltStudy& tilts) {
  const auto& [up, down] = tilts.farthest;
  if (!up || !down) return fmt::format("{}", up.value_or(down.value_or(0)) + 1);
  if (*up == *down) return message("{}, ↑ and ↓ together,", *up + 1);
  return message("{} ↑, with {} ↓,", *up + 1, *down + 1);
}

Finding tilts_finding(const Case& c, const TiltStudy& tilts) {
  const Message cause = c.metadata.axis.kind == AxisKind::linear
                            ? Message(", such as those of an axis whose temperature changes between them")
                            : Message("");
  return note(
      "tilted-runs", "3.18",
      message("found runs with slopes of their own, which differ over the range of the targets by {} (standard "
              "deviation), where readings scatter by {} about target, run and slope ({}){}; that of run {} lies "
              "{} {} their mean; {}, and nothing is removed",
              deviation_message(c, tilts.between()), deviation_message(c, tilts.within), format_chance(tilts.p), cause,
              run_of_tilt(tilts), deviation_message(c, std::abs(tilts.farthest_tilt)),
              tilts.farthest_tilt > 0.0 ? "above" : "below",
              consequence(c, evaluate(without_shifts(without_tilts(c.series))).parameters,
                          "shifts and slopes of the runs")));
}

}  // namespace

std::vector<Finding> scatter_findings(const Case& c) {
  const ScatterStudy study = scatter_study(c.series);
  std::vector<Finding> findings;
  if (!study.outliers.empty()) {
    const AxisWithoutOne axis(evaluate_positions(c.series));
    for (const OutlyingReading& outlier : study.outliers)
      findings.push_back(outlier_finding(c, outlier, axis.with(outlier.target, position_without(c.series, outlier))));
  }
  if (study.uneven && study.uneven->within.in_native() > of_rounding)
    findings.push_back(uneven_finding(c, *study.uneven, study.tilts.has_value()));
  if (study.shifts && study.shifts->between.in_native() > of_rounding)
    findings.push_back(shifts_finding(c, *study.shifts));
  if (study.tilts && study.tilts->between() > of_rounding) findings.push_back(tilts_finding(c, *study.tilts));
  return findings;
}

}  // namespace axiometry::iso230_2::rules
