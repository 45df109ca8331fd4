// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/error_motions/reference_line.h"

#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/moments.h"

namespace axiometry::error_motions {
namespace {

/// Where the line is told best: the mean of the positions, or the first end.
struct Anchor {
  double position_mm = 0.0;
  double value = 0.0;
  double slope_per_mm = 0.0;
};

Anchor anchored(std::span<const double> positions_mm, std::span<const double> values, Reference reference) {
  AXIOMETRY_CONTRACT(values.size() == positions_mm.size() && values.size() >= 2);
  if (reference == Reference::none) return {positions_mm.front(), 0.0, 0.0};
  const std::vector<double> weights = slope_weights(positions_mm, reference);
  const bool ends = reference == Reference::end_points;
  const double level = ends ? values.front() : numeric::moments(values).mean;
  double slope = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) slope += weights[i] * (values[i] - level);  // Σ w = 0
  return {ends ? positions_mm.front() : numeric::moments(positions_mm).mean, level, slope};
}

}  // namespace

std::string_view reference_key(Reference reference) {
  switch (reference) {
    case Reference::least_squares: return "least-squares";
    case Reference::end_points: return "end-points";
    case Reference::none: break;
  }
  return "none";
}

std::string_view reference_name(Reference reference) {
  switch (reference) {
    case Reference::least_squares: return "least squares";
    case Reference::end_points: return "end points";
    case Reference::none: break;
  }
  return "none";
}

std::optional<Reference> parse_reference(std::string_view key) {
  for (const Reference r : {Reference::least_squares, Reference::end_points, Reference::none})
    if (key == reference_key(r)) return r;
  return std::nullopt;
}

std::vector<double> slope_weights(std::span<const double> positions_mm, Reference reference) {
  AXIOMETRY_CONTRACT(positions_mm.size() >= 2 && positions_mm.front() < positions_mm.back());
  std::vector<double> weights(positions_mm.size(), 0.0);
  if (reference == Reference::none) return weights;
  if (reference == Reference::end_points) {
    weights.back() = 1.0 / (positions_mm.back() - positions_mm.front());
    weights.front() = -weights.back();
    return weights;
  }
  const double middle = numeric::moments(positions_mm).mean;
  double squares = 0.0;
  for (const double x : positions_mm) squares += (x - middle) * (x - middle);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = (positions_mm[i] - middle) / squares;
  return weights;
}

ReferenceLine fit_line(std::span<const double> positions_mm, std::span<const double> values, Reference reference) {
  const Anchor a = anchored(positions_mm, values, reference);
  return {a.value - a.slope_per_mm * a.position_mm, a.slope_per_mm};
}

std::vector<double> line_residuals(std::span<const double> positions_mm, std::span<const double> values,
                                   Reference reference) {
  const Anchor a = anchored(positions_mm, values, reference);
  std::vector<double> rest(values.size());
  for (std::size_t i = 0; i < rest.size(); ++i)
    rest[i] = values[i] - a.value - a.slope_per_mm * (positions_mm[i] - a.position_mm);
  return rest;
}

double slope_arcsec(double slope_um_per_m) {
  return std::atan(1e-6 * slope_um_per_m) * (180.0 * 3600.0 / std::numbers::pi);
}

}  // namespace axiometry::error_motions
