// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr Direction both_directions[] = {Direction::up, Direction::down};

constexpr std::size_t cells_for_run_shifts = 3;  // with fewer, a shift of the run and scatter look alike
constexpr int sweeps = 20;                       // leave 1e-20 with a tenth of the readings missing
constexpr double least_run_sd = 0.1;             // of what noise alone would show, to ten times what was seen
constexpr double most_run_sd = 10.0;
constexpr std::size_t run_grid_size = 24;
constexpr double negligible_share = 1e-12;  // of the variance of δ, below which other noise is none

double square(double x) { return x * x; }

/// The part of a departure that is the first's own, where the variances of two causes add up.
double share(double own_variance, double other_variance) {
  return own_variance == 0.0 ? 0.0 : own_variance / (own_variance + other_variance);
}

}  // namespace

/// What all draws of a batch of trials need: rows over the cells, one value per trial.
struct ReadingPosterior::State {
  std::size_t trials = 0;
  std::vector<double> sds;       ///< σ
  std::vector<double> means;     ///< μ, then the true means of the cells' own approaches
  std::vector<double> run_sds;   ///< σ_ρ, one row
  std::vector<double> machines;  ///< σ²/(σ² + u²), the machine's share of the scatter; from share_means()
  std::vector<double> normals;   ///< spare ones: rows for share_means() and the readings
  std::size_t normals_used = 0;  ///< rows

  std::span<double> sd(std::size_t cell) { return std::span(sds).subspan(cell * trials, trials); }
  std::span<double> mean(std::size_t cell) { return std::span(means).subspan(cell * trials, trials); }
  std::span<double> machine(std::size_t cell) { return std::span(machines).subspan(cell * trials, trials); }
  std::span<const double> next_normals() { return std::span(normals).subspan(trials * normals_used++, trials); }
};

ReadingPosterior::ReadingPosterior(const Series& series, const ReadingNoise& noise, Asked asked,
                                   const ReadingPosterior* alike)
    : targets_(series.target_count()), runs_(series.run_count()), noise_(noise) {
  const double r = noise.up_down_correlation;
  shared_variance_ = std::abs(r) * square(noise.target);
  own_variance_ = (1.0 - std::abs(r)) * square(noise.target) + square(noise.target_direction);
  down_sign_ = r < 0.0 ? -1.0 : 1.0;
  exact_ = noise.reading == 0.0 && noise.run == 0.0 && noise.target == 0.0 && noise.target_direction == 0.0;
  for (Direction direction : both_directions) {
    for (std::size_t i = 0; i < targets_; ++i) {
      Cell cell{static_cast<std::size_t>(direction) * targets_ + i, i, series.count(i, direction), 0.0, {}, {}};
      if (cell.count == 0) continue;
      const auto readings = series.cell(i, direction);
      for (double x : readings)
        if (!std::isnan(x)) cell.mean += x / static_cast<double>(cell.count);
      cell.readings.assign(readings.begin(), readings.end());
      cell.residuals.resize(runs_);
      cells_.push_back(std::move(cell));
    }
  }
  if (cells_.size() < cells_for_run_shifts && runs_ >= 2) {  // a drift is then one more noise of the readings
    noise_.reading = std::hypot(noise_.reading, noise_.run);
    noise_.run = 0.0;
  }
  if (exact_ && asked == Asked::readings) return;
  find_run_shifts();
  find_curves(series, alike);
}

/// Departure of each run, and the means without it: the additive model x̄_c + q_j, by alternating means. Without
/// missing readings the first sweep is exact; with them each sweep leaves about the missing share of the error.
void ReadingPosterior::find_run_shifts() {
  run_shifts_.assign(runs_, 0.0);
  std::vector<double> cells_of_run(runs_, 0.0);
  for (const Cell& cell : cells_)
    for (std::size_t j = 0; j < runs_; ++j) cells_of_run[j] += std::isnan(cell.readings[j]) ? 0.0 : 1.0;
  if (runs_ >= 2 && cells_.size() >= cells_for_run_shifts) {
    for (double count : cells_of_run) cells_per_run_ += count / static_cast<double>(runs_);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      take_run_shifts(cells_of_run);
      take_cell_means();
    }
  }
  for (Cell& cell : cells_)
    for (std::size_t j = 0; j < runs_; ++j) cell.residuals[j] = cell.readings[j] - cell.mean - run_shifts_[j];
  find_spread();
  find_run_sds();
}

void ReadingPosterior::take_run_shifts(std::span<const double> cells_of_run) {
  for (std::size_t j = 0; j < runs_; ++j) {
    run_shifts_[j] = 0.0;
    if (cells_of_run[j] < double(cells_for_run_shifts)) continue;  // would take its readings for a shift
    for (const Cell& cell : cells_)
      if (!std::isnan(cell.readings[j])) run_shifts_[j] += (cell.readings[j] - cell.mean) / cells_of_run[j];
  }
}

void ReadingPosterior::take_cell_means() {
  for (Cell& cell : cells_) {
    cell.mean = 0.0;
    for (std::size_t j = 0; j < runs_; ++j)
      if (!std::isnan(cell.readings[j])) cell.mean += (cell.readings[j] - run_shifts_[j]) / double(cell.count);
  }
}

/// Taking out the shifts of the runs uses up one part in `cells_per_run` of the degrees of freedom.
void ReadingPosterior::find_spread() {
  std::vector<numeric::CellScatter> scatter;
  for (const Cell& cell : cells_) {
    double squares = 0.0;
    for (double residual : cell.residuals)
      if (!std::isnan(residual)) squares += square(residual);
    const double left = cells_per_run_ > 0.0 ? 1.0 - 1.0 / cells_per_run_ : 1.0;
    scatter.push_back({squares, static_cast<double>(cell.count - 1) * left});
  }
  spread_.emplace(scatter, noise_.reading);
}

/// The observed shifts scatter by σ_ρ² + u(d)² + (σ² + u²)/C with n − 1 degrees of freedom; σ_ρ is equally
/// likely in every octave, or absent.
void ReadingPosterior::find_run_sds() {
  run_sds_ = {0.0};
  std::vector<double> log_weights = {0.0};
  const double noise_variance =
      cells_per_run_ > 0.0 ? spread_->pooled_variance() / cells_per_run_ + square(noise_.run) : 0.0;
  if (noise_variance > 0.0) {
    double squares = 0.0;
    for (double shift : run_shifts_) squares += square(shift);
    const double freedom = static_cast<double>(runs_ - 1);
    const double least = least_run_sd * std::sqrt(noise_variance);
    const double most = most_run_sd * std::sqrt(std::max(squares / freedom, noise_variance));
    run_step_ = std::log(most / least) / double(run_grid_size - 1);
    for (std::size_t k = 0; k < run_grid_size; ++k) run_sds_.push_back(least * std::exp(run_step_ * double(k)));
    log_weights.clear();
    for (double sd : run_sds_) {
      const double variance = square(sd) + noise_variance;
      log_weights.push_back(-0.5 * (freedom * std::log(variance) + squares / variance));
    }
  }
  run_choice_ = numeric::WeightedChoice::from_log_weights(log_weights);
}

void ReadingPosterior::find_curves(const Series& series, const ReadingPosterior* alike) {
  double of_mean = 0.0;  // variance of a cell's mean, on average over the cells
  for (const Cell& cell : cells_)
    of_mean += spread_->pooled_variance() / static_cast<double>(cell.count * cells_.size());
  const double of_direction = of_mean + own_variance_;
  CurveData first{.alike = alike}, second{.alike = alike};
  if (cells_.size() == 2 * targets_) {  // the middle of ↑ and ↓, and ↑ − ↓
    for (std::size_t i = 0; i < targets_; ++i) {
      const std::size_t down = targets_ + i;
      first.values.push_back(0.5 * (cells_[i].mean + cells_[down].mean));
      second.values.push_back(cells_[i].mean - cells_[down].mean);
      first.terms.insert(first.terms.end(), {{i, i, 1.0}, {down, i, 1.0}});
      second.terms.insert(second.terms.end(), {{i, i, 0.5}, {down, i, -0.5}});
    }
    const double in_middle = down_sign_ > 0.0 ? shared_variance_ : 0.0;
    const double in_difference = down_sign_ > 0.0 ? 0.0 : 4.0 * shared_variance_;
    first.noise_variance = 0.5 * of_direction + in_middle;
    second.noise_variance = 2.0 * of_direction + in_difference;
    second.trend_terms = 1;
  } else {
    for (std::size_t c = 0; c < cells_.size(); ++c) {  // each direction for itself
      CurveData& own = cells_[c].place < targets_ ? first : second;
      own.terms.push_back({c, own.values.size(), 1.0});
      own.values.push_back(cells_[c].mean);
    }
    first.noise_variance = second.noise_variance = of_direction + shared_variance_;
  }
  add_curve(series, std::move(first));
  add_curve(series, std::move(second));
}

void ReadingPosterior::add_curve(const Series& series, CurveData data) {
  if (data.values.empty()) return;
  std::vector<double> places(data.values.size());
  for (const Curve::Term& term : data.terms)
    places[term.place] = series.targets()[cells_[term.cell].target].in_native();
  const numeric::CurvePosterior* alike = curves_.empty() ? nullptr : &curves_.front().posterior;
  if (data.alike != nullptr && curves_.size() < data.alike->curves_.size())
    alike = &data.alike->curves_[curves_.size()].posterior;
  curves_.push_back({numeric::CurvePosterior({places, data.values, data.noise_variance, data.trend_terms}, alike),
                     std::move(data.terms)});
  curve_normals_ += curves_.back().posterior.normals_each();
}

/// σ, σ_ρ and μ of every trial.
ReadingPosterior::State ReadingPosterior::draw_state(numeric::RandomKey key, std::size_t trials, Asked asked) const {
  const std::size_t cells = cells_.size();
  State state{trials,
              std::vector<double>(cells * trials),
              std::vector<double>(cells * trials, 0.0),
              std::vector<double>(trials),
              {},
              {},
              0};
  // No more than are taken: what takes them takes them in this order.
  const std::size_t rows_shared = (shared_variance_ > 0.0 ? targets_ : 0) + 2 * cells;
  const std::size_t rows_of_readings = runs_ + (noise_.reading > 0.0 ? cells * runs_ : 0);
  if (asked == Asked::readings) state.normals.resize((rows_shared + rows_of_readings) * trials);
  const std::size_t uniforms_each = 4 + curves_.size() + cells;
  std::vector<double> uniforms(uniforms_each * trials);
  std::vector<double> curve_normals(curve_normals_ * trials);
  numeric::fill_uniform({key.seed, key.stream, 2 * key.block}, uniforms);
  numeric::fill_normal({key.seed, key.stream, 2 * key.block + 1}, curve_normals);
  numeric::fill_normal({key.seed, key.stream + 1, key.block}, state.normals);
  std::vector<double> values(cells);
  for (std::size_t t = 0; t < trials; ++t) {
    const std::span<const double> u = std::span(uniforms).subspan(t * uniforms_each, uniforms_each);
    spread_->draw({u[0], u[1], u.last(cells)}, values);
    for (std::size_t c = 0; c < cells; ++c) state.sd(c)[t] = values[c];
    state.run_sds[t] = run_sds_[run_choice_(u[2])] * std::exp(run_step_ * (u[3] - 0.5));
  }
  draw_means(state, uniforms, curve_normals);
  return state;
}

/// μ of every trial; `uniforms` and `normals` hold what belongs to one trial after the other.
void ReadingPosterior::draw_means(State& state, std::span<const double> uniforms,
                                  std::span<const double> normals) const {
  const std::size_t trials = state.trials, uniforms_each = uniforms.size() / trials;
  std::vector<double> choices(trials), values;
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const numeric::CurvePosterior& posterior = curves_[k].posterior;
    for (std::size_t t = 0; t < trials; ++t) choices[t] = uniforms[t * uniforms_each + 4 + k];
    values.resize(posterior.size() * trials);
    posterior.draw({choices, normals, curve_normals_}, numeric::Rows<double>{values, trials});
    normals = normals.subspan(posterior.normals_each());
    for (const Curve::Term& term : curves_[k].terms) {
      const auto of_cell = state.mean(term.cell);
      for (std::size_t t = 0; t < trials; ++t) of_cell[t] += term.factor * values[term.place * trials + t];
    }
  }
}

/// From the long-run means to those of the cells' own approaches: what x̄ − μ holds is shared between the target's
/// δ, the direction's own, the noise of the readings and the machine's scatter, in the ratio of their variances.
void ReadingPosterior::share_means(State& state) const {
  const double u2 = square(noise_.reading);
  std::vector<double> precision(targets_ * state.trials, 0.0), pull(targets_ * state.trials, 0.0);
  const auto of_mean = [&](std::size_t cell, double sd) {
    return (square(sd) + u2) / static_cast<double>(cells_[cell].count);
  };
  const auto sign_of = [&](std::size_t cell) { return cells_[cell].place < targets_ ? 1.0 : down_sign_; };
  for (std::size_t c = 0; c < cells_.size() && shared_variance_ > 0.0; ++c) {
    for (std::size_t t = 0; t < state.trials; ++t) {
      // Means without any noise of their own (n = 1, or all readings alike) tell δ all but exactly.
      const double own = std::max(of_mean(c, state.sd(c)[t]) + own_variance_, negligible_share * shared_variance_);
      const double weight = 1.0 / own;
      precision[cells_[c].target * state.trials + t] += weight;
      pull[cells_[c].target * state.trials + t] += sign_of(c) * weight * (cells_[c].mean - state.mean(c)[t]);
    }
  }
  std::vector<double> shift(targets_ * state.trials, 0.0);
  for (std::size_t i = 0; i < targets_ && shared_variance_ > 0.0; ++i) {
    const auto z = state.next_normals();
    for (std::size_t t = 0; t < state.trials; ++t) {
      const std::size_t k = i * state.trials + t;
      const double variance = 1.0 / (precision[k] + 1.0 / shared_variance_);
      shift[k] = variance * pull[k] + std::sqrt(variance) * z[t];
    }
  }
  state.machines.resize(cells_.size() * state.trials);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    const auto z_direction = state.next_normals();
    const auto z_reading = state.next_normals();
    const auto mean = state.mean(c);
    const auto sd = state.sd(c);
    const auto machine = state.machine(c);
    for (std::size_t t = 0; t < state.trials; ++t) {
      double left = cells_[c].mean - mean[t] - sign_of(c) * shift[cells_[c].target * state.trials + t];
      if (own_variance_ > 0.0) {
        const double variance = of_mean(c, sd[t]);
        const double own = share(own_variance_, variance);
        left -= own * left + std::sqrt(own * variance) * z_direction[t];
      }
      machine[t] = share(square(sd[t]), u2);
      mean[t] += machine[t] * left + std::sqrt(machine[t] * u2 / static_cast<double>(cells_[c].count)) * z_reading[t];
    }
  }
}

/// The machine's part of the runs' shifts: rows over the runs. What was seen of a run is ρ_j + d_j and the mean of what
/// its C readings have of their own: the machine has σ_ρ² + σ²/C of it, the measurement u_d² + u²/C. draw_cell() brings
/// the noise of single readings, so that its part is left out here.
std::vector<double> ReadingPosterior::draw_run_shifts(State& state) const {
  std::vector<double> shifts(runs_ * state.trials, 0.0);
  if (cells_per_run_ == 0.0) return shifts;
  std::vector<double> own(state.trials), noise_sd(state.trials);
  for (std::size_t t = 0; t < state.trials; ++t) {
    double scatter = 0.0;
    for (std::size_t c = 0; c < cells_.size(); ++c) scatter += square(state.sd(c)[t]) / double(cells_.size());
    const double measured = square(noise_.run) + square(noise_.reading) / cells_per_run_;
    const double of_readings = share(scatter, square(noise_.reading)) * square(noise_.reading) / cells_per_run_;
    own[t] = measured == 0.0 ? 1.0 : share(square(state.run_sds[t]) + scatter / cells_per_run_, measured);
    noise_sd[t] = std::sqrt(std::max(0.0, own[t] * measured - of_readings));
  }
  for (std::size_t j = 0; j < runs_; ++j) {
    const auto z = state.next_normals();
    for (std::size_t t = 0; t < state.trials; ++t)
      shifts[j * state.trials + t] = own[t] * run_shifts_[j] + noise_sd[t] * z[t];
  }
  return shifts;
}

/// The readings of one cell about its true mean: shifts of the runs, and the machine's share of the residuals.
void ReadingPosterior::draw_cell(std::size_t index, std::span<const double> shifts, State& state,
                                 numeric::Rows<double> readings) const {
  const Cell& cell = cells_[index];
  const std::size_t trials = state.trials;
  const auto mean = state.mean(index);
  const auto machine = state.machine(index);
  if (noise_.reading == 0.0) {
    for (std::size_t j = 0; j < runs_; ++j) {
      if (std::isnan(cell.residuals[j])) continue;
      const auto row = readings.row(cell.place * runs_ + j, trials);
      for (std::size_t t = 0; t < trials; ++t)
        row[t] = mean[t] + shifts[j * trials + t] + machine[t] * cell.residuals[j];
    }
    return;
  }
  std::vector<double> noise_sd(trials), about(trials, 0.0);
  for (std::size_t t = 0; t < trials; ++t) noise_sd[t] = std::sqrt(machine[t]) * noise_.reading;
  for (std::size_t j = 0; j < runs_; ++j) {
    if (std::isnan(cell.residuals[j])) continue;
    const auto z = state.next_normals();
    const auto row = readings.row(cell.place * runs_ + j, trials);
    for (std::size_t t = 0; t < trials; ++t) {
      const double noise = noise_sd[t] * z[t];
      about[t] += noise / static_cast<double>(cell.count);
      row[t] = mean[t] + shifts[j * trials + t] + machine[t] * cell.residuals[j] + noise;
    }
  }
  for (std::size_t j = 0; j < runs_; ++j) {
    if (std::isnan(cell.residuals[j])) continue;
    const auto row = readings.row(cell.place * runs_ + j, trials);
    for (std::size_t t = 0; t < trials; ++t) row[t] -= about[t];
  }
}

void ReadingPosterior::draw_readings(numeric::RandomKey key, numeric::Rows<double> readings) const {
  std::ranges::fill(readings.values, missing);
  if (exact_) {
    for (const Cell& cell : cells_)
      for (std::size_t j = 0; j < runs_; ++j)
        std::ranges::fill(readings.row(cell.place * runs_ + j, readings.stride), cell.readings[j]);
    return;
  }
  State state = draw_state(key, readings.stride, Asked::readings);
  share_means(state);
  const std::vector<double> shifts = draw_run_shifts(state);
  for (std::size_t c = 0; c < cells_.size(); ++c) draw_cell(c, shifts, state, readings);
}

void ReadingPosterior::draw_long_run(numeric::RandomKey key, numeric::Rows<double> means,
                                     numeric::Rows<double> sds) const {
  AXIOMETRY_CONTRACT(!curves_.empty());
  std::ranges::fill(means.values, missing);
  std::ranges::fill(sds.values, missing);
  State state = draw_state(key, means.stride, Asked::long_run);
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    std::ranges::copy(state.mean(c), means.row(cells_[c].place, means.stride).begin());
    const auto sd = state.sd(c);
    const auto row = sds.row(cells_[c].place, means.stride);
    for (std::size_t t = 0; t < means.stride; ++t) row[t] = std::hypot(sd[t], state.run_sds[t]);
  }
}

}  // namespace axiometry::iso230_2
