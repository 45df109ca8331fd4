// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/polar/polar_settling.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/dense/dense.h"

namespace axiometry::tracking::detail {
namespace {

constexpr double settled_move_mm = 1e-7, settled_gain = 1e-12;
constexpr double bend_share = 0.1;  // of a step, by which the second derivative along it is taken
constexpr double damping_first = 1e-12, damping_most = 1e6;  // of 1, the square of a column in its own unit

class Settling {
 public:
  Settling(const PolarLayout& layout, std::span<const PolarReading> readings, PolarState start,
           const PolarOptions& options)
      : layout_(layout), readings_(readings), options_(options) {
    now_.state = std::move(start);
  }

  PolarSettling carry_out() && {
    now_.outcome = find();
    return std::move(now_);
  }

 private:
  PolarOutcome find() {
    double chi_squared = polar_chi_squared(layout_, readings_, now_.state);
    for (now_.iterations = 1; now_.iterations <= options_.iterations_most; ++now_.iterations) {
      if (!std::isfinite(chi_squared)) return PolarOutcome::diverged;
      bool is_open = false;
      for (;; damping_ = std::max(10.0 * damping_, damping_first)) {
        if (options_.stop.stop_requested()) return PolarOutcome::not_wanted;
        // No step is short enough to lower χ²: what is left is rounding.
        if (damping_ > damping_most) return take(PolarOutcome::settled);
        linearise();
        if (now_.inverse.null_directions > 0) {
          is_open = is_open || damping_ == 0.0;
          continue;
        }
        const double gain = now_.system.gain + now_.inverse.gain;
        auto [next, tried] = tried_step();
        // Rounding alone may raise a χ² of 0: below 1e-9 of one reading's share it is left alone.
        if (!(tried <= chi_squared * (1.0 + 1e-9) + 1e-9)) continue;
        now_.move_mm = largest_move(next);
        const bool is_small = now_.move_mm <= settled_move_mm || gain <= settled_gain * unknowns();
        const bool is_as_promised = chi_squared - tried > 0.5 * gain;
        now_.state = std::move(next);
        chi_squared = tried;
        if (is_small && (damping_ == 0.0 || is_open)) return take(PolarOutcome::settled);
        damping_ *= is_as_promised || is_small ? 0.01 : 0.1;
        if (damping_ < damping_first) damping_ = 0.0;
        break;
      }
    }
    return PolarOutcome::unsettled;
  }

  PolarOutcome take(PolarOutcome outcome) {
    damping_ = 0.0;
    linearise();
    return outcome;
  }

  void linearise() {
    now_.system = reduce_polar(layout_, readings_, now_.state, damping_);
    now_.inverse = invert_polar(now_.system, gauge());
  }

  Eigen::MatrixXd gauge() const {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& p : now_.state.points) middle += p / static_cast<double>(now_.state.points.size());
    return station_gauge(layout_, now_.state, middle);
  }

  double unknowns() const { return static_cast<double>(3 * now_.state.points.size() + layout_.columns - 6); }

  struct Step {
    std::vector<Eigen::Vector3d> points;
    Eigen::VectorXd stations;
  };
  static Step step_of(const PolarSystem& system, const PolarInverse& inverse) {
    Step step{{}, inverse.step};
    for (const PolarBlock& block : system.blocks) {
      Eigen::Vector3d way = -block.step;
      for (std::size_t k = 0; k < block.columns.size(); ++k)
        way -=
            inverse.step[static_cast<Eigen::Index>(block.columns[k])] * block.shares.col(static_cast<Eigen::Index>(k));
      step.points.push_back(way);
    }
    return step;
  }

  struct Tried {
    PolarState state;
    double chi_squared = 0.0;
  };
  /// The step, or where that lowers χ² more, along the parabola that the residuals bend it to: a point that is known
  /// well along a beam and badly across it moves on a sphere (Transtrum and Sethna's acceleration).
  Tried tried_step() const {
    const Step step = step_of(now_.system, now_.inverse);
    Tried plain{stepped(step, 1.0), 0.0};
    plain.chi_squared = polar_chi_squared(layout_, readings_, plain.state);
    if (plain.chi_squared < 0.1 * now_.system.chi_squared || plain.chi_squared <= settled_gain) return plain;
    std::vector<double> bend = polar_residuals(layout_, readings_, stepped(step, bend_share));
    const std::vector<double> back = polar_residuals(layout_, readings_, stepped(step, -bend_share));
    const std::vector<double> here = polar_residuals(layout_, readings_, now_.state);
    for (std::size_t k = 0; k < bend.size(); ++k)
      bend[k] = (bend[k] - 2.0 * here[k] + back[k]) / (2.0 * bend_share * bend_share);
    const PolarSystem system = reduce_polar(layout_, readings_, now_.state, damping_, bend);
    const Step more = step_of(system, invert_polar(system, gauge()));
    Step bent = step;
    for (std::size_t i = 0; i < bent.points.size(); ++i) bent.points[i] += more.points[i];
    bent.stations += more.stations;
    Tried other{stepped(bent, 1.0), 0.0};
    other.chi_squared = polar_chi_squared(layout_, readings_, other.state);
    return other.chi_squared < plain.chi_squared ? other : plain;
  }

  PolarState stepped(const Step& by, double part) const {
    PolarState next = now_.state;
    for (std::size_t i = 0; i < next.points.size(); ++i) next.points[i] += part * by.points[i];
    const Eigen::VectorXd step = part * by.stations;
    for (std::size_t j = 0; j < next.poses.size(); ++j) {
      const auto at = static_cast<Eigen::Index>(layout_.column[j]);
      PolarPose& pose = next.poses[j];
      pose.at += step.segment(at, 3);
      if (layout_.has_angles[j]) {
        const Eigen::Vector3d turn = step.segment(at + 3, 3);
        if (turn.norm() > 0.0) pose.turn = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.turn;
      } else {
        for (std::size_t k = 0; k < pose.dead.size(); ++k) pose.dead[k] += step[at + 3 + static_cast<Eigen::Index>(k)];
      }
    }
    return next;
  }

  double largest_move(const PolarState& next) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < next.points.size(); ++i)
      largest = std::max(largest, (next.points[i] - now_.state.points[i]).norm());
    for (std::size_t j = 0; j < next.poses.size(); ++j)
      largest = std::max(largest, (next.poses[j].at - now_.state.poses[j].at).norm());
    return largest;
  }

  const PolarLayout& layout_;
  std::span<const PolarReading> readings_;
  const PolarOptions& options_;
  PolarSettling now_;
  double damping_ = 0.0;
};

}  // namespace

PolarSettling settle_polar(const PolarLayout& layout, std::span<const PolarReading> readings, PolarState start,
                           const PolarOptions& options) {
  return Settling(layout, readings, std::move(start), options).carry_out();
}

}  // namespace axiometry::tracking::detail
