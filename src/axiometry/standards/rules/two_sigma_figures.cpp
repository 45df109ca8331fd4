// SPDX-License-Identifier: Apache-2.0
//
// Mean ± 2 s as in ISO 230-2:2014; only the names are older. Their clause numbers are not known.
#include <array>

#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {
namespace {

using iso230_2::AxisParameters;

std::string_view bidirectional_scatter(const RuleCase& c) { return lack_of_scatter(c); }
std::string_view both_directions(const RuleCase& c) { return lack_of_reversal(c); }
template <Direction direction>
std::string_view scatter(const RuleCase& c) {
  return lack_of_scatter(c, direction);
}
template <Direction direction>
std::string_view means(const RuleCase& c) {
  return lack_of_means(c, direction);
}

template <std::optional<Deviation> AxisParameters::*member, std::string_view (*lack)(const RuleCase&)>
RuleValue of(const RuleCase& c) {
  return parameter_or<member>(c, lack);
}

constexpr auto figures(Evidence evidence) {
  return std::to_array<RuleFigure>({
      {"A", "A", "Bidirectional accuracy of positioning", "", evidence, "A", "", false,
       of<&AxisParameters::A, bidirectional_scatter>},
      {"A_up", "A↑", "Unidirectional accuracy of positioning", "", evidence, "A_up", "", false,
       of<&AxisParameters::A_up, scatter<Direction::up>>},
      {"A_down", "A↓", "Unidirectional accuracy of positioning", "", evidence, "A_down", "", false,
       of<&AxisParameters::A_down, scatter<Direction::down>>},
      {"E", "E", "Bidirectional systematic deviation of positioning", "", evidence, "E", "", false,
       of<&AxisParameters::E, both_directions>},
      {"E_up", "E↑", "Unidirectional systematic deviation of positioning", "", evidence, "E_up", "", false,
       of<&AxisParameters::E_up, means<Direction::up>>},
      {"E_down", "E↓", "Unidirectional systematic deviation of positioning", "", evidence, "E_down", "", false,
       of<&AxisParameters::E_down, means<Direction::down>>},
      {"M", "M", "Range of the mean bidirectional deviations", "", evidence, "M", "", false,
       of<&AxisParameters::M, both_directions>},
      {"R", "R", "Bidirectional repeatability of positioning", "", evidence, "R", "", false,
       of<&AxisParameters::R, bidirectional_scatter>},
      {"R_up", "R↑", "Unidirectional repeatability of positioning", "", evidence, "R_up", "", false,
       of<&AxisParameters::R_up, scatter<Direction::up>>},
      {"R_down", "R↓", "Unidirectional repeatability of positioning", "", evidence, "R_down", "", false,
       of<&AxisParameters::R_down, scatter<Direction::down>>},
      {"B", "B", "Reversal value", "", evidence, "B", "", false, of<&AxisParameters::B, both_directions>},
      {"B_mean", "B̄", "Mean reversal value", "", evidence, "B_mean", "", false,
       of<&AxisParameters::B_mean, both_directions>},
  });
}

constexpr auto second_hand = figures(Evidence::second_hand);
constexpr auto of_a_program = figures(Evidence::program);

}  // namespace

std::span<const RuleFigure> two_sigma_figures(Evidence evidence) {
  return evidence == Evidence::program ? std::span<const RuleFigure>(of_a_program) : second_hand;
}

}  // namespace axiometry::standards
