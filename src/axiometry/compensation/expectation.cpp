// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/expectation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"

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

/// In the order of make_dense(): ↑ of all targets, then ↓. Empty where nothing scatters.
std::vector<Cell> cells_of(const Series& series) {
  const bool each_its_own = iso230_2::scatter_study(series).uneven.has_value();
  std::vector<Cell> cells;
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
    if (!each_its_own && freedom > 0.0)
      for (std::size_t k = first; k < cells.size(); ++k) cells[k].s = std::sqrt(squares / freedom);
  }
  return scatters ? cells : std::vector<Cell>{};
}

/// The value that this share of the trials lies below.
double quantile(std::vector<double>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
  std::ranges::nth_element(values, values.begin() + at);
  return values[static_cast<std::size_t>(at)];
}

}  // namespace

std::optional<ExpectedRetest> expected_retest(const Series& predicted, std::uint64_t seed) {
  const std::vector<Cell> cells = cells_of(predicted);
  if (cells.empty()) return std::nullopt;
  const std::size_t runs = predicted.run_count(), numbers_each = cells.size() * (runs + 1);
  const std::size_t trials = std::clamp(readings_most / numbers_each, trials_least, trials_most);
  const std::vector<Position> targets(predicted.targets().begin(), predicted.targets().end());

  std::array<std::vector<double>, std::size(iso230_2::parameters)> values;
  std::vector<double> normal(numbers_each);
  for (std::size_t trial = 0; trial < trials; ++trial) {
    numeric::fill_normal({.seed = seed, .stream = 0, .block = trial}, normal);
    std::vector<iso230_2::PositionResult> positions(targets.size());
    std::vector<double> readings(2 * runs);
    const double* z = normal.data();
    for (std::size_t i = 0; i < targets.size(); ++i) {
      std::array<std::span<double>, 2> of{std::span(readings).first(runs), std::span(readings).last(runs)};
      for (std::size_t d = 0; d < 2; ++d) {
        const Cell& cell = cells[d * targets.size() + i];
        const double table = cell.count > 0 ? *z / std::sqrt(static_cast<double>(cell.count)) : 0.0;
        ++z;
        for (std::size_t j = 0; j < runs; ++j, ++z)
          of[d][j] = j < cell.count ? cell.mean + cell.s * (table + *z) : std::nan("");
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
