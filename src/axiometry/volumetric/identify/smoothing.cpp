// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/smoothing.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/distributions/chi_square.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t rounds_most = 300;
constexpr double settled = 0.002;  // change of ln τ in a round: it moves no curve by a hundredth of its uncertainty
constexpr std::size_t judged_places = 21;

Vector3 judged_place(const Coefficients& coefficients, std::size_t k) {
  const double share = static_cast<double>(k) / static_cast<double>(judged_places - 1);
  Vector3 place;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const CurveBasis& basis = coefficients.basis(a);
    place[a] = basis.lower_mm() + share * (basis.upper_mm() - basis.lower_mm());
  }
  return place;
}

std::vector<double> negative(std::vector<double> values) {
  for (double& x : values) x = -x;
  return values;
}

/// −V S c: what the penalty makes of coefficients c.
std::vector<double> pull_on(const CurvaturePenalty& penalty, const LinearSolution& solution,
                            std::span<const double> coefficients, std::size_t columns) {
  std::vector<double> against = negative(penalty.times(coefficients));
  against.resize(columns, 0.0);
  return solution.step(std::move(against));
}

}  // namespace

LikeliestBends likeliest_bends(const Problem& problem, const Fit& plain, CurvaturePenalty penalty) {
  const double factor = penalty.variance_factor();
  const NormalEquations equations = normal_equations(problem, sights(problem, plain.state));
  const NullDirections nulls = plain.solution.null_basis();
  const PerCurve ranks = penalty.ranks(), bent = penalty.squares(plain.state.coefficients);
  Bends bends{}, counts{};
  for (std::size_t e = 0; e < curve_count; ++e) {
    bends[bend_of(e)] += bent[e];
    counts[bend_of(e)] += ranks[e];
  }
  for (std::size_t g = 0; g < bends.size(); ++g)
    bends[g] = std::clamp(std::sqrt(bends[g] / std::max(1.0, counts[g])), Smoothness::least, Smoothness::most);
  for (std::size_t round = 0; round < rounds_most && !problem.stop.stop_requested(); ++round) {
    penalty.set(bends, factor);
    const LinearSolution solution(problem.coefficients, penalty.added_to(equations), nulls);
    std::vector<double> coefficients = pull_on(penalty, solution, plain.state.coefficients, problem.unknowns.columns);
    coefficients.resize(problem.coefficients.raw());
    for (std::size_t k = 0; k < coefficients.size(); ++k) coefficients[k] += plain.state.coefficients[k];
    const PerCurve squares = penalty.squares(coefficients);
    const CurvaturePenalty::Told told = penalty.told(solution.coefficient_covariance());
    Bends sums{}, numbers{};
    for (std::size_t e = 0; e < curve_count; ++e) {
      sums[bend_of(e)] += squares[e];
      numbers[bend_of(e)] += told.trace[e];
    }
    double change = 0.0;
    for (std::size_t g = 0; g < bends.size(); ++g) {
      const double next = numbers[g] > 0.0 ? std::sqrt(sums[g] / numbers[g]) : Smoothness::least;
      const double taken = std::clamp(next, Smoothness::least, Smoothness::most);
      change = std::max(change, std::abs(std::log(taken / bends[g])));
      bends[g] = taken;
    }
    if (change < settled) return {bends, true};
  }
  return {bends, false};
}

std::vector<double> with_bend_uncertainty(const CurvaturePenalty& penalty, const Coefficients& coefficients,
                                          const Fit& fit, const std::vector<double>& covariance,
                                          std::vector<double> scaled) {
  const CurvaturePenalty::Told told = penalty.told(covariance);
  Bends information{};
  for (std::size_t e = 0; e < curve_count; ++e) information[bend_of(e)] += 0.5 * told.trace_of_square[e];
  const std::size_t n = coefficients.raw();
  for (std::size_t g = 0; g < information.size(); ++g) {
    if (!(information[g] > 0.0)) continue;
    std::vector<double> against = penalty.times(fit.state.coefficients);
    for (std::size_t k = 0; k < n; ++k)
      if (const std::size_t e = coefficients.error_of(k); e >= curve_count || bend_of(e) != g) against[k] = 0.0;
    against.resize(fit.solution.columns(), 0.0);
    const std::vector<double> v = fit.solution.step(std::move(against));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) scaled[i * n + k] += v[i] * v[k] / information[g];
  }
  return scaled;
}

PerCurve mean_variances(const Coefficients& coefficients, const std::vector<double>& covariance) {
  const std::size_t width = coefficients.raw();
  PerCurve means{};
  for (std::size_t k = 0; k < judged_places; ++k) {
    const Vector3 at = judged_place(coefficients, k);
    for (std::size_t a = 0; a < axis_count; ++a) {
      const ActiveFunctions f = coefficients.basis(a).at(at[a]);
      for (std::size_t m = 0; m < motion_count; ++m) {
        const std::size_t begin = coefficients.curve(a) + f.first * motion_count + m;
        double variance = 0.0;
        for (std::size_t i = 0; i < f.count; ++i)
          for (std::size_t j = 0; j < f.count; ++j)
            variance +=
                f.values[i] * f.values[j] * covariance[(begin + i * motion_count) * width + begin + j * motion_count];
        means[a * motion_count + m] += variance / static_cast<double>(judged_places);
      }
    }
  }
  return means;
}

SmoothedCurves smoothed_curves(const CurvaturePenalty& penalty, const Coefficients& coefficients, const Fit& fit,
                               const std::vector<double>& covariance) {
  const CurvaturePenalty::Told told = penalty.told(covariance);
  const PerCurve ranks = penalty.ranks(), squares = penalty.squares(fit.state.coefficients);
  const std::vector<double> pull = pull_on(penalty, fit.solution, fit.state.coefficients, fit.solution.columns());
  SmoothedCurves smoothed{.displacement_um = penalty.bends()[0], .rotation_urad = penalty.bends()[1]};
  PerCurve bias{};
  const auto directions = coefficients.reversal() == Reversal::none ? std::vector{0.0} : std::vector{1.0, -1.0};
  for (const double direction : directions) {
    for (std::size_t k = 0; k < judged_places; ++k) {
      const ErrorValues at = coefficients.errors(std::span(pull).first(coefficients.raw()),
                                                 judged_place(coefficients, k), {direction, direction, direction});
      for (std::size_t e = 0; e < curve_count; ++e)
        bias[e] = std::max(bias[e], std::abs(at.motions[e / motion_count][e % motion_count]));
    }
  }
  for (std::size_t e = 0; e < curve_count; ++e) {
    if (ranks[e] == 0.0) continue;
    SmoothedError own{.error = e, .bias = bias[e]};
    smoothed.taken += ranks[e] - told.trace[e];
    if (told.trace[e] > 0.0 && told.trace_of_square[e] > 0.0) {
      const double tau = penalty.bends()[bend_of(e)];
      own.bend_ratio = std::sqrt(squares[e] / (tau * tau * told.trace[e]));
      // Satterthwaite: a sum of squares of this mean and variance is a multiple of a χ².
      const double scale = told.trace_of_square[e] / told.trace[e];
      own.chance = 1.0 - numeric::chi_square_probability(squares[e] / (tau * tau * scale), told.trace[e] / scale);
    }
    smoothed.errors.push_back(own);
  }
  return smoothed;
}

}  // namespace axiometry::volumetric::detail
