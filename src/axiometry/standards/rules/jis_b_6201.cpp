// SPDX-License-Identifier: Apache-2.0
//
// As a maker's manual applies JIS B 6201 and JIS B 6330. That repeatability and lost motion are taken at the middle and
// at both ends is told by others, and so is what is made of it. Seven approaches to each place are what the rule asks
// for; of more, the first seven count. A series of fewer gives neither figure.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {
namespace {

constexpr std::size_t approaches_to_a_place = 7;
constexpr std::string_view needs_seven = "needs seven approaches to both ends and the middle from this direction";
constexpr std::string_view needs_seven_from_both =
    "needs seven approaches to both ends and the middle from each direction";

/// Range of the deviations of the first run of a direction.
template <Direction direction>
RuleValue range_of_one_pass(const RuleCase& c) {
  if (!c.series.has(direction)) return std::unexpected(needs_this_direction);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (std::size_t i = 0; i < c.series.target_count(); ++i) {
    const auto x = c.series.reading(i, direction, 0);
    if (!x) return std::unexpected("needs a reading at every target in the first run");
    lowest = std::min(lowest, x->in_native());
    highest = std::max(highest, x->in_native());
  }
  return Deviation::native(highest - lowest);
}

/// Both ends and the target nearest the middle between them, the lower one of two.
std::array<std::size_t, 3> three_places(const Series& series) {
  const auto targets = series.targets();
  const double middle = (targets.front().in_native() + targets.back().in_native()) / 2.0;
  const auto nearest = std::ranges::min_element(
      targets, {}, [&](const Position& target) { return std::abs(target.in_native() - middle); });
  return {0, static_cast<std::size_t>(nearest - targets.begin()), targets.size() - 1};
}

struct SevenApproaches {
  std::size_t count = 0;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  double sum = 0.0;

  bool complete() const { return count == approaches_to_a_place; }
  double mean() const { return sum / static_cast<double>(count); }
};

SevenApproaches seven_approaches(const Series& series, std::size_t target, Direction direction) {
  SevenApproaches seven;
  for (const double x : series.cell(target, direction)) {
    if (std::isnan(x) || seven.complete()) continue;
    ++seven.count;
    seven.sum += x;
    seven.lowest = std::min(seven.lowest, x);
    seven.highest = std::max(seven.highest, x);
  }
  return seven;
}

template <Direction direction>
RuleValue half_range_of_seven(const RuleCase& c) {
  if (!c.series.has(direction)) return std::unexpected(needs_this_direction);
  double worst = 0.0;
  for (const std::size_t place : three_places(c.series)) {
    const SevenApproaches seven = seven_approaches(c.series, place, direction);
    if (!seven.complete()) return std::unexpected(needs_seven);
    worst = std::max(worst, (seven.highest - seven.lowest) / 2.0);
  }
  return Deviation::native(worst);
}

RuleValue lost_motion(const RuleCase& c) {
  if (!c.series.has_both_directions()) return std::unexpected(needs_both_directions);
  double worst = 0.0;
  for (const std::size_t place : three_places(c.series)) {
    const SevenApproaches up = seven_approaches(c.series, place, Direction::up);
    const SevenApproaches down = seven_approaches(c.series, place, Direction::down);
    if (!up.complete() || !down.complete()) return std::unexpected(needs_seven_from_both);
    worst = std::max(worst, std::abs(up.mean() - down.mean()));
  }
  return Deviation::native(worst);
}

constexpr std::string_view of_one_pass = "the range of one pass, without any scatter";
constexpr std::string_view half_a_range = "half the range of seven approaches at three places in place of 4 s at all";

constexpr auto pass_figures = std::to_array<RuleFigure>({
    {"positioning_up", "", "Positioning accuracy of one pass ↑", "", Evidence::makers_text, "A_up", of_one_pass, false,
     range_of_one_pass<Direction::up>, true},
    {"positioning_down", "", "Positioning accuracy of one pass ↓", "", Evidence::makers_text, "A_down", of_one_pass,
     false, range_of_one_pass<Direction::down>, true},
    {"repeatability_up", "", "Repeatability ↑, ± half the range", "", Evidence::second_hand, "R_up", half_a_range,
     false, half_range_of_seven<Direction::up>, true},
    {"repeatability_down", "", "Repeatability ↓, ± half the range", "", Evidence::second_hand, "R_down", half_a_range,
     false, half_range_of_seven<Direction::down>, true},
    {"lost_motion", "", "Lost motion", "", Evidence::second_hand, "B", "at three places in place of all", false,
     lost_motion, true},
});

/// Seven passes over the travel are not seven approaches one after the other.
std::vector<iso230_2::Finding> pass_findings(const RuleCase& c) {
  std::vector<iso230_2::Finding> all;
  const bool is_taken = half_range_of_seven<Direction::up>(c) || half_range_of_seven<Direction::down>(c);
  if (is_taken && c.metadata.conditions.cycle != TestCycle::step)
    all.push_back({"jis-b-6201-runs-for-approaches", "", iso230_2::Severity::note,
                   "repeatability and lost motion are taken of seven runs, expected approaches to one place one after "
                   "the other: a drift between the runs is in them"});
  return all;
}

}  // namespace

extern const AxisRule jis_b_6201_axis_rule;
const AxisRule jis_b_6201_axis_rule = {
    .id = "jis-b-6201",
    .name = "JIS B 6201, JIS B 6330",
    .remark = "as a maker applies them, as far as a series over the travel gives it",
    .linear_only = false,
    .figures = pass_figures,
    .findings = pass_findings,
    .cycle =
        AskedCycle{.evidence = Evidence::makers_text, .approaches = approaches_to_a_place, .order = TestCycle::step},
};

}  // namespace axiometry::standards
