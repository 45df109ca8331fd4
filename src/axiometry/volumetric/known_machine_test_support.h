// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/machine/kinematics.h"

/// A machine whose errors are known, and lengths of it.
namespace axiometry::volumetric::testing {

/// Travels 1000, 600, 500 mm; tools whose points form a triangle.
inline MachineModel known_machine(const char* chain = "XFYZ") {
  MachineModel machine{.chain = *KinematicChain::make(chain)};
  machine.travel = {{0, 0, -500}, {1000, 600, 0}};
  machine.tools = {{"T1", {0, 0, -150}}, {"T2", {0, 0, -300}}, {"T3", {120, 60, -180}}};
  machine.ranging = {.constant = Length::um(0.2), .per_length = RelativeLength::um_per_m(0.3)};
  return machine;
}

/// Errors of some µm and µrad, smooth, and 12, −8, 5 µrad of squareness.
inline ErrorValues known_errors(Vector3 q) {
  ErrorValues errors;
  const Vector3 size{1000, 600, 500};
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const double x = q[a] / size[a], phase = 0.7 * static_cast<double>(m) + 1.9 * static_cast<double>(a);
      errors.motions[a][m] = 5.0 * std::sin(3.0 * x + phase) + 2.0 * std::cos(5.0 * x - phase);
    }
  errors.squareness_urad = {12, -8, 5};
  return errors;
}

/// As many places for each of four stations with each tool; the same numbers for the same seed on every machine.
inline VolumetricLengths known_lengths(const MachineModel& machine, std::size_t places, unsigned seed = 1) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const auto normal = [&] {
    double sum = -6.0;
    for (int k = 0; k < 12; ++k) sum += uniform();
    return sum;
  };
  VolumetricLengths lengths{{"S1", "S2", "S3", "S4"}, {}, {"1"}, {}};
  const std::vector<Vector3> stations = {{-150, -120, -700}, {1150, -100, -650}, {500, 720, -680}, {200, 300, -900}};
  for (const Tool& tool : machine.tools) lengths.tools.push_back(tool.name);
  for (std::size_t s = 0; s < stations.size(); ++s)
    for (std::size_t t = 0; t < machine.tools.size(); ++t)
      for (std::size_t k = 0; k < places; ++k) {
        const Vector3 q{1000 * uniform(), 600 * uniform(), -500 * uniform()};
        const Vector3 offset = machine.tools[t].offset_mm;
        const Vector3 p = q + offset + 1e-3 * displacement_um(machine, known_errors(q), q, offset);
        const double d = norm(p - stations[s]);
        lengths.readings.push_back({s, t, 0, q, d - 321.0 + 1e-3 * machine.sigma_um(d) * normal(), 0});
      }
  return lengths;
}

/// Contract of the test: it can be found.
inline Identification known_identification(const MachineModel& machine, std::size_t places = 60) {
  auto found = identify(machine, known_lengths(machine, places), {});
  if (!found) {
    ADD_FAILURE() << found.error().to_string();
    std::abort();
  }
  return *std::move(found);
}

}  // namespace axiometry::volumetric::testing
