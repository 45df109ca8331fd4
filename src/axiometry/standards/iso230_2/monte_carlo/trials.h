// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/numeric/rows.h"
#include "axiometry/standards/iso230_2/batch.h"
#include "axiometry/standards/iso230_2/inputs/inputs.h"
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"
#include "axiometry/standards/iso230_2/monte_carlo/noise.h"
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"
#include "axiometry/standards/iso230_2/monte_carlo/trial_figures.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/standards/readings/station_offset.h"
#include "axiometry/uncertainty/monte_carlo.h"

/// The trials of monte_carlo.h, block by block; private to it and its tests.
namespace axiometry::iso230_2 {

struct TrialModelOptions {
  Measurand measurand = Measurand::this_test;
  TypeA type_a = TypeA::pooled;
  std::uint64_t seed = 1;
  bool sampling = true;                   ///< whether approaches and their noise vary from trial to trial
  std::optional<std::size_t> only_input;  ///< the others stay at their estimates
  const TrialFigures* figures = nullptr;  ///< figures in place of the parameters; must outlive the model
};

class TrialModel {
 public:
  /// Refers to series and inputs, which must outlive it. The noise is that of the model, whatever the inputs say. What
  /// depends on the targets alone is shared with `alike`, if that has the same ones.
  TrialModel(const Series& series, const UncertaintyInputs& inputs, const NoiseModel& noise,
             const TrialModelOptions& options, const TrialModel* alike = nullptr);

  /// Parameters that exist, in the order of `parameters`: one row of outputs each.
  std::span<const ParameterInfo* const> outputs() const { return layout_.outputs(); }
  /// Of the parameters, or of the figures that stand in their place.
  std::size_t output_count() const {
    return options_.figures == nullptr ? layout_.outputs().size() : options_.figures->figures.size();
  }

  /// One block of trials (uncertainty::BlockModel).
  void operator()(std::uint64_t block, uncertainty::BlockOutputs outputs) const;

  /// One block of the same trials as mean deviations: of each of these targets a row x̄_i↑, one x̄_i↓ and one x̄_i
  /// (3.12, 3.14); 0 where a direction has no readings. An error between any two places counts from where the
  /// instrument was set to zero, as in gum_positions.cpp.
  void draw_means(std::uint64_t block, std::span<const std::size_t> targets, uncertainty::BlockOutputs outputs) const;

 private:
  /// Trials that are drawn together; a block holds a whole number of them.
  static constexpr std::size_t chunk = 80;
  static_assert(uncertainty::block_size % chunk == 0);

  /// A relative error of length, made of one input, or of α and ΔT of one body.
  struct LengthError {
    Effect effect = Effect::scale;
    std::size_t input = 0;                   ///< number in UncertaintyInputs; α where there are two
    std::optional<std::size_t> temperature;  ///< ΔT
  };

  void find_length_errors();
  numeric::RandomKey posterior_key(std::uint64_t place) const;
  numeric::RandomKey drift_key(std::uint64_t place) const;
  std::vector<double> draws(std::size_t input, std::uint64_t place) const;
  std::vector<double> draw(const LengthError& error, std::uint64_t place) const;
  std::vector<double> length_errors(std::uint64_t place) const;
  void add_length_errors(std::uint64_t place, std::size_t rows_per_cell, numeric::Rows<double> rows) const;
  std::vector<double> station_squares(std::uint64_t place) const;
  void add_station_errors(std::uint64_t place, std::size_t rows_per_cell, numeric::Rows<double> rows) const;
  void add_target_errors(std::uint64_t place, std::size_t rows_per_cell, numeric::Rows<double> rows) const;
  void add_displacement_errors(std::uint64_t place, numeric::Rows<double> outputs) const;
  void draw_t_scaled(std::uint64_t place, numeric::Rows<double> means, numeric::Rows<double> sds) const;
  void draw_resampled(std::uint64_t place, numeric::Rows<double> readings) const;
  bool is_between_places(std::size_t output) const;
  void evaluate_figures(numeric::Rows<const double> readings, std::size_t runs, const WantedFigures& wanted,
                        numeric::Rows<double> outputs) const;
  void evaluate_figures(numeric::Rows<const double> means, numeric::Rows<const double> estimators,
                        const WantedFigures& wanted, numeric::Rows<double> outputs) const;
  void draw_figures(std::uint64_t place, numeric::Rows<double> outputs) const;
  bool draws_readings_alone() const;  ///< runs are resampled
  bool draws_moments_alone() const;   ///< whether it draws nothing but moments of the long run
  /// What the axis did in the trials of a chunk: readings, or what evaluate_batch() takes of cells.
  struct DrawnCells {
    std::vector<double> readings;                     ///< empty where means are drawn
    numeric::UnsetNumbers<double> means, estimators;  ///< empty where readings are
  };
  DrawnCells draw_cells(std::uint64_t place, bool as_readings = false) const;
  void add_levels(std::uint64_t place, DrawnCells& drawn) const;
  std::vector<double> mean_of_cell(const DrawnCells& drawn, std::size_t target, Direction direction) const;
  std::vector<double> displacements(std::uint64_t place) const;
  void draw_cell_moments(std::uint64_t place, numeric::Rows<double> means, numeric::Rows<double> estimators) const;
  void take_cell_moments(std::uint64_t place, numeric::Rows<double> means, numeric::Rows<double> estimators) const;
  void draw_chunk(std::uint64_t place, numeric::Rows<double> outputs) const;

  const Series& series_;
  const UncertaintyInputs& inputs_;
  TrialModelOptions options_;
  BatchLayout layout_;
  std::vector<LengthError> length_errors_;
  std::optional<StationErrors> station_;
  std::vector<ReadingNoise> noise_;           ///< shares, which the chunks of trials take in turn
  std::vector<ReadingPosterior> posteriors_;  ///< a posterior for each share
  std::shared_ptr<const DriftPosterior> drift_;
};

}  // namespace axiometry::iso230_2
