// SPDX-License-Identifier: Apache-2.0
//
// Piezo stages. Accuracy, unidirectional repeatability and linearity are told for each direction by itself.
// Straightness is no matter of a positioning test and is left out.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "axiometry/standards/iso230_2/programme.h"
#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {
namespace {

constexpr std::size_t positions_asked = 11;
constexpr std::size_t approaches_for_accuracy = 5;
constexpr std::size_t approaches_for_repeatability = 10;
constexpr std::size_t approaches_for_both = 6;

/// max |x̄_i|
template <Direction direction>
RuleValue largest_mean(const RuleCase& c) {
  if (const auto lack = lack_of_means(c, direction); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(largest(c, [](const auto& p) { return std::abs(mean_of(p, direction)->in_native()); }));
}

/// max s_i
template <Direction direction>
RuleValue largest_scatter(const RuleCase& c) {
  if (const auto lack = lack_of_scatter(c, direction); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(largest(c, [](const auto& p) { return s_of(p, direction)->in_native(); }));
}

/// √(Σ_j (x_ij − centre)²/(m − 1)) over the m runs after the first.
double spread_about(std::span<const double> later, double centre) {
  double squares = 0.0;
  for (const double x : later) squares += (x - centre) * (x - centre);
  return std::sqrt(squares / static_cast<double>(later.size() - 1));
}

double mean_of_runs(std::span<const double> runs) {
  double sum = 0.0;
  for (const double x : runs) sum += x;
  return sum / static_cast<double>(runs.size());
}

/// The first run dropped; of either direction about the mean of both.
RuleValue bidirectional_repeatability(const RuleCase& c) {
  if (!c.series.has_both_directions()) return std::unexpected(needs_both_directions);
  if (!c.series.complete()) return std::unexpected("needs every reading of every run");
  constexpr std::size_t dropped = 1;
  if (c.series.run_count() < dropped + 2)
    return std::unexpected("needs three runs or more, of which the first is dropped");
  double worst = 0.0;
  for (std::size_t i = 0; i < c.series.target_count(); ++i) {
    const auto up = c.series.cell(i, Direction::up).subspan(dropped);
    const auto down = c.series.cell(i, Direction::down).subspan(dropped);
    const double centre = (mean_of_runs(up) + mean_of_runs(down)) / 2.0;
    worst = std::max({worst, spread_about(up, centre), spread_about(down, centre)});
  }
  return Deviation::native(worst);
}

RuleValue hysteresis(const RuleCase& c) {
  if (const auto lack = lack_of_reversal(c); !lack.empty()) return std::unexpected(lack);
  return Deviation::native(largest_reversal(c));
}

/// Largest residual of the means about their least-squares line over the targets.
template <Direction direction>
RuleValue largest_residual(const RuleCase& c) {
  if (const auto lack = lack_of_means(c, direction); !lack.empty()) return std::unexpected(lack);
  const auto positions = c.positions();
  const double m = static_cast<double>(positions.size());
  double target_sum = 0.0, mean_sum = 0.0;
  for (const auto& p : positions) {
    target_sum += p.target.in_native();
    mean_sum += mean_of(p, direction)->in_native();
  }
  const double target_centre = target_sum / m, mean_centre = mean_sum / m;
  double products = 0.0, squares = 0.0;
  for (const auto& p : positions) {
    const double from_centre = p.target.in_native() - target_centre;
    products += from_centre * (mean_of(p, direction)->in_native() - mean_centre);
    squares += from_centre * from_centre;
  }
  const double slope = products / squares;  // two targets differ: a Series is strictly ascending
  return Deviation::native(largest(c, [&](const auto& p) {
    return std::abs(mean_of(p, direction)->in_native() - mean_centre - slope * (p.target.in_native() - target_centre));
  }));
}

constexpr std::string_view from_the_target = "the largest distance from the target in place of a range with 4 s";
constexpr std::string_view one_s = "1 s in place of 4 s";

constexpr auto piezo_figures = std::to_array<RuleFigure>({
    {"accuracy_up", "", "Positioning accuracy ↑", "", Evidence::text, "A_up", from_the_target, false,
     largest_mean<Direction::up>, false, true},
    {"accuracy_down", "", "Positioning accuracy ↓", "", Evidence::text, "A_down", from_the_target, false,
     largest_mean<Direction::down>, false, true},
    {"repeatability_up", "", "Unidirectional repeatability ↑", "", Evidence::text, "R_up", one_s, false,
     largest_scatter<Direction::up>},
    {"repeatability_down", "", "Unidirectional repeatability ↓", "", Evidence::text, "R_down", one_s, false,
     largest_scatter<Direction::down>},
    {"repeatability", "", "Bidirectional repeatability", "", Evidence::text, "R",
     "1 s about the mean of both directions, without the first run", false, bidirectional_repeatability, true},
    {"hysteresis", "", "Hysteresis, largest reversal", "", Evidence::text, "B", "", true, hysteresis},
    {"linearity_up", "", "Linearity ↑, largest residual", "", Evidence::text, "", "", true,
     largest_residual<Direction::up>},
    {"linearity_down", "", "Linearity ↓, largest residual", "", Evidence::text, "", "", true,
     largest_residual<Direction::down>},
});

bool equally_spaced(const Series& series) {
  const auto targets = series.targets();
  const double step = series.travel_native() / static_cast<double>(targets.size() - 1);
  for (std::size_t i = 1; i < targets.size(); ++i)
    if (std::abs(targets[i].in_native() - targets[i - 1].in_native() - step) > iso230_2::equal_interval * step)
      return false;
  return true;
}

/// Of T, which hysteresis and linearity are divided by.
void find_ends(const RuleCase& c, std::vector<iso230_2::Finding>& all) {
  const AxisEnds ends = axis_ends(c.metadata.axis);
  if (!ends.lower || !ends.upper) {
    all.push_back({"gb-t-38614-2020-travel-not-stated", "", iso230_2::Severity::missing,
                   "the travel of the axis is not stated, expected targets at both of its ends: T is the measured "
                   "travel"});
    return;
  }
  const double near = iso230_2::same_position.in_native();
  const auto targets = c.series.targets();
  const double from = ends.lower->in_native(), to = ends.upper->in_native();
  if (std::abs(targets.front().in_native() - from) > near || std::abs(targets.back().in_native() - to) > near)
    all.push_back({"gb-t-38614-2020-ends-of-travel", "", iso230_2::Severity::departure,
                   "found no target at one end of the axis travel or at both, expected one at each: T is the measured "
                   "travel"});
}

std::vector<iso230_2::Finding> piezo_findings(const RuleCase& c) {
  std::vector<iso230_2::Finding> all;
  if (c.series.target_count() != positions_asked)
    all.push_back({"gb-t-38614-2020-number-of-targets", "", iso230_2::Severity::departure,
                   fmt::format("found {} targets, expected {}", c.series.target_count(), positions_asked)});
  if (!equally_spaced(c.series))
    all.push_back({"gb-t-38614-2020-equal-steps", "", iso230_2::Severity::departure,
                   "found targets at unequal steps, expected equal ones"});
  find_ends(c, all);
  expect_approaches(c, "gb-t-38614-2020-approaches-for-accuracy", approaches_for_accuracy, "accuracy", all);
  expect_approaches(c, "gb-t-38614-2020-approaches-for-repeatability", approaches_for_repeatability,
                    "unidirectional repeatability", all);
  if (c.series.has_both_directions())
    expect_approaches(c, "gb-t-38614-2020-approaches-for-both", approaches_for_both, "bidirectional repeatability",
                      all);
  return all;
}

}  // namespace

extern const AxisRule gb_t_38614_2020_axis_rule;
const AxisRule gb_t_38614_2020_axis_rule = {
    .id = "gb-t-38614-2020",
    .name = "GB/T 38614-2020",
    .remark = "for piezo stages; hysteresis and linearity are stated as parts of the travel T",
    .linear_only = false,
    .figures = piezo_figures,
    .findings = piezo_findings,
    .cycle = AskedCycle{.evidence = Evidence::text,
                        .approaches = approaches_for_repeatability,
                        .targets = positions_asked,
                        .equal_steps = true,
                        .approaches_are_found = true},
};

}  // namespace axiometry::standards
