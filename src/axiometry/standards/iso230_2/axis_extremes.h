// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "axiometry/model/series.h"

namespace axiometry::iso230_2 {

struct AxisParameters;
struct PositionResult;

/// What the parameters of an axis are made of: extremes of means, boundaries and spreads over the positions seen so far
/// (3.16 to 3.27). Two parts of an axis may be seen apart and joined.
class AxisExtremes {
 public:
  void see(const PositionResult& position);
  void see(const AxisExtremes& other);
  AxisParameters parameters() const;

 private:
  /// Algebraic maximum and minimum of what it has seen.
  class Extremes {
   public:
    void see(double x) {
      max_ = std::max(max_, x);
      min_ = std::min(min_, x);
    }
    void see(const Extremes& other) {
      max_ = std::max(max_, other.max_);
      min_ = std::min(min_, other.min_);
    }
    bool any() const { return max_ >= min_; }
    std::optional<Deviation> range() const { return value(max_ - min_); }
    std::optional<Deviation> maximum() const { return value(max_); }
    double magnitude() const { return std::max(std::abs(max_), std::abs(min_)); }

   private:
    std::optional<Deviation> value(double x) const {
      return any() ? std::optional(Deviation::native(x)) : std::nullopt;
    }

    double max_ = -std::numeric_limits<double>::infinity();
    double min_ = std::numeric_limits<double>::infinity();
  };

  /// What one direction of approach contributes to the axis.
  struct DirectionExtremes {
    Extremes means;       // x̄_i
    Extremes boundaries;  // x̄_i ± 2 s_i
    Extremes R;           // R_i of this direction

    void see(std::optional<Deviation> mean, std::optional<Deviation> s, std::optional<Deviation> repeatability);
    void see(const DirectionExtremes& other);
    std::optional<Deviation> A() const;
  };

  DirectionExtremes up_, down_;
  Extremes means_;  // x̄_i of both directions
  Extremes R_;      // 3.20, 0 for terms that do not exist
  Extremes B_;      // |B_i|
  double reversal_sum_ = 0.0;
  std::size_t reversal_count_ = 0;
  std::size_t count_ = 0;
};

}  // namespace axiometry::iso230_2
