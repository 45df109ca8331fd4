// SPDX-License-Identifier: Apache-2.0
//
// What must hold for every series, whatever its readings. evaluate() itself checks the ordering of the
// parameters as a contract; here it is stated again, from the outside.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "tests/support/series.h"

namespace axiometry::iso230_2 {
namespace {

using testing_support::make_series;
using testing_support::RunDeviations;
using Value = std::optional<Deviation>;

constexpr double missing_value = std::numeric_limits<double>::quiet_NaN();

/// Readings as a table: up[j][i] and down[j][i], NaN where missing.
struct Table {
  std::vector<double> targets;
  std::vector<RunDeviations> up;
  std::vector<RunDeviations> down;

  Series series() const { return make_series(targets, up, down); }
};

/// Deviations on a grid of 0.1 µm within ±100 µm: what instruments print.
double any_deviation() { return *rc::gen::inRange(-1000, 1001) / 10.0; }

std::vector<double> any_targets(std::size_t count) {
  std::vector<double> targets;
  double position = *rc::gen::inRange(-500000, 500000) / 1000.0;
  for (std::size_t i = 0; i < count; ++i) {
    targets.push_back(position);
    position += *rc::gen::inRange(1, 300000) / 1000.0;
  }
  return targets;
}

std::vector<RunDeviations> any_runs(std::size_t runs, std::size_t targets) {
  std::vector<RunDeviations> result(runs, RunDeviations(targets));
  for (RunDeviations& run : result)
    for (double& x : run) x = any_deviation();
  return result;
}

Table any_table(int fewest_runs = 1) {
  const auto m = static_cast<std::size_t>(*rc::gen::inRange(2, 14));
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(fewest_runs, 8));
  return {any_targets(m), any_runs(n, m), any_runs(n, m)};
}

/// Takes readings away, but leaves every target one.
Table with_gaps(Table table) {
  for (std::size_t i = 0; i < table.targets.size(); ++i) {
    std::vector<double*> cells;
    for (auto* runs : {&table.up, &table.down})
      for (RunDeviations& run : *runs) cells.push_back(&run[i]);
    const auto kept = static_cast<std::size_t>(*rc::gen::inRange<int>(0, static_cast<int>(cells.size())));
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (k != kept && *rc::gen::inRange(0, 3) == 0) *cells[k] = missing_value;
  }
  return table;
}

double number(Value value) { return value ? value->in_native() : missing_value; }

void expect_equal(Value got, double expected, double tolerance) {
  if (std::isnan(expected)) {
    RC_ASSERT(!got);
  } else {
    RC_ASSERT(got.has_value());
    RC_ASSERT(std::abs(got->in_native() - expected) <= tolerance);
  }
}

void expect_at_least(Value larger, Value smaller) {
  if (larger && smaller) RC_ASSERT(larger->in_native() >= smaller->in_native() - 1e-9);
}

void expect_ordering(const AxisParameters& p) {
  for (Value smaller : {p.E_up, p.E_down, p.M, p.B}) expect_at_least(p.E, smaller);
  for (Value smaller : {p.E, p.A_up, p.A_down, p.R}) expect_at_least(p.A, smaller);
  for (Value smaller : {p.R_up, p.R_down, p.B}) expect_at_least(p.R, smaller);
  if (p.B_mean) RC_ASSERT(std::abs(number(p.B_mean)) <= number(p.B) + 1e-9);
}

void expect_same(const AxisParameters& a, const AxisParameters& b, double factor = 1.0) {
  for (const ParameterInfo& info : parameters) expect_equal(a.*info.member, factor * number(b.*info.member), 1e-9);
}

Table transformed(Table table, auto&& change) {
  for (auto* runs : {&table.up, &table.down})
    for (RunDeviations& run : *runs)
      for (double& x : run) x = change(x);
  return table;
}

RC_GTEST_PROP(Parameters, AreOrdered, ()) { expect_ordering(evaluate(any_table().series()).parameters); }

RC_GTEST_PROP(Parameters, AreOrderedWhateverIsMissing, ()) {
  const Table table = with_gaps(any_table());
  expect_ordering(evaluate(table.series()).parameters);
}

RC_GTEST_PROP(Parameters, DoNotSeeAShiftOfTheDatum, ()) {
  const Table table = any_table();
  const double shift = any_deviation() * 9.0;
  const Table shifted = transformed(table, [&](double x) { return x + shift; });
  expect_same(evaluate(shifted.series()).parameters, evaluate(table.series()).parameters);
}

RC_GTEST_PROP(Parameters, ScaleWithTheReadings, ()) {
  const Table table = any_table();
  const double factor = *rc::gen::inRange(1, 100) / 10.0;
  const Table scaled = transformed(table, [&](double x) { return factor * x; });
  expect_same(evaluate(scaled.series()).parameters, evaluate(table.series()).parameters, factor);
}

RC_GTEST_PROP(Parameters, SwapDirectionsWhenTheAxisIsReversed, ()) {
  const Table table = with_gaps(any_table());
  Table reversed = transformed(table, [](double x) { return -x; });
  std::swap(reversed.up, reversed.down);
  for (auto* runs : {&reversed.up, &reversed.down})
    for (RunDeviations& run : *runs) std::ranges::reverse(run);
  std::ranges::reverse(reversed.targets);
  for (double& target : reversed.targets) target = -target;
  const AxisParameters a = evaluate(table.series()).parameters;
  const AxisParameters b = evaluate(reversed.series()).parameters;
  const AxisParameters expected{a.A, a.A_down, a.A_up,   a.E,    a.E_down, a.E_up,
                                a.M, a.R,      a.R_down, a.R_up, a.B,      a.B_mean};
  expect_same(b, expected);
}

RC_GTEST_PROP(Parameters, NegateTheMeanReversalWhenTheDirectionsAreSwapped, ()) {
  const Table table = any_table();
  Table swapped = table;
  std::swap(swapped.up, swapped.down);
  const AxisParameters a = evaluate(table.series()).parameters;
  const AxisParameters b = evaluate(swapped.series()).parameters;
  expect_equal(b.B_mean, -number(a.B_mean), 1e-9);
  expect_equal(b.A_up, number(a.A_down), 0.0);
  expect_equal(b.R_up, number(a.R_down), 0.0);
  expect_equal(b.E_up, number(a.E_down), 0.0);
  for (auto member :
       {&AxisParameters::A, &AxisParameters::E, &AxisParameters::M, &AxisParameters::R, &AxisParameters::B})
    expect_equal(b.*member, number(a.*member), 1e-9);
}

RC_GTEST_PROP(Parameters, DoNotDependOnTheOrderOfTheRuns, ()) {
  const Table table = any_table();
  Table turned = table;
  std::ranges::rotate(turned.up, turned.up.begin() + *rc::gen::inRange<int>(0, static_cast<int>(turned.up.size())));
  std::ranges::reverse(turned.down);
  expect_same(evaluate(turned.series()).parameters, evaluate(table.series()).parameters);
}

RC_GTEST_PROP(Estimator, IsNotRaisedByARunEqualToTheMean, ()) {
  Table table = any_table(2);
  const auto before = evaluate_positions(table.series());
  RunDeviations mean_up, mean_down;
  for (const PositionResult& p : before) {
    mean_up.push_back(number(p.mean_up));
    mean_down.push_back(number(p.mean_down));
  }
  table.up.push_back(mean_up);
  table.down.push_back(mean_down);
  const auto after = evaluate_positions(table.series());
  for (std::size_t i = 0; i < before.size(); ++i) {
    RC_ASSERT(number(after[i].s_up) <= number(before[i].s_up) + 1e-12);
    RC_ASSERT(number(after[i].s_down) <= number(before[i].s_down) + 1e-12);
  }
}

RC_GTEST_PROP(SingleApproach, HasNeitherScatterNorWhatRestsOnIt, ()) {
  const auto m = static_cast<std::size_t>(*rc::gen::inRange(2, 14));
  const Table table{any_targets(m), any_runs(1, m), any_runs(1, m)};
  const Evaluation e = evaluate(table.series());
  for (auto member : {&AxisParameters::A, &AxisParameters::A_up, &AxisParameters::A_down, &AxisParameters::R,
                      &AxisParameters::R_up, &AxisParameters::R_down})
    RC_ASSERT(!(e.parameters.*member));
  for (auto member : {&AxisParameters::E, &AxisParameters::M, &AxisParameters::B, &AxisParameters::B_mean})
    RC_ASSERT((e.parameters.*member).has_value());
  for (const PositionResult& p : e.positions) RC_ASSERT(!p.s_up && !p.s_down && !p.R_up && !p.R_down && !p.R);
}

/// Clause 3 once more, written down line by line in long double and without any care for speed or gaps.
struct Oracle {
  long double A, A_up, A_down, E, E_up, E_down, M, R, R_up, R_down, B, B_mean;
};

Oracle brute_force(const Table& table) {
  const std::size_t m = table.targets.size();
  std::vector<long double> xu, xd, xm, lo_u, hi_u, lo_d, hi_d, Ru, Rd, Ri, Bi;
  const auto mean_and_s = [](const std::vector<RunDeviations>& runs, std::size_t i) {
    const long double n = runs.size();
    long double mean = 0, squares = 0;
    for (const RunDeviations& run : runs) mean += run[i] / n;
    for (const RunDeviations& run : runs) squares += (run[i] - mean) * (run[i] - mean);
    return std::pair(mean, std::sqrt(squares / (n - 1)));
  };
  for (std::size_t i = 0; i < m; ++i) {
    const auto [u, su] = mean_and_s(table.up, i);
    const auto [d, sd] = mean_and_s(table.down, i);
    xu.push_back(u), xd.push_back(d), xm.push_back((u + d) / 2), Bi.push_back(u - d);
    lo_u.push_back(u - 2 * su), hi_u.push_back(u + 2 * su), lo_d.push_back(d - 2 * sd), hi_d.push_back(d + 2 * sd);
    Ru.push_back(4 * su), Rd.push_back(4 * sd);
    Ri.push_back(std::max({2 * su + 2 * sd + std::abs(u - d), 4 * su, 4 * sd}));
  }
  const auto hi = [](const std::vector<long double>& v) { return *std::ranges::max_element(v); };
  const auto lo = [](const std::vector<long double>& v) { return *std::ranges::min_element(v); };
  long double B = 0, sum = 0;
  for (long double b : Bi) B = std::max(B, std::abs(b)), sum += b;
  return {std::max(hi(hi_u), hi(hi_d)) - std::min(lo(lo_u), lo(lo_d)),
          hi(hi_u) - lo(lo_u),
          hi(hi_d) - lo(lo_d),
          std::max(hi(xu), hi(xd)) - std::min(lo(xu), lo(xd)),
          hi(xu) - lo(xu),
          hi(xd) - lo(xd),
          hi(xm) - lo(xm),
          hi(Ri),
          hi(Ru),
          hi(Rd),
          B,
          sum / static_cast<long double>(m)};
}

RC_GTEST_PROP(Parameters, AgreeWithABruteForceOracle, ()) {
  const Table table = any_table(2);
  const AxisParameters p = evaluate(table.series()).parameters;
  const Oracle o = brute_force(table);
  const long double expected[] = {o.A, o.A_up, o.A_down, o.E,      o.E_up, o.E_down,
                                  o.M, o.R,    o.R_up,   o.R_down, o.B,    o.B_mean};
  for (std::size_t k = 0; k < std::size(parameters); ++k)
    expect_equal(p.*parameters[k].member, static_cast<double>(expected[k]), 1e-9);
}

RC_GTEST_PROP(Assessment, AnswersEverySeries, ()) {
  const Table table = with_gaps(any_table());
  Metadata metadata;
  metadata.axis.kind = *rc::gen::element(AxisKind::linear, AxisKind::rotary);
  if (*rc::gen::arbitrary<bool>()) metadata.uncertainty.environmental_variation = Deviation::native(1.7);
  if (*rc::gen::arbitrary<bool>()) metadata.uncertainty.device_calibration = Deviation::native(1.0);
  const iso230_2::Assessment a = assess({metadata, table.series(), {}});
  for (std::size_t k = 1; k < a.findings.size(); ++k) RC_ASSERT(a.findings[k - 1].severity <= a.findings[k].severity);
  for (const ParameterInfo& info : parameters)
    if (a.annex_a && a.annex_a->U.*info.member) RC_ASSERT((a.evaluation.parameters.*info.member).has_value());
  if (a.annex_a && a.annex_a->corrected) {
    const AxisParameters& corrected = a.annex_a->corrected->parameters;
    expect_at_least(a.evaluation.parameters.R, corrected.R);
    expect_at_least(a.evaluation.parameters.R_up, corrected.R_up);
    expect_at_least(corrected.R, corrected.B);
  }
}

}  // namespace
}  // namespace axiometry::iso230_2
