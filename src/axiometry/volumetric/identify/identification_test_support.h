// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/volumetric/machine/kinematics.h"
#include "axiometry/volumetric/machine/volumetric_data.h"

/// A machine whose errors are known, measured by a tracking interferometer: by homogeneous transformations, so that
/// nothing of what identifies them is used.
namespace axiometry::volumetric::test {

/// Sums of two waves per error, of some µm and µrad; smooth enough for eight spans.
class TrueMachine {
 public:
  TrueMachine(const char* chain, unsigned seed) : model({.chain = KinematicChain::make(chain).value()}), random_(seed) {
    model.travel = {{0.0, 0.0, -500.0}, {1000.0, 600.0, 0.0}};
    model.tools = {{"short", {0.0, 0.0, -150.0}}, {"long", {0.0, 0.0, -300.0}}, {"side", {120.0, 60.0, -180.0}}};
    for (auto& axis : waves_)
      for (auto& w : axis) w = {10.0 * normal(), 4.0 * normal(), uniform(0.0, 6.28), uniform(0.0, 6.28)};
    for (double& s : squareness) s = 20.0 * normal();
  }

  double value(ErrorMotion error, double q) const {
    const Wave& w = waves_[error.axis][error.motion];
    const double lower = model.travel.lowest_mm[error.axis], upper = model.travel.highest_mm[error.axis];
    const double x = std::numbers::pi * (q - lower) / (upper - lower);
    return w.first * std::sin(x + w.phase_first) + w.second * std::sin(2.0 * x + w.phase_second);
  }
  ErrorValues errors(Vector3 q) const {
    ErrorValues errors;
    for (std::size_t a = 0; a < axis_count; ++a)
      for (std::size_t m = 0; m < motion_count; ++m) errors.motions[a][m] = value({a, m}, q[a]);
    errors.squareness_urad = squareness;
    return errors;
  }
  double normal() { return normal_(random_); }
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  MachineModel model;
  std::array<double, 3> squareness{};

 private:
  struct Wave {
    double first, second, phase_first, phase_second;
  };
  std::array<std::array<Wave, motion_count>, axis_count> waves_{};
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

inline std::vector<NamedStation> four_stations() {
  return {{"A", {-150.0, -120.0, -700.0}},
          {"B", {1150.0, -100.0, -650.0}},
          {"C", {500.0, 720.0, -680.0}},
          {"D", {200.0, 300.0, -750.0}}};
}

struct Measuring {
  std::size_t points = 60;            ///< points per station and tool
  bool noise = true;                  ///< as stated
  std::array<std::size_t, 3> grid{};  ///< instead of points anywhere: so many along each axis, row by row, X first
};

inline Vector3 grid_place(const TravelBox& travel, const std::array<std::size_t, 3>& grid, std::size_t k) {
  Vector3 q;
  for (std::size_t a = 0; a < axis_count; k /= grid[a], ++a)
    q[a] = std::lerp(travel.lowest_mm[a], travel.highest_mm[a], double(k % grid[a]) / double(grid[a] - 1));
  return q;
}

/// Stations in turn, at each all tools of the model.
inline VolumetricLengths measured(TrueMachine& machine, const std::vector<NamedStation>& stations,
                                  const Measuring& measuring = {}) {
  VolumetricLengths lengths;
  lengths.segments = {"1"};
  for (const Tool& tool : machine.model.tools) lengths.tools.push_back(tool.name);
  for (std::size_t s = 0; s < stations.size(); ++s) {
    lengths.stations.push_back(stations[s].name);
    for (std::size_t t = 0; t < machine.model.tools.size(); ++t) {
      const double dead_path_mm = machine.uniform(100.0, 800.0);
      const bool in_rows = measuring.grid[0] > 0;
      const std::size_t points = in_rows ? measuring.grid[0] * measuring.grid[1] * measuring.grid[2] : measuring.points;
      for (std::size_t k = 0; k < points; ++k) {
        Vector3 q = in_rows ? grid_place(machine.model.travel, measuring.grid, k) : Vector3{};
        for (std::size_t a = 0; a < axis_count && !in_rows; ++a)
          q[a] = machine.uniform(machine.model.travel.lowest_mm[a], machine.model.travel.highest_mm[a]);
        const Vector3 tool = machine.model.tools[t].offset_mm;
        const Vector3 p = q + tool + 1e-3 * displacement_exact_um(machine.model, machine.errors(q), q, tool);
        const double far_mm = distance(p, stations[s].at_mm);
        const double noise_um = measuring.noise ? machine.model.sigma_um(far_mm) * machine.normal() : 0.0;
        lengths.readings.push_back({s, t, 0, q, far_mm - dead_path_mm + 1e-3 * noise_um});
      }
    }
  }
  return lengths;
}

}  // namespace axiometry::volumetric::test
