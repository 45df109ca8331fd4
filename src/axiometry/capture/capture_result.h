// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/capture/standstill.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/plan.h"
#include "axiometry/model/test.h"

/// What a recording gave for a plan: readings, and everything on the way that a person must know.
namespace axiometry::capture {

/// One approach of the plan with its standstill.
struct CapturedReading {
  Approach approach;
  Standstill standstill;  ///< standstill in the frame of the plan: sign and zero of the instrument applied
  Deviation deviation;    ///< x_ij (3.6): mean position at rest minus target
  std::vector<std::string>
      remarks;  ///< "2 of 40 samples left out as outliers", "drifts by 1.2 µm"; empty when nothing is to be said
};

enum class EventKind {
  zero,             ///< the zero of the instrument was set at the first standstill of target 1
  missed,           ///< approaches that the axis passed without standing still long enough
  repeated,         ///< another standstill at an approach that has its reading: the first one is kept
  wrong_direction,  ///< a standstill at the expected target, but reached from the other side: not used
  too_short,        ///< a standstill at a target, but shorter than the shortest: not used
  signal_lost,      ///< the value stood still to the last digit and then jumped: not used (Standstill::frozen_from_s)
  unexpected,       ///< a standstill at no target of the plan, or at one that was not due: not used
  unseen,           ///< the motion towards a target was not recorded, so its direction is not known: not used
  restarted,        ///< the first approach came again before the first pass was over: began again
  off_zero,         ///< the readings have a common offset that looks like another zero
  incomplete,       ///< the recording ended before the plan
  unsteady,         ///< what was read at a stop did not stand still: not used
  doubtful,         ///< a reading came so late that it may belong to a target behind the one that is due
  skipped,          ///< a person left the target without a reading
  undone,           ///< a person took the last one back
};

std::string_view event_name(EventKind kind);  ///< "missed", "wrong direction", …

struct CaptureEvent {
  EventKind kind;
  double time_s = 0.0;  ///< time within the recording, s
  std::string message;  ///< a sentence without full stop
};

struct CaptureResult {
  std::vector<CapturedReading> readings;  ///< readings in the order in which they were taken
  std::vector<CaptureEvent> events;
  Position datum;                    ///< position of the axis at which the instrument shows zero
  Position window;                   ///< farthest from a target that was taken for it
  std::size_t approaches = 0;        ///< how many approaches the plan has
  std::size_t standstills = 0;       ///< long enough, not at overruns
  std::size_t overruns = 0;          ///< standstills at turning points of the plan
  std::size_t full_ways_before = 0;  ///< ways over all targets, one way or the other, before the first reading
};

/// "target 3↑ run 2"
std::string approach_name(const Approach& approach);

/// "the recording ended before target 3↓ run 2 and the 4 behind it".
std::string ended_before(const Approach& approach, std::size_t behind);

/// Fails when less than half of the standstills belong to approaches.
Result<void> check_fit(const Plan& plan, const CaptureResult& result);

/// The test that the readings make: conditions as recorded (captured_conditions.h), the rest of the metadata from the
/// plan, times of the readings, remarks on what is missing and what the recording lacks. A target
/// without any reading is left out, which makes it no test after ISO 230-2. Fails when fewer than two targets have a
/// reading, and when the recording does not fit the plan: less than half of its standstills belong to approaches, or
/// the readings lie all over the window, as they do at targets that are only near those of the plan.
Result<Test> captured_test(const Plan& plan, const CaptureResult& result);

}  // namespace axiometry::capture
