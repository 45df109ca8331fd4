// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/model/tracking.h"

/// A machine, an instrument and plans of lines to test with: written for the tests alone, so that they share no formula
/// with what they test but that of the distance.
namespace axiometry::tracking::testing_support {

inline Plan line_plan(const SpatialLine& line, const std::vector<double>& targets, std::size_t runs,
                      TestCycle cycle = TestCycle::standard) {
  Plan plan;
  set_spatial_line(plan.axis, line);
  plan.cycle = cycle;
  for (const double t : targets) plan.targets.push_back(Position::native(t));
  plan.runs = runs;
  plan.overrun = Position::native(5.0);
  plan.feed = 1000.0;
  plan.dwell = Duration::s(2.0);
  return plan;
}

inline Vector3 station() { return {480.0, 310.0, -90.0}; }
inline Vector3 tool() { return {0.0, 12.0, -120.0}; }

inline const std::vector<double>& distances() {
  static const std::vector<double> values = {212.0, 251.5, 297.2, 331.0, 379.3, 424.8, 468.1};
  return values;
}

/// Lines through the station along x (positions are those of the axis), and along the diagonal of X and −Z.
inline TrackingPlan two_lines(std::size_t runs = 5, TestCycle cycle = TestCycle::standard) {
  TrackingPlan plan;
  plan.machine = "Mill 5";
  plan.setup.travel = {{0.0, 0.0, -600.0}, {1000.0, 600.0, 600.0}};
  plan.setup.tool_offset_mm = tool();
  plan.setup.station.position_mm = station();
  plan.setup.station.covariance_mm2 = Matrix3{{{4e-6, 0, 0}, {0, 9e-6, 0}, {0, 0, 25e-6}}};
  const Vector3 axes = station() - tool();  // place of the axes when the reflector is at the station
  std::vector<double> along_x;
  for (const double d : distances()) along_x.push_back(axes.x + d);
  plan.lines.push_back({"x", line_plan({{0.0, axes.y, axes.z}, {1.0, 0.0, 0.0}}, along_x, runs, cycle)});
  plan.lines.push_back({"xz", line_plan({axes, unit({1.0, 0.0, -1.0})}, distances(), runs, cycle)});
  return plan;
}

/// Linear errors, lost motion along the way, and noise.
struct Machine {
  double scale = 25e-6;        ///< scale error of all axes: the machine goes too far
  double reversal_mm = 0.004;  ///< it stays behind by half of it, whichever way it comes
  double wave_mm = 0.002;      ///< wave of the positioning along the line
  double noise_mm = 0.0004;
  unsigned seed = 1;
};

struct Beam {
  std::function<double(const std::string&, std::size_t)> dead_path_mm;  ///< dead path by line and reading in it
};

inline double deviation_mm(const Machine& machine, double position_mm, Direction direction) {
  return machine.scale * position_mm + machine.wave_mm * std::sin(position_mm / 37.0) +
         (direction == Direction::up ? -0.5 : 0.5) * machine.reversal_mm;
}

inline std::vector<LengthReading> measured(const TrackingPlan& plan, const Machine& machine, const Beam& beam = {}) {
  std::mt19937 random(machine.seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<LengthReading> readings;
  for (const TrackingLine& line : plan.lines) {
    const SpatialLine way = *spatial_line(line.plan.axis);
    std::size_t k = 0;
    for (const Approach& a : approaches(line.plan)) {
      const double at = line.plan.targets[a.target].in_native();
      const double reached = at + deviation_mm(machine, at, a.direction) + machine.noise_mm * noise(random);
      const Vector3 reflector = way.at(Position::native(reached)) + plan.setup.tool_offset_mm;
      const double dead = beam.dead_path_mm ? beam.dead_path_mm(line.id, k) : -212.7;
      readings.push_back({line.id, a, distance(reflector, plan.setup.station.position_mm) + dead, 0});
      ++k;
    }
  }
  return readings;
}

}  // namespace axiometry::tracking::testing_support
