// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: the reference is the farthest target, not the last; Δ∥ is left out.
#include "axiometry/standards/readings/station_offset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/base/unit_sizes.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry {
namespace {

using uncertainty::Distribution;

constexpr double largest_mm = 1e6;  // largest uncertainty; beyond it somebody mixed up units

constexpr std::size_t quarter_turn_nodes = 64;

/// w/u1² at the middle of each part of a quarter turn.
std::array<double, quarter_turn_nodes> weights_of(double ratio) {
  std::array<double, quarter_turn_nodes> weights;
  for (std::size_t k = 0; k < quarter_turn_nodes; ++k) {
    const double theta = (static_cast<double>(k) + 0.5) / quarter_turn_nodes * std::numbers::pi / 2.0;
    const double c = std::cos(theta), s = ratio * std::sin(theta);
    weights[k] = c * c + s * s;
  }
  return weights;
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
  double lowest = 0.0;  // the reference has no error
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
  const double larger = offset.larger_mm;
  if (larger == 0.0) return 0.0;
  const double ratio = offset.smaller_mm / larger;
  const std::array<double, quarter_turn_nodes> weights = weights_of(ratio);
  // Between the quantiles of χ²₁ and χ²₂; Newton's steps on F − p, halved where they leave the bracket.
  const double z = numeric::normal_quantile((1.0 + p) / 2.0);
  double low = z * z * (1.0 - 1e-12), high = -2.0 * std::log1p(-p) * (1.0 + 1e-12);
  double q = low + ratio * (high - low);
  for (int step = 0; step < 100; ++step) {
    double tail = 0.0, density = 0.0;
    for (const double w : weights) {
      const double e = std::exp(-q / (2.0 * w)) / quarter_turn_nodes;
      tail += e;
      density += e / (2.0 * w);
    }
    const double excess = (1.0 - p) - tail;  // F − p
    (excess < 0.0 ? low : high) = q;
    const double newton = q - excess / density;
    const double next = newton > low && newton < high ? newton : (low + high) / 2.0;
    if (std::abs(next - q) <= 1e-15 * q) break;
    q = next;
  }
  return q * larger * larger;
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
