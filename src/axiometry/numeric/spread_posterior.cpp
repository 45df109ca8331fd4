// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/spread_posterior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "axiometry/numeric/kernels/affine_rows.h"

namespace axiometry::numeric {
namespace {

constexpr std::size_t grid_size = 128;          // 4.5 % from point to point; draws move within a step
constexpr std::size_t values_of_freedom = 256;  // points of the table over the sum of squares
constexpr std::size_t level_step = 2;           // levels stand on every second grid point
constexpr double lowest = 0.02;                 // smallest σ as a share of the larger of noise and pooled scatter
constexpr double highest = 6.0;
constexpr double negligible = 1e-6;  // posterior weight, against the largest, that is left out
constexpr double largest_uniform = 1.0 - 0x1p-53;
constexpr double window_in_omega = 3.5;  // the normal prior of ln σ beyond is left out: 5e-4

struct SpreadPrior {
  double omega;
  double weight;
};
constexpr SpreadPrior spreads[] = {{0.0, 3.0},  {0.1, 1.0}, {0.15, 1.0}, {0.22, 1.0},
                                   {0.33, 1.0}, {0.5, 1.0}, {0.75, 1.0}};

/// Of every cell at every grid point (cells × grid); the largest of each cell is 1.
std::vector<double> likelihoods(std::span<const CellScatter> cells, std::span<const double> variances) {
  std::vector<double> table(cells.size() * grid_size), logarithms;
  for (double variance : variances) logarithms.push_back(std::log(variance));
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::span<double> row = std::span(table).subspan(c * grid_size, grid_size);
    for (std::size_t g = 0; g < grid_size; ++g)
      row[g] = -0.5 * (cells[c].degrees_of_freedom * logarithms[g] + cells[c].sum_of_squares / variances[g]);
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

/// Cells that are summed up side by side: some after the others, so that all windows find them in the cache.
constexpr std::size_t cells_at_once = 40;

/// Calls visit(first, count, block) with the likelihoods of `count` cells from the first on, grid × cells; the last of
/// them again where there are fewer than `cells_at_once`.
template <typename Visit>
void for_each_block(std::span<const double> likelihoods, const Visit& visit) {
  const std::size_t cells = likelihoods.size() / grid_size;
  std::vector<double> block(grid_size * cells_at_once);
  for (std::size_t first = 0; first < cells; first += cells_at_once) {
    const std::size_t count = std::min(cells_at_once, cells - first);
    for (std::size_t c = 0; c < cells_at_once; ++c)
      for (std::size_t g = 0; g < grid_size; ++g)
        block[g * cells_at_once + c] = likelihoods[(first + std::min(c, count - 1)) * grid_size + g];
    visit(first, count, Rows<const double>{block, cells_at_once});
  }
}

/// Rows of a block that belong to a window.
Rows<const double> rows_of(const Window& window, const Rows<const double>& block) {
  return {block.values.subspan(window.begin * block.stride), block.stride};
}

/// A sum of logarithms, most of them taken of products.
class LogSum {
 public:
  void add(double factor, double count) {  // the factor is 0 to 1, but for rounding
    if (count != 1.0) {
      if (count != 0.0) log_sum_ += count * std::log(std::max(factor, 1e-300));  // weights may be below 0
      return;
    }
    constexpr double smallest = 1e-150;
    if (product_ * factor > smallest) {
      product_ *= factor;
      return;
    }
    log_sum_ += std::log(product_) + std::log(factor);
    product_ = 1.0;
  }
  double value() const { return log_sum_ + std::log(product_); }

 private:
  double log_sum_ = 0.0;
  double product_ = 1.0;
};

/// Log probability of all cells' readings where each ln σ comes from a window, for every window.
std::vector<double> log_marginals(std::span<const double> likelihoods, std::span<const double> counts,
                                  std::span<const Window> windows) {
  std::vector<LogSum> sums(windows.size());
  for_each_block(likelihoods, [&](std::size_t first, std::size_t count, const Rows<const double>& block) {
    for (std::size_t w = 0; w < windows.size(); ++w) {
      std::array<double, cells_at_once> less{};
      subtract_products(windows[w].weights, rows_of(windows[w], block), less);
      for (std::size_t c = 0; c < count; ++c) sums[w].add(-less[c], counts[first + c]);
    }
  });
  std::vector<double> result;
  for (const LogSum& sum : sums) result.push_back(sum.value());
  return result;
}

/// The distribution of every cell's σ within each window, a row for each cell.
void set_distributions(std::span<const double> likelihoods, std::span<const Window> windows,
                       std::span<AliasRows* const> tables) {
  std::array<double, grid_size> weights;
  for (std::size_t w = 0; w < windows.size(); ++w) {
    const Window& window = windows[w];
    const auto own = std::span(weights).first(window.weights.size());
    for (std::size_t c = 0; c * grid_size < likelihoods.size(); ++c) {
      const double* const of_cell = likelihoods.data() + c * grid_size + window.begin;
      double sum = 0.0;
      for (std::size_t k = 0; k < own.size(); ++k) sum += own[k] = window.weights[k] * of_cell[k];
      tables[w]->set(c, sum > 0.0 ? own : std::span<const double>(window.weights));
    }
  }
}

}  // namespace

SpreadPosterior::SpreadPosterior(std::span<const CellScatter> cells, double noise_sd, std::optional<bool> by_classes)
    : cells_(cells.size()) {
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
  if (by_classes.value_or(cells.size() > cells_one_by_one)) {
    const Classes classes = classes_of(cells, variances.front());
    consider_hypotheses(likelihoods(classes.values, variances), classes.counts);
  } else {
    consider_hypotheses(likelihoods(cells, variances), std::vector<double>(cells.size(), 1.0));
  }
}

/// Values at equal steps of ln(S + v) for each ν; a cell between two of them counts for four by Lagrange's weights.
SpreadPosterior::Classes SpreadPosterior::classes_of(std::span<const CellScatter> cells, double smallest_variance) {
  struct Span {
    std::size_t first = 0;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  };
  std::map<double, Span> of_freedom;
  const auto place_of = [&](const CellScatter& cell) { return std::log(cell.sum_of_squares + smallest_variance); };
  for (const CellScatter& cell : cells) {
    Span& own = of_freedom[cell.degrees_of_freedom];
    own.lowest = std::min(own.lowest, place_of(cell));
    own.highest = std::max(own.highest, place_of(cell));
  }
  Classes classes;
  for (auto& [freedom, own] : of_freedom) {
    own.first = classes.values.size();
    const double step = (own.highest - own.lowest) / double(values_of_freedom - 1);
    for (std::size_t k = 0; k < values_of_freedom; ++k)
      classes.values.push_back({std::max(0.0, std::exp(own.lowest + step * double(k)) - smallest_variance), freedom});
  }
  classes.counts.assign(classes.values.size(), 0.0);
  for (const CellScatter& cell : cells) {
    const Span& own = of_freedom[cell.degrees_of_freedom];
    const double range = own.highest - own.lowest;
    const double at = range > 0.0 ? (place_of(cell) - own.lowest) / range * double(values_of_freedom - 1) : 0.0;
    const auto below = std::min(static_cast<std::size_t>(at), values_of_freedom - 2);
    memberships_.push_back({static_cast<std::uint32_t>(own.first + below), static_cast<float>(at - double(below))});
    const std::size_t begin = std::clamp<std::size_t>(below, 1, values_of_freedom - 3) - 1;
    const double t = at - double(begin);
    const double lagrange[] = {(t - 1) * (t - 2) * (t - 3) / -6, t * (t - 2) * (t - 3) / 2, t * (t - 1) * (t - 3) / -2,
                               t * (t - 1) * (t - 2) / 6};
    for (std::size_t k = 0; k < 4; ++k) classes.counts[own.first + begin + k] += lagrange[k];
  }
  return classes;
}

void SpreadPosterior::consider_hypotheses(const std::vector<double>& likelihoods, std::span<const double> counts) {
  struct Candidate {
    std::size_t level;
    double log_prior;
  };
  std::vector<Candidate> candidates;
  std::vector<Window> windows;
  for (const SpreadPrior& prior : spreads)
    for (std::size_t level = 0; level < grid_size; level += level_step) {
      candidates.push_back({level, std::log(prior.weight)});
      windows.push_back(window_about(level, prior.omega, grid_step_));
    }
  std::vector<double> log_weights = log_marginals(likelihoods, counts, windows);
  for (std::size_t k = 0; k < candidates.size(); ++k) log_weights[k] += candidates[k].log_prior;
  const double best = *std::ranges::max_element(log_weights);
  std::vector<double> kept;
  std::vector<Window> uneven;  // windows of the hypotheses whose cells differ
  std::vector<std::size_t> uneven_places;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (log_weights[k] < best + std::log(negligible)) continue;
    kept.push_back(log_weights[k]);
    hypotheses_.push_back({candidates[k].level, windows[k].begin, {}});
    if (windows[k].weights.size() == 1) continue;
    hypotheses_.back().of_cells = AliasRows(counts.size(), windows[k].weights.size());
    uneven_places.push_back(hypotheses_.size() - 1);
    uneven.push_back(std::move(windows[k]));
  }
  std::vector<AliasRows*> tables;
  for (std::size_t place : uneven_places) tables.push_back(&hypotheses_[place].of_cells);
  set_distributions(likelihoods, uneven, tables);
  choice_ = WeightedChoice::from_log_weights(kept);
}

void SpreadPosterior::draw(const Randoms& randoms, std::span<double> sds, std::size_t stride) const {
  const auto set_all = [&](double sd) {
    for (std::size_t c = 0; c < cells_; ++c) sds[c * stride] = sd;
  };
  if (hypotheses_.empty()) return set_all(0.0);
  const Hypothesis& hypothesis = hypotheses_[choice_(randoms.choice)];
  const bool alike = hypothesis.of_cells.empty();
  const double shift = std::exp(grid_step_ * (randoms.shift - 0.5) * (alike ? double(level_step) : 1.0));
  if (alike) return set_all(grid_[hypothesis.level] * shift);
  const double* const grid = grid_.data() + hypothesis.window_begin;
  if (memberships_.empty()) {
    for (std::size_t c = 0; c < cells_; ++c) sds[c * stride] = grid[hypothesis.of_cells(c, randoms.cells[c])] * shift;
    return;
  }
  for (std::size_t c = 0; c < cells_; ++c) {  // a uniform number that has chosen is uniform again once it is rescaled
    const auto next = static_cast<double>(memberships_[c].next);
    const double uniform = randoms.cells[c];
    const bool is_next = uniform < next;
    const double left = std::min(is_next ? uniform / next : (uniform - next) / (1.0 - next), largest_uniform);
    sds[c * stride] = grid[hypothesis.of_cells(memberships_[c].place + (is_next ? 1 : 0), left)] * shift;
  }
}

}  // namespace axiometry::numeric
