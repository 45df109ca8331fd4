// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/face_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "axiometry/standards/error_motions/motion_estimate.h"

namespace axiometry::tracking {
namespace {

struct Face {
  std::string_view name, first, second, term;
  std::size_t a, b;  // axes of the face
  double sign;       // sign of the term when the angle between the axes grows
};
constexpr std::array<Face, 3> faces = {{{"XY", "NN0-PP0", "NP0-PN0", "C0Y", 0, 1, 1.0},
                                        {"XZ", "N0N-P0P", "N0P-P0N", "B0Z", 0, 2, -1.0},
                                        {"YZ", "0NN-0PP", "0NP-0PN", "A0Z", 1, 2, 1.0}}};

/// Whether the lines go as the diagonals of that face do: over the same legs, one up and one down the second axis.
bool are_diagonals(const Face& face, Vector3 first, Vector3 second) {
  constexpr double least_leg = 1e-6, tolerance = 1e-3;
  const std::size_t standing = 3 - face.a - face.b;
  const double a = first[face.a], b = first[face.b];
  return a > least_leg && b > least_leg && std::abs(second[face.a] - a) <= tolerance * a &&
         std::abs(second[face.b] + b) <= tolerance * b && std::abs(first[standing]) <= tolerance &&
         std::abs(second[standing]) <= tolerance;
}

bool is_stated(double uncertainty) { return std::isfinite(uncertainty) && uncertainty > 0.0; }

}  // namespace

std::vector<FacePair> face_pairs(std::span<const LineSlope> slopes) {
  std::vector<FacePair> pairs;
  for (const Face& face : faces) {
    const auto first = std::ranges::find(slopes, face.first, &LineSlope::id);
    const auto second = std::ranges::find(slopes, face.second, &LineSlope::id);
    if (first == slopes.end() || second == slopes.end()) continue;
    const Vector3 u = unit(first->direction);
    if (!are_diagonals(face, u, unit(second->direction))) continue;
    const double twice = 2.0 * u[face.a] * u[face.b];
    const double difference = first->slope_um_per_m - second->slope_um_per_m;
    FacePair pair{std::string(face.name),
                  std::string(face.first),
                  std::string(face.second),
                  std::string(face.term),
                  difference,
                  -face.sign * difference / twice,
                  {},
                  2.0};
    if (is_stated(first->uncertainty_um_per_m) && is_stated(second->uncertainty_um_per_m)) {
      const error_motions::ScatterPart parts[] = {{first->uncertainty_um_per_m, first->degrees_of_freedom},
                                                  {second->uncertainty_um_per_m, second->degrees_of_freedom}};
      pair.coverage_factor = error_motions::coverage_of(error_motions::combined_scatter(parts).degrees);
      pair.uncertainty_um_per_m =
          std::hypot(first->uncertainty_um_per_m, second->uncertainty_um_per_m) / std::abs(twice);
    }
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::vector<FacePair> face_pairs(std::span<const EvaluatedLine> lines) {
  std::vector<LineSlope> slopes;
  for (const EvaluatedLine& line : lines)
    if (const auto way = spatial_line(line.test.metadata.axis))
      slopes.push_back({line.id, way->direction, line.slope_um_per_m, line.slope_uncertainty_um_per_m,
                        line.test.series.travel_native(), line.slope_degrees_of_freedom});
  return face_pairs(slopes);
}

}  // namespace axiometry::tracking
