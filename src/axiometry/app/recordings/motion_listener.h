// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/capture/values/value_listener.h"
#include "axiometry/formats/recording.h"
#include "axiometry/formats/text/units.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/motion_series.h"
#include "axiometry/model/plan.h"

/// Readings of a straightness or a rotation out of a stream, in the unit that somebody stated.
namespace axiometry::app {

/// What was said at a stop, and when in the recording.
struct StopMark {
  capture::StopKey key = capture::StopKey::take;
  double time_s = 0.0;
};

/// What a person says of such a stream.
struct MotionStatement {
  capture::StopSign sign = capture::StopSign::keys;
  std::optional<MotionName> error{};         ///< else the only one that the plan is made for
  const formats::Unit* unit = nullptr;       ///< unit of the readings, where the stream does not name it
  std::optional<std::size_t> stop_column{};  ///< column of the trigger or the position: 0 is the first beside the time
  std::optional<Duration> window{};          ///< averaged at a stop
  std::optional<double> still{};             ///< µm, ″ or µrad: farthest that means in it may lie apart
  std::optional<ReadingSense> sense{};
  std::vector<std::string> equipment{};  ///< "Laser head | Acme | LI-1 | 1234"
  std::vector<StopMark> marks{};         ///< what was said at the stops of a recording that is played again
};

class MotionListener {
 public:
  /// Fails on a plan of a rotary axis, of a line in space or with further plans, as check_error_of_plan() does, where
  /// neither plan nor statement tells one error, on a unit or a sense of another kind than the error, on a column of
  /// stops that is missing or of no use, and as ValueListener::make() does.
  static Result<MotionListener> make(Plan plan, const MotionStatement& stated, const capture::StandstillOptions& rest,
                                     const capture::MatcherOptions& matcher);

  /// Fails on a layout whose numbers are positions, and where the stops need a channel of their own.
  Result<void> check_layout(const formats::Recording& layout) const;
  /// How the channel is read that tells the stops; nothing where there is none.
  std::optional<formats::RecordingOptions> beside(formats::RecordingOptions recording) const;
  bool beside_comes_first() const { return stated_.sign == capture::StopSign::trigger; }

  /// `named` is the unit that the stream names, `called` what it calls the readings. Fails where nobody names a unit,
  /// on two that contradict each other or the error, and on readings that are called another error.
  Result<void> push(std::span<const Sample> samples, const formats::Unit* named, std::string_view called = {});
  void push_beside(std::span<const Sample> samples) { listener_.push_beside(samples); }
  double press(capture::StopKey key) { return listener_.press(key); }
  void interrupt() { listener_.interrupt(); }
  Result<void> finish() { return listener_.finish(); }

  const capture::ValueListener& values() const { return listener_; }
  const MotionName& error() const { return error_; }
  MotionUnit unit() const;                                       ///< unit of values()
  const formats::Unit* unit_of_stream() const { return unit_; }  ///< nullptr before the first reading
  const MotionStatement& stated() const { return stated_; }

 private:
  MotionListener(capture::ValueListener listener, MotionStatement stated, MotionName error)
      : listener_(std::move(listener)), stated_(std::move(stated)), error_(error) {}
  Result<void> settle_unit(const formats::Unit* named, std::string_view called);

  capture::ValueListener listener_;
  MotionStatement stated_;
  MotionName error_;
  const formats::Unit* unit_ = nullptr;
  std::vector<Sample> converted_;
};

}  // namespace axiometry::app
