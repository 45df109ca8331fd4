// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/length_run.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/live/runs/recording_spared.h"
#include "axiometry/app/tracking/tracking_plan.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"

namespace axiometry::app {

Result<LengthOutcome> run_length_capture(const CaptureRun& run, const CaptureOptions& options,
                                         const CaptureObserver& observer) {
  AXIOMETRY_TRY_VOID(check_recording_spared(run, options.plan));
  AXIOMETRY_TRY_VOID(check_ending(run.out, {".csv", ".txt"}));
  AXIOMETRY_TRY(const TrackingPlan plan, read_tracking_plan_file(options.plan));
  AXIOMETRY_TRY(CaptureSession session, CaptureSession::open(plan, options));
  AXIOMETRY_TRY(HeardSource heard, hear_source(run, std::move(session), observer));
  AXIOMETRY_TRY(CapturedLengths lengths, in_file(captured_lengths(plan, heard.session), run.from));
  if (!run.out.empty()) AXIOMETRY_TRY_VOID(write_file(run.out, length_capture_table(lengths)));
  return LengthOutcome{heard.complete, heard.stopped, std::move(lengths), std::move(heard.date)};
}

Result<PartOutcome> run_part_capture(const CaptureRun& run, const CaptureOptions& options,
                                     const CaptureObserver& observer) {
  AXIOMETRY_TRY_VOID(check_recording_spared(run, options.plan));
  AXIOMETRY_TRY_VOID(check_ending(run.out, {".csv", ".txt"}));
  AXIOMETRY_TRY(const std::string bytes, whole_file(options.plan));
  AXIOMETRY_TRY(const volumetric::CalibrationPlan plan, in_file(formats::read_volumetric_plan(bytes), options.plan));
  if (!options.part && plan.runs.size() > 1)
    return fail(fmt::format("found a plan of {} parts, expected which one is measured: 1 to {}", plan.runs.size(),
                            plan.runs.size()));
  const PartRange parts{options.part.value_or(1), options.part.value_or(1)};
  AXIOMETRY_TRY(CaptureSession session, open_parts(plan, parts, options));
  AXIOMETRY_TRY(const HeardSource heard, hear_source(run, std::move(session), observer));
  AXIOMETRY_TRY(PartLengths lengths, in_file(part_lengths(plan, parts, false, heard.session), run.from));
  if (!run.out.empty()) AXIOMETRY_TRY_VOID(write_file(run.out, part_lengths_table(lengths)));
  return PartOutcome{heard.complete, heard.stopped, std::move(lengths)};
}

}  // namespace axiometry::app
