// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>

#include "axiometry/app/live/lengths/length_task.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/tracking/lines/line_test_support.h"
#include "axiometry/volumetric/known_machine_test_support.h"
#include "axiometry/volumetric/plan/point_set.h"

/// Plans whose lengths can be captured within seconds.
namespace axiometry::testing_support {

inline constexpr std::size_t volume_points = 8;

inline json::Value body_with(json::Value plan) {
  json::Value body = json::Value::object();
  body.add("plan", std::move(plan));
  return body;
}

/// Lines x and xz.
inline app::LengthTask lines_task(std::size_t part) {
  const TrackingPlan plan = tracking::testing_support::two_lines(1);
  return *app::LengthTask::make(app::LengthPlanKind::lines, body_with(formats::tracking_plan_value(plan)), part);
}

/// One tool from two stations, at other points from each.
inline volumetric::CalibrationPlan volume_plan() {
  volumetric::CalibrationPlan plan{.machine = volumetric::testing::known_machine()};
  plan.date = "2026-11-25";
  plan.machine.stations = {{"A", {-150.0, -120.0, -700.0}}, {"B", {1150.0, -100.0, -650.0}}};
  plan.machine.tools.resize(1);
  plan.feed_mm_per_min = 20'000.0;
  plan.dwell = Duration::s(2.0);
  for (std::size_t station = 0; station < 2; ++station) {
    volumetric::PlannedRun& run = plan.runs.emplace_back(volumetric::PlannedRun{station, 0});
    const double shift = 0.1 + 0.3 * static_cast<double>(station);
    for (const Vector3& q :
         volumetric::short_tour(volumetric::spread_points(plan.machine.travel, volume_points, {shift, shift, shift})))
      run.stops.push_back({q});
  }
  return plan;
}

inline json::Value volume_body() { return body_with(formats::volumetric_plan_value(volume_plan())); }

inline app::LengthTask volume_task(std::size_t part, const volumetric::CalibrationPlan& plan = volume_plan()) {
  return *app::LengthTask::make(app::LengthPlanKind::volume, body_with(formats::volumetric_plan_value(plan)), part);
}

}  // namespace axiometry::testing_support
