// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/equations/least_squares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/go_on_unless.h"
#include "axiometry/numeric/median.h"
#include "axiometry/volumetric/identify/curvature_penalty.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr double converged_step = 1e-4;
constexpr std::size_t steps_most = 60;
/// What is told so weakly that it all but has no number bends while it is followed: steps of less than one standard
/// deviation may shrink by a fifth each. Where even 200 leave some thousandths, rounding keeps them up, and they make
/// no number wrong.
constexpr std::size_t small_steps_most = 200;
constexpr double small_step = 1.0, near_enough = 1e-2;
constexpr double moved_far_mm = 1.0;
constexpr double slow = 0.2;  // ratio of one step to the one before; 1e-4 is usual
constexpr int halvings_most = 10;
constexpr double huber_limit = 2.0;

double farthest(std::span<const Vector3> from, std::span<const Vector3> to) {
  double most = 0.0;
  for (std::size_t k = 0; k < from.size(); ++k) most = std::max(most, distance(from[k], to[k]));
  return most;
}

/// Sights with the gradient of all that is made least: χ² and the penalty.
struct Look {
  Sights seen;
  double chi_squared = 0.0;
  double penalty = 0.0;

  double sum() const { return chi_squared + penalty; }
};

Look look(const Problem& problem, const State& state) {
  Look look{sights(problem, state)};
  look.chi_squared = chi_squared(problem, look.seen.residuals_um);
  if (problem.penalty == nullptr) return look;
  const std::vector<double> pull = problem.penalty->times(state.coefficients);
  for (std::size_t k = 0; k < pull.size(); ++k) look.seen.gradient[k] -= pull[k];
  look.penalty = problem.penalty->value(state.coefficients);
  return look;
}

}  // namespace

Result<Fit> least_squares(const Problem& problem, State state) {
  AXIOMETRY_TRY_VOID(go_on_unless(problem.stop));
  Look now = look(problem, state);
  std::vector<Vector3> linearised_at = state.stations_mm;
  LinearSolution solution = linear_solution(problem, state, normal_equations(problem, now.seen));
  double before = 0.0;
  std::size_t step_number = 1;
  for (; step_number <= small_steps_most; ++step_number) {
    AXIOMETRY_TRY_VOID(go_on_unless(problem.stop));
    std::vector<double> step = solution.step(now.seen.gradient);
    double decrease = 0.0;
    for (std::size_t k = 0; k < step.size(); ++k) decrease += step[k] * now.seen.gradient[k];
    const double size = std::sqrt(std::max(0.0, decrease));
    if (!std::isfinite(size) || (step_number > steps_most && size > small_step)) break;
    if (size < (step_number < small_steps_most ? converged_step : near_enough)) {
      add_step(problem.unknowns, step, state);
      return Fit{std::move(state),          std::move(now.seen.residuals_um),
                 std::move(now.seen.beams), std::move(solution),
                 now.chi_squared,           step_number};
    }
    const State from = state;
    const double sum_before = now.sum();
    for (int halved = 0;; ++halved) {
      state = from;
      add_step(problem.unknowns, step, state);
      now = look(problem, state);
      if (now.sum() <= sum_before * (1.0 + 1e-9) + 1e-9 || halved == halvings_most) break;
      for (double& x : step) x *= 0.5;
    }
    const bool is_far = farthest(linearised_at, state.stations_mm) > moved_far_mm;
    if (is_far || (before > 0.0 && size > slow * before)) {
      linearised_at = state.stations_mm;
      solution = linear_solution(problem, state, normal_equations(problem, now.seen));
    }
    before = size;
  }
  return fail(
      fmt::format("found no errors and stations that fit the lengths in {} steps, expected lengths, tools and "
                  "positions that belong together",
                  step_number - 1));
}

double robust_scale(const Problem& problem, std::span<const double> residuals) {
  std::vector<double> sizes;
  for (std::size_t i = 0; i < residuals.size(); ++i)
    if (problem.weights[i] > 0.0) sizes.push_back(std::sqrt(problem.weights[i]) * std::abs(residuals[i]));
  return sizes.empty() ? 1.0 : std::max(1.0, 1.4826 * numeric::median(std::move(sizes)));
}

std::vector<double> huber_weights(const Problem& problem, std::span<const double> residuals) {
  const double limit = huber_limit * robust_scale(problem, residuals);
  std::vector<double> weights(problem.weights.begin(), problem.weights.end());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double z = std::sqrt(weights[i]) * std::abs(residuals[i]);
    if (z > limit) weights[i] *= limit / z;
  }
  return weights;
}

}  // namespace axiometry::volumetric::detail
