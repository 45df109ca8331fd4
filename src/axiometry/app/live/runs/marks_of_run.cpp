// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/marks_of_run.h"

#include <string>

#include "axiometry/app/live/disk/stop_marks.h"
#include "axiometry/app/recordings/raw_times.h"

namespace axiometry::app {

Result<void> take_marks(const CaptureRun& run, MotionStatement& stated) {
  AXIOMETRY_TRY(const auto live, parse_live(run.from));
  if (live && !run.keys.empty())
    return fail("found a file of keys with a live source, expected one with a finished recording");
  if (live && run.resume.empty() && has_marks(run.raw))
    return std::unexpected(
        Error{"found keys of another recording, expected none before this one begins", marks_name(run.raw), {}});
  const std::string& played = run.resume.empty() ? run.from : run.resume;
  if (!run.keys.empty()) {
    AXIOMETRY_TRY(stated.marks, read_marks(run.keys));
  } else if (is_raw(played)) {
    AXIOMETRY_TRY(stated.marks, marks_beside(played));
  }
  if (stated.sign != capture::StopSign::keys || live || !stated.marks.empty()) return {};
  return std::unexpected(
      Error{"found a finished recording and no keys, expected those that were said at its stops", run.from, {}});
}

}  // namespace axiometry::app
