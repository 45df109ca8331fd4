// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/retest_model.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"

namespace axiometry::compensation::retest {
namespace {

/// √(ν/χ²_ν) of one target, with as many degrees of freedom as there are standard normal numbers.
double drawn_share(std::span<const double> normal) {
  if (normal.empty()) return 1.0;
  double squares = 0.0;
  for (const double z : normal) squares += z * z;
  return std::sqrt(static_cast<double>(normal.size()) / squares);
}

}  // namespace

std::optional<RetestModel> RetestModel::of(const Series& predicted, std::optional<std::size_t> runs) {
  RetestModel model(predicted, runs);
  return model.scatters_ ? std::optional(std::move(model)) : std::nullopt;
}

RetestModel::RetestModel(const Series& predicted, std::optional<std::size_t> runs)
    : targets_(predicted.targets().begin(), predicted.targets().end()),
      levers_(iso230_2::tilt_levers(predicted)),
      runs_of_test_(predicted.run_count()),
      runs_(runs.value_or(predicted.run_count())),
      all_runs_reach_all_(runs.has_value()) {
  const iso230_2::ScatterStudy study = iso230_2::scatter_study(predicted);
  // Runs that lie higher or lower as a whole do so in all targets alike, and leave the shape of the axis alone.
  const iso230_2::TiltStudy tilts = iso230_2::tilt_study(predicted);
  const bool tilted = counts(tilts);
  runs_differ_ = study.shifts || tilted;
  each_its_own_ = study.uneven.has_value();
  if (runs_differ_) spread_ = run_spread(predicted, tilts, tilted);
  const Series level = tilted ? iso230_2::without_tilts(predicted) : predicted;
  find_cells(runs_differ_ ? iso230_2::without_shifts(level) : level, tilted ? 2 : runs_differ_ ? 1 : 0);
  shares_.emplace_back(runs_differ_ ? static_cast<double>(runs_of_test_) - 1.0 : 0.0);
  if (each_its_own_)
    for (const Cell& cell : cells_) own_scatters_ += cell.freedom();
}

/// `removed_of_runs`: how many numbers of each run were taken out of each direction, shifts and slopes, which takes so
/// many degrees of freedom for every run but one.
void RetestModel::find_cells(const Series& level, std::size_t removed_of_runs) {
  for (const Direction direction : {Direction::up, Direction::down}) {
    double squares = 0.0, freedom = 0.0;
    const std::size_t first = cells_.size();
    for (std::size_t i = 0; i < level.target_count(); ++i) {
      const numeric::Moments m = numeric::moments(level.cell(i, direction));
      cells_.push_back({m.mean, m.standard_deviation, m.count});
      if (m.count < 2) continue;
      scatters_ = true;
      squares += static_cast<double>(m.count - 1) * m.standard_deviation * m.standard_deviation;
      freedom += static_cast<double>(m.count - 1);
    }
    if (level.run_count() > 1)
      freedom = std::max(1.0, freedom - static_cast<double>(removed_of_runs * (level.run_count() - 1)));
    shares_.emplace_back(freedom);
    if (!each_its_own_ && freedom > 0.0)
      for (std::size_t k = first; k < cells_.size(); ++k) cells_[k].s = std::sqrt(squares / freedom);
  }
}

/// s of each cell: it is known from the readings of one test, and what it may be as well is drawn.
std::vector<double> RetestModel::drawn_scatter(std::uint64_t seed, std::size_t trial,
                                               std::span<const double> uniform) const {
  const std::array<double, 2> share{shares_[0](uniform[0]), shares_[1](uniform[1])};
  std::vector<double> normal(own_scatters_), s;
  if (each_its_own_) numeric::fill_normal({.seed = seed, .stream = 2, .block = trial}, normal);
  std::span<const double> left = normal;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const std::size_t known = each_its_own_ ? cells_[k].freedom() : 0;
    s.push_back(cells_[k].s * (each_its_own_ ? drawn_share(left.first(known)) : share[k / targets_.size()]));
    left = left.subspan(known);
  }
  return s;
}

/// What each run has of its own, beside what the mean of the test's runs has put into the table.
std::vector<RunNumbers> RetestModel::drawn_runs(std::span<const double> normal, double uniform) const {
  if (!runs_differ_) return std::vector<RunNumbers>(runs_);
  const double share = shares_[2](uniform);
  const double of_mean = share / std::sqrt(static_cast<double>(runs_of_test_));
  std::vector<RunNumbers> own(runs_, drawn_run(spread_, normal.last(numbers_of_run), of_mean));
  for (std::size_t j = 0; j < runs_; ++j) {
    const RunNumbers drawn = drawn_run(spread_, normal.subspan(numbers_of_run * j, numbers_of_run), share);
    for (std::size_t k = 0; k < numbers_of_run; ++k) own[j][k] += drawn[k];
  }
  return own;
}

std::vector<iso230_2::PositionResult> RetestModel::drawn(std::uint64_t seed, std::size_t trial) const {
  std::vector<double> normal(normals_each());
  numeric::fill_normal({.seed = seed, .stream = 0, .block = trial}, normal);
  std::array<double, 3> uniform{};
  numeric::fill_uniform({.seed = seed, .stream = 1, .block = trial}, uniform);
  const std::vector<double> s = drawn_scatter(seed, trial, std::span(uniform).first(2));
  const std::vector<RunNumbers> own = drawn_runs(std::span(normal).last(normals_of_runs()), uniform[2]);
  std::vector<iso230_2::PositionResult> positions(targets_.size());
  std::vector<double> readings(2 * runs_);
  const std::array<std::span<double>, 2> of{std::span(readings).first(runs_), std::span(readings).last(runs_)};
  const double* z = normal.data();
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    for (std::size_t d = 0; d < 2; ++d) {
      const std::size_t at = d * targets_.size() + i;
      const Cell& cell = cells_[at];
      const double table = cell.count > 0 ? *z / std::sqrt(static_cast<double>(cell.count)) : 0.0;
      const std::size_t approaches = all_runs_reach_all_ && cell.count > 0 ? runs_ : cell.count;
      ++z;
      for (std::size_t j = 0; j < runs_; ++j, ++z)
        of[d][j] =
            j < approaches ? cell.mean + s[at] * (table + *z) + own[j][d] + own[j][2 + d] * levers_[i] : std::nan("");
    }
    positions[i] = iso230_2::evaluate_position(targets_[i], of[0], of[1]);
  }
  return positions;
}

}  // namespace axiometry::compensation::retest
