// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/curves/beam_row.h"
#include "axiometry/volumetric/identify/normal_equations.h"

/// The normal equations under the gauge, factored once: steps, covariance, rank. Internal to identify().
namespace axiometry::volumetric::detail {

class LinearSolution {
 public:
  /// Turns the coefficients into the gauge, drops what it removes, scales columns to the same size, and factors
  /// (Cholesky; by eigenvectors where a direction is not told).
  LinearSolution(const Coefficients& coefficients, NormalEquations equations);
  ~LinearSolution();
  LinearSolution(LinearSolution&&) noexcept;
  LinearSolution& operator=(LinearSolution&&) noexcept;

  std::size_t unknowns() const;         ///< under the gauge, stations and dead paths included
  std::size_t null_directions() const;  ///< of which the lengths say nothing
  /// Largest over smallest singular value of the scaled rows that are told; found anew at each call.
  double condition() const;

  /// The step for a gradient: all columns, raw. Least in the scaled columns where directions are not told.
  std::vector<double> step(std::vector<double> raw_gradient) const;

  /// Of the raw coefficients alone, coefficients.raw() squared; and of all columns' own place: the block of three of a
  /// station from `column` on, µm².
  std::vector<double> coefficient_covariance() const;
  Matrix3 block(std::size_t column) const;

  /// Directions of raw coefficients of which the lengths say nothing, of length 1.
  std::vector<std::vector<double>> unseen() const;

  /// aᵀ C a for a row of raw columns: the variance of what the row predicts.
  double variance(std::span<const BeamRow::Piece> row) const;

 private:
  struct Factors;
  std::unique_ptr<Factors> factors_;
};

}  // namespace axiometry::volumetric::detail
