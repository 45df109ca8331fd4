// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/equations/normal_equations.h"

/// The normal equations under the gauge, factored once: steps, covariance, rank. Internal to identify().
namespace axiometry::volumetric::detail {

/// Directions of the columns that stay under the gauge of which the lengths say nothing, each as long as one standard
/// deviation.
using NullDirections = std::vector<std::vector<double>>;

class LinearSolution {
 public:
  /// Turns the coefficients into the gauge, drops what it removes, scales columns to the same size, and factors what is
  /// left beside the null directions (Cholesky).
  LinearSolution(const Coefficients& coefficients, NormalEquations equations, NullDirections nulls = {});
  ~LinearSolution();
  LinearSolution(LinearSolution&&) noexcept;
  LinearSolution& operator=(LinearSolution&&) noexcept;

  /// Whether there may be directions that are not told: the reciprocal condition (in the 1-norm, which is never larger
  /// than the least eigenvalue) is below what null_directions() asks for, or there is no factor.
  bool is_doubtful() const;

  std::size_t columns() const;          ///< columns of the normal equations
  std::size_t unknowns() const;         ///< unknowns under the gauge, stations and dead paths included
  std::size_t null_directions() const;  ///< directions of which the lengths say nothing
  std::size_t told() const { return unknowns() - null_directions(); }  ///< unknowns that the lengths tell
  /// Largest over smallest singular value of the scaled rows, beside the null directions; found anew at each call.
  double condition() const;

  /// The step for a gradient: all columns, raw. Nothing along null directions.
  std::vector<double> step(std::vector<double> raw_gradient) const;

  /// Of the raw coefficients alone, coefficients.raw() squared; and the blocks of three columns from each of `columns`
  /// on, µm².
  std::vector<double> coefficient_covariance() const;
  std::vector<Matrix3> blocks(std::span<const std::size_t> columns) const;

  /// As they were given.
  NullDirections null_basis() const;

  /// The null directions as raw coefficients, of length 1, with 0 for errors that take no part in them, which are as
  /// certain with them as without; those of stations alone are left out.
  std::vector<std::vector<double>> unseen() const;
  /// Errors that a null direction changes, in the order of error_names(), rising.
  std::vector<std::size_t> unseen_errors() const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

/// By eigenvalues of the scaled matrix below 1e-8: along these, numbers would be known 10⁴ times worse than if all
/// others were given, some 100 µm and more, which tells nothing of a machine. Rounding leaves 1e-15 of an exact null
/// direction, splines that imitate one less well up to 1e-9, the weakest set-ups that tell all 1e-6.
NullDirections null_directions(const Coefficients& coefficients, NormalEquations equations);

/// At a state. Where the factor of the lengths alone is doubtful, the null directions are those with stations joined.
/// A penalty tells nothing that the lengths do not: it is added when the null directions are known.
LinearSolution linear_solution(const Problem& problem, const State& state, const NormalEquations& equations);

}  // namespace axiometry::volumetric::detail
