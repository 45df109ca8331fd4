// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/numeric/curve_posterior.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/numeric/random/weighted_choice.h"
#include "axiometry/numeric/rows.h"
#include "axiometry/numeric/spread_posterior.h"

/// What the axis truly did, and what it would do in the long run, given readings that contain noise of known size.
///
/// A reading is x_ij = μ_i + ρ_j + ε_ij (the machine) + d_j + e_ij + δ_i (the measurement): μ the long-run means
/// of a direction, ρ and d shifts of a whole run, ε and e independent from reading to reading, δ common to a
/// target. Known are the sizes of d, e and δ; what the machine has of its own, the readings must tell. Adding d, e
/// and δ once more around the readings would count them twice. Instead each observed departure is shared between
/// machine and measurement in the ratio of their variances, and never below zero: the generalisation of (A.10).
/// Where runs have slopes of their own (counts() of tilt_study), the long run has the mean of all such slopes, of which
/// the test has seen n: μ_i turns by it. Derivation, and proof of the coverage by simulation:
/// docs/theory/uncertainty.md, docs/studies/coverage.md.
///
/// What all readings have in common is drawn by itself, by draw_levels(): no parameter of clause 3 depends on it, but
/// figures that count from zero do.
namespace axiometry::iso230_2 {

/// Standard uncertainties in the native deviation unit (µm or ″), all ≥ 0.
struct ReadingNoise {
  double reading = 0.0;              ///< u(e), of each reading
  double run = 0.0;                  ///< u(d), common to a run
  double target = 0.0;               ///< u(δ), of a target in either direction …
  double up_down_correlation = 1.0;  ///< … with this correlation between the two, −1 to 1
  double target_direction = 0.0;     ///< standard uncertainty of a target in one direction, independent
};

class ReadingPosterior {
 public:
  enum class Asked { long_run, readings };  ///< what will be drawn: both, or readings alone

  /// Takes a time that grows with the readings, but none for readings alone of exact() instruments. What depends on the
  /// targets alone is shared with `alike`, if that has the same ones.
  ReadingPosterior(const Series& series, const ReadingNoise& noise, Asked asked = Asked::long_run,
                   const ReadingPosterior* alike = nullptr);

  /// What perfect instruments would have read: rows in the order of Series::cell (direction, target, run), NaN
  /// where no reading is. Uses the streams from `key.stream` on, `streams` of them.
  void draw_readings(numeric::RandomKey key, numeric::Rows<double> readings) const;

  /// The same, one cell after the other, while its readings are in the nearest cache: calls visit(place of the cell in
  /// the order direction, target; rows over its runs, NaN where no reading is). Cells without a reading are left out.
  using VisitCell = std::function<void(std::size_t place, numeric::Rows<double> readings)>;
  void draw_cells(numeric::RandomKey key, std::size_t trials, const VisitCell& visit) const;

  /// Mean and estimator of the readings that draw_readings() would give, of the same distribution but without making
  /// them: other random numbers, and fewer. Rows in the order direction, target; NaN where no reading is.
  /// `take_away` is called for each cell with rows over its runs, NaN where no reading is, and may take any number away
  /// from each; it may be empty. Contract: independent_noise(), and trials in whole groups of normal numbers.
  using TakeAway = std::function<void(std::size_t place, numeric::Rows<double> readings)>;
  struct MomentRows {
    numeric::Rows<double> means, estimators;  ///< rows of one stride, the number of trials; 0: a cell has one reading
  };
  void draw_moments(numeric::RandomKey key, const MomentRows& moments, const TakeAway& take_away = {}) const;

  /// Contract: asked for. Long-run μ and σ of each cell: rows in the order direction, target; NaN where no reading is.
  /// σ contains the machine's own shifts from run to run.
  void draw_long_run(numeric::RandomKey key, numeric::Rows<double> means, numeric::Rows<double> sds) const;

  /// By how much the level of all readings lies beside that of the draws of `key`, for each of their trials. The mean
  /// of n shifts of runs is in the level that was seen; of the long run it is none of the machine's, and of readings
  /// perfect instruments lack the part of d: standard deviation √((σ_ρ² + u(d)²)/n) and u(d)/√n, of the latter what the
  /// draws do not have yet. Random numbers from `own`. 0 where two or more runs have fewer than 3 cells,
  /// so that their shifts are not followed.
  std::vector<double> draw_levels(numeric::RandomKey key, numeric::RandomKey own, std::size_t trials,
                                  Asked asked) const;

  static constexpr std::uint64_t streams = 2;

  /// Whether the readings are exactly what the axis did: no noise of known size.
  bool exact() const { return exact_; }
  /// Whether each reading has noise of its own, so that draw_moments() saves the numbers for it.
  bool independent_noise() const { return noise_.reading > 0.0; }

 private:
  struct Cell {
    std::size_t place = 0;  ///< direction × m + target
    std::size_t target = 0;
    std::size_t count = 0;          ///< n
    double mean = 0.0;              ///< x̄ without the shifts of the runs that it happens to have
    std::vector<double> readings;   ///< readings per run, NaN where missing
    std::vector<double> residuals;  ///< residuals per run: x less mean and shift of the run
  };
  /// A curve over the targets: the middle of ↑ and ↓, their difference, or one direction alone.
  struct Curve {
    numeric::CurvePosterior posterior;
    struct Term {
      std::size_t cell, place;
      double factor;
    };
    std::vector<Term> terms;  ///< how the curve's values add to the cells' means
  };
  struct State;

  void find_run_shifts();
  void take_run_shifts(std::span<const double> cells_of_run);
  void take_cell_means();
  void find_spread();
  void find_run_sds();
  /// Values of a curve, where they come from, and whose places it may have.
  struct CurveData {
    std::vector<double> values;
    std::vector<Curve::Term> terms;
    double noise_variance = 0.0;
    std::size_t trend_terms = 2;
    const ReadingPosterior* alike = nullptr;
  };
  void find_tilts(const Series& series);
  void find_curves(const Series& series, const ReadingPosterior* alike);
  void add_curve(const Series& series, CurveData data);
  void draw_means(State& state, std::span<const double> uniforms, std::span<const double> normals) const;
  /// Uniform numbers of each trial: two for σ, two for σ_ρ, one for every curve, one for every cell.
  std::size_t uniforms_each() const { return 4 + curves_.size() + cells_.size(); }
  void draw_spreads(std::span<const double> uniforms, numeric::Rows<double> sds, std::span<double> run_sds) const;
  /// Of the long run in each trial and direction: by how much the mean of all tilts lies beside that of the test's
  /// runs; and the square of what σ of the tilts is of what was found. Random numbers of the stream that readings have,
  /// of which there are none.
  struct TiltDraws {
    std::array<std::vector<double>, 2> of_mean;
    std::vector<double> square_shares;
  };
  TiltDraws draw_tilts(numeric::RandomKey key, std::size_t trials) const;
  State draw_state(numeric::RandomKey key, std::size_t trials, Asked asked) const;
  std::vector<double> draw_target_shifts(State& state) const;
  void share_means(State& state) const;
  void share_mean(std::size_t index, State& state, const double* z) const;
  std::vector<double> draw_run_shifts(State& state) const;
  void draw_cell(std::size_t index, std::span<const double> shifts, State& state, numeric::Rows<double> readings) const;
  void part_shifts(std::size_t index, std::span<const double> shifts, const TakeAway& take_away, State& state) const;
  void draw_moments_of(std::size_t index, State& state, const MomentRows& moments) const;

  std::size_t targets_ = 0;
  std::size_t runs_ = 0;
  ReadingNoise noise_;
  double shared_variance_ = 0.0;  ///< variance of δ that ↑ and ↓ share, with opposite signs where r < 0
  double own_variance_ = 0.0;     ///< variance of δ that either direction of a target has of its own
  double down_sign_ = 1.0;
  bool exact_ = false;
  std::vector<Cell> cells_;
  double cells_per_run_ = 0.0;      ///< C, on average; 0 where shifts of the runs are not followed, and of one run
  std::vector<double> run_shifts_;  ///< observed ρ_j + d_j, about their mean
  std::vector<double> run_sds_;     ///< what the machine's own σ_ρ may be, draws fill the steps between
  double run_step_ = 0.0;           ///< step of ln σ_ρ
  numeric::WeightedChoice run_choice_;
  /// Slopes of the runs, where these differ by more than chance easily makes: of tilts over the range of the targets.
  struct Tilts {
    double runs = 0.0;
    std::array<double, 2> variances{};  ///< of ↑ and of ↓, without what scatter makes of them
    std::array<double, 3> factor{};  ///< u, v and w of tilts ↑ = u z₁ and ↓ = v z₁ + w z₂ with that covariance
    std::array<double, 2>
        shifts{};                ///< shift of a run that goes with a tilt of 1: the axis stays in its place somewhere
    double kept = 1.0;           ///< part of σ² of all cells that is none of tilts
    std::vector<double> levers;  ///< what a tilt of 1 adds at each target
  };
  std::optional<Tilts> tilts_;
  std::optional<numeric::SpreadPosterior> spread_;
  std::vector<Curve> curves_;
  std::size_t curve_normals_ = 0;  ///< how many normal numbers one draw of all curves takes
};

}  // namespace axiometry::iso230_2
