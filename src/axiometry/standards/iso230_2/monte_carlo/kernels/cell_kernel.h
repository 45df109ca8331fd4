// SPDX-License-Identifier: Apache-2.0
#pragma once

// What posterior.h and trials.h do with the cells of many trials, for one target; compiled once for each
// (numeric/vector_target.h). Operation by operation in the order that is written here.
#include "axiometry/numeric/kernels/lanes.h"
#include "axiometry/standards/iso230_2/monte_carlo/kernels/cell_kernel_types.h"

namespace axiometry::iso230_2::AXIOMETRY_VECTOR_TARGET {
namespace {

using namespace numeric::AXIOMETRY_VECTOR_TARGET;

using numeric::AXIOMETRY_VECTOR_TARGET::square_root;

/// A single trial as a vector of one lane.
[[gnu::always_inline]] inline double square_root(double x) { return __builtin_sqrt(x); }

/// 0 where `condition` is 0.
template <typename Vector>
[[gnu::always_inline]] inline Vector unless_zero(Vector condition, Vector value) {
  return condition == Vector{} ? Vector{} : value;
}

/// The part of a departure that is the first's own, where the variances of two causes add up.
template <typename Vector>
[[gnu::always_inline]] inline Vector share_of(Vector own_variance, Vector other_variance) {
  return unless_zero(own_variance, own_variance / (own_variance + other_variance));
}

/// Calls body(Doubles{}, t) for as many trials at once as there are lanes, and body(0.0, t) for each of the rest.
template <typename Body>
[[gnu::always_inline]] inline void for_all_trials(size_t trials, Body body) {
  size_t t = 0;
  for (; t + lanes<Doubles> <= trials; t += lanes<Doubles>) body(Doubles{}, t);
  for (; t < trials; ++t) body(0.0, t);
}

void share(const CellShare& cell) {
  for_all_trials(
      cell.trials, [&]<typename Vector>(Vector, size_t t) __attribute__((always_inline)) {
        const Vector mean = load<Vector>(cell.means + t), sd = load<Vector>(cell.sds + t);
        const Vector noise = all<Vector>(cell.noise_variance);
        const Vector machine = share_of<Vector>(sd * sd, noise);
        Vector left = cell.observed_mean - mean;
        if (cell.shift != nullptr) left -= load<Vector>(cell.shift + t);
        if (cell.own_variance > 0.0) {
          const Vector variance = (sd * sd + noise) / cell.count;
          const Vector own = share_of<Vector>(all<Vector>(cell.own_variance), variance);
          left -= own * left + square_root(own * variance) * load<Vector>(cell.direction_normals + t);
        }
        store(cell.machines + t, machine);
        store(cell.means + t, mean + (machine * left + square_root(machine * noise / cell.count) *
                                                           load<Vector>(cell.reading_normals + t)));
      });
}

void run_shifts(const RunShares& runs) {
  for_all_trials(
      runs.trials, [&]<typename Vector>(Vector, size_t t) __attribute__((always_inline)) {
        const auto cells = static_cast<double>(runs.cells);
        Vector scatter{};
        for (size_t c = 0; c < runs.cells; ++c) {
          const Vector sd = load<Vector>(runs.sds + c * runs.trials + t);
          scatter += sd * sd;
        }
        scatter /= cells;
        const Vector noise = all<Vector>(runs.noise_variance), measured = all<Vector>(runs.measured);
        const Vector of_readings = share_of<Vector>(scatter, noise) * noise / runs.cells_per_run;
        Vector own = all<Vector>(1.0);
        if (runs.measured != 0.0) {
          const Vector run_sd = load<Vector>(runs.run_sds + t);
          own = share_of<Vector>(run_sd * run_sd + scatter / runs.cells_per_run, measured);
        }
        const Vector variance = own * measured - of_readings;
        const Vector noise_sd = square_root(variance > Vector{} ? variance : Vector{});
        for (size_t j = 0; j < runs.runs; ++j)
          store(runs.shifts + j * runs.trials + t,
                own * runs.observed[j] + noise_sd * load<Vector>(runs.normals + j * runs.trials + t));
      });
}

template <size_t n>
struct FixedCount {
  constexpr operator size_t() const { return n; }
};

/// A count that the compiler knows unrolls the loops.
template <typename Count>
[[gnu::always_inline]] inline void noisy_readings(const NoisyCell& cell, Count count) {
  for_all_trials(
      cell.trials, [&]<typename Vector>(Vector, size_t t) __attribute__((always_inline)) {
        const Vector mean = load<Vector>(cell.means + t), machine = load<Vector>(cell.machines + t);
        const Vector noise_sd = square_root(machine) * cell.noise_sd;
        const auto noise_of = [&](size_t j) { return noise_sd * load<Vector>(cell.normals + j * cell.trials + t); };
        Vector about{};
        for (size_t j = 0; j < count; ++j) about += noise_of(j) / static_cast<double>(static_cast<size_t>(count));
        for (size_t j = 0; j < count; ++j)
          store(cell.readings[j] + t,
                mean + load<Vector>(cell.shifts[j] + t) + machine * cell.residuals[j] + noise_of(j) - about);
      });
}

void readings(const NoisyCell& cell) {
  if (cell.noise_sd != 0.0) {
    if (cell.count == 5) return noisy_readings(cell, FixedCount<5>{});
    return noisy_readings(cell, cell.count);
  }
  for_all_trials(
      cell.trials, [&]<typename Vector>(Vector, size_t t) __attribute__((always_inline)) {
        const Vector mean = load<Vector>(cell.means + t), machine = load<Vector>(cell.machines + t);
        for (size_t j = 0; j < cell.count; ++j)
          store(cell.readings[j] + t, mean + load<Vector>(cell.shifts[j] + t) + machine * cell.residuals[j]);
      });
}

template <typename Count>
[[gnu::always_inline]] inline void moments_of(const MovedCell& cell, Count count) {
  for_all_trials(
      cell.trials, [&]<typename Vector>(Vector, size_t t) __attribute__((always_inline)) {
        const Vector stretch =
            cell.length_errors != nullptr ? cell.position * load<Vector>(cell.length_errors + t) : Vector{};
        const Vector beside = cell.position_errors != nullptr ? load<Vector>(cell.position_errors + t) : Vector{};
        const auto reading = [&](size_t j) { return load<Vector>(cell.readings[j] + t) + stretch - beside; };
        Vector sum = reading(0);
        for (size_t j = 1; j < count; ++j) sum += reading(j);
        const Vector mean = sum / static_cast<double>(static_cast<size_t>(count));
        store(cell.means + t, mean);
        Vector estimator{};
        if (count > 1) {
          const Vector first = reading(0) - mean;
          Vector squares = first * first;
          for (size_t j = 1; j < count; ++j) {
            const Vector difference = reading(j) - mean;
            squares += difference * difference;
          }
          estimator = square_root(squares / static_cast<double>(count - 1));
        }
        store(cell.estimators + t, estimator);
      });
}

void moments(const MovedCell& cell) {
  if (cell.count == 5) return moments_of(cell, FixedCount<5>{});  // the number of the standard programme, 5.3.2
  moments_of(cell, cell.count);
}

}  // namespace

extern const CellKernel cell_kernel;
const CellKernel cell_kernel = {share, run_shifts, readings, moments};

}  // namespace axiometry::iso230_2::AXIOMETRY_VECTOR_TARGET
