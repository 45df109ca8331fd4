// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/simulate/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <thread>
#include <utility>

#include "axiometry/numeric/random/random.h"
#include "axiometry/volumetric/plan/point_set.h"
#include "axiometry/volumetric/simulate/random_streams.h"

namespace axiometry::volumetric {
namespace {

constexpr double inside_most = 1.96;
constexpr std::size_t curve_places_tried = 9;
constexpr std::size_t field_places_tried = 10;
constexpr std::size_t trials_most = 100'000;

void try_curves(const ErrorModel& model, const TrueErrors& truth, CoverageTrial& trial) {
  const TravelBox& travel = model.machine().travel;
  const auto add = [&](std::size_t error, const std::optional<Estimate>& stated, double value) {
    if (!stated || !(stated->u > 0.0)) return;
    trial.errors[error].add((stated->value - value) / stated->u);
  };
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m)
      for (std::size_t k = 0; k < curve_places_tried; ++k) {
        const double share = (static_cast<double>(k) + 0.5) / static_cast<double>(curve_places_tried);
        const double q = travel.lowest_mm[a] + share * (travel.highest_mm[a] - travel.lowest_mm[a]);
        add(a * motion_count + m, model.motion({a, m}, q), truth.curves[a][m].at(q));
        if (model.coefficients().reversal() == Reversal::none) continue;
        for (const double approach : {1.0, -1.0}) {
          const auto stated = model.motion({a, m}, q, approach);
          if (stated && stated->u > 0.0)
            trial.directions.add((stated->value - truth.curves[a][m].at(q) - approach * truth.halves[a][m].at(q)) /
                                 stated->u);
        }
      }
  for (std::size_t k = 0; k < squareness_names.size(); ++k)
    add(axis_count * motion_count + k, model.squareness(static_cast<Squareness>(k)), truth.squareness_urad[k]);
  for (const Share& share : trial.errors) trial.curves.add(share);
}

/// To first order, as the model predicts: the exact displacement differs by 2e-3 µm, and by what the gauge takes off.
void try_field(const ErrorModel& model, const TrueErrors& truth, Draw draw, CoverageTrial& trial) {
  const MachineModel& machine = model.machine();
  std::array<double, 3> shift{};
  numeric::fill_uniform({draw.seed, detail::stream_check, draw.trial}, shift);
  std::size_t places = 0;
  for (const Vector3& q : spread_points(machine.travel, field_places_tried, {shift[0], shift[1], shift[2]}))
    for (const Tool& tool : machine.tools) {
      const ToolPointError stated = model.at(q, tool.offset_mm);
      const Vector3 error = displacement_um(machine, truth.at(q), q, tool.offset_mm);
      ++places;
      for (std::size_t c = 0; c < 3; ++c) {
        const double u = std::sqrt(stated.covariance_um2[c][c]);
        if (!stated.error_um[c] || !(u > 0.0)) continue;
        const double difference = *stated.error_um[c] - error[c];
        trial.field.add(difference / u);
        trial.field_error_um_squared += difference * difference;
      }
    }
  trial.field_error_um_squared /= static_cast<double>(std::max<std::size_t>(places, 1));
}

void try_faults(const Identification& found, const SimulatedLengths& simulated, CoverageTrial& trial) {
  for (const FoundBreak& b : found.breaks) {
    const bool right = std::ranges::any_of(simulated.jumps, [&](const SimulatedJump& j) {
      return !j.told && j.before_reading >= b.earliest_reading && j.before_reading <= b.latest_reading;
    });
    ++(right ? trial.breaks_found : trial.breaks_wrong);
  }
  for (const SetAside& s : found.set_aside) {
    if (s.reason != SetAside::Reason::outlier) continue;  // only an outlier is said to be wrong
    const bool right =
        std::ranges::find(simulated.outliers, s.reading, &SimulatedOutlier::reading) != simulated.outliers.end();
    ++(right ? trial.outliers_found : trial.set_aside_wrong);
  }
}

Result<CoverageTrial> try_once(const MachineModel& machine, const CoverageOptions& options, std::uint64_t number) {
  const Draw draw{options.seed, number};
  const SimulatedCourse course = simulated_course(machine,
                                                  {.errors = options.errors ? &*options.errors : nullptr,
                                                   .size = options.size,
                                                   .reversal = options.identify.reversal,
                                                   .visits = options.visits,
                                                   .points = options.points},
                                                  draw);
  AXIOMETRY_TRY(const SimulatedLengths simulated,
                simulate_lengths(machine, course.errors, course.visits, options.faults, draw));
  IdentifyOptions identify_options = options.identify;
  identify_options.threads = 1;
  AXIOMETRY_TRY(const Identification found, identify(machine, simulated.lengths, identify_options));
  CoverageTrial trial;
  const TrueErrors truth = in_gauge(course.errors, machine);
  try_curves(found.model, truth, trial);
  try_field(found.model, truth, draw, trial);
  try_faults(found, simulated, trial);
  trial.chi_squared = found.chi_squared;
  trial.degrees_of_freedom = found.degrees_of_freedom;
  return trial;
}

}  // namespace

void Share::add(double z) {
  ++count;
  if (std::abs(z) <= inside_most) ++inside;
  sum_squares += z * z;
}

void Share::add(const Share& other) {
  count += other.count;
  inside += other.inside;
  sum_squares += other.sum_squares;
}

double Share::rms() const { return count > 0 ? std::sqrt(sum_squares / static_cast<double>(count)) : 0.0; }

CoverageStudy::Total CoverageStudy::total(Share CoverageTrial::*which) const {
  Total total;
  double n = 0.0, sum = 0.0, squares = 0.0;
  for (const CoverageTrial& trial : trials) {
    if ((trial.*which).count == 0) continue;  // the trial states no such value
    n += 1.0;
    total.share.add(trial.*which);
    sum += (trial.*which).share();
    squares += (trial.*which).share() * (trial.*which).share();
  }
  if (n > 1.0) total.standard_error = std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1.0) / n);
  return total;
}

double CoverageStudy::chi_squared_per_dof() const {
  double chi = 0.0, dof = 0.0;
  for (const CoverageTrial& trial : trials) {
    chi += trial.chi_squared;
    dof += static_cast<double>(trial.degrees_of_freedom);
  }
  return dof > 0.0 ? chi / dof : 0.0;
}

Result<CoverageStudy> try_coverage(const MachineModel& machine, const CoverageOptions& options) {
  if (options.trials < 1 || options.trials > trials_most)
    return fail(fmt::format("found {} trials, expected 1 to {}", options.trials, trials_most));
  std::vector<std::optional<Result<CoverageTrial>>> done(options.trials);
  std::atomic<std::size_t> next = 0;
  const auto run = [&] {
    for (std::size_t k = next++; k < done.size(); k = next++) done[k] = try_once(machine, options, k);
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < std::max(1u, std::thread::hardware_concurrency()); ++k) others.emplace_back(run);
    run();
  }
  CoverageStudy coverage;
  for (auto& trial : done) {
    if (*trial) {
      coverage.trials.push_back(**std::move(trial));
      continue;
    }
    if (coverage.failed++ == 0) coverage.first_failure = trial->error().message;
  }
  if (coverage.trials.empty()) return fail(coverage.first_failure);
  return coverage;
}

}  // namespace axiometry::volumetric
