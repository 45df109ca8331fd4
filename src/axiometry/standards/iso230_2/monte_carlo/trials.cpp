// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/trials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/numeric/moments.h"

namespace axiometry::iso230_2 {
namespace {

// Streams of random numbers; inputs take one each, from first_of_inputs on.
constexpr std::uint64_t of_posterior = 0;
constexpr std::uint64_t of_sampling = of_posterior + ReadingPosterior::streams;
constexpr std::uint64_t of_drift = of_sampling + 1;
constexpr std::uint64_t first_of_inputs = of_drift + 1;  // errors of targets and levels follow the inputs

constexpr double m_per_mm = 1e-3;

bool is_long_run(const TrialModelOptions& options) {
  return options.sampling && options.measurand == Measurand::this_machine;
}

ReadingPosterior::Asked asked_of(const TrialModelOptions& options) {
  return is_long_run(options) ? ReadingPosterior::Asked::long_run : ReadingPosterior::Asked::readings;
}

/// The readings less what is expected of the drift.
Series without(const Series& series, std::span<const double> drift) {
  std::vector<double> readings;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i)
      for (double x : series.cell(i, direction)) readings.push_back(x - drift[readings.size()]);
  auto still = Series::make_dense({series.targets().begin(), series.targets().end()}, series.run_count(), readings);
  return still ? *std::move(still) : series;  // fails only at the limit of what a reading may be
}

/// f_t(α, ΔT) − f_t(α̂, ΔT̂) in µm/m, α in µm/(m·°C); the difference of (14) without cancellation.
double expansion_error(double alpha, double dT, double alpha_estimate, double dT_estimate) {
  const double strain = alpha * dT;
  const double strain_estimate = alpha_estimate * dT_estimate;
  return (strain_estimate - strain) / ((1.0 + 1e-6 * strain) * (1.0 + 1e-6 * strain_estimate));
}

/// For θ in °, in µm/m: 1/cos θ − 1, by which an instrument at this angle to the axis shows too little; cos θ − 1 of
/// an artefact, which along the axis is shorter than it is long. sin² does not cancel where cos does. At 90°, where
/// nothing is shown, a finite number.
double cosine_error(double theta_deg, bool of_artefact) {
  const double s = std::sin(0.5 * theta_deg * std::numbers::pi / 180.0);
  return of_artefact ? -2e6 * s * s : 2e6 * s * s / std::max(1.0 - 2.0 * s * s, 1e-9);
}

}  // namespace

TrialModel::TrialModel(const Series& series, const UncertaintyInputs& inputs, const NoiseModel& noise,
                       const TrialModelOptions& options, const TrialModel* alike)
    : series_(series), inputs_(inputs), options_(options), layout_(series), drift_(noise.drift) {
  find_length_errors();
  if (inputs.station) station_.emplace(series.targets(), *inputs.station);
  noise_ = options.sampling ? noise.shares : std::vector<ReadingNoise>{ReadingNoise{}};
  if (!options.sampling) drift_.reset();
  const std::optional<Series> still = drift_ ? std::optional(without(series, drift_->expected())) : std::nullopt;
  posteriors_.reserve(noise_.size());
  for (const ReadingNoise& share : noise_) {
    const ReadingPosterior* const other = !posteriors_.empty() ? &posteriors_.back()
                                          : alike != nullptr   ? &alike->posteriors_.back()
                                                               : nullptr;
    posteriors_.emplace_back(still ? *still : series, share, asked_of(options), other);
  }
}

numeric::RandomKey TrialModel::posterior_key(std::uint64_t place) const { return {options_.seed, of_posterior, place}; }
numeric::RandomKey TrialModel::drift_key(std::uint64_t place) const { return {options_.seed, of_drift, place}; }

/// Draws of one input.
std::vector<double> TrialModel::draws(std::size_t input, std::uint64_t place) const {
  std::vector<double> values(chunk);
  const auto& distribution = inputs_.inputs[input].distribution;
  if (options_.only_input && *options_.only_input != input) {
    std::ranges::fill(values, distribution.mean());
    return values;
  }
  distribution.sample({options_.seed, first_of_inputs + input, place}, values);
  return values;
}

/// α and ΔT of one body make one error of length; all other systematic inputs one each.
void TrialModel::find_length_errors() {
  const auto& all = inputs_.inputs;
  const auto find = [&](Effect effect) {
    const auto found = std::ranges::find(all, effect, &UncertaintyInput::effect);
    return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
  };
  for (std::size_t k = 0; k < all.size(); ++k) {
    LengthError error{all[k].effect, k, std::nullopt};
    switch (error.effect) {
      case Effect::machine_expansion: error.temperature = find(Effect::machine_temperature); break;
      case Effect::device_expansion: error.temperature = find(Effect::device_temperature); break;
      case Effect::alignment:
      case Effect::scale: break;
      default: continue;
    }
    const bool expansion = error.effect != Effect::alignment && error.effect != Effect::scale;
    if (!expansion || error.temperature) length_errors_.push_back(error);
  }
}

/// Draws of one error in µm/m.
std::vector<double> TrialModel::draw(const LengthError& error, std::uint64_t place) const {
  std::vector<double> values = draws(error.input, place);
  const uncertainty::Distribution& own = inputs_.inputs[error.input].distribution;
  if (error.temperature) {
    const std::vector<double> dT = draws(*error.temperature, place);
    const double dT_estimate = inputs_.inputs[*error.temperature].distribution.mean();
    for (std::size_t t = 0; t < chunk; ++t) values[t] = expansion_error(values[t], dT[t], own.mean(), dT_estimate);
  } else if (error.effect == Effect::alignment) {
    // The readings have no correction for it: each draw takes out all of it, not what departs from the mean.
    const bool varied = !options_.only_input || *options_.only_input == error.input;
    for (double& value : values) value = varied ? cosine_error(value, inputs_.of_artefact) : 0.0;
  }
  return values;
}

/// Errors of length from all systematic inputs: deviation per position.
std::vector<double> TrialModel::length_errors(std::uint64_t place) const {
  std::vector<double> errors(chunk);
  for (const LengthError& error : length_errors_) {
    const std::vector<double> drawn = draw(error, place);
    for (std::size_t t = 0; t < chunk; ++t) errors[t] += drawn[t] * m_per_mm;
  }
  return errors;
}

/// Each cell for itself: σ² + u² from χ², μ from the normal distribution that follows (together Student's t).
void TrialModel::draw_t_scaled(std::uint64_t place, numeric::Rows<double> means, numeric::Rows<double> sds) const {
  const ReadingNoise& noise = noise_.front();
  const double noise_variance = std::pow(noise.reading, 2) + std::pow(noise.run, 2);
  std::vector<double> normals(chunk * (series_.run_count() + 1));
  for (std::size_t c = 0; c < 2 * series_.target_count(); ++c) {
    const auto direction = static_cast<Direction>(c / series_.target_count());
    const numeric::Moments cell = numeric::moments(series_.cell(c % series_.target_count(), direction));
    if (cell.count < 2) continue;
    const double sum_of_squares = std::pow(cell.standard_deviation, 2) * static_cast<double>(cell.count - 1);
    numeric::fill_normal({options_.seed, of_sampling, place * 2 * series_.target_count() + c}, normals);
    for (std::size_t t = 0; t < chunk; ++t) {
      double chi_square = 0.0;
      for (std::size_t k = 1; k < cell.count; ++k) chi_square += std::pow(normals[k * chunk + t], 2);
      const double variance = sum_of_squares / chi_square;
      means.row(c, chunk)[t] = cell.mean + std::sqrt(variance / static_cast<double>(cell.count)) * normals[t];
      sds.row(c, chunk)[t] = std::sqrt(std::max(0.0, variance - noise_variance));
    }
  }
}

/// Whole runs drawn with replacement, so that what readings of a run have in common stays.
void TrialModel::draw_resampled(std::uint64_t place, numeric::Rows<double> readings) const {
  const std::size_t runs = series_.run_count();
  const std::size_t targets = series_.target_count();
  std::vector<double> uniforms(chunk * runs);
  numeric::fill_uniform({options_.seed, of_sampling, place}, uniforms);
  for (std::size_t c = 0; c < 2 * targets; ++c) {
    const auto cell = series_.cell(c % targets, static_cast<Direction>(c / targets));
    for (std::size_t j = 0; j < runs; ++j)
      for (std::size_t t = 0; t < chunk; ++t)
        readings.row(c * runs + j, chunk)[t] =
            cell[std::min(runs - 1, static_cast<std::size_t>(uniforms[j * chunk + t] * static_cast<double>(runs)))];
  }
}

/// The errors of length at every target: rows of readings (or of means) of one direction move together.
void TrialModel::add_length_errors(std::uint64_t place, std::size_t rows_per_cell, numeric::Rows<double> rows) const {
  if (length_errors_.empty()) return;
  const std::vector<double> error = length_errors(place);
  const std::size_t targets = series_.target_count();
  for (std::size_t c = 0; c < 2 * targets; ++c) {
    const double position = series_.targets()[c % targets].in_native();
    for (std::size_t k = 0; k < rows_per_cell; ++k) {
      const auto row = rows.row(c * rows_per_cell + k, chunk);
      for (std::size_t t = 0; t < chunk; ++t) row[t] += position * error[t];
    }
  }
}

/// Squares of the station's offset.
std::vector<double> TrialModel::station_squares(std::uint64_t place) const {
  std::vector<double> squares(chunk);
  for (std::size_t k = 0; k < inputs_.inputs.size(); ++k) {
    if (inputs_.inputs[k].effect != Effect::station) continue;
    const std::vector<double> offset = draws(k, place);
    for (std::size_t t = 0; t < chunk; ++t) squares[t] += offset[t] * offset[t];
  }
  return squares;
}

/// What the draws of the station's offset take away: the readings hold its length difference, the trials do not.
void TrialModel::add_station_errors(std::uint64_t place, std::size_t rows_per_cell, numeric::Rows<double> rows) const {
  if (!station_) return;
  const std::vector<double> squares = station_squares(place);
  const std::size_t targets = series_.target_count();
  std::vector<double> error(chunk);
  for (std::size_t i = 0; i < targets; ++i) {
    for (std::size_t t = 0; t < chunk; ++t) error[t] = station_->error_um(i, squares[t]);
    for (std::size_t c : {i, targets + i})
      for (std::size_t k = 0; k < rows_per_cell; ++k) {
        const auto row = rows.row(c * rows_per_cell + k, chunk);
        for (std::size_t t = 0; t < chunk; ++t) row[t] -= error[t];
      }
  }
}

/// The errors of single targets, where no posterior has taken them out of the readings: rows of one cell move alike.
void TrialModel::add_target_errors(std::uint64_t place, std::size_t rows_per_cell, numeric::Rows<double> rows) const {
  const ReadingNoise& noise = noise_.front();
  if (noise.target == 0.0 && noise.target_direction == 0.0) return;
  const std::size_t targets = series_.target_count();
  const double r = noise.up_down_correlation;
  const double own = std::hypot(std::sqrt(1.0 - std::abs(r)) * noise.target, noise.target_direction);
  std::vector<double> normals(3 * targets * chunk);  // rows: what both directions share, then what each has of its own
  numeric::fill_normal({options_.seed, first_of_inputs + inputs_.inputs.size(), place}, normals);
  for (std::size_t c = 0; c < 2 * targets; ++c) {
    const double shared = std::sqrt(std::abs(r)) * noise.target * (c >= targets && r < 0.0 ? -1.0 : 1.0);
    const auto z_shared = std::span(normals).subspan(c % targets * chunk, chunk);
    const auto z_own = std::span(normals).subspan((targets + c) * chunk, chunk);
    for (std::size_t k = 0; k < rows_per_cell; ++k) {
      const auto row = rows.row(c * rows_per_cell + k, chunk);
      for (std::size_t t = 0; t < chunk; ++t) row[t] += shared * z_shared[t] + own * z_own[t];
    }
  }
}

bool TrialModel::is_between_places(std::size_t output) const {
  if (options_.figures != nullptr) return options_.figures->figures[output].between_places;
  const std::string_view key = layout_.outputs()[output]->key;
  return key.starts_with('A') || key.starts_with('E') || key.starts_with('M');
}

/// What any two places differ by: it makes the parameters that are distances between two places longer or shorter, and
/// has no part in reversals and scatter. A distance below 0 has its ends exchanged.
void TrialModel::add_displacement_errors(std::uint64_t place, numeric::Rows<double> outputs) const {
  for (std::size_t k = 0; k < inputs_.inputs.size() && series_.target_count() > 1; ++k) {
    if (inputs_.inputs[k].effect != Effect::displacement) continue;
    const std::vector<double> error = draws(k, place);
    for (std::size_t p = 0; p < output_count(); ++p) {
      if (!is_between_places(p)) continue;
      const auto row = outputs.row(p, chunk);
      for (std::size_t t = 0; t < chunk; ++t) row[t] = std::abs(row[t] + error[t]);
    }
  }
}

bool TrialModel::draws_readings_alone() const { return is_long_run(options_) && options_.type_a == TypeA::resampled; }

bool TrialModel::draws_moments_alone() const { return is_long_run(options_) && !draws_readings_alone(); }

TrialModel::DrawnCells TrialModel::draw_cells(std::uint64_t place, bool as_readings) const {
  const bool long_run = is_long_run(options_);
  const ReadingPosterior& posterior = posteriors_[place % posteriors_.size()];
  DrawnCells drawn;
  if (!draws_readings_alone() && !as_readings) {
    drawn.means = numeric::UnsetNumbers<double>(layout_.cell_rows() * chunk);
    drawn.estimators = numeric::UnsetNumbers<double>(layout_.cell_rows() * chunk);
    if (!series_.complete()) {  // a cell without readings is not drawn
      std::ranges::fill(drawn.means.all(), 0.0);
      std::ranges::fill(drawn.estimators.all(), 0.0);
    }
  }
  const numeric::Rows<double> mean_rows{drawn.means.all(), chunk}, estimator_rows{drawn.estimators.all(), chunk};
  if (draws_moments_alone()) {
    if (options_.type_a == TypeA::pooled) {
      posterior.draw_long_run(posterior_key(place), mean_rows, estimator_rows);
    } else {
      draw_t_scaled(place, mean_rows, estimator_rows);
      add_target_errors(place, 1, mean_rows);
    }
    if (drift_) drift_->subtract_from_means(drift_key(place), mean_rows);
    add_length_errors(place, 1, mean_rows);
    add_station_errors(place, 1, mean_rows);
    return drawn;
  }
  if (!long_run && !as_readings) {
    draw_cell_moments(place, mean_rows, estimator_rows);
    return drawn;
  }
  drawn.readings.resize(layout_.reading_rows() * chunk);
  const numeric::Rows<double> rows{drawn.readings, chunk};
  if (long_run) {
    draw_resampled(place, rows);
    add_target_errors(place, series_.run_count(), rows);
  } else {
    posterior.draw_readings(posterior_key(place), rows);
    if (drift_) drift_->subtract_from_readings(drift_key(place), rows);
  }
  add_length_errors(place, series_.run_count(), rows);
  add_station_errors(place, series_.run_count(), rows);
  return drawn;
}

/// What all readings have in common, where it counts. Cells that are drawn each for itself, and runs that are drawn
/// with replacement, have the shifts of their runs in them.
void TrialModel::add_levels(std::uint64_t place, DrawnCells& drawn) const {
  if (is_long_run(options_) && options_.type_a != TypeA::pooled) return;
  const numeric::RandomKey own{options_.seed, first_of_inputs + inputs_.inputs.size() + 1, place};
  const std::vector<double> levels =
      posteriors_[place % posteriors_.size()].draw_levels(posterior_key(place), own, chunk, asked_of(options_));
  for (const std::span<double> rows : {std::span(drawn.readings), drawn.means.all()})
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] += levels[k % chunk];
}

void TrialModel::draw_chunk(std::uint64_t place, numeric::Rows<double> outputs) const {
  if (options_.figures != nullptr) return draw_figures(place, outputs);
  const DrawnCells drawn = draw_cells(place);
  const numeric::Rows<const double> readings{drawn.readings, chunk}, means{drawn.means.all(), chunk},
      estimators{drawn.estimators.all(), chunk};
  if (drawn.readings.empty())
    evaluate_batch(layout_, CellMoments<double>{means, estimators}, chunk, outputs);
  else
    evaluate_batch(layout_, readings, chunk, outputs);
}

void TrialModel::operator()(std::uint64_t block, uncertainty::BlockOutputs outputs) const {
  std::vector<double> last;
  for (std::size_t begin = 0; begin < outputs.trials; begin += chunk) {
    const std::uint64_t place = block * (uncertainty::block_size / chunk) + begin / chunk;
    const std::size_t count = std::min(chunk, outputs.trials - begin);
    numeric::Rows<double> drawn{outputs.values.subspan(begin), outputs.trials};
    if (count < chunk) {  // fewer are wanted than are drawn
      last.resize(output_count() * chunk);
      drawn = {last, chunk};
    }
    draw_chunk(place, drawn);
    add_displacement_errors(place, drawn);
    for (std::size_t p = 0; p < output_count() && count < chunk; ++p)
      std::ranges::copy(drawn.row(p, count), outputs.row(p).begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

}  // namespace axiometry::iso230_2
