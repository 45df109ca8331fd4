// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/capture/capture_result.h"
#include "axiometry/capture/standstill.h"
#include "axiometry/capture/target_matcher.h"
#include "axiometry/capture/values/plan_progress.h"
#include "axiometry/capture/values/still_values.h"

/// Readings of a straightness or a rotation, which do not show where the axis stops: something beside them must.
namespace axiometry::capture {

/// What tells the stops.
enum class StopSign {
  keys,      ///< a person, at each stop
  trigger,   ///< a channel of the stream that is not 0 once the control has put out its M code
  readings,  ///< the instrument records at a trigger: each sample is the reading of a stop
  position   ///< a channel of the stream that is the position of the axis
};

/// What a person says.
enum class StopKey {
  take,  ///< the axis stands at the target that is due; where readings come by themselves: the next one is its own,
         ///< whatever its time says
  skip,  ///< the target that is due has no reading
  undo   ///< the last one back; of a reading that is being taken, that
};

struct ValueOptions {
  StopSign sign = StopSign::keys;
  StillOptions still;
  Duration window = Duration::s(1.0);  ///< averaged behind a key or a trigger
  StandstillOptions rest;              ///< how rest is told by positions, as the matcher does
  MatcherOptions matcher;
};

/// Two fifths of the plan's dwell, so that a window that begins with the trigger in its middle, or with a key a little
/// after the stop, ends before the axis moves on; 1 s of a plan without dwell.
Duration value_window(const Plan& plan);

/// One pass over both channels; the result does not depend on how they are cut into pieces, as long as of each piece
/// the triggers come before the values, and the positions behind them.
class ValueListener {
 public:
  /// Fails as TargetMatcher::make() does, and on a zero to be set at the first target. Needs a sound plan.
  static Result<ValueListener> make(Plan plan, const ValueOptions& options);

  /// What is still is told by a stream whose unit is known late: before the first reading (contract).
  void judge_by(const StillOptions& still);

  /// Readings in µm, µrad or ″, finite and in order of time (contract).
  void push(std::span<const Sample> values);
  /// The channel beside them: positions, or 0 and another number.
  void push_beside(std::span<const Sample> samples);

  /// Now, behind the last reading and behind the gap that followed it. The time at which press_at() has the same
  /// effect.
  double press(StopKey key);
  /// What was said in a recording that is played again, in order of time: before the first reading, or gap, behind it.
  void press_at(StopKey key, double time_s);

  /// Samples are missing here.
  void interrupt();
  /// What is missing becomes an event. Fails where positions do not fit the plan.
  Result<void> finish();
  /// Of what has come so far.
  Result<void> check_positions() const;

  bool complete() const;
  std::size_t taken() const;
  std::size_t expected() const { return progress_.expected(); }
  std::optional<Approach> due() const;
  std::vector<PlannedValue> values() const;
  /// Every reading that was given to an approach, in the order in which that was done, also what was taken back.
  const std::vector<PlannedValue>& given() const { return given_; }
  const std::vector<CaptureEvent>& events() const { return events_; }
  std::optional<double> now() const;                              ///< the last reading
  bool is_reading() const { return window_from_s_.has_value(); }  ///< whether a window is open
  bool waits_for_key() const { return !held_.empty(); }           ///< a doubtful reading waits to be told
  bool has_more_said() const { return !pressed_.empty(); }        ///< whether press_at() said what is still to come
  const Plan& plan() const { return plan_; }
  const ValueOptions& options() const { return options_; }

 private:
  struct Candidate {
    double time_s;
    Result<StillValue> still;
  };
  struct Pressed {
    StopKey key;
    double time_s;
  };

  ValueListener(Plan plan, const ValueOptions& options);

  void take(const Sample& value);
  void act_again();
  void act(const Pressed& pressed);
  void take_key(double time_s);
  void open_window(double from_s);
  void close_window();
  void offer(Candidate candidate);
  void drain();
  bool settle(const Candidate& candidate);
  void give(const Candidate& candidate);
  void match(const std::vector<Standstill>& standstills);
  void take_events();
  void read_rest(const CapturedReading& reading);
  void forget_before(double time_s);
  void event(EventKind kind, double time_s, std::string message);
  void refused(EventKind kind, double time_s, std::string message);
  void tell_more_alike();

  Plan plan_;
  ValueOptions options_;
  PlanProgress progress_;
  std::vector<PlannedValue> given_;
  std::vector<CaptureEvent> events_;
  std::optional<CaptureEvent> last_refused_;  // the refusal, where the last event that was told is one
  std::size_t more_alike_ = 0;                // refused since for the same reason
  std::optional<Sample> last_;
  double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_;  // of all readings
  double now_s_ = -std::numeric_limits<double>::infinity();  // time of last_, s; by a rounding later behind each gap
  std::deque<Pressed> pressed_;                              // keys of a recording that were not reached yet
  std::deque<double> edges_;                                 // edges of the trigger that were not reached yet
  std::optional<bool> level_;                                // level of the trigger; nothing where samples are missing
  std::optional<double> window_from_s_;
  std::vector<Sample> window_;  // samples of the window, or those that a rest of the axis may be averaged from
  std::deque<Candidate> held_;  // readings from the first doubtful one on
  bool doubt_told_ = false;
  bool trusted_ = false;  // the next is of the target that is due
  bool warned_ = false;   // a key came too soon, another one insists

  std::unique_ptr<StandstillDetector> detector_;
  std::optional<TargetMatcher> matcher_;
  std::vector<PlannedValue> at_rests_;
  std::size_t events_matched_ = 0;
};

}  // namespace axiometry::capture
