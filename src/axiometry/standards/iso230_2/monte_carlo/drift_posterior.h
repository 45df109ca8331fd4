// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/numeric/random/weighted_choice.h"
#include "axiometry/numeric/rows.h"
#include "axiometry/standards/iso230_2/monte_carlo/environment_modes.h"

/// What a slow variation of the environment has done to the readings, given the readings.
///
/// x_r = μ_c + ε_r + a Σ_k φ_k(τ_r) c_k: any mean μ_c of a target and direction, scatter ε of the standard deviation σ,
/// and the shapes φ of the variation with standard normal c_k and the size a. What changes from approach to approach of
/// a cell tells about c; what the means of the cells hide stays as uncertain as it was before. σ and a are not known
/// either: σ is equally likely in every octave about what was seen, ln a is normal about the stated size, if it is not
/// taken as it is, with a factor of two, from an eighth to eight times of it, and the readings decide (a grid, so that
/// draws are independent).
/// Derivation: docs/theory/monte-carlo.md.
namespace axiometry::iso230_2 {

/// What the runs of the machine do as a whole, beside the variation.
enum class MachineRuns {
  steady,    ///< nothing: every shift of a run is the variation's
  shifting,  ///< shift by any amount, each of its own: what the readings of a run have in common tells nothing
  scattered  ///< shift by normal amounts of an unknown standard deviation: of a variation that is slower than a run the
             ///< means of the runs alone tell
};

/// What of the shapes of a variation is seen in the residuals of the readings about the means of their cells: beside
/// those of their runs where these shift freely, in those of their runs alone where these scatter. In the axes used
/// here each shape is seen independently of the others, in the residual coordinate √λ c + ε.
struct SeenModes {
  SeenModes(const Series& series, const EnvironmentModes& modes, MachineRuns machine_runs = MachineRuns::steady);

  std::size_t count = 0;
  std::vector<double> of_readings;  ///< shapes in these axes, one after the other, per reading …
  std::vector<double> of_means;     ///< … and their mean in every cell, in the order direction, target
  std::vector<double> sizes;        ///< λ; 0 for what is not seen
  std::vector<double> coordinates;
  double squares = 0.0;  ///< sum of the squares of the residuals
  double degrees_of_freedom = 0.0;
  double squares_left = 0.0;  ///< sum of squares without what shapes of any size can explain
  double degrees_of_freedom_left = 0.0;
  double least_scatter = 0.0;  ///< standard deviation within runs, where the means of runs tell: they scatter by more
};

/// What is known of the size a before the readings tell more.
struct VariationSize {
  double range = 0.0;   ///< E_VE, as stated or the largest that is held possible, native deviation unit, > 0
  bool doubted = true;  ///< whether a is not `range`, but normal about it in its logarithm
};

class DriftPosterior {
 public:
  /// Takes a time that grows with N K².
  DriftPosterior(const Series& series, const EnvironmentModes& modes, VariationSize size, MachineRuns machine_runs);

  /// E(e_r), dense as in Series::make_dense(); 0 where no reading is.
  std::span<const double> expected() const { return expected_; }
  /// Posterior mean of a over the size known before.
  double relative_size() const { return relative_size_; }

  /// Takes e − E(e) of every reading away: rows as in Series::make_dense(), a column for every trial. Uses one stream.
  void subtract_from_readings(numeric::RandomKey key, numeric::Rows<double> readings) const;
  /// The same of the readings of one cell after the other: a row for each run of the cell at this place in the order
  /// direction, target.
  using Drawn = std::vector<double>;  ///< coordinates of e − E(e), a row for each shape
  Drawn draw(numeric::RandomKey key, std::size_t trials) const;
  void subtract_from_cell(const Drawn& drawn, std::size_t cell, numeric::Rows<double> readings) const;
  /// The same of the means of the cells: rows in the order direction, target.
  void subtract_from_means(numeric::RandomKey key, numeric::Rows<double> means) const;

 private:
  /// One pair of σ and a: what it makes of the coordinates of e.
  struct Hypothesis {
    std::vector<double> mean;  ///< less the mean over all hypotheses
    std::vector<double> sd;
  };
  void consider_hypotheses(VariationSize size);
  void subtract(const Drawn& drawn, std::span<const double> factors, std::size_t first,
                numeric::Rows<double> rows) const;

  SeenModes seen_;
  std::vector<double> factors_of_readings_, factors_of_means_;  ///< the shapes at each place, one place after the other
  double relative_size_ = 1.0;
  std::vector<Hypothesis> hypotheses_;
  numeric::WeightedChoice choice_;
  std::vector<double> expected_;
};

}  // namespace axiometry::iso230_2
