// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/compensate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "axiometry/app/compensate/control_findings.h"
#include "axiometry/app/compensate/existing_table.h"
#include "axiometry/app/compensate/measured_state.h"
#include "axiometry/app/compensate/table_positions.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/compensation/retest_findings.h"
#include "axiometry/compensation/suspicions.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::app {
namespace {

using iso230_2::Evaluation;
using nc::AxisTable;

constexpr double same_target_native = 1e-3;  // mm or °, of test and re-test

std::vector<double> target_positions(const Series& series) {
  std::vector<double> positions;
  for (const Position target : series.targets()) positions.push_back(target.in_native());
  return positions;
}

/// The mean deviations' root mean square about their mean: a new zero of the instrument is no error of the axis.
double spread_of_means(const Evaluation& evaluation) {
  std::vector<double> means;
  for (const iso230_2::PositionResult& p : evaluation.positions)
    for (const auto& mean : {p.mean_up, p.mean_down})
      if (mean) means.push_back(mean->in_native());
  double sum = 0.0, squares = 0.0;
  for (const double mean : means) sum += mean;
  const double average = sum / static_cast<double>(means.size());
  for (const double mean : means) squares += (mean - average) * (mean - average);
  return std::sqrt(squares / static_cast<double>(means.size()));
}

/// E, and of a test of one direction that one's.
std::optional<Deviation> systematic(const iso230_2::AxisParameters& p) {
  return p.E ? p.E : p.E_up ? p.E_up : p.E_down;
}

Result<Evaluation> evaluated_with(const Series& series, const AxisCorrection& added, const AxisCorrection* removed) {
  AXIOMETRY_TRY(const Series corrected, compensation::corrected_series(series, added, removed));
  return iso230_2::evaluate(corrected);
}

/// What is known before a table is made.
struct Setting {
  const CompensateRequest& request;
  const Series& series;
  const AxisTable& control;
  nc::AxisTableOptions options;
  std::optional<AxisCorrection> existing;
  TableCurves curves = TableCurves::both_ways;
  const Series* fitted = nullptr;  ///< the readings that make the table: all, or without the periodic part
  std::vector<double> nodes{};
};

Result<std::vector<double>> nodes_of(const Setting& s) {
  if (s.control.limits.points != 1 && s.existing && !is_wished(s.request.grid)) {
    if (!s.request.hold_ends) AXIOMETRY_TRY_VOID(check_within_targets(*s.existing, s.series));
    return s.existing->positions();
  }
  return table_positions(s.control, s.options.reference, s.request.grid, target_positions(s.series));
}

/// The new table before it is rounded: the change that the readings ask for, upon what was there.
Result<compensation::Fit> table_by(const Setting& s, compensation::Method method) {
  AXIOMETRY_TRY(compensation::Fit fit,
                compensation::fit_correction(*s.fitted, s.options.kind,
                                             {s.nodes, s.curves, method, s.request.smooth, s.request.hold_ends}));
  if (s.existing) {
    AXIOMETRY_TRY(fit.correction, compensation::updated(*s.existing, fit.correction));
  }
  if (s.control.limits.closes) {
    AXIOMETRY_TRY(fit.correction, compensation::closed_turn(fit.correction));
  }
  const double zero = std::clamp(s.options.reference, s.nodes.front(), s.nodes.back());
  const TableCurves zeroed = s.control.limits.zero_upwards ? TableCurves::with_backlash : s.curves;
  AXIOMETRY_TRY(fit.correction, compensation::with_zero_at(fit.correction, zeroed, zero));
  return fit;
}

/// The file, read back as the control reads it. Fails where it would not make the axis better.
Result<AxisCorrection> proved(const Setting& s, const std::string& text, const Evaluation& before) {
  AXIOMETRY_TRY(const AxisCorrection applied,
                in_file(nc::read_table(s.control, text, s.options), "the table that was made"));
  AXIOMETRY_TRY(const Evaluation after, evaluated_with(s.series, applied, s.existing ? &*s.existing : nullptr));
  const auto E_before = systematic(before.parameters), E_after = systematic(after.parameters);
  const double spread_before = spread_of_means(before), spread_after = spread_of_means(after);
  if (E_before && E_after && E_after->in_native() < E_before->in_native() && spread_after < spread_before)
    return applied;
  const auto text_of = [](const std::optional<Deviation>& x) {
    return x ? fmt::format("{:.2f}", x->in_native()) : "–";
  };
  const std::string_view unit = deviation_unit(s.options.kind);
  return fail(fmt::format(
      "found that the axis would not become better by this table: E from {} to {} {}, mean deviations (r.m.s.) from "
      "{:.2f} to {:.2f} {}; no table is written",
      text_of(E_before), text_of(E_after), unit, spread_before, spread_after, unit));
}

/// What lies above 95 % of the re-tests that were to be expected; whether anything does.
bool add_exceeded(const Evaluation& retest, const compensation::ExpectedRetest& expected, AxisKind kind,
                  std::vector<NamedFinding>& findings) {
  constexpr double room = 1.2;  // so that one re-test in twenty is not called wrong
  bool is_above = false;
  for (const auto member : {&iso230_2::AxisParameters::E, &iso230_2::AxisParameters::B}) {
    const auto &found = retest.parameters.*member, &most = expected.percent_95.*member;
    if (!found || !most || found->in_native() <= most->in_native()) continue;
    is_above = true;
    if (found->in_native() <= room * most->in_native()) continue;
    findings.push_back(
        {"retest-above-expected", true,
         fmt::format("the re-test shows {} of {:.2f} {}, where 95 % of re-tests would show less than {:.2f} "
                     "{}: the axis, the set-up or the table is not what it was taken for",
                     member == &iso230_2::AxisParameters::E ? "E" : "B", found->in_native(), deviation_unit(kind),
                     most->in_native(), deviation_unit(kind))});
  }
  return is_above;
}

/// What is known of the table before its re-test is looked at.
struct Foretold {
  const AxisCorrection& applied;
  const std::optional<compensation::ExpectedRetest>& expected;
};

Result<Retest> retest_of(NamedTest again, const Test& before, const Foretold& foretold, const Setting& s,
                         std::vector<NamedFinding>& findings) {
  Test& test = again.test;
  if (test.metadata.axis.kind != before.metadata.axis.kind)
    return std::unexpected(in_file(Error{"found a re-test of another kind of axis", {}, {}}, again.name));
  AXIOMETRY_TRY_VOID(in_file(check_not_itself(before, test), again.name));
  const AxisCorrection* removed = s.existing ? &*s.existing : nullptr;
  Evaluation evaluation = iso230_2::evaluate(test.series);
  std::vector<NamedFinding> exceeded;
  const bool above_95 = foretold.expected && add_exceeded(evaluation, *foretold.expected, s.options.kind, exceeded);
  const auto effect =
      compensation::effect_of_table(before.series, test.series, foretold.applied, removed, same_target_native);
  const auto part = effect ? compensation::finding_of_part(*effect, before.series, s.options.kind) : std::nullopt;
  std::vector<NamedFinding> of_state = findings_of_retest_state(before.metadata, test);
  // Another axis, or a day before the test: then nothing is "as predicted". That none was active may be a slip of the
  // pen.
  const bool excluded = std::ranges::any_of(
      of_state, [](const NamedFinding& f) { return f.id == "retest-before-test" || f.id == "retest-of-another"; });
  if (effect) {
    NamedFinding shown = compensation::finding_of_retest(
        *effect, {s.control.uses.turned_sign, !exceeded.empty(), above_95, part.has_value()});
    if (shown.serious || !excluded) findings.push_back(std::move(shown));
  } else {
    findings.push_back({"retest-other-targets", true,
                        "the re-test has fewer than three targets in common with the test: it cannot be held against "
                        "the prediction"});
  }
  if (part) findings.push_back(*part);
  std::ranges::move(of_state, std::back_inserter(findings));
  std::ranges::move(exceeded, std::back_inserter(findings));
  return Retest{std::move(test), std::move(evaluation), effect};
}

/// Why a table does not make the axis better. Means that lie farther apart than 95 % of those that `scatter` alone
/// makes are what the axis does: the reversal is left by one curve for both directions, the rest by points too far
/// apart.
std::string why_not_better(const Evaluation& before, const Series& scatter, const Setting& s) {
  const auto by_scatter = compensation::expected_retest(scatter);
  const auto E = systematic(before.parameters), E_by_scatter = by_scatter ? systematic(by_scatter->percent_95) : E;
  if (!E || !E_by_scatter || E->in_native() <= E_by_scatter->in_native())
    return "the deviations are what scatter makes of them, and a table of scatter makes the axis worse";
  const auto& B = before.parameters.B;
  if (s.curves == TableCurves::both_ways && B)
    return fmt::format("one curve for both directions leaves the reversal error, up to {:.2f} {}", B->in_native(),
                       deviation_unit(s.options.kind));
  return "no table of these points makes the axis better";
}

/// Fails where re-tests would show no less than the axis has.
Result<void> check_worth_it(const Evaluation& before, const std::optional<compensation::ExpectedRetest>& expected,
                            const Series& scatter, const Setting& s) {
  if (!expected) return {};
  const auto E_before = systematic(before.parameters), E_after = systematic(expected->median);
  if (!E_before || !E_after || E_after->in_native() < E_before->in_native()) return {};
  const std::string unit(deviation_unit(s.options.kind));
  return fail(fmt::format(
      "found that a re-test would show E of {:.2f} {} (median) where the axis has {:.2f} {}: {}; no table is written",
      E_after->in_native(), unit, E_before->in_native(), unit, why_not_better(before, scatter, s)));
}

struct Within {
  double least;
  double most;
};

Result<void> check_within(std::string_view what, double x, Within range) {
  if (x >= range.least && x <= range.most) return {};
  return fail(fmt::format("found the {} {}, expected a number from {} to {}", what, format_rounded(x, 9),
                          format_rounded(range.least, 9), format_rounded(range.most, 9)));
}

Result<NamedTest> test_in(const std::string& file, const EvaluateOptions& reading) {
  AXIOMETRY_TRY(Test measured, read_test(file, reading.format, reading.profile));
  AXIOMETRY_TRY(Test test, in_file(prepare_test(std::move(measured), reading), file));
  return NamedTest{file, std::move(test)};
}

/// Fails on curves that the control cannot hold.
Result<void> check_curves(const AxisTable& control, std::optional<TableCurves> curves) {
  if (curves != TableCurves::with_backlash || control.curves == TableCurves::with_backlash || !control.backlash.empty())
    return {};
  return fail(fmt::format("found a backlash beside one curve asked for of {}, expected {}", control.title,
                          control.curves == TableCurves::each_way
                              ? "a curve for each direction, which it has, or both-ways"
                              : "one curve alone: no number for it is known"));
}

/// The period that somebody states, on the command line or in the test. Fails where one is needed and nobody does.
Result<std::optional<double>> period_of(const CompensateRequest& request, const Test& test) {
  if (request.period) return request.period;
  const auto& expected = test.metadata.axis.expected_period;
  if (expected && expected->in_native() > 0.0) return std::optional(expected->in_native());
  if (request.periodic == compensation::Periodic::leave)
    return fail(
        "found a periodic part to leave out and no period, expected one: axis.expected_period of the test, or one for "
        "this table");
  return std::optional<double>();
}

/// The table that was active, as the control read it.
Result<std::optional<AxisCorrection>> existing_of(const std::optional<NamedTable>& existing, const Setting& s) {
  const std::optional<bool>& in_inch = s.request.existing_in_inch;
  if (in_inch && !existing) return fail("found a unit of the existing table and no such table, expected both");
  if (in_inch && s.options.kind == AxisKind::rotary)
    return fail("found a unit of length for the table of a rotary axis, expected none: it is in °");
  if (!existing) return std::optional<AxisCorrection>();
  nc::AxisTableOptions options = s.options;
  if (in_inch) options.in_inch = *in_inch;
  AXIOMETRY_TRY(AxisCorrection read, in_file(nc::read_table(s.control, existing->text, options), existing->name));
  if (!in_inch && s.control.uses.inch)
    AXIOMETRY_TRY_VOID(in_file(check_unit_of_length(read, s.series, s.options.in_inch), existing->name));
  if (s.control.limits.rolls_over) AXIOMETRY_TRY_VOID(in_file(check_over_targets(read, s.series), existing->name));
  if (s.control.limits.origin == nc::TableOrigin::on_grid) {
    const LeadOn lead{s.options.reference, s.control.limits.rolls_over};
    AXIOMETRY_TRY(read, without_lead_to(lead, std::move(read), s.series));
  }
  if (s.control.backlash.empty()) return std::optional(std::move(read));
  AXIOMETRY_TRY(read, without_number_beside(read));
  return std::optional(std::move(read));
}

/// What must be done beside the table, or is known of it beside its numbers.
void add_findings_of_control(const Setting& s, const AxisCorrection& applied, std::vector<NamedFinding>& findings) {
  std::ranges::move(
      findings_of_control(s.control, s.options, applied, {s.request.resolution_said, s.existing.has_value()}),
      std::back_inserter(findings));
  const bool has_positions = s.control.limits.points == 0 || s.control.limits.points > 2;
  if (s.existing && has_positions)
    if (auto cut = finding_of_cut_table(*s.existing, s.nodes)) findings.push_back(*std::move(cut));
}

}  // namespace

Result<void> check_table_options(const nc::AxisTableOptions& o) {
  AXIOMETRY_TRY_VOID(check_within("resolution", o.resolution, {nc::resolution_least, nc::resolution_most}));
  AXIOMETRY_TRY_VOID(check_within("magnification", o.magnification, {1.0, 1000.0}));
  AXIOMETRY_TRY_VOID(check_within("largest number", o.largest, {0.0, 99'999.0}));
  AXIOMETRY_TRY_VOID(check_within("number", o.number, {0.0, 99'999.0}));
  if (o.steps_per_unit != 0.0) AXIOMETRY_TRY_VOID(check_within("steps per unit", o.steps_per_unit, {1e-9, 1e7}));
  return check_within("step", o.step, {0.0, 1e6});
}

Result<void> check_request(const CompensateRequest& request) {
  AXIOMETRY_TRY(const AxisTable* control, nc::axis_table_named(request.control));
  AXIOMETRY_TRY_VOID(nc::check_used(*control, request.table));
  AXIOMETRY_TRY_VOID(check_curves(*control, request.curves));
  if (request.period) AXIOMETRY_TRY_VOID(check_within("period", *request.period, {1e-6, 1e6}));
  if (request.smooth && request.method == compensation::Method::interpolation)
    return fail("found smoothing asked for with interpolation, which has none; expected it with least-squares");
  if (request.grid.step) AXIOMETRY_TRY_VOID(check_within("step", *request.grid.step, {1e-9, 1e6}));
  return check_table_options(request.table);
}

Result<MeasuredAxis> read_measured_axis(const CompensateFiles& files) {
  AXIOMETRY_TRY(NamedTest measured, test_in(files.test, files.reading));
  MeasuredAxis axis{std::move(measured)};
  if (!files.existing.empty()) {
    AXIOMETRY_TRY(std::string text, whole_file(files.existing));
    axis.existing = NamedTable{files.existing, std::move(text)};
  }
  if (!files.retest.empty()) {
    AXIOMETRY_TRY(axis.retest, test_in(files.retest, files.reading));
  }
  return axis;
}

Result<CompensatedAxis> compensate(MeasuredAxis axis, const CompensateRequest& request) {
  AXIOMETRY_TRY_VOID(check_request(request));
  AXIOMETRY_TRY(const AxisTable* control, nc::axis_table_named(request.control));
  const std::string& name = axis.measured.name;
  Test& test = axis.measured.test;
  const Result<void> measures_axis = check_measures_axis(test);
  if (!measures_axis && !axis.is_kept) return std::unexpected(in_file(measures_axis.error(), name));
  AXIOMETRY_TRY_VOID(in_file(compensation::check_plausible(test.series, test.metadata.axis.kind), name));
  if (control->limits.cross_only)
    return fail(
        fmt::format("found {} for a test of one axis, which it does not correct; expected it of the 21 errors, "
                    "volumetric compensate",
                    control->title));
  Setting s{request, test.series, *control, request.table, {}, request.curves.value_or(control->curves)};
  s.options.kind = test.metadata.axis.kind;
  s.options.axis = !request.axis.empty()              ? request.axis
                   : !test.metadata.axis.name.empty() ? test.metadata.axis.name
                                                      : "X";
  s.options.step = request.grid.step.value_or(0.0);
  AXIOMETRY_TRY(s.existing, existing_of(axis.existing, s));
  AXIOMETRY_TRY(s.nodes, in_file(nodes_of(s), name));
  AXIOMETRY_TRY(const std::optional<double> period, in_file(period_of(request, test), name));
  std::optional<compensation::PeriodicPart> periodic;
  if (period) periodic = compensation::periodic_part(test.series, *period);
  std::optional<Series> smooth;
  if (periodic && request.periodic == compensation::Periodic::leave) {
    AXIOMETRY_TRY(smooth, compensation::without_periodic(test.series, *periodic));
  }
  s.fitted = smooth ? &*smooth : &test.series;

  const Evaluation before = iso230_2::evaluate(test.series);
  const AxisCorrection* removed = s.existing ? &*s.existing : nullptr;
  AXIOMETRY_TRY(const compensation::Fit fit, in_file(table_by(s, request.method), name));
  AXIOMETRY_TRY(std::string text, in_file(write_over_targets(*control, fit.correction, s.series, s.options), name));
  AXIOMETRY_TRY(AxisCorrection applied, in_file(proved(s, text, before), name));

  std::vector<NamedFinding> findings = findings_of_state(test, s.curves, s.existing.has_value());
  if (!measures_axis) findings.push_back(finding_of_kept_table(measures_axis.error()));
  std::ranges::move(compensation::findings_of_readings(test.series, s.options.kind, s.curves),
                    std::back_inserter(findings));
  std::ranges::move(compensation::findings_of_table(test.series, fit.correction, s.control.limits.rolls_over),
                    std::back_inserter(findings));
  if (periodic)
    std::ranges::move(compensation::findings_of_periodic(*periodic, request.periodic, s.nodes, s.options.kind),
                      std::back_inserter(findings));
  add_findings_of_control(s, applied, findings);
  AXIOMETRY_TRY(const compensation::Fit plain, in_file(table_by(s, compensation::Method::interpolation), name));
  AXIOMETRY_TRY(const Evaluation interpolated, evaluated_with(test.series, plain.correction, removed));
  AXIOMETRY_TRY(const Evaluation fitted, evaluated_with(test.series, fit.correction, removed));
  AXIOMETRY_TRY(const Series corrected, compensation::corrected_series(test.series, applied, removed));
  AXIOMETRY_TRY(const Series scatter, compensation::scatter_alone(test.series));
  auto expected = compensation::expected_retest(corrected);
  AXIOMETRY_TRY_VOID(in_file(check_worth_it(before, expected, scatter, s), name));
  if (axis.retest && most_runs_made(axis.retest->test.series) != most_runs_made(test.series))
    expected = compensation::expected_retest(corrected, {.runs = most_runs_made(axis.retest->test.series)});
  AXIOMETRY_TRY(auto known,
                in_file(compensation::compensated_positions(test, {applied, fit.correction, removed}), name));
  std::optional<Retest> retest;
  if (axis.retest) {
    AXIOMETRY_TRY(retest, retest_of(*std::move(axis.retest), test, {applied, expected}, s, findings));
  }
  if (request.axis.empty() && test.metadata.axis.name.empty())
    findings.push_back({"compensation-axis-assumed", false, "nobody names the axis: the table is made for X"});
  std::ranges::stable_partition(findings, &NamedFinding::serious);
  return CompensatedAxis{.test = std::move(test),
                         .control = control,
                         .options = s.options,
                         .text = std::move(text),
                         .applied = std::move(applied),
                         .existing = std::move(s.existing),
                         .periodic_choice = request.periodic,
                         .periodic = std::move(periodic),
                         .smoothing = fit.smoothing,
                         .before = before,
                         .predicted = iso230_2::evaluate(corrected),
                         .interpolated = interpolated.parameters,
                         .fitted = fitted.parameters,
                         .scatter = compensation::tells_scatter(scatter) ? iso230_2::evaluate(scatter).parameters
                                                                         : iso230_2::AxisParameters{},
                         .expected = expected,
                         .known = std::move(known),
                         .retest = std::move(retest),
                         .findings = std::move(findings)};
}

}  // namespace axiometry::app
