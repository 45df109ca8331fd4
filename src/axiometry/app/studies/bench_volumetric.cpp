// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/studies/bench_volumetric.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "axiometry/numeric/median.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/identify/noise_trials.h"
#include "axiometry/volumetric/machine/kinematics.h"

namespace axiometry::app {
namespace {

using volumetric::axis_count;
using volumetric::DriftModel;
using volumetric::ErrorValues;
using volumetric::Identification;
using volumetric::IdentifyOptions;
using volumetric::KinematicChain;
using volumetric::MachineModel;
using volumetric::motion_count;
using volumetric::NoiseTrials;
using volumetric::VolumetricLengths;

constexpr std::size_t bench_spans = 8;
constexpr std::size_t trial_observations = 1'000;
constexpr std::size_t bench_noise_trials = 200;

MachineModel bench_machine() {
  MachineModel machine{.chain = KinematicChain::make("XFYZ").value()};
  machine.travel = {{0.0, 0.0, -500.0}, {1000.0, 600.0, 0.0}};
  machine.tools = {{"short", {0.0, 0.0, -150.0}}, {"long", {0.0, 0.0, -300.0}}, {"side", {120.0, 60.0, -180.0}}};
  return machine;
}

/// Waves of 3 to 8 µm and µrad over each travel.
ErrorValues bench_errors(const MachineModel& machine, Vector3 q) {
  ErrorValues errors;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const double k = static_cast<double>(a * motion_count + m);
      const double x =
          (q[a] - machine.travel.lowest_mm[a]) / (machine.travel.highest_mm[a] - machine.travel.lowest_mm[a]);
      errors.motions[a][m] = (3.0 + 0.3 * k) * std::sin(std::numbers::pi * x * (1.0 + 0.1 * k) + k);
    }
  errors.squareness_urad = {12.0, -8.0, 20.0};
  return errors;
}

VolumetricLengths bench_lengths(const MachineModel& machine, std::size_t observations, std::uint64_t seed) {
  constexpr Vector3 stations[] = {
      {-150.0, -120.0, -700.0}, {1150.0, -100.0, -650.0}, {500.0, 720.0, -680.0}, {200.0, 300.0, -750.0}};
  VolumetricLengths lengths{{"A", "B", "C", "D"}, {"short", "long", "side"}, {"1"}, {}, {}};
  std::vector<double> places(3 * observations), noise(observations);
  numeric::fill_uniform({seed, 0, 0}, places);
  numeric::fill_normal({seed, 1, 0}, noise);
  for (std::size_t i = 0; i < observations; ++i) {
    const std::size_t v = 10 * i / observations;  // virtual station
    const std::size_t tool = v < 4 ? 0 : v < 7 ? 1 : 2, station = v < 4 ? v : (v - 4) % 3 + (v < 7 ? 0 : 1);
    Vector3 q;
    for (std::size_t a = 0; a < axis_count; ++a)
      q[a] = machine.travel.lowest_mm[a] +
             places[3 * i + a] * (machine.travel.highest_mm[a] - machine.travel.lowest_mm[a]);
    const Vector3 t = machine.tools[tool].offset_mm;
    const Vector3 p = q + t + 1e-3 * displacement_um(machine, bench_errors(machine, q), q, t);
    const double far_mm = distance(p, stations[station]);
    const double length_mm = far_mm - 300.0 + 1e-3 * machine.sigma_um(far_mm) * noise[i];
    lengths.readings.push_back({station, tool, 0, q, length_mm, 0});
  }
  return lengths;
}

double seconds_of(const std::chrono::steady_clock::time_point& begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

Result<json::Value> bench_volumetric(const VolumetricBench& bench) {
  const MachineModel machine = bench_machine();
  IdentifyOptions options;
  options.sizes = {bench_spans, bench_spans, bench_spans};
  options.drift = DriftModel::none;
  options.find_breaks = false;
  options.find_outliers = false;
  options.find_part_scales = false;
  options.threads = bench.threads;
  const VolumetricLengths lengths = bench_lengths(machine, bench.observations, bench.seed);
  json::Value value = json::Value::object();
  std::vector<double> seconds;
  for (std::size_t run = 0; run < bench.runs; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    AXIOMETRY_TRY(const Identification found, identify(machine, lengths, options));
    seconds.push_back(seconds_of(begin));
    if (run + 1 < bench.runs) continue;
    value.add("observations", bench.observations);
    value.add("unknowns", found.rank.unknowns);
    value.add("threads",
              std::size_t{bench.threads > 0 ? bench.threads : std::max(1u, std::thread::hardware_concurrency())});
    value.add("seconds", std::ranges::min(seconds));
    value.add("median_seconds", numeric::median(seconds));
    value.add("first_seconds", seconds.front());
    value.add("chi2_per_dof", found.chi_squared_per_dof());
  }
  const VolumetricLengths few = bench_lengths(machine, trial_observations, bench.seed);
  const auto begin = std::chrono::steady_clock::now();
  AXIOMETRY_TRY(const NoiseTrials trials, noise_trials(machine, few, options, bench_noise_trials, bench.seed));
  json::Value& monte_carlo = value.add("monte_carlo", json::Value::object());
  monte_carlo.add("trials", trials.trials);
  monte_carlo.add("observations", trial_observations);
  monte_carlo.add("seconds", seconds_of(begin));
  return value;
}

}  // namespace axiometry::app
