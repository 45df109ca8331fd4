// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/recordings/length_capture.h"
#include "axiometry/app/volumetric/part_lengths.h"
#include "axiometry/base/result.h"

/// The use case "wait for the lengths of a plan and keep them". `out` is the table, written once, at the end.
namespace axiometry::app {

struct LengthOutcome {
  bool complete = false;  ///< the last approach has come
  bool stopped = false;   ///< whether the observer stopped it
  CapturedLengths lengths;
  std::string date;  ///< day on which the first bytes of a live source arrived
};

/// Of the lines of a tracking plan. Fails as hear_source() and captured_lengths() do.
Result<LengthOutcome> run_length_capture(const CaptureRun& run, const CaptureOptions& options,
                                         const CaptureObserver& observer);

struct PartOutcome {
  bool complete = false;  ///< the last point has come
  bool stopped = false;   ///< whether the observer stopped it
  PartLengths lengths;
};

/// Of a part of a volumetric plan, which the options must say where it has several. Fails as hear_source() and
/// part_lengths() do, so where another part fits what came far better; no table is written then, the raw file is kept.
Result<PartOutcome> run_part_capture(const CaptureRun& run, const CaptureOptions& options,
                                     const CaptureObserver& observer);

}  // namespace axiometry::app
