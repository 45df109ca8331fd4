// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"

namespace axiometry::iso230_2 {
namespace {

constexpr Direction both_directions[] = {Direction::up, Direction::down};

constexpr std::size_t cells_for_run_shifts = 3;  // with fewer, a shift of the run and scatter look alike
constexpr int sweeps = 20;                       // they leave 1e-20 with a tenth of the readings missing
constexpr double least_run_sd = 0.1;             // times what noise alone would show
constexpr double most_run_sd = 10.0;             // times what was seen
constexpr std::size_t run_grid_size = 24;

double square(double x) { return x * x; }

}  // namespace

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
  if (asked == Asked::long_run) find_tilts(series);
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
    if (cells_of_run[j] < double(cells_for_run_shifts)) continue;  // too few cells to tell a shift from scatter
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
    for (std::size_t c = 0; c < cells_.size(); ++c) {  // each direction on its own
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

}  // namespace axiometry::iso230_2
