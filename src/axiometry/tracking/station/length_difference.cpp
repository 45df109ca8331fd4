// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/length_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/standards/readings/station_offset.h"

namespace axiometry::tracking {
namespace {

/// Δ along the line and across it.
struct Split {
  double along_mm;
  double across_mm;
};
Split split(Vector3 error_mm, Vector3 direction) {
  return {dot(error_mm, direction), norm(cross(direction, error_mm))};
}

/// d̂(1 − cos α): how much longer the actual distance is than its part along the line. Where the station was determined
/// beyond the target, that part is negative, and the plain difference does not cancel.
double excess_mm(const Split& error, double distance_mm) {
  const double along = error.along_mm + distance_mm;
  const double actual = std::hypot(along, error.across_mm);
  if (along < 0.0) return actual - along;
  return actual == 0.0 ? 0.0 : error.across_mm * (error.across_mm / (actual + along));
}

}  // namespace

std::vector<LengthDifference> length_differences(Vector3 station_error_mm, Vector3 direction,
                                                 std::span<const double> distances_mm, std::size_t reference) {
  AXIOMETRY_CONTRACT(reference < distances_mm.size());
  const Split error = split(station_error_mm, direction);
  const double at_reference = excess_mm(error, distances_mm[reference]);
  std::vector<LengthDifference> list;
  list.reserve(distances_mm.size());
  for (const double d : distances_mm) {
    const double alpha = std::atan2(error.across_mm, error.along_mm + d);
    list.push_back({Angle::deg(alpha * 180.0 / std::numbers::pi), Length::mm(excess_mm(error, d) - at_reference)});
  }
  return list;
}

std::vector<Length> combined_length_differences(Vector3 station_error_mm, std::span<const double> distances_mm,
                                                std::size_t reference) {
  const auto x = length_differences(station_error_mm, {1, 0, 0}, distances_mm, reference);
  const auto y = length_differences(station_error_mm, {0, 1, 0}, distances_mm, reference);
  const auto z = length_differences(station_error_mm, {0, 0, 1}, distances_mm, reference);
  std::vector<Length> list;
  list.reserve(x.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    list.push_back(Length::mm(std::hypot(x[k].difference.in_mm(), y[k].difference.in_mm(), z[k].difference.in_mm())));
  return list;
}

OffsetUncertainty offset_uncertainty(const Matrix3& covariance_mm2, Vector3 direction) {
  // Two directions across the line; the first from the axis that is least along it.
  const std::array<double, 3> size = {std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
  Vector3 least{};
  least[static_cast<std::size_t>(std::ranges::min_element(size) - size.begin())] = 1.0;
  const Vector3 first = unit(cross(direction, least)), second = cross(direction, first);
  const double a = quadratic(first, covariance_mm2, first), c = quadratic(second, covariance_mm2, second);
  const double b = (quadratic(first, covariance_mm2, second) + quadratic(second, covariance_mm2, first)) / 2.0;
  const double middle = (a + c) / 2.0, half = std::hypot((a - c) / 2.0, b);
  return {std::sqrt(std::max(0.0, middle + half)), std::sqrt(std::max(0.0, middle - half))};
}

double squared_offset_quantile_mm2(const OffsetUncertainty& offset, double probability) {
  const auto [smaller, larger] = std::minmax(offset.smaller_mm, offset.larger_mm);
  return offset_squared_quantile({.at = {}, .larger_mm = larger, .smaller_mm = smaller}, probability);
}

std::vector<Length> length_difference_bounds(const OffsetUncertainty& offset, std::span<const double> distances_mm,
                                             std::size_t reference) {
  AXIOMETRY_CONTRACT(reference < distances_mm.size());
  const double q = squared_offset_quantile_mm2(offset, 0.95);
  std::vector<Length> list;
  list.reserve(distances_mm.size());
  for (const double d : distances_mm)
    list.push_back(Length::mm(q / 2.0 * std::abs(1.0 / d - 1.0 / distances_mm[reference])));
  return list;
}

double negligible_from_mm(const OffsetUncertainty& offset, const RangingUncertainty& ranging, double fraction) {
  const double q = squared_offset_quantile_mm2(offset, 0.95);
  if (q == 0.0) return 0.0;
  const double a = fraction * ranging.constant.in_mm(), b = fraction * ranging.per_length.in_um_per_m() * 1e-6;
  if (a <= 0.0 && b <= 0.0) return std::numeric_limits<double>::infinity();
  // b d² + a d = q/2, solved without cancellation.
  return q / (a + std::sqrt(a * a + 2.0 * b * q));
}

}  // namespace axiometry::tracking
