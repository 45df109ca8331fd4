// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/model/plan.h"

/// Which approach of a plan it is time for.
namespace axiometry::capture {

/// Of every approach, in the order of approaches(): its dwell and the way to it from the approach before at the plan's
/// feed, s. Needs a sound plan.
std::vector<double> planned_times_s(const Plan& plan);

/// How fast the program goes through its plan, told by the readings that follow each other, and what it must have come
/// to behind samples that are missing.
class PlanPace {
 public:
  /// Needs a sound plan.
  explicit PlanPace(const Plan& plan);

  /// A reading of that approach; `seen` where all of the way from the one before was recorded.
  void read(std::size_t approach, double time_s, bool seen);
  void forget();

  struct Placed {
    std::size_t approach = 0;
    bool sure = true;  ///< false where the time lies between two of them, or behind the last
  };
  /// Which of these approaches, in their order, comes next to that time; the first of them where that is not sure.
  /// Needs one at least (contract).
  Placed place(std::span<const std::size_t> approaches, double time_s) const;

 private:
  struct Last {
    std::size_t approach = 0;
    double time_s = 0.0;
  };

  std::vector<double> until_s_;  // planned from the first approach to each
  std::optional<Last> last_;
  std::vector<double> paces_;  // time taken over time planned, of neighbours
};

/// How often an axis went over the whole of a stretch, one way or the other.
class FullWays {
 public:
  FullWays(double lowest, double highest) : lowest_(lowest), highest_(highest) {}

  /// Where it turned or stood next.
  void go(double place);
  std::size_t count() const { return count_; }

 private:
  double lowest_, highest_;
  std::optional<double> from_;
  std::size_t count_ = 0;
};

}  // namespace axiometry::capture
