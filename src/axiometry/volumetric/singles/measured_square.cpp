// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/singles/measured_square.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "axiometry/base/contract.h"
#include "axiometry/volumetric/singles/single_places.h"

namespace axiometry::volumetric {
namespace {

constexpr double range_slack_mm = 1e-6;  // finer than any axis resolves

struct MeasuredRange {
  double lower_mm = 0.0, upper_mm = 0.0;
};

/// What all given errors of an axis have in common; absent where none is given.
std::optional<MeasuredRange> common_range(const SingleErrors& errors, std::size_t axis) {
  std::optional<MeasuredRange> range;
  for (const SingleMotion& m : errors.motions) {
    if (m.error.axis != axis) continue;
    const double first = m.positions_mm.front(), last = m.positions_mm.back();
    range = range ? MeasuredRange{std::max(range->lower_mm, first), std::min(range->upper_mm, last)}
                  : MeasuredRange{first, last};
  }
  return range;
}

/// Weights of the readings in the slope over a part of their range: those of the curve from end to end of it, whose
/// ends are shared out to the readings beside them.
std::vector<double> slope_weights_within(const std::vector<double>& at_mm, const MeasuredRange& range) {
  std::vector<double> knots = {range.lower_mm};
  for (const double q : at_mm)
    if (q > range.lower_mm + range_slack_mm && q < range.upper_mm - range_slack_mm) knots.push_back(q);
  knots.push_back(range.upper_mm);
  const std::vector<double> of_knots = curve_slope_weights(knots);
  std::vector<double> weights(at_mm.size(), 0.0);
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const auto found = std::ranges::lower_bound(at_mm, knots[k]) - at_mm.begin();
    const auto above = std::clamp<std::size_t>(static_cast<std::size_t>(found), 1, at_mm.size() - 1);
    const double share = std::clamp((knots[k] - at_mm[above - 1]) / (at_mm[above] - at_mm[above - 1]), 0.0, 1.0);
    weights[above - 1] += (1.0 - share) * of_knots[k];
    weights[above] += share * of_knots[k];
  }
  return weights;
}

double root_of_squares(std::span<const double> weights) {
  double sum = 0.0;
  for (const double w : weights) sum += w * w;
  return std::sqrt(sum);
}

double sum_of_magnitudes(std::span<const double> weights) {
  double sum = 0.0;
  for (const double w : weights) sum += std::abs(w);
  return sum;
}

}  // namespace

std::vector<double> curve_slope_weights(const std::vector<double>& at_mm) {
  AXIOMETRY_CONTRACT(at_mm.size() >= 2 && at_mm.front() < at_mm.back());
  const double length = at_mm.back() - at_mm.front(), middle = 0.5 * (at_mm.front() + at_mm.back());
  std::vector<double> weights(at_mm.size(), 0.0);
  for (std::size_t k = 1; k < at_mm.size(); ++k) {
    const double step = at_mm[k] - at_mm[k - 1], from_middle = at_mm[k - 1] - middle;
    const double scale = 12.0 * step / (length * length * length);
    weights[k - 1] += scale * (from_middle / 2.0 + step / 6.0);
    weights[k] += scale * (from_middle / 2.0 + step / 3.0);
  }
  return weights;
}

Result<SingleSquareness> squareness_over_common_range(const SquareMeasurement& measured, const SingleErrors& errors) {
  const auto k = static_cast<std::size_t>(measured.which);
  const SquareLines& wanted = square_lines[k];
  const ErrorMotion one = measured.lines[0].error, two = measured.lines[1].error;
  if (!(one == wanted.first && two == wanted.second) && !(one == wanted.second && two == wanted.first))
    return fail(fmt::format("found {} from the lines {} and {}, expected {} and {}", squareness_names[k],
                            error_name(one), error_name(two), error_name(wanted.first), error_name(wanted.second)));
  double slopes_urad = 0.0, scatter_ratio = 1.0, instrument_ratio = 1.0;
  for (const SquareLine& line : measured.lines) {
    const MeasuredRange own{line.positions_mm.front(), line.positions_mm.back()};
    const MeasuredRange range = common_range(errors, line.error.axis).value_or(own);
    if (!(range.lower_mm < range.upper_mm)) continue;  // the errors have no range: refused with a better reason
    if (own.lower_mm > range.lower_mm + range_slack_mm || own.upper_mm < range.upper_mm - range_slack_mm)
      return fail(
          fmt::format("found the line {} of {} read from {} to {} mm, expected it over the range that the "
                      "errors of {} have in common, from {} to {} mm",
                      error_name(line.error), squareness_names[k], own.lower_mm, own.upper_mm,
                      single_axis_letters[line.error.axis], range.lower_mm, range.upper_mm));
    const std::vector<double> weights = slope_weights_within(line.positions_mm, range);
    for (std::size_t i = 0; i < weights.size(); ++i) slopes_urad += 1e3 * weights[i] * line.values_um[i];
    scatter_ratio = std::max(scatter_ratio, root_of_squares(weights) / root_of_squares(line.weights_per_mm));
    instrument_ratio = std::max(instrument_ratio, sum_of_magnitudes(weights) / sum_of_magnitudes(line.weights_per_mm));
  }
  SingleSquareness squareness{measured.which, wanted.sign * slopes_urad + measured.square_urad, 0.0, true};
  squareness.u_urad = std::hypot(scatter_ratio * measured.u_scatter_urad, instrument_ratio * measured.u_instrument_urad,
                                 measured.u_square_urad);
  for (const SquareLine& line : measured.lines)
    squareness.directions[line.error == wanted.first ? 0 : 1] = line.direction;
  return squareness;
}

}  // namespace axiometry::volumetric
