// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: the reference is the farthest target, not the last; Δ∥ is left out.
#include "axiometry/standards/station_offset.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"

namespace axiometry {
namespace {

using uncertainty::Distribution;

constexpr double um_per_mm = 1000.0;
constexpr double largest_mm = 1e6;  // of an uncertainty: beyond, somebody mixed up units

/// Nodes of the quadrature over a quarter of a turn; the integrand is smooth and even at both ends.
constexpr int nodes = 256;

/// P(Δ⊥² > q).
double tail(double u1, double u2, double q) {
  double sum = 0.0;
  for (int k = 0; k <= nodes; ++k) {
    const double angle = std::numbers::pi / 2.0 * k / nodes;
    const double w = std::pow(u1 * std::cos(angle), 2) + std::pow(u2 * std::sin(angle), 2);
    const double value = w > 0.0 ? std::exp(-q / (2.0 * w)) : 0.0;
    sum += k == 0 || k == nodes ? value / 2.0 : value;
  }
  return sum / nodes;
}

}  // namespace

std::string station_offset_problem(const Metadata& metadata) {
  const TrackingInputs& tracking = metadata.tracking;
  const auto& u = tracking.station_uncertainty_mm;
  if (!tracking.station_position && u.empty()) return "";
  if (metadata.axis.kind == AxisKind::rotary) return "a rotary axis has no line beside which a station could stand";
  if (u.empty()) return "its uncertainty was not given (tracking.station_uncertainty_mm)";
  if (!tracking.station_position) return "its position along the line was not given (tracking.station_position)";
  if (u.size() != 2)
    return fmt::format("found {} standard uncertaint{}, expected two, one for each direction across the line", u.size(),
                       u.size() == 1 ? "y" : "ies");
  for (double x : u)
    if (!(x >= 0.0 && x <= largest_mm))
      return fmt::format("found a standard uncertainty of {} mm, expected one from 0 to {:g}", x, largest_mm);
  return "";
}

std::optional<StationOffset> station_offset(const Metadata& metadata) {
  const TrackingInputs& tracking = metadata.tracking;
  if (!tracking.station_position || !station_offset_problem(metadata).empty()) return std::nullopt;
  const auto [smaller, larger] = std::ranges::minmax(tracking.station_uncertainty_mm);
  if (larger == 0.0) return std::nullopt;
  return StationOffset{*tracking.station_position, larger, smaller};
}

StationErrors::StationErrors(std::span<const Position> targets, Position station) {
  AXIOMETRY_CONTRACT(!targets.empty());
  for (const Position& target : targets) {
    const double along = target.in_native() - station.in_native();
    distances_mm_.push_back(std::abs(along));
    signs_.push_back(along < 0.0 ? -1.0 : 1.0);
  }
  reference_ = static_cast<std::size_t>(std::ranges::max_element(distances_mm_) - distances_mm_.begin());
}

double StationErrors::error_um(std::size_t target, double offset_squared_mm2) const {
  if (offset_squared_mm2 == 0.0) return 0.0;
  const auto longer = [&](double d) { return offset_squared_mm2 / (std::sqrt(d * d + offset_squared_mm2) + d); };
  return signs_[target] * um_per_mm * (longer(distances_mm_[target]) - longer(distances_mm_[reference_]));
}

double StationErrors::slope_um_per_mm2(std::size_t target, double offset_squared_mm2) const {
  const auto slope = [&](double d) { return 0.5 / std::sqrt(d * d + offset_squared_mm2); };
  return signs_[target] * um_per_mm * (slope(distances_mm_[target]) - slope(distances_mm_[reference_]));
}

double StationErrors::range_um(double offset_squared_mm2) const {
  double lowest = 0.0;  // the reference has none
  double highest = 0.0;
  for (std::size_t i = 0; i < count(); ++i) {
    const double error = error_um(i, offset_squared_mm2);
    lowest = std::min(lowest, error);
    highest = std::max(highest, error);
  }
  return highest - lowest;
}

double StationErrors::nearest_mm() const { return *std::ranges::min_element(distances_mm_); }

double offset_squared_quantile(const StationOffset& offset, double p) {
  AXIOMETRY_CONTRACT(p > 0.0 && p < 1.0);
  if (offset.larger_mm == 0.0) return 0.0;
  const double u2 = offset.smaller_mm / offset.larger_mm;
  // At most that of u2 = u1, where the square is exponential.
  double low = 0.0;
  double high = -2.0 * std::log1p(-p) * (1.0 + 1e-12);
  for (int k = 0; k < 60; ++k) {
    const double middle = low + (high - low) / 2.0;
    (tail(1.0, u2, middle) > 1.0 - p ? low : high) = middle;
  }
  return high * offset.larger_mm * offset.larger_mm;
}

SquareMoments square_moments(const Distribution& distribution) {
  if (const auto* normal = std::get_if<uncertainty::Normal>(&distribution.form())) {
    const double variance = normal->sd * normal->sd;
    const double square = normal->mean * normal->mean;
    return {square + variance, std::sqrt(2.0 * variance * (variance + 2.0 * square))};
  }
  if (const auto* t = std::get_if<uncertainty::StudentT>(&distribution.form()); t && t->degrees_of_freedom <= 4.0)
    return {distribution.mean() * distribution.mean() + std::pow(distribution.standard_deviation().value_or(0.0), 2),
            std::nullopt};
  constexpr double step = 1.0 / 256.0;
  constexpr int reach = 9 * 256;  // φ(9) is 1e-18
  double total = 0.0, first = 0.0, second = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    const double z = step * k;
    const double weight = std::exp(-z * z / 2.0);
    const double square = std::pow(distribution.from_normal(z), 2);
    total += weight;
    first += weight * square;
    second += weight * square * square;
  }
  const double mean = first / total;
  return {mean, std::sqrt(std::max(0.0, second / total - mean * mean))};
}

}  // namespace axiometry
