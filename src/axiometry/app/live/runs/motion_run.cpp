// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/motion_run.h"

#include <utility>

#include "axiometry/app/live/runs/marks_of_run.h"
#include "axiometry/app/live/runs/recording_spared.h"

namespace axiometry::app {

Result<MotionOutcome> run_motion_capture(const CaptureRun& run, CaptureOptions options,
                                         const CaptureObserver& observer) {
  AXIOMETRY_TRY_VOID(check_recording_spared(run, options.plan));
  AXIOMETRY_TRY_VOID(take_marks(run, *options.motion));
  AXIOMETRY_TRY(Plan plan, load_any_plan(options.plan));
  AXIOMETRY_TRY(CaptureSession session, CaptureSession::open(std::move(plan), options));
  AXIOMETRY_TRY(const HeardSource heard, hear_source(run, std::move(session), observer));
  return MotionOutcome{heard.complete,           heard.stopped,           heard.session.taken(),
                       heard.session.expected(), heard.session.samples(), heard.session.lost()};
}

}  // namespace axiometry::app
