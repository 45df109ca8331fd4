// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/plates.h"

namespace axiometry::report::plot {
namespace {

using iso230_2::AxisParameters;

/// "R↑ = R_3↑ = 1.9 µm"
Runs repeatability_label(Direction direction, std::size_t target, const std::string& value) {
  const std::string_view a = arrow(direction);
  return {italic("R"), plain(std::string(a) + " = "), italic("R"), index_number(target + 1),
          plain(std::string(a) + value)};
}

/// "2s_3↑ = 0.9 µm"
Runs half_band_label(Direction direction, std::size_t target, const std::string& value) {
  return {plain("2"), italic("s"), index_number(target + 1), plain(std::string(arrow(direction)) + " = " + value)};
}

/// From the mean to the upper boundary.
Extent upper_half_band(const iso230_2::Evaluation& evaluation, const Extent& band, Direction direction) {
  Extent half = band;
  half.low = *mean(evaluation.positions[band.high_at], direction);
  return half;
}

}  // namespace

Plate unidirectional_plate(const Subject& subject, const Options& options, Direction direction) {
  const iso230_2::Evaluation& evaluation = subject.assessment.evaluation;
  const bool up = direction == Direction::up;
  Plate plate{.test = subject.test,
              .evaluation = evaluation,
              .options = options,
              .label = subject.assessment.label,
              .directions = {direction},
              .bidirectional_mean = false,
              .at_targets = {},
              .at_margin = {}};
  const Parameter repeatability = up ? &AxisParameters::R_up : &AxisParameters::R_down;
  if (const auto R = extent(evaluation, repeatability)) {
    using Side = TargetDimension::Side;
    const std::size_t target = R->high_at;
    plate.at_targets.push_back(
        {*R, repeatability_label(direction, target, shown_value(repeatability, subject, options)), Side::right});
    const double half = half_band(evaluation.positions[target], direction);
    const std::string value = shown_deviation(half, subject.test.metadata.axis.kind, options);
    plate.at_targets.push_back(
        {upper_half_band(evaluation, *R, direction), half_band_label(direction, target, value), Side::left});
  }
  add_at_margin(plate, up ? &AxisParameters::E_up : &AxisParameters::E_down, subject, options);
  add_at_margin(plate, up ? &AxisParameters::A_up : &AxisParameters::A_down, subject, options);
  return plate;
}

}  // namespace axiometry::report::plot
