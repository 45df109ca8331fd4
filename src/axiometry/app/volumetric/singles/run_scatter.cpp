// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/singles/run_scatter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/numeric/distributions/f_distribution.h"
#include "axiometry/standards/error_motions/motion_estimate.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"

namespace axiometry::app {
namespace {

constexpr double no_square = error_motions::rounding * error_motions::rounding;

/// s² of one mean.
struct MeanSquare {
  double square = 0.0;
  double degrees = 1.0;  // degrees of freedom, n − 1
  std::size_t position = 0, direction = 0;
  double runs() const { return degrees + 1.0; }
};

std::vector<MeanSquare> squares_of(std::span<const PositionMeans> positions) {
  std::vector<MeanSquare> all;
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (const std::size_t direction : {0u, 1u}) {
      const auto& mean = direction == 0 ? positions[i].up : positions[i].down;
      if (!mean || !mean->s) continue;
      const double degrees = std::max(1.0, static_cast<double>(mean->runs) - 1.0);
      const double square = *mean->s * *mean->s;
      all.push_back({square > no_square ? square : 0.0, degrees, i, direction});
    }
  std::ranges::stable_sort(all, {}, &MeanSquare::square);
  return all;
}

/// Of rounding to the step of the readings, where some runs show that there is one: the least other s is at least that
/// of one reading which lies a step apart, step/√n.
double rounding_variance(const std::vector<MeanSquare>& ascending) {
  if (ascending.empty() || ascending.front().square > 0.0) return 0.0;
  double least = 0.0;
  for (const MeanSquare& m : ascending)
    if (const double step = m.runs() * m.square; m.square > 0.0 && (least == 0.0 || step < least)) least = step;
  return least / 12.0;
}

/// Means that scatter alike, of squares in ascending order, and those beyond them.
class ScatterPool {
 public:
  ScatterPool(std::vector<MeanSquare> ascending, double rounding)
      : ascending_(std::move(ascending)), count_(ascending_.size()), rounding_(rounding) {
    std::vector<double> squares(count_ + 1, 0.0), degrees(count_ + 1, 0.0);  // sums over the first of them
    for (std::size_t k = 0; k < count_; ++k) {
      squares[k + 1] = squares[k] + ascending_[k].degrees * ascending_[k].square;
      degrees[k + 1] = degrees[k] + ascending_[k].degrees;
    }
    const std::size_t all = count_;
    for (std::size_t left = all - 1; 2 * left >= all && left > 0; --left)
      if (tail_over(ascending_[left], squares[left], degrees[left]) <
          iso230_2::uneven_level / static_cast<double>(left + 1))
        count_ = left;
    squares_ = squares[count_];
    degrees_ = degrees[count_];
  }

  double degrees() const { return degrees_; }
  double variance() const { return std::max(squares_ / degrees_, rounding_); }

  void put_into(RunScatter& scatter) const {
    const double of_all = widened(variance(), degrees_);
    for (std::size_t k = 0; k < ascending_.size(); ++k) {
      const MeanSquare& m = ascending_[k];
      const bool stands_out = k >= count_;
      const double own = stands_out ? widened(m.square, m.degrees) : is_doubtful(m) ? m.square : 0.0;
      scatter.means[m.position][m.direction] = {std::max(own, of_all) / m.runs(), stands_out};
    }
  }

 private:
  static double widened(double square, double degrees) {
    const double widening = error_motions::coverage_of(degrees) / 2.0;
    return widening * widening * square;
  }

  /// How often chance exceeds its F over others.
  double tail_over(const MeanSquare& m, double squares, double degrees) const {
    const double others = std::max(squares / degrees, rounding_);
    return others > 0.0 ? numeric::f_tail(m.square / others, {m.degrees, degrees}) : 1.0;
  }

  bool is_doubtful(const MeanSquare& m) const {
    const double degrees = degrees_ - m.degrees;
    return degrees > 0.0 && m.square > variance() &&
           tail_over(m, std::max(0.0, squares_ - m.degrees * m.square), degrees) < own_scatter_level;
  }

  std::vector<MeanSquare> ascending_;
  std::size_t count_ = 0;  // how many of them scatter alike
  double rounding_ = 0.0, squares_ = 0.0, degrees_ = 0.0;
};

bool are_unlike(const ScatterPool& one, const ScatterPool& other) {
  const bool first = one.variance() > other.variance();
  const ScatterPool& above = first ? one : other;
  const ScatterPool& below = first ? other : one;
  return below.variance() > 0.0 && numeric::f_tail(above.variance() / below.variance(),
                                                   {above.degrees(), below.degrees()}) < 0.5 * own_scatter_level;
}

}  // namespace

RunScatter run_scatter(std::span<const PositionMeans> positions) {
  RunScatter scatter;
  scatter.means.resize(positions.size());
  const std::vector<MeanSquare> all = squares_of(positions);
  if (all.empty()) return scatter;
  const double rounding = rounding_variance(all);
  std::array<std::vector<MeanSquare>, 2> of;
  for (const MeanSquare& m : all) of[m.direction].push_back(m);
  if (!of[0].empty() && !of[1].empty()) {
    const ScatterPool up(of[0], rounding), down(of[1], rounding);
    if (are_unlike(up, down)) {
      up.put_into(scatter);
      down.put_into(scatter);
      scatter.by_direction = {std::sqrt(up.variance()), std::sqrt(down.variance())};
      return scatter;
    }
  }
  ScatterPool(all, rounding).put_into(scatter);
  return scatter;
}

}  // namespace axiometry::app
