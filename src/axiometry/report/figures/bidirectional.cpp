// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/plates.h"

namespace axiometry::report::plot {
namespace {

using iso230_2::AxisParameters;

/// "R = R_3 = 8.3 µm"
Runs repeatability_label(std::size_t target, const std::string& value) {
  return {italic("R"), plain(" = "), italic("R"), index_number(target + 1), plain(value)};
}

/// "B = |B_3| = 4.1 µm"
Runs reversal_label(std::size_t target, const std::string& value) {
  return {italic("B"), plain(" = |"), italic("B"), index_number(target + 1), plain("|" + value)};
}

}  // namespace

Plate bidirectional_plate(const Subject& subject, const Options& options) {
  const iso230_2::Evaluation& evaluation = subject.assessment.evaluation;
  Plate plate{.test = subject.test,
              .evaluation = evaluation,
              .options = options,
              .label = subject.assessment.label,
              .directions = {Direction::up, Direction::down},
              .bidirectional_mean = evaluation.parameters.M.has_value(),
              .at_targets = {},
              .at_margin = {}};
  const auto R = extent(evaluation, &AxisParameters::R);
  const auto B = extent(evaluation, &AxisParameters::B);
  using Side = TargetDimension::Side;
  // On the outer sides of their targets, so that the two lines never meet.
  const bool R_is_left_of_B = R && B && R->high_at < B->high_at;
  if (R) {
    const std::string value = shown_value(&AxisParameters::R, subject, options);
    plate.at_targets.push_back({*R, repeatability_label(R->high_at, value), R_is_left_of_B ? Side::left : Side::right});
  }
  if (B) {
    const std::string value = shown_value(&AxisParameters::B, subject, options);
    plate.at_targets.push_back({*B, reversal_label(B->high_at, value), R_is_left_of_B ? Side::right : Side::left});
  }
  for (const Parameter parameter : {&AxisParameters::M, &AxisParameters::E, &AxisParameters::A}) {
    add_at_margin(plate, parameter, subject, options);
  }
  return plate;
}

}  // namespace axiometry::report::plot
