// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/simulation/virtual_axis.h"

/// When the axis is where, if it does exactly what it is told: the moves of a plan under feed and acceleration. In here
/// and in the other kernels of the simulation numbers are mm or °, s, and µm or ″.
namespace axiometry::simulation {

/// How a machine does not follow its plan.
struct Departures {
  std::vector<Approach> missed;            ///< approaches that were never made
  std::vector<Approach> doubled;           ///< made, left by an overrun, and made once more
  std::vector<std::size_t> reversed_runs;  ///< j − 1; begun at the last target: ↓ first, then ↑ (standard cycle only)
};

/// Part of a move with constant acceleration: command c = at + speed·τ + acceleration·τ²/2, τ = t − begin.
///
/// What the servo leaves (following error e = c − y) is e = α + βτ + e^(−Dωτ)·(A cos ω_d τ + B sin ω_d τ), the solution
/// of e″ + 2Dω e′ + ω² e = c″ + 2Dω c′ with ω_d = ω√(1 − D²).
struct Phase {
  double begin = 0.0;
  double at = 0.0;
  double speed = 0.0;
  double acceleration = 0.0;
  double alpha = 0.0, beta = 0.0;   ///< mm or °, and per s
  double cosine = 0.0, sine = 0.0;  ///< A, B, mm or °
};

/// One move and the rest after it.
struct Leg {
  double begin = 0.0;    ///< s; the move begins
  double arrive = 0.0;   ///< the command is at its end
  double settled = 0.0;  ///< time from which to `leave` the servo is within 0.01 µm or ″; `leave` when it never is
  double leave = 0.0;    ///< the next move begins
  double from = 0.0;
  double to = 0.0;
  std::array<Phase, 4> phases;  ///< faster, at feed, slower, at rest; an absent one lasts no time
  std::optional<Approach> approach;
  bool extra = false;  ///< made a second time (Departures::doubled)

  double towards() const { return to < from ? -1.0 : 1.0; }
};

class Timeline {
 public:
  /// At rest before the first move and after the last.
  static constexpr double rest_s = 2.0;

  /// Needs a sound axis and plan. Fails on a departure that names an approach the plan does not have, or the same one
  /// twice, on reversed runs in another cycle than the standard one, when no approach is left and on more than a
  /// million approaches.
  static Result<Timeline> make(const Plan& plan, const VirtualAxis& axis, const Departures& departures);

  std::span<const Leg> legs() const { return legs_; }
  double duration() const { return legs_.back().leave; }

  /// The phase in which t of this leg lies.
  static const Phase& phase_at(const Leg& leg, double t);
  /// c(t), where the axis is told to be.
  static double command(const Leg& leg, const Phase& phase, double t);
  /// e(t), by how much it is not there yet; 0 without a servo.
  double following_error(const Phase& phase, double t) const;

 private:
  explicit Timeline(const VirtualAxis& axis);
  void add(double to, double feed, double dwell);
  void follow(Leg& leg);

  double acceleration_;
  bool servo_ = false;
  double decay_ = 0.0;                  ///< Dω, 1/s
  double omega_ = 0.0;                  ///< ω
  double frequency_ = 0.0;              ///< ω_d/2π, turns/s
  double lag_ = 0.0, lag_speed_ = 0.0;  ///< e and e′ at the end of what is there so far
  double small_ = 0.0;                  ///< 0.01 µm or ″ in mm or °
  std::vector<Leg> legs_;
};

}  // namespace axiometry::simulation
