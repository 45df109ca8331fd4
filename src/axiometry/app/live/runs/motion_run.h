// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "axiometry/app/live/runs/capture_run.h"

/// The use case "wait for the readings of a straightness or a rotation after a plan and keep them".
namespace axiometry::app {

struct MotionOutcome {
  bool complete = false;    ///< every approach has its reading or was left without one
  bool stopped = false;     ///< whether the observer stopped it
  std::size_t found = 0;    ///< readings
  std::size_t planned = 0;  ///< approaches
  std::size_t samples = 0;
  std::size_t lost = 0;
};

/// As run_capture(), also of "simulator://?preset=good&size=5&seed=7&speed=10", with options.motion: `out` is the table
/// of motion_table(), written after every reading. What was said at the stops is kept beside the raw file, and played
/// again with it (stop_marks.h). Fails also as take_marks() does, and on what the simulator does not know.
Result<MotionOutcome> run_motion_capture(const CaptureRun& run, CaptureOptions options,
                                         const CaptureObserver& observer);

}  // namespace axiometry::app
