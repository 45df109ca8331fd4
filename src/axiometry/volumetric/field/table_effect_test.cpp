// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/table_effect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/volumetric/known_machine_test_support.h"

namespace axiometry::volumetric {
namespace {

using testing::known_identification;
using testing::known_machine;

using AxisErrors = std::array<std::vector<std::array<double, motion_count>>, axis_count>;

/// All 18 curves at as many positions of each axis: as they are, and between `nodes` positions straight.
struct SampledCurves {
  AxisErrors found, straight;
};
SampledCurves sampled(const ErrorModel& model, std::size_t places, std::size_t nodes) {
  SampledCurves curves;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const double from = model.observed().lowest_mm[a], way = model.observed().highest_mm[a] - from;
    curves.found[a].resize(places);
    curves.straight[a].resize(places);
    for (std::size_t m = 0; m < motion_count; ++m) {
      const auto at = [&](double share) { return model.motion({a, m}, from + way * share)->value; };
      std::vector<double> table;
      for (std::size_t k = 0; k < nodes; ++k) table.push_back(at(double(k) / double(nodes - 1)));
      for (std::size_t k = 0; k < places; ++k) {
        const double share = double(k) / double(places - 1), node = share * double(nodes - 1);
        const std::size_t below = std::min(static_cast<std::size_t>(node), nodes - 2);
        curves.found[a][k][m] = at(share);
        curves.straight[a][k][m] = std::lerp(table[below], table[below + 1], node - double(below));
      }
    }
  }
  return curves;
}

/// Errors at as many positions of each axis, less what is taken away.
struct Sampling {
  std::size_t places = 0;
  const AxisErrors& found;
  const AxisErrors* taken = nullptr;  ///< with all squareness
};

struct Displaced {
  Vector3 at_mm, by_um;
};
Displaced displaced(const ErrorModel& model, Vector3 tool, const Sampling& sampling, std::size_t number) {
  ErrorValues errors{};
  Displaced place;
  for (std::size_t a = 0; a < axis_count; ++a, number /= sampling.places) {
    const std::size_t k = number % sampling.places;
    const double share = double(k) / double(sampling.places - 1);
    place.at_mm[a] = std::lerp(model.observed().lowest_mm[a], model.observed().highest_mm[a], share);
    for (std::size_t m = 0; m < motion_count; ++m)
      errors.motions[a][m] = sampling.found[a][k][m] - (sampling.taken != nullptr ? (*sampling.taken)[a][k][m] : 0.0);
  }
  if (sampling.taken == nullptr)
    for (std::size_t s = 0; s < 3; ++s) errors.squareness_urad[s] = model.squareness(static_cast<Squareness>(s))->value;
  place.by_um = displacement_um(model.machine(), errors, place.at_mm, tool);
  return place;
}

using Motion = Eigen::Matrix<double, 6, 1>;

Eigen::Matrix<double, 3, 6> rows_of_motion(Vector3 q) {
  const Vector3 p = 1e-3 * q;
  Eigen::Matrix<double, 3, 6> rows;
  rows << 1, 0, 0, 0, p.z, -p.y, 0, 1, 0, -p.z, 0, p.x, 0, 0, 1, p.y, -p.x, 0;
  return rows;
}

/// The largest of all places, without the motion that fits the grid best: six equations, by no symmetry.
double largest_of_all(const ErrorModel& model, Vector3 tool, const Sampling& all, const Sampling& grid) {
  Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
  Motion right = Motion::Zero();
  for (std::size_t i = 0; i < grid.places * grid.places * grid.places; ++i) {
    const auto [q, f] = displaced(model, tool, grid, i);
    const Eigen::Matrix<double, 3, 6> rows = rows_of_motion(q);
    normal += rows.transpose() * rows;
    right += rows.transpose() * Eigen::Vector3d(f.x, f.y, f.z);
  }
  const Motion motion = normal.ldlt().solve(right);
  double most = 0.0;
  for (std::size_t i = 0; i < all.places * all.places * all.places; ++i) {
    const auto [q, f] = displaced(model, tool, all, i);
    most = std::max(most, (Eigen::Vector3d(f.x, f.y, f.z) - rows_of_motion(q) * motion).norm());
  }
  return most;
}

TEST(TableEffect, CallsLargestWhatIsSoBetweenItsPlacesToo) {
  constexpr std::size_t dense = 81, grid = 12;  // 80 spans: those of the tables are among them
  const auto found = known_identification(known_machine("FXYZ"), 60);
  const ErrorModel& model = found.model;
  for (const Tool& tool : model.machine().tools)
    for (const std::size_t nodes : {5u, 11u}) {
      const auto effect = effect_of_all_errors(model, tool.offset_mm, nodes);
      ASSERT_TRUE(effect);
      const SampledCurves all = sampled(model, dense, nodes), few = sampled(model, grid, nodes);
      const double before = largest_of_all(model, tool.offset_mm, {dense, all.found}, {grid, few.found});
      const double after =
          largest_of_all(model, tool.offset_mm, {dense, all.found, &all.straight}, {grid, few.found, &few.straight});
      EXPECT_NEAR(effect->before.largest.value, before, 0.01 * before) << tool.name << " " << nodes;
      EXPECT_NEAR(effect->after.largest.value, after, 0.01 * after) << tool.name << " " << nodes;
    }
}

}  // namespace
}  // namespace axiometry::volumetric
