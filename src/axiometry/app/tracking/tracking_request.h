// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/files/reader.h"
#include "axiometry/app/tracking/tracking_evaluate.h"
#include "axiometry/app/tracking/tracking_plan.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"

/// What the workbench asks of a tracking interferometer, and what it is answered: TrackingRequest, TrackingDraft and
/// their like in apps/server/openapi.json. Nothing is kept, and no text of a request is taken for the name of a file.
namespace axiometry::app {

/// A plan of lines that was asked for, with the request that makes the same plan again: its seed and date are in it.
/// null for a plan that was given as a whole.
struct RequestedLines {
  PlannedLines planned;
  json::Value request;
};

/// TrackingRequest. Fails, with line and column, on members that are unknown, missing or of another kind, on more than
/// 100 obstacles, 50 lines or 100 runs, on names that are no given_line(), and as tracking_setup_from() and
/// check_setup() do. Seed and date are drawn where they are not given.
Result<TrackingPlanRequest> tracking_request_from(const json::Value& value);

/// From {"request": …} or {"plan": …}. Fails also as plan_tracking() does, and on a plan of more than 100 000 readings
/// or 50 lines.
Result<RequestedLines> requested_lines(const json::Value& body);

/// evaluate_tracking() of what a workbench takes: it fails also on a plan that is larger, or has names that are none,
/// as requested_lines() does, and on more than 10 million trials in all, before anything is computed.
Result<EvaluatedLines> evaluate_presentable(const TrackingFiles& files, const TrackingEvaluateOptions& options);

/// TrackingDraft, its texts in the reader's language.
json::Value lines_value(const RequestedLines& lines, const Reader& reader);

/// TrackingPoints.
json::Value points_value(const PlannedLocation& planned, const Reader& reader);

/// TrackingAdvice.
json::Value advice_value(const StationAdvice& advice);

/// {"tool_offset_mm", "near_mm", "machine_sigma_um", "ranging"}; all may be left out. Fails on members that are unknown
/// or of another kind, and on numbers that are none of their kind.
Result<LocateRequest> locate_request_from(const json::Value& value);

}  // namespace axiometry::app
