// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/capture/capture_result.h"
#include "axiometry/capture/plan_pace.h"
#include "axiometry/capture/standstill.h"
#include "axiometry/model/plan.h"

/// Which standstill belongs to which approach of a plan. By position, direction of arrival and the way in between,
/// never by counting alone, so that one missed target does not shift those behind it.
namespace axiometry::capture {

struct MatcherOptions {
  std::optional<Position> window{};      ///< farthest from a target; default_window() when absent
  Duration shortest = Duration::s(1.0);  ///< shorter standstills are not used
  bool reversed = false;                 ///< the instrument counts up when the axis moves down
  Position datum{};                      ///< position of the axis at which the instrument shows zero
  bool zero_at_first_target = false;     ///< instead of `datum`: its first standstill at target 1 is that target
};

/// A quarter of the smallest interval between targets, but at most half the overrun.
Position default_window(const Plan& plan);

/// Farther than that the axis did not overshoot a target, but was driven beyond it and back: 0.05 mm or 0.01°, three
/// thresholds of rest if that is more.
Position came_back_limit(AxisKind kind, Position threshold);

/// Takes standstills in order. The rules, for a standstill at target i from direction d:
///
/// - It is the next approach that the plan still expects at (i, d), if the axis has passed the targets of all
/// approaches
///   in between; those are missed.
/// - At the approach just read, without having been away by half an overrun: the same standstill again, not used.
/// - Anything else is not used and told as an event. Nothing is used whose direction contradicts the plan, or to which
///   the axis came back from beyond it (came_back_limit()).
/// - Where samples are missing, or before the recording, the way is not known: then any later approach of that
///   direction will do, of several the one for which it is time (plan_pace.h). A standstill is never used when the
///   motion towards it was not recorded.
/// - Of a rotary axis, at first and behind missing samples: whole turns are added where that makes it the approach that
///   is due; of an instrument that rolls over so that it is at a target, of several at the one that comes first.
class TargetMatcher {
 public:
  /// Fails when the plan is not sound, or the window is not positive, reaches half way to the next target or an
  /// overrun.
  static Result<TargetMatcher> make(Plan plan, const MatcherOptions& options);

  /// The instrument is known to show the same again after each turn from that time of the recording on (full_turns.h).
  void rolls_from(double time_s) { rolls_from_s_ = time_s; }

  /// The readings that this standstill completes; mostly one or none.
  std::vector<CapturedReading> take(const Standstill& standstill);

  /// What is still missing becomes an event, and an offset of all readings too. Fails when the zero was to be set at
  /// target 1 and no standstills fitted.
  Result<void> finish();

  bool complete() const { return due_ == walk_->approaches.size(); }
  const CaptureResult& result() const { return result_; }
  const Plan& plan() const { return walk_->plan; }
  /// The approach that is due; nothing when all are done.
  std::optional<Approach> due() const;

 private:
  /// What follows from the plan alone: shared by all that are tried while the zero is sought.
  struct Walk {
    explicit Walk(Plan walked);

    Plan plan;
    std::vector<Approach> approaches;
    std::set<Position> turning_points;
    std::size_t first_pass = 0;  ///< approaches before the first change of direction
  };

  TargetMatcher(std::shared_ptr<const Walk> walk, const MatcherOptions& options);

  Standstill in_plan(const Standstill& shown) const;
  std::optional<CapturedReading> match(const Standstill& shown);
  bool rolls(const Standstill& standstill) const;
  void find_turn(const Standstill& standstill);
  std::optional<double> turns_to_target(const Standstill& standstill) const;
  bool at_overrun_of_a_turn(const Standstill& standstill) const;
  void tell_rollover(const Standstill& standstill);
  std::vector<CapturedReading> try_zero(const Standstill& standstill);
  std::optional<std::size_t> target_at(Position position) const;
  bool at_turning_point(Position position) const;
  std::optional<PlanPace::Placed> approach_for(std::size_t target, const Standstill& standstill) const;
  bool came_back(const Standstill& standstill) const;
  void begin_with(const Standstill& standstill);
  void tell_missing(const Standstill& standstill);
  void note_behind(const Standstill& standstill);
  bool passed(std::size_t first, std::size_t last) const;
  bool was_away() const;
  CapturedReading read(std::size_t approach, const Standstill& standstill);
  void explain(std::size_t target, const Standstill& standstill);
  bool begins_again(std::size_t target, const Standstill& standstill) const;
  void event(EventKind kind, double time_s, std::string message);
  std::string shown(Position position) const;

  std::shared_ptr<const Walk> walk_;
  MatcherOptions options_;
  Position window_;
  std::size_t due_ = 0;                  // index of the next approach
  std::optional<std::size_t> last_;      // the approach read last
  double lowest_ = 0.0, highest_ = 0.0;  // range of the positions on the way since then
  bool unseen_ = true;                   // a part of that way is missing
  PlanPace pace_;
  FullWays warm_up_;
  std::vector<Standstill> waiting_;     // standstills that wait until the zero is known
  std::optional<double> rolls_from_s_;  // nothing of an instrument that was not seen to roll over
  double turns_deg_ = 0.0;              // whole turns from what counts on as it is shown to the plan
  bool turn_found_ = false;             // since the last gap it was at the target that is due, or read
  bool rollover_told_ = false;
  double last_time_s_ = 0.0;
  std::size_t behind_ = 0;      // standstills at targets behind the last approach
  double behind_from_s_ = 0.0;  // when the first of them began
  CaptureResult result_;
};

}  // namespace axiometry::capture
