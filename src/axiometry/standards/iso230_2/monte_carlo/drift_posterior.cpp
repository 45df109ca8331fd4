// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/drift_posterior.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/principal_axes.h"
#include "axiometry/numeric/kernels/affine_rows.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double visible = 1e-8;  // share of the largest λ below which an axis is rounding alone
constexpr std::size_t scatter_steps = 16;
constexpr std::size_t size_steps = 17;
constexpr double size_reach = 8.0;      // a from an eighth of what was stated to eight times as much
constexpr double size_spread = 0.6931;  // standard deviation of ln a
constexpr double few_freedom = 10.0;    // degrees of freedom below which the scatter may be ten times what was seen
constexpr double kept_weight = 1e-5;    // share of the largest weight; lighter hypotheses are left out

double square_of(double x) { return x * x; }

/// Shapes, one after the other, as sums of those given: column k of `axes` has the weights of the k-th.
std::vector<double> turned(std::span<const double> shapes, const numeric::PrincipalAxes& axes) {
  const std::size_t count = axes.values.size();
  const std::size_t places = shapes.size() / count;
  std::vector<double> result(shapes.size(), 0.0);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t l = 0; l < count; ++l) {
      const double weight = axes.axis(k)[l];
      for (std::size_t r = 0; r < places; ++r) result[k * places + r] += weight * shapes[l * places + r];
    }
  return result;
}

/// What all shapes have at one place after the other: shapes one after the other would be far apart.
std::vector<double> by_place(std::span<const double> shapes, std::size_t count) {
  const std::size_t places = shapes.size() / count;
  std::vector<double> result(shapes.size());
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t r = 0; r < places; ++r) result[r * count + k] = shapes[k * places + r];
  return result;
}

double product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// Readings and shapes, and their means in every cell taken out: zero where no reading is.
struct AboutMeans {
  std::vector<double> readings;
  std::vector<double> shapes;
  std::vector<double> means_of_shapes;  ///< per cell
  std::vector<double> shapes_of_readings;
  double degrees_of_freedom = 0.0;
  double least_scatter = 0.0;
};

/// Which readings there are of the cells (direction, target) and runs, as values lie in Series::make_dense().
class Layout {
 public:
  explicit Layout(const Series& series)
      : runs_(series.run_count()), cells_(2 * series.target_count()), of_run_(runs_, 0.0) {
    for (std::size_t c = 0; c < cells_; ++c) {
      const auto cell = series.cell(c % series.target_count(), static_cast<Direction>(c / series.target_count()));
      begins_.push_back(there_.size());
      for (std::size_t j = 0; j < runs_; ++j) {
        if (std::isnan(cell[j])) continue;
        there_.push_back(j);
        of_run_[j] += 1.0;
      }
    }
    begins_.push_back(there_.size());
  }

  std::size_t runs() const { return runs_; }
  std::size_t cells() const { return cells_; }
  std::span<const std::size_t> runs_of(std::size_t cell) const {
    return std::span(there_).subspan(begins_[cell], begins_[cell + 1] - begins_[cell]);
  }
  double readings_of(std::size_t run) const { return of_run_[run]; }

 private:
  std::size_t runs_, cells_;
  std::vector<double> of_run_;
  std::vector<std::size_t> there_, begins_;
};

/// Sum over the cells of what a shift of each run is about the mean of its cell: the normal equations of shifts beside
/// any means of the cells.
std::vector<double> about_cells(const Layout& layout, std::span<const double> shifts) {
  std::vector<double> sums(layout.runs(), 0.0);
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    const auto runs = layout.runs_of(c);
    double mean = 0.0;
    for (std::size_t j : runs) mean += shifts[j] / double(runs.size());
    for (std::size_t j : runs) sums[j] += shifts[j] - mean;
  }
  return sums;
}

/// The shifts of the runs that fit sums of readings about their cells best, by conjugate gradients, which end after as
/// many steps as there are runs, but for rounding; where no reading is missing after one.
std::vector<double> fitted_shifts(const Layout& layout, std::vector<double> left) {
  constexpr double done = 1e-28;  // squares of residuals that end it, as a share of those at the beginning
  const auto scaled = [&](const std::vector<double>& x) {
    std::vector<double> result(x.size(), 0.0);
    for (std::size_t j = 0; j < x.size(); ++j)
      if (layout.readings_of(j) > 0.0) result[j] = x[j] / layout.readings_of(j);
    return result;
  };
  std::vector<double> shifts(left.size(), 0.0);
  std::vector<double> step = scaled(left);
  double squares = product(left, step);
  const double enough = done * squares;
  for (std::size_t k = 0; k < layout.runs() && squares > enough; ++k) {
    const std::vector<double> moved = about_cells(layout, step);
    const double curvature = product(step, moved);
    if (!(curvature > 0.0)) break;
    for (std::size_t j = 0; j < left.size(); ++j) {
      shifts[j] += squares / curvature * step[j];
      left[j] -= squares / curvature * moved[j];
    }
    const std::vector<double> next = scaled(left);
    const double before = std::exchange(squares, product(left, next));
    for (std::size_t j = 0; j < left.size(); ++j) step[j] = next[j] + squares / before * step[j];
  }
  return shifts;
}

/// Takes what runs have in common out of values that have no mean in their cells, so that neither is left. Again for
/// what rounding left of it.
void take_out_run_means(const Layout& layout, std::span<double> values) {
  constexpr std::size_t most_rounds = 5;
  constexpr double done = 1e-13;  // largest mean of a run that may be left, as a share of the largest value
  double size = 0.0;
  for (double x : values) size = std::max(size, std::abs(x));
  for (std::size_t round = 0; round < most_rounds; ++round) {
    std::vector<double> sums(layout.runs(), 0.0);
    for (std::size_t c = 0; c < layout.cells(); ++c)
      for (std::size_t j : layout.runs_of(c)) sums[j] += values[c * layout.runs() + j];
    double largest = 0.0;
    for (std::size_t j = 0; j < sums.size(); ++j)
      largest = std::max(largest, std::abs(sums[j]) / std::max(layout.readings_of(j), 1.0));
    if (largest <= done * size) return;
    const std::vector<double> shifts = fitted_shifts(layout, std::move(sums));
    for (std::size_t c = 0; c < layout.cells(); ++c) {
      const auto runs = layout.runs_of(c);
      double mean = 0.0;
      for (std::size_t j : runs) mean += shifts[j] / double(runs.size());
      for (std::size_t j : runs) values[c * layout.runs() + j] -= shifts[j] - mean;
    }
  }
}

/// The number by which a run's group is known; who asked is nearer to it the next time.
std::size_t root_of(std::vector<std::size_t>& group, std::size_t run) {
  while (group[run] != run) run = group[run] = group[group[run]];
  return run;
}

/// How many shifts of runs are free of each other beside the means of the cells: of runs that have cells in common one
/// is not, for the means take it up. Where no reading is missing, all runs but one.
double free_run_shifts(const Layout& layout) {
  std::vector<std::size_t> group(layout.runs());
  std::iota(group.begin(), group.end(), std::size_t{0});
  double shifts = 0.0;
  for (std::size_t c = 0; c < layout.cells(); ++c) {
    const auto runs = layout.runs_of(c);
    for (std::size_t j : runs) {
      const std::size_t own = root_of(group, j), first = root_of(group, runs.front());
      if (own == first) continue;
      group[own] = first;
      shifts += 1.0;
    }
  }
  return shifts;
}

AboutMeans about_means(const Series& series, const EnvironmentModes& modes, MachineRuns machine_runs) {
  const std::size_t runs = series.run_count();
  const std::size_t cells = 2 * series.target_count();
  const std::size_t count = modes.count();
  AboutMeans found{std::vector<double>(modes.places, 0.0),
                   modes.values,
                   std::vector<double>(cells * count, 0.0),
                   modes.values,
                   0.0,
                   0.0};
  for (std::size_t c = 0; c < cells; ++c) {
    const std::size_t i = c % series.target_count();
    const auto direction = static_cast<Direction>(c / series.target_count());
    const auto cell = series.cell(i, direction);
    const auto n = double(series.count(i, direction));
    double mean = 0.0;
    for (double x : cell)
      if (!std::isnan(x)) mean += x / n;
    for (std::size_t j = 0; j < runs; ++j)
      if (!std::isnan(cell[j])) found.readings[c * runs + j] = cell[j] - mean;
    if (n > 0.0) found.degrees_of_freedom += n - 1.0;
    for (std::size_t k = 0; k < count; ++k) {
      const auto own = std::span(found.shapes).subspan(k * modes.places + c * runs, runs);
      double& of_cell = found.means_of_shapes[k * cells + c];
      for (std::size_t j = 0; j < runs; ++j) {
        if (std::isnan(cell[j]))
          found.shapes_of_readings[k * modes.places + c * runs + j] = 0.0;
        else
          of_cell += own[j] / n;
      }
      for (std::size_t j = 0; j < runs; ++j) own[j] = std::isnan(cell[j]) ? 0.0 : own[j] - of_cell;
    }
  }
  if (machine_runs == MachineRuns::steady) return found;
  AboutMeans within = found;
  const Layout layout(series);
  take_out_run_means(layout, within.readings);
  for (std::size_t k = 0; k < count; ++k)
    take_out_run_means(layout, std::span(within.shapes).subspan(k * modes.places, modes.places));
  within.degrees_of_freedom = std::max(0.0, found.degrees_of_freedom - free_run_shifts(layout));
  if (machine_runs == MachineRuns::shifting) return within;
  for (std::size_t r = 0; r < found.readings.size(); ++r) found.readings[r] -= within.readings[r];
  for (std::size_t r = 0; r < found.shapes.size(); ++r) found.shapes[r] -= within.shapes[r];
  found.degrees_of_freedom -= within.degrees_of_freedom;
  if (within.degrees_of_freedom > 0.0)
    found.least_scatter = std::sqrt(product(within.readings, within.readings) / within.degrees_of_freedom);
  return found;
}

}  // namespace

SeenModes::SeenModes(const Series& series, const EnvironmentModes& modes, MachineRuns machine_runs)
    : count(modes.count()) {
  AXIOMETRY_CONTRACT(modes.places == 2 * series.target_count() * series.run_count() && count > 0);
  const AboutMeans about = about_means(series, modes, machine_runs);
  const auto shape = [&](std::size_t k) { return std::span(about.shapes).subspan(k * modes.places, modes.places); };
  std::vector<double> products(count * count);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t l = 0; l <= k; ++l)
      products[k * count + l] = products[l * count + k] = product(shape(k), shape(l));
  const numeric::PrincipalAxes axes = numeric::principal_axes(products, count);
  of_readings = turned(about.shapes_of_readings, axes);
  of_means = turned(about.means_of_shapes, axes);
  squares = squares_left = product(about.readings, about.readings);
  degrees_of_freedom = degrees_of_freedom_left = about.degrees_of_freedom;
  least_scatter = about.least_scatter;
  const std::vector<double> seen = turned(about.shapes, axes);
  sizes.assign(count, 0.0);
  coordinates.assign(count, 0.0);
  for (std::size_t k = count; k-- > 0;) {  // the largest first, as far as there are degrees of freedom
    const double size = axes.values[k];
    if (!(size > visible * axes.values[count - 1]) || degrees_of_freedom_left < 2.0) continue;
    sizes[k] = size;
    coordinates[k] = product(std::span(seen).subspan(k * modes.places, modes.places), about.readings) / std::sqrt(size);
    squares_left = std::max(0.0, squares_left - square_of(coordinates[k]));
    degrees_of_freedom_left -= 1.0;
  }
}

DriftPosterior::DriftPosterior(const Series& series, const EnvironmentModes& modes, VariationSize size,
                               MachineRuns machine_runs)
    : seen_(series, modes, machine_runs),
      factors_of_readings_(by_place(seen_.of_readings, seen_.count)),
      factors_of_means_(by_place(seen_.of_means, seen_.count)) {
  AXIOMETRY_CONTRACT(size.range > 0.0);
  consider_hypotheses(size);
}

void DriftPosterior::consider_hypotheses(VariationSize size) {
  const double squares = seen_.squares_left;
  const double freedom = seen_.degrees_of_freedom_left;
  // The scatter lies between what is left beside the shapes and all that was seen.
  const double seen_sd = seen_.degrees_of_freedom > 0.0 ? std::sqrt(seen_.squares / seen_.degrees_of_freedom) : 0.0;
  const double left_sd = freedom >= 1.0 ? std::sqrt(squares / freedom) : 0.5 * seen_sd;
  const double least = std::max({0.4 * left_sd, seen_.least_scatter, 1e-6 * size.range});
  const double most = std::max((seen_.degrees_of_freedom < few_freedom ? 10.0 : 1.5) * seen_sd, 2.0 * least);
  const std::size_t steps = size.doubted ? size_steps : 1;
  std::vector<double> log_weights;
  std::vector<std::pair<double, double>> pairs;  // σ² and a²
  std::vector<double> sizes;
  for (std::size_t i = 0; i < scatter_steps; ++i) {
    const double sigma = least * std::pow(most / least, double(i) / double(scatter_steps - 1));
    for (std::size_t l = 0; l < steps; ++l) {
      const double octaves =
          size.doubted ? std::log(size_reach) * (2.0 * double(l) / double(size_steps - 1) - 1.0) : 0.0;
      const double a = size.range * std::exp(octaves);
      double log_weight = -0.5 * square_of(octaves / size_spread) -
                          0.5 * (freedom * std::log(square_of(sigma)) + squares / square_of(sigma));
      for (std::size_t k = 0; k < seen_.count; ++k) {
        if (seen_.sizes[k] == 0.0) continue;
        const double variance = square_of(sigma) + square_of(a) * seen_.sizes[k];
        log_weight -= 0.5 * (std::log(variance) + square_of(seen_.coordinates[k]) / variance);
      }
      log_weights.push_back(log_weight);
      pairs.emplace_back(square_of(sigma), square_of(a));
      sizes.push_back(std::exp(octaves));
    }
  }
  const double best = *std::ranges::max_element(log_weights);
  std::vector<double> kept;
  double sum = 0.0;
  relative_size_ = 0.0;
  std::vector<double> mean(seen_.count, 0.0);
  for (std::size_t h = 0; h < pairs.size(); ++h) {
    if (log_weights[h] < best + std::log(kept_weight)) continue;
    const double weight = std::exp(log_weights[h] - best);
    const auto [scatter, variation] = pairs[h];
    Hypothesis own{std::vector<double>(seen_.count), std::vector<double>(seen_.count)};
    for (std::size_t k = 0; k < seen_.count; ++k) {
      const double variance = scatter + variation * seen_.sizes[k];
      own.mean[k] = variation * std::sqrt(seen_.sizes[k]) / variance * seen_.coordinates[k];
      own.sd[k] = std::sqrt(variation * scatter / variance);
      mean[k] += weight * own.mean[k];
    }
    sum += weight;
    relative_size_ += weight * sizes[h];
    kept.push_back(log_weights[h]);
    hypotheses_.push_back(std::move(own));
  }
  relative_size_ /= sum;
  for (double& x : mean) x /= sum;
  for (Hypothesis& own : hypotheses_)
    for (std::size_t k = 0; k < seen_.count; ++k) own.mean[k] -= mean[k];
  choice_ = numeric::WeightedChoice::from_log_weights(kept);
  const std::size_t places = seen_.of_readings.size() / seen_.count;
  expected_.assign(places, 0.0);
  for (std::size_t k = 0; k < seen_.count; ++k)
    for (std::size_t r = 0; r < places; ++r) expected_[r] += seen_.of_readings[k * places + r] * mean[k];
}

DriftPosterior::Drawn DriftPosterior::draw(numeric::RandomKey key, std::size_t trials) const {
  std::vector<double> uniforms(trials);
  std::vector<double> coordinates(seen_.count * trials);
  numeric::fill_uniform({key.seed, key.stream, 2 * key.block}, uniforms);
  numeric::fill_normal({key.seed, key.stream, 2 * key.block + 1}, coordinates);
  for (std::size_t t = 0; t < trials; ++t) {
    const Hypothesis& own = hypotheses_[choice_(uniforms[t])];
    for (std::size_t k = 0; k < seen_.count; ++k) {
      double& c = coordinates[k * trials + t];
      c = own.mean[k] + own.sd[k] * c;
    }
  }
  return coordinates;
}

/// Of all rows that there are, which belong to the places from the first on; what is no reading stays none.
void DriftPosterior::subtract(const Drawn& drawn, std::span<const double> factors, std::size_t first,
                              numeric::Rows<double> rows) const {
  const std::size_t trials = rows.stride, count = rows.values.size() / trials;
  numeric::subtract_products(factors.subspan(first * seen_.count, count * seen_.count),
                             numeric::Rows<const double>{drawn, trials}, rows, trials);
}

void DriftPosterior::subtract_from_readings(numeric::RandomKey key, numeric::Rows<double> readings) const {
  subtract(draw(key, readings.stride), factors_of_readings_, 0, readings);
}

void DriftPosterior::subtract_from_cell(const Drawn& drawn, std::size_t cell, numeric::Rows<double> readings) const {
  const std::size_t runs = readings.values.size() / readings.stride;
  subtract(drawn, factors_of_readings_, cell * runs, readings);
}

void DriftPosterior::subtract_from_means(numeric::RandomKey key, numeric::Rows<double> means) const {
  subtract(draw(key, means.stride), factors_of_means_, 0, means);
}

}  // namespace axiometry::iso230_2
