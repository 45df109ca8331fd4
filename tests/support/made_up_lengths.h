// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "axiometry/base/vector3.h"
#include "axiometry/model/recording.h"

namespace axiometry::testing_support {

/// A reflector that is driven from place to place, and a tracking interferometer that watches it. mm and s.
struct MadeUpLengths {
  struct Place {
    Vector3 at_mm;
    double rest_s = 0.0;  ///< 0: passed through
  };
  struct Break {
    double jump_mm = 0.0;
    bool silent = true;  ///< samples are missing while the beam is lost; else they go on, behind the jump
  };

  Vector3 station_mm = {500.0, 300.0, -100.0};
  Vector3 home_mm = {30.0, 20.0, 550.0};  ///< where it waits for a while at first
  double rate_hz = 200.0;
  double noise = 0.0002;  ///< standard deviation
  double speed = 50.0;
  double drift_per_s = 0.0;               ///< of the length shown
  double sign = 1.0;                      ///< −1: the length shown falls where the reflector recedes
  std::map<std::size_t, Break> broken{};  ///< in the middle of the way to that place
  unsigned seed = 1;

  std::vector<Sample> record(const std::vector<Place>& places) const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Sample> samples;
    double dead_path = distance(home_mm, station_mm);
    std::size_t ticks = 0;
    bool lost = false;
    const auto add = [&](Vector3 at) {
      const double t = static_cast<double>(ticks++) / rate_hz;
      const double shown = sign * (distance(at, station_mm) - dead_path) + drift_per_s * t + noise * normal(random);
      if (!lost) samples.push_back({t, shown});
    };
    Vector3 at = home_mm;
    for (double t = 0.0; t < 1.5; t += 1.0 / rate_hz) add(at);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Vector3 way = places[k].at_mm - at;
      const double time_s = 1.5 * norm(way) / speed;
      const auto here = broken.find(k);
      bool is_broken = false;
      for (double t = 0.0; t < time_s; t += 1.0 / rate_hz) {
        const double u = t / time_s;
        if (here != broken.end()) {
          lost = here->second.silent && u > 0.2 && u < 0.6;
          if (u >= 0.4 && !std::exchange(is_broken, true)) dead_path -= here->second.jump_mm;
        }
        add(at + u * u * (3.0 - 2.0 * u) * way);
      }
      lost = false;
      at = places[k].at_mm;
      for (double t = 0.0; t < places[k].rest_s; t += 1.0 / rate_hz) add(at);
    }
    for (double t = 0.0; t < 0.3; t += 1.0 / rate_hz) add(at + Vector3{30.0 * t, 20.0 * t, 10.0 * t});
    return samples;
  }
};

}  // namespace axiometry::testing_support
