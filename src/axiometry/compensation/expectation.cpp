// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/expectation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"
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

/// What a standard deviation may be of what was found with so many degrees of freedom: √(ν/χ²_ν), in equally likely
/// steps.
class PossibleShares {
 public:
  explicit PossibleShares(double freedom) {
    if (!(freedom > 0.0)) return;
    for (std::size_t k = 0; k < steps; ++k)
      shares_[k] =
          std::sqrt(freedom / numeric::chi_square_quantile((static_cast<double>(k) + 0.5) / double(steps), freedom));
  }

  /// Of a uniform number from (0, 1).
  double operator()(double p) const {
    return shares_[std::min(steps - 1, static_cast<std::size_t>(p * static_cast<double>(steps)))];
  }

 private:
  static constexpr std::size_t steps = 200;
  std::vector<double> shares_ = std::vector<double>(steps, 1.0);
};

/// The same of one target: χ² with as many degrees of freedom as there are standard normal numbers.
double drawn_share(std::span<const double> normal) {
  if (normal.empty()) return 1.0;
  double squares = 0.0;
  for (const double z : normal) squares += z * z;
  return std::sqrt(static_cast<double>(normal.size()) / squares);
}

std::size_t freedom_of(const Cell& cell) { return cell.count > 1 ? cell.count - 1 : 0; }

/// What runs lie higher or lower by as a whole, of the part that both directions share and of that of ↑ against ↓:
/// along two axes that are independent of each other, the columns, times their standard deviations.
struct RunSpread {
  std::array<double, 2> common{}, against{};
  double tilt = 0.0;  ///< standard deviation of their tilts, which both directions share …
  double common_of_tilt = 0.0, against_of_tilt = 0.0;  ///< … and what of both shifts goes with a tilt of 1
  double degrees = 0.0;                                ///< of freedom that the shifts are known with
};

/// Of the variances and the covariance of both parts: its principal axes.
RunSpread along_axes(double common, double against, double covariance) {
  const double angle = 0.5 * std::atan2(2.0 * covariance, common - against);
  const double middle = 0.5 * (common + against), half = std::hypot(0.5 * (common - against), covariance);
  const double first = std::sqrt(middle + half), second = std::sqrt(std::max(0.0, middle - half));
  return {.common = {first * std::cos(angle), -second * std::sin(angle)},
          .against = {first * std::sin(angle), second * std::cos(angle)}};
}

double product_of(std::span<const double> a, std::span<const double> b) {
  const double mean_a = numeric::moments(a).mean, mean_b = numeric::moments(b).mean;
  double products = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) products += (a[j] - mean_a) * (b[j] - mean_b);
  return products;
}

RunSpread run_spread_of(const Series& series, const std::optional<iso230_2::TiltStudy>& tilts) {
  const std::size_t runs = series.run_count();
  std::array<std::vector<double>, 2> shift{std::vector<double>(runs), std::vector<double>(runs)};
  for (const Direction direction : {Direction::up, Direction::down}) {
    std::vector<double> counts(runs);
    std::vector<double>& of = shift[static_cast<std::size_t>(direction)];
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const std::span<const double> cell = series.cell(i, direction);
      const double mean = numeric::moments(cell).mean;
      for (std::size_t j = 0; j < runs; ++j)
        if (!std::isnan(cell[j])) of[j] += cell[j] - mean, counts[j] += 1.0;
    }
    for (std::size_t j = 0; j < runs; ++j) of[j] = counts[j] > 0.0 ? of[j] / counts[j] : 0.0;
  }
  std::vector<double> common(runs), difference(runs);
  for (std::size_t j = 0; j < runs; ++j) {
    common[j] = 0.5 * (shift[0][j] + shift[1][j]);
    difference[j] = 0.5 * (shift[0][j] - shift[1][j]);
  }
  const auto shifts_of = [&] {
    const double freedom = std::max(1.0, static_cast<double>(runs) - (tilts ? 2.0 : 1.0));
    RunSpread spread = along_axes(product_of(common, common) / freedom, product_of(difference, difference) / freedom,
                                  product_of(common, difference) / freedom);
    spread.degrees = freedom;
    return spread;
  };
  if (!tilts) return shifts_of();
  std::vector<double> of_runs = iso230_2::run_tilts(series);
  std::ranges::replace_if(
      of_runs, [](double tilt) { return std::isnan(tilt); }, 0.0);
  const double squares = product_of(of_runs, of_runs);
  const double common_of_tilt = product_of(common, of_runs) / squares;
  const double against_of_tilt = product_of(difference, of_runs) / squares;
  for (std::size_t j = 0; j < runs; ++j) {
    common[j] -= common_of_tilt * of_runs[j];
    difference[j] -= against_of_tilt * of_runs[j];
  }
  RunSpread spread = shifts_of();
  spread.tilt = tilts->between();
  spread.common_of_tilt = common_of_tilt;
  spread.against_of_tilt = against_of_tilt;
  return spread;
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
  const bool runs_differ = study.shifts || study.tilts;
  const RunSpread spread = runs_differ ? run_spread_of(predicted, study.tilts) : RunSpread{};
  const Series within_runs = study.tilts    ? iso230_2::without_tilts(predicted)
                             : study.shifts ? iso230_2::without_shifts(predicted)
                                            : predicted;
  const auto [cells, freedom] = cells_of(within_runs, study.uneven.has_value(), study.tilts ? 2 : study.shifts ? 1 : 0);
  const std::vector<double> levers = iso230_2::tilt_levers(predicted);
  if (cells.empty()) return std::nullopt;
  const PossibleShares shares_up(freedom[0]), shares_down(freedom[1]), shares_of_runs(spread.degrees),
      shares_of_tilts(study.tilts ? study.tilts->degrees() : 0.0);
  const std::size_t runs = of_retest.runs.value_or(predicted.run_count());
  const std::size_t numbers_of_tilts = study.tilts ? runs + 1 : 0;
  const std::size_t numbers_each = cells.size() * (runs + 1) + 2 * runs + 2 + numbers_of_tilts;
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
    std::array<double, 5> uniform{};
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
    const std::array<double, 2> wide{shares_of_runs(uniform[2]), shares_of_runs(uniform[3])};
    std::vector<iso230_2::PositionResult> positions(targets.size());
    std::vector<double> readings(2 * runs);
    const double* z = normal.data();
    const std::span<const double> of_runs = std::span(normal).last(2 * runs + 2 + numbers_of_tilts);
    const std::span<const double> shifts = of_runs.first(2 * runs + 2), tilts = of_runs.last(numbers_of_tilts);
    const auto shift = [&](const std::array<double, 2>& along, std::size_t first, std::size_t second) {
      return along[0] * wide[0] * shifts[first] + along[1] * wide[1] * shifts[second];
    };
    const double of_table =
        shift(spread.against, 2 * runs, 2 * runs + 1) / std::sqrt(static_cast<double>(predicted.run_count()));
    // The table holds the mean tilt of the test's runs.
    const double tilt_sd = spread.tilt * shares_of_tilts(uniform[4]);
    const double tilt_of_table =
        tilts.empty() ? 0.0 : tilts[runs] / std::sqrt(static_cast<double>(predicted.run_count()));
    const auto tilted = [&](std::size_t run, std::size_t target, double side) {
      return tilts.empty() ? 0.0
                           : tilt_sd * (tilts[run] + tilt_of_table) *
                                 (spread.common_of_tilt + side * spread.against_of_tilt + levers[target]);
    };
    for (std::size_t i = 0; i < targets.size(); ++i) {
      std::array<std::span<double>, 2> of{std::span(readings).first(runs), std::span(readings).last(runs)};
      for (std::size_t d = 0; d < 2; ++d) {
        const Cell& cell = cells[d * targets.size() + i];
        const double table = cell.count > 0 ? *z / std::sqrt(static_cast<double>(cell.count)) : 0.0;
        const double side = d == 0 ? 1.0 : -1.0;
        const std::size_t approaches = of_retest.runs && cell.count > 0 ? runs : cell.count;
        ++z;
        for (std::size_t j = 0; j < runs; ++j, ++z)
          of[d][j] = j < approaches
                         ? cell.mean + s[d * targets.size() + i] * (table + *z) + shift(spread.common, j, runs + j) +
                               tilted(j, i, side) + side * (shift(spread.against, j, runs + j) + of_table)
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
