// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/expectation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "axiometry/numeric/distributions/possible_shares.h"
#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::compensation {
namespace {

using iso230_2::AxisParameters;

constexpr std::size_t trials_most = 1000, trials_least = 40;
constexpr std::size_t readings_most = 10'000'000;  // of all trials, what a second can do

/// Of a target in one direction.
struct Cell {
  double mean = 0.0;
  double s = 0.0;
  std::size_t count = 0;
};

struct Cells {
  std::vector<Cell> of;             ///< ↑ of all targets, then ↓, as make_dense() has them; empty without scatter
  std::array<double, 2> freedom{};  ///< degrees of freedom that s of a direction is known with
};

/// `removed_of_runs`: how many numbers of each run were taken out of each direction, shifts and slopes, which takes so
/// many degrees of freedom for every run but one.
Cells cells_of(const Series& series, bool each_its_own, std::size_t removed_of_runs) {
  std::vector<Cell> cells;
  std::array<double, 2> known{};
  bool scatters = false;
  for (const Direction direction : {Direction::up, Direction::down}) {
    double squares = 0.0, freedom = 0.0;
    const std::size_t first = cells.size();
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const numeric::Moments m = numeric::moments(series.cell(i, direction));
      cells.push_back({m.mean, m.standard_deviation, m.count});
      if (m.count < 2) continue;
      scatters = true;
      squares += static_cast<double>(m.count - 1) * m.standard_deviation * m.standard_deviation;
      freedom += static_cast<double>(m.count - 1);
    }
    if (series.run_count() > 1)
      freedom = std::max(1.0, freedom - static_cast<double>(removed_of_runs * (series.run_count() - 1)));
    known[static_cast<std::size_t>(direction)] = freedom;
    if (!each_its_own && freedom > 0.0)
      for (std::size_t k = first; k < cells.size(); ++k) cells[k].s = std::sqrt(squares / freedom);
  }
  return {scatters ? cells : std::vector<Cell>{}, known};
}

/// √(ν/χ²_ν) of one target, with as many degrees of freedom as there are standard normal numbers.
double drawn_share(std::span<const double> normal) {
  if (normal.empty()) return 1.0;
  double squares = 0.0;
  for (const double z : normal) squares += z * z;
  return std::sqrt(static_cast<double>(normal.size()) / squares);
}

std::size_t freedom_of(const Cell& cell) { return cell.count > 1 ? cell.count - 1 : 0; }

/// What a run has of its own: shift ↑, shift ↓, tilt ↑, tilt ↓ (run_tilts.h).
constexpr std::size_t of_run = 4;
using RunNumbers = std::array<double, of_run>;

/// How runs differ: L of their covariance L Lᵀ, so that L z of four normal numbers are those of another run.
using RunSpread = std::array<RunNumbers, of_run>;

/// Cholesky's, of a matrix that may be of lower rank: what is no more than rounding counts as nothing.
RunSpread factor_of(std::array<RunNumbers, of_run> covariance) {
  constexpr double rounding = 1e-12;
  RunSpread L{};
  for (std::size_t k = 0; k < of_run; ++k) {
    double left = covariance[k][k];
    for (std::size_t m = 0; m < k; ++m) left -= L[k][m] * L[k][m];
    if (!(left > rounding * covariance[k][k])) continue;
    L[k][k] = std::sqrt(left);
    for (std::size_t i = k + 1; i < of_run; ++i) {
      double product = covariance[i][k];
      for (std::size_t m = 0; m < k; ++m) product -= L[i][m] * L[k][m];
      L[i][k] = product / L[k][k];
    }
  }
  return L;
}

RunNumbers drawn_run(const RunSpread& spread, std::span<const double> z, double share) {
  RunNumbers numbers{};
  for (std::size_t k = 0; k < of_run; ++k)
    for (std::size_t m = 0; m <= k; ++m) numbers[k] += share * spread[k][m] * z[m];
  return numbers;
}

/// Of the runs of a test, freed of what scatter makes of their numbers; without tilts where they do not count.
RunSpread run_spread_of(const Series& series, const iso230_2::TiltStudy& study, bool tilted) {
  const std::size_t runs = series.run_count();
  std::array<std::vector<double>, of_run> numbers;
  std::ranges::fill(numbers, std::vector<double>(runs));
  RunNumbers of_scatter{};
  for (const Direction direction : {Direction::up, Direction::down}) {
    std::vector<double> counts(runs);
    std::vector<double>& of = numbers[static_cast<std::size_t>(direction)];
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const std::span<const double> cell = series.cell(i, direction);
      const double mean = numeric::moments(cell).mean;
      for (std::size_t j = 0; j < runs; ++j)
        if (!std::isnan(cell[j])) of[j] += cell[j] - mean, counts[j] += 1.0;
    }
    for (std::size_t j = 0; j < runs; ++j) of[j] = counts[j] > 0.0 ? of[j] / counts[j] : 0.0;
    if (const double readings = std::accumulate(counts.begin(), counts.end(), 0.0); readings > 0.0)
      of_scatter[static_cast<std::size_t>(direction)] =
          study.within * study.within * static_cast<double>(runs) / readings;
  }
  if (tilted) {
    const double directions = series.has(Direction::up) && series.has(Direction::down) ? 2.0 : 1.0;
    of_scatter[2] = of_scatter[3] = directions * study.of_scatter;  // of the mean of both it is half that of each
    std::array<std::vector<double>, 2> tilts = iso230_2::direction_tilts(series);
    for (std::size_t d = 0; d < 2; ++d) {
      std::ranges::replace_if(
          tilts[d], [](double tilt) { return std::isnan(tilt); }, 0.0);
      numbers[2 + d] = std::move(tilts[d]);
    }
  }
  std::array<RunNumbers, of_run> covariance{};
  for (std::size_t i = 0; i < of_run; ++i)
    for (std::size_t k = 0; k < of_run; ++k) {
      const double mean_i = numeric::moments(numbers[i]).mean, mean_k = numeric::moments(numbers[k]).mean;
      for (std::size_t j = 0; j < runs; ++j)
        covariance[i][k] += (numbers[i][j] - mean_i) * (numbers[k][j] - mean_k) / static_cast<double>(runs - 1);
      if (i == k) covariance[i][k] = std::max(0.0, covariance[i][k] - of_scatter[i]);
    }
  return factor_of(covariance);
}

/// The value that this share of the trials lies below.
double quantile(std::vector<double>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

std::optional<ExpectedRetest> expected_retest(const Series& numbered, RetestTrials of_retest) {
  const Series predicted = without_empty_runs(numbered);  // a number without readings is no run that was not shifted
  const iso230_2::ScatterStudy study = iso230_2::scatter_study(predicted);
  // Runs that lie higher or lower as a whole do so in all targets alike, and leave the shape of the axis alone.
  const iso230_2::TiltStudy tilts = iso230_2::tilt_study(predicted);
  const bool tilted = tilts.runs > 1 && counts(tilts), runs_differ = study.shifts || tilted;
  const RunSpread spread = runs_differ ? run_spread_of(predicted, tilts, tilted) : RunSpread{};
  const Series level = tilted ? iso230_2::without_tilts(predicted) : predicted;
  const std::size_t removed_of_runs = tilted ? 2 : runs_differ ? 1 : 0;
  const auto [cells, freedom] =
      cells_of(runs_differ ? iso230_2::without_shifts(level) : level, study.uneven.has_value(), removed_of_runs);
  const std::vector<double> levers = iso230_2::tilt_levers(predicted);
  if (cells.empty()) return std::nullopt;
  const numeric::PossibleShares shares_up(freedom[0]), shares_down(freedom[1]),
      shares_of_runs(runs_differ ? static_cast<double>(predicted.run_count()) - 1.0 : 0.0);
  const std::size_t runs = of_retest.runs.value_or(predicted.run_count());
  const std::size_t numbers_of_runs = runs_differ ? of_run * (runs + 1) : 0;  // the table has the mean of the test's
  const std::size_t numbers_each = cells.size() * (runs + 1) + numbers_of_runs;
  std::size_t numbers_of_scatter = 0;  // where each target has its own, which is known from its few readings alone
  if (study.uneven)
    for (const Cell& cell : cells) numbers_of_scatter += freedom_of(cell);
  const std::size_t trials = std::clamp(readings_most / (numbers_each + numbers_of_scatter), trials_least, trials_most);
  const std::vector<Position> targets(predicted.targets().begin(), predicted.targets().end());

  std::array<std::vector<double>, std::size(iso230_2::parameters)> values;
  std::vector<double> normal(numbers_each), of_scatter(numbers_of_scatter);
  std::vector<double> s(cells.size());
  for (std::size_t trial = 0; trial < trials; ++trial) {
    numeric::fill_normal({.seed = of_retest.seed, .stream = 0, .block = trial}, normal);
    std::array<double, 3> uniform{};
    numeric::fill_uniform({.seed = of_retest.seed, .stream = 1, .block = trial}, uniform);
    // The scatter of the axis is known from the readings of one test: what it may be as well is drawn.
    const std::array<double, 2> share{shares_up(uniform[0]), shares_down(uniform[1])};
    if (study.uneven) numeric::fill_normal({.seed = of_retest.seed, .stream = 2, .block = trial}, of_scatter);
    std::span<const double> left = of_scatter;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const std::size_t known = study.uneven ? freedom_of(cells[k]) : 0;
      s[k] = cells[k].s * (study.uneven ? drawn_share(left.first(known)) : share[k / targets.size()]);
      left = left.subspan(known);
    }
    std::vector<iso230_2::PositionResult> positions(targets.size());
    std::vector<double> readings(2 * runs);
    const double* z = normal.data();
    const std::span<const double> of_runs = std::span(normal).last(numbers_of_runs);
    const double share_of_runs = shares_of_runs(uniform[2]);
    const RunNumbers of_table = runs_differ
                                    ? drawn_run(spread, of_runs.last(of_run),
                                                share_of_runs / std::sqrt(static_cast<double>(predicted.run_count())))
                                    : RunNumbers{};
    std::vector<RunNumbers> own(runs, of_table);
    for (std::size_t j = 0; j < runs && runs_differ; ++j) {
      const RunNumbers drawn = drawn_run(spread, of_runs.subspan(of_run * j, of_run), share_of_runs);
      for (std::size_t k = 0; k < of_run; ++k) own[j][k] += drawn[k];
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
      std::array<std::span<double>, 2> of{std::span(readings).first(runs), std::span(readings).last(runs)};
      for (std::size_t d = 0; d < 2; ++d) {
        const Cell& cell = cells[d * targets.size() + i];
        const double table = cell.count > 0 ? *z / std::sqrt(static_cast<double>(cell.count)) : 0.0;
        const std::size_t approaches = of_retest.runs && cell.count > 0 ? runs : cell.count;
        ++z;
        for (std::size_t j = 0; j < runs; ++j, ++z)
          of[d][j] = j < approaches
                         ? cell.mean + s[d * targets.size() + i] * (table + *z) + own[j][d] + own[j][2 + d] * levers[i]
                         : std::nan("");
      }
      positions[i] = iso230_2::evaluate_position(targets[i], of[0], of[1]);
    }
    const AxisParameters parameters = iso230_2::evaluate_axis(positions);
    for (std::size_t p = 0; p < values.size(); ++p)
      if (const auto& value = parameters.*iso230_2::parameters[p].member) values[p].push_back(value->in_native());
  }
  ExpectedRetest expected;
  expected.trials = trials;
  for (std::size_t p = 0; p < values.size(); ++p) {
    if (values[p].empty()) continue;
    const auto member = iso230_2::parameters[p].member;
    expected.median.*member = Deviation::native(quantile(values[p], 0.5));
    expected.percent_95.*member = Deviation::native(quantile(values[p], 0.95));
  }
  return expected;
}

}  // namespace axiometry::compensation
