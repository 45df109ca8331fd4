// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/numeric/alias_rows.h"
#include "axiometry/numeric/random/weighted_choice.h"

/// What the standard deviations σ_c of many cells may be, given a few noisy readings in each.
///
/// The readings of a cell scatter by σ_c, and by noise of the known standard deviation u on top: their sum of
/// squares about the mean is (σ_c² + u²) χ² with ν degrees of freedom. Four degrees of freedom tell little about
/// one σ_c, and the largest of many such guesses is far too large. So cells tell about each other: ln σ_c is
/// normal about a common level with the spread ω. The level is equally likely in every octave from far below the
/// noise to far above what was seen; ω is 0 (all cells alike) with prior weight 3 against 1 for each of 0.1, 0.15,
/// … 0.75. What the readings say decides between them: a hierarchical model (Gelman et al., Bayesian Data Analysis,
/// 2013, chapter 5) on a grid, so that draws are independent.
///
/// A cell tells no more than its ν and its sum of squares S. Of many cells (more than `cells_one_by_one`) those of one
/// ν share 256 values of S, equally spaced in ln(S + v), v the smallest variance that is considered: the logarithm of
/// a cell's likelihood is taken between four of them (Lagrange), its σ from either of two, by chance and in the share
/// of its distance. Steps are below 5 %: weights of hypotheses agree to five digits with those of cells one by one,
/// and means of σ within 0.5 % (spread_posterior_test.cpp), where a grid point of σ stands for 4.5 %. Time and memory
/// are then those of 256 cells, beside what each draw of each cell takes.
///
/// σ_c² is never below zero, which is what subtracting u² from a sample variance cannot promise.
namespace axiometry::numeric {

struct CellScatter {
  double sum_of_squares = 0.0;      ///< sum of the squares about the cell's mean
  double degrees_of_freedom = 0.0;  ///< ν; 0 where the cell tells nothing
};

class SpreadPosterior {
 public:
  static constexpr std::size_t cells_one_by_one = 512;

  /// `by_classes`: whether cells share values, which is decided by their number unless said.
  SpreadPosterior(std::span<const CellScatter> cells, double noise_sd, std::optional<bool> by_classes = {});

  std::size_t size() const { return cells_; }

  /// One draw: `choice` picks level and ω, `shift` moves within a step of the grid, one uniform number per cell the
  /// rest; all from (0, 1).
  struct Randoms {
    double choice = 0.0;
    double shift = 0.0;
    std::span<const double> cells;
  };
  /// Sets every `stride`-th of the numbers.
  void draw(const Randoms& randoms, std::span<double> sds, std::size_t stride = 1) const;

  /// The variance of one reading, scatter and noise, pooled over the cells and at least u².
  double pooled_variance() const { return pooled_variance_; }

 private:
  /// A level and an ω, with the distributions of the cells that follow from them.
  struct Hypothesis {
    std::size_t level = 0;         ///< index in the grid
    std::size_t window_begin = 0;  ///< grid points considered
    AliasRows of_cells;            ///< rows for cells or their classes, on these points; empty when all cells are alike
  };

  /// Values that cells share, and how many cells each stands for.
  struct Classes {
    std::vector<CellScatter> values;
    std::vector<double> counts;
  };
  Classes classes_of(std::span<const CellScatter> cells, double smallest_variance);
  void consider_hypotheses(const std::vector<double>& likelihoods, std::span<const double> counts);

  std::size_t cells_ = 0;
  double pooled_variance_ = 0.0;
  double grid_step_ = 0.0;    ///< step of the grid of ln σ
  std::vector<double> grid_;  ///< σ
  /// Of a cell: it is of this class, or with a probability of `next` of the one behind.
  struct Membership {
    std::uint32_t place = 0;
    float next = 0.0F;
  };
  std::vector<Membership> memberships_;  ///< empty where every cell is a class of its own
  std::vector<Hypothesis> hypotheses_;
  WeightedChoice choice_;
};

}  // namespace axiometry::numeric
