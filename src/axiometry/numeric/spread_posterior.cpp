// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/spread_posterior.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiometry::numeric {
namespace {

constexpr std::size_t grid_size = 128;  // 4.5 % from point to point; draws move within a step
constexpr std::size_t level_step = 2;   // levels stand on every second grid point
constexpr double lowest = 0.02;         // of the larger of noise and pooled scatter
constexpr double highest = 6.0;
constexpr double negligible = 1e-6;      // posterior weight, against the largest, that is left out
constexpr double window_in_omega = 3.5;  // the normal prior of ln σ beyond is left out: 5e-4

struct SpreadPrior {
  double omega;
  double weight;
};
constexpr SpreadPrior spreads[] = {{0.0, 3.0},  {0.1, 1.0}, {0.15, 1.0}, {0.22, 1.0},
                                   {0.33, 1.0}, {0.5, 1.0}, {0.75, 1.0}};

/// Of every cell at every grid point (cells × grid); the largest of each cell is 1.
std::vector<double> likelihoods(std::span<const CellScatter> cells, std::span<const double> variances) {
  std::vector<double> table(cells.size() * grid_size);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::span<double> row = std::span(table).subspan(c * grid_size, grid_size);
    for (std::size_t g = 0; g < grid_size; ++g)
      row[g] = -0.5 * (cells[c].degrees_of_freedom * std::log(variances[g]) + cells[c].sum_of_squares / variances[g]);
    const double largest = *std::ranges::max_element(row);
    for (double& x : row) x = std::exp(x - largest);
  }
  return table;
}

/// The normal prior of ln σ about a level, on the grid from `begin` on; its weights add up to 1.
struct Window {
  std::size_t begin = 0;
  std::vector<double> weights;
};

Window window_about(std::size_t level, double omega, double step) {
  if (omega == 0.0) return {level, {1.0}};
  const double reach = window_in_omega * omega / step;
  const auto centre = double(level);
  Window window;
  window.begin = static_cast<std::size_t>(std::max(0.0, std::ceil(centre - reach)));
  const auto end = static_cast<std::size_t>(std::min(double(grid_size - 1), std::floor(centre + reach))) + 1;
  double sum = 0.0;
  for (std::size_t g = window.begin; g < end; ++g) {
    const double t = (double(g) - centre) * step / omega;
    window.weights.push_back(std::exp(-0.5 * t * t));
    sum += window.weights.back();
  }
  for (double& w : window.weights) w /= sum;
  return window;
}

/// Log probability of all cells' readings where each ln σ comes from the window.
double log_marginal(std::span<const double> likelihoods, const Window& window) {
  double log_sum = 0.0;
  for (std::size_t cell = window.begin; cell < likelihoods.size(); cell += grid_size) {
    double sum = 0.0;
    for (std::size_t k = 0; k < window.weights.size(); ++k) sum += window.weights[k] * likelihoods[cell + k];
    log_sum += std::log(sum);
  }
  return log_sum;
}

/// The distribution of every cell's σ within the window (cells × window).
std::vector<float> cumulative_by_cell(std::span<const double> likelihoods, const Window& window) {
  std::vector<float> table;
  for (std::size_t cell = window.begin; cell < likelihoods.size(); cell += grid_size) {
    double total = 0.0;
    for (std::size_t k = 0; k < window.weights.size(); ++k) total += window.weights[k] * likelihoods[cell + k];
    double sum = 0.0;
    for (std::size_t k = 0; k < window.weights.size(); ++k)
      table.push_back(static_cast<float>((sum += window.weights[k] * likelihoods[cell + k]) / total));
  }
  return table;
}

/// How many of the ascending numbers are at most x: std::upper_bound without a branch that depends on x, which half the
/// time would be guessed wrong.
std::size_t count_up_to(float x, std::span<const float> ascending) {
  if (ascending.empty()) return 0;
  const float* first = ascending.data();
  std::size_t left = ascending.size();
  while (left > 1) {
    const std::size_t half = left / 2;
    first += half * static_cast<std::size_t>(first[half - 1] <= x);
    left -= half;
  }
  return static_cast<std::size_t>(first - ascending.data()) + static_cast<std::size_t>(*first <= x);
}

}  // namespace

SpreadPosterior::SpreadPosterior(std::span<const CellScatter> cells, double noise_sd) : cells_(cells.size()) {
  double squares = 0.0;
  double freedom = 0.0;
  for (const CellScatter& cell : cells) {
    squares += cell.sum_of_squares;
    freedom += cell.degrees_of_freedom;
  }
  const double noise_variance = noise_sd * noise_sd;
  pooled_variance_ = std::max(freedom > 0.0 ? squares / freedom : 0.0, noise_variance);
  if (pooled_variance_ == 0.0 || freedom == 0.0) return;  // nothing scatters, or nothing is known: σ is 0
  const double top = std::sqrt(pooled_variance_);
  grid_step_ = std::log(highest / lowest) / double(grid_size - 1);
  std::vector<double> variances;
  for (std::size_t g = 0; g < grid_size; ++g) {
    grid_.push_back(lowest * top * std::exp(grid_step_ * double(g)));
    variances.push_back(grid_.back() * grid_.back() + noise_variance);
  }
  consider_hypotheses(likelihoods(cells, variances));
}

void SpreadPosterior::consider_hypotheses(const std::vector<double>& likelihoods) {
  struct Candidate {
    Window window;
    double log_weight;
    std::size_t level;
  };
  std::vector<Candidate> candidates;
  double best = -std::numeric_limits<double>::infinity();
  for (const SpreadPrior& prior : spreads) {
    for (std::size_t level = 0; level < grid_size; level += level_step) {
      Window window = window_about(level, prior.omega, grid_step_);
      const double log_weight = std::log(prior.weight) + log_marginal(likelihoods, window);
      best = std::max(best, log_weight);
      candidates.push_back({std::move(window), log_weight, level});
    }
  }
  std::vector<double> kept;
  for (const Candidate& candidate : candidates) {
    if (candidate.log_weight < best + std::log(negligible)) continue;
    kept.push_back(candidate.log_weight);
    hypotheses_.push_back({candidate.level, candidate.window.begin, candidate.window.weights.size(), {}});
    if (candidate.window.weights.size() > 1)
      hypotheses_.back().cumulative = cumulative_by_cell(likelihoods, candidate.window);
  }
  choice_ = WeightedChoice::from_log_weights(kept);
}

void SpreadPosterior::draw(const Randoms& randoms, std::span<double> sds) const {
  if (hypotheses_.empty()) {
    std::ranges::fill(sds.first(cells_), 0.0);
    return;
  }
  const Hypothesis& hypothesis = hypotheses_[choice_(randoms.choice)];
  const bool alike = hypothesis.cumulative.empty();
  const double shift = std::exp(grid_step_ * (randoms.shift - 0.5) * (alike ? double(level_step) : 1.0));
  if (alike) {
    std::ranges::fill(sds.first(cells_), grid_[hypothesis.level] * shift);
    return;
  }
  for (std::size_t c = 0; c < cells_; ++c) {
    const auto row = std::span(hypothesis.cumulative).subspan(c * hypothesis.window, hypothesis.window - 1);
    sds[c] = grid_[hypothesis.window_begin + count_up_to(static_cast<float>(randoms.cells[c]), row)] * shift;
  }
}

}  // namespace axiometry::numeric
