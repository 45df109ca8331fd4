// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/compensation/run_spread.h"
#include "axiometry/model/series.h"
#include "axiometry/numeric/distributions/possible_shares.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// What re-tests are drawn from (expectation.h). Private to compensation/.
namespace axiometry::compensation::retest {

class RetestModel {
 public:
  /// Nothing where no target has two readings in a direction. `runs`: of a re-test; as many as the test where nobody
  /// knows.
  static std::optional<RetestModel> of(const Series& predicted, std::optional<std::size_t> runs);

  /// Random numbers that one re-test takes.
  std::size_t numbers_each() const { return normals_each() + own_scatters_; }

  std::vector<iso230_2::PositionResult> drawn(std::uint64_t seed, std::size_t trial) const;

 private:
  /// Readings of one target in one direction.
  struct Cell {
    double mean = 0.0;
    double s = 0.0;
    std::size_t count = 0;

    std::size_t freedom() const { return count > 1 ? count - 1 : 0; }
  };

  RetestModel(const Series& predicted, std::optional<std::size_t> runs);

  void find_cells(const Series& level, std::size_t removed_of_runs);
  std::size_t normals_of_runs() const { return runs_differ_ ? numbers_of_run * (runs_ + 1) : 0; }
  std::size_t normals_each() const { return cells_.size() * (runs_ + 1) + normals_of_runs(); }
  std::vector<double> drawn_scatter(std::uint64_t seed, std::size_t trial, std::span<const double> uniform) const;
  std::vector<RunNumbers> drawn_runs(std::span<const double> normal, double uniform) const;

  std::vector<Position> targets_;
  std::vector<double> levers_;  ///< of the targets, by which a tilt counts
  std::size_t runs_of_test_ = 0;
  std::size_t runs_ = 0;
  bool all_runs_reach_all_ = false;  ///< as of a stated number of runs; else a cell has as many readings as it had
  std::vector<Cell> cells_;          ///< ↑ of all targets, then ↓
  bool scatters_ = false;
  bool each_its_own_ = false;     ///< s of each target by itself, which is known from its few readings alone
  std::size_t own_scatters_ = 0;  ///< degrees of freedom of all these
  bool runs_differ_ = false;
  RunSpread spread_{};
  std::vector<numeric::PossibleShares> shares_;  ///< of s ↑, of s ↓, of the spread of the runs
};

}  // namespace axiometry::compensation::retest
