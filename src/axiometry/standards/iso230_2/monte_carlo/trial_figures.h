// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"

/// Figures of a test that are no parameters of clause 3, as those of other rules, carried through trials of the same
/// distribution: each is a complete test that may have happened, and they are evaluated of it as of the one that was
/// measured.
namespace axiometry::iso230_2 {

struct TrialFigure {
  double value = 0.0;  ///< value of the measured test, native deviation unit
  /// Whether it is a distance between two places, so that an input by which any two positions differ acts on it
  /// (Effect::displacement).
  bool between_places = false;
  /// Whether it is made of single readings and not of means and s of the targets alone: in the long run of a machine,
  /// unless whole runs are resampled, there are none.
  bool of_single_readings = false;
  /// Whether what all readings have in common is in it (ReadingPosterior::draw_levels()).
  bool counts_from_zero = false;
};

/// Figures that are wanted of a trial.
struct WantedFigures {
  bool of_moments = true;
  bool of_single_readings = true;
  bool from_zero = false;  ///< those that count from zero, or the others

  bool has(const TrialFigure& figure) const {
    return figure.counts_from_zero == from_zero && (figure.of_single_readings ? of_single_readings : of_moments);
  }
};

struct TrialFigures {
  std::vector<TrialFigure> figures;
  /// The wanted ones of one trial, in the order of all; those that it leaves alone keep the measured value. Pure,
  /// called from several threads. Where none of single readings is wanted, the trial may have any readings that have
  /// the cell's mean and s, and of the long run two in each cell.
  std::function<void(const Series& trial, const WantedFigures& wanted, std::span<double> values)> evaluate;
};

/// As MonteCarlo, of other figures.
struct FigureTrials {
  Measurand measurand = Measurand::this_test;
  std::uint64_t seed = 0;
  std::size_t trials = 0;
  bool adaptive = false;
  bool stable = false;
  double coverage = 0.95;
  /// Of each figure; absent where nothing that is known acts on it, or where the long run has no single readings.
  std::vector<std::optional<ParameterDistribution>> distributions;
  std::vector<std::string> notes;  ///< what was assumed, what the intervals hold for
};

/// Nothing, and failures, as monte_carlo() has them. A trial takes a time that grows with the readings and with what
/// `evaluate` does.
Result<std::optional<FigureTrials>> monte_carlo(const Test& test, const Evaluation& evaluation,
                                                const TrialFigures& figures, const MonteCarloOptions& options);

}  // namespace axiometry::iso230_2
