// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "axiometry/model/plan.h"
#include "axiometry/model/recording.h"

namespace axiometry::testing_support {

/// A plan whose targets do not lie evenly.
inline Plan made_up_plan(std::size_t targets = 5, std::size_t runs = 2, TestCycle cycle = TestCycle::standard) {
  Plan plan;
  plan.cycle = cycle;
  plan.axis.name = "X";
  for (std::size_t i = 0; i < targets; ++i)
    plan.targets.push_back(
        Position::native(10.0 + 25.0 * static_cast<double>(i) + 3.7 * std::sin(3.0 * static_cast<double>(i))));
  plan.runs = runs;
  plan.overrun = Position::native(5.0);
  plan.feed = 1200.0;
  plan.dwell = Duration::s(2.0);
  return plan;
}

/// An axis that walks a plan, and an instrument that watches it. mm and s.
struct MadeUpRun {
  Plan plan = made_up_plan();
  double rate_hz = 500.0;
  double noise = 0.0001;   ///< standard deviation
  double quantum = 0.0;    ///< of the instrument
  double vibration = 0.0;  ///< amplitude
  double vibration_hz = 17.0;
  double creep_per_s = 0.0;  ///< at rest
  double tail = 0.0;         ///< way left when the axis seems to have stopped
  double tail_s = 0.1;       ///< time constant of that
  double overrun_dwell_s = 0.0;
  double spike = 0.0;  ///< height of single false samples
  std::size_t spike_every = 0;
  std::set<std::size_t> missed{};  ///< approaches (in order) where the axis does not stop
  std::function<double(const Approach&)> deviation = [](const Approach& a) {
    return 0.002 * static_cast<double>(a.target) - (a.direction == Direction::down ? 0.003 : 0.0) +
           0.0005 * static_cast<double>(a.run);
  };
  unsigned seed = 1;

  /// What is recorded of these positions one after the other, with this dwell on each.
  struct Stop {
    double position = 0.0;
    double dwell_s = 0.0;
  };

  std::vector<Stop> stops() const {
    std::vector<Stop> list;
    std::size_t number = 0;
    for (const PlannedMove& move : moves(plan)) {
      if (!move.approach) {
        list.push_back({move.to.in_native(), overrun_dwell_s});
        continue;
      }
      const bool stands = !missed.contains(number++);
      list.push_back({move.to.in_native() + deviation(*move.approach), stands ? plan.dwell.in_s() : 0.0});
    }
    return list;
  }

  std::vector<Sample> record() const { return record(stops()); }

  std::vector<Sample> record(const std::vector<Stop>& list) const {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Sample> samples;
    const auto add = [&](double x) {
      const double t = static_cast<double>(samples.size()) / rate_hz;
      x += noise * normal(random) + vibration * std::sin(2.0 * std::numbers::pi * vibration_hz * t);
      if (spike_every > 0 && samples.size() % spike_every == spike_every - 1) x += spike;
      if (quantum > 0.0) x = std::round(x / quantum) * quantum;
      samples.push_back({t, x});
    };
    double at = list.front().position;
    for (double t = 0.0; t < 1.0; t += 1.0 / rate_hz) add(at);
    for (const Stop& stop : list) {
      const double way = stop.position - at;
      const double time_s = 1.5 * std::abs(way) / (plan.feed / 60.0);
      for (double t = 0.0; t < time_s; t += 1.0 / rate_hz) {
        const double u = t / time_s;
        add(at + way * u * u * (3.0 - 2.0 * u));
      }
      const double left = stop.dwell_s > 0.0 && way != 0.0 ? std::copysign(tail, way) : 0.0;
      for (double t = 0.0; t < stop.dwell_s; t += 1.0 / rate_hz)
        add(stop.position + creep_per_s * t - left * std::exp(-t / tail_s));
      at = stop.position;
    }
    for (double t = 0.0; t < 0.3; t += 1.0 / rate_hz) add(at + 20.0 * t);
    return samples;
  }
};

}  // namespace axiometry::testing_support
