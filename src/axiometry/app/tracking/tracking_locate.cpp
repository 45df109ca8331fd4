// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_locate.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/tracking/tracking_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/tracking/location_points_csv.h"
#include "axiometry/report/tracking.h"

namespace axiometry::app {

namespace {

/// Whether a table of planned points holds one length or more: the last cell of a row is not empty.
bool has_lengths(std::string_view table) {
  if (!table.contains("axes_x_mm")) return false;
  return std::ranges::any_of(text::split(table, '\n'), [](std::string_view line) {
    line = text::trim(line);
    return !line.empty() && line.front() >= '0' && line.front() <= '9' && !line.ends_with(',') && !line.ends_with(';');
  });
}

}  // namespace

Result<Located> locate(const LocateRequest& request) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(request.file));
  return locate(request, bytes);
}

Result<Located> locate(const LocateRequest& request, std::string_view bytes) {
  AXIOMETRY_TRY(formats::LocationPointsFile file, in_file(formats::read_location_points(bytes), request.file));
  if (file.has_axes && request.tool_offset_mm != Vector3{})
    return std::unexpected(
        Error{"found columns of the axes beside those of the reflector, which hold the tool already; "
              "expected no tool offset to be added",
              request.file,
              {}});
  Located located{request, sha256(bytes), std::move(file.points), {}};
  for (LocationPoint& point : located.points) point.at_mm += request.tool_offset_mm;
  AXIOMETRY_TRY(located.location, in_file(tracking::locate_station(located.points, request.options), request.file));
  for (std::string& remark : file.remarks)
    located.location.findings.push_back({"station-source-remark", false, std::move(remark)});
  return located;
}

Experiment present(const Located& located, const report::Options& options) {
  const report::StationSubject subject{located.points, located.location, located.request.options,
                                       base_name(located.request.file), located.sha256};
  return {report::compose(subject, options), to_json(located)};
}

Result<PlannedLocation> plan_location_points(const TrackingSetup& setup, std::size_t count) {
  AXIOMETRY_TRY(tracking::LocationPlan plan, tracking::plan_location(setup, count));
  return PlannedLocation{setup, std::move(plan)};
}

Experiment present(const PlannedLocation& planned, const report::Options& options) {
  return {report::compose(report::LocationPlanSubject{planned.setup, planned.plan}, options), to_json(planned)};
}

std::string location_points_csv(const PlannedLocation& planned) {
  std::string text = fmt::format(
      "# Drive the axes to each point in this order without breaking the beam and fill in the change of length.\n"
      "point,axes_x_mm,axes_y_mm,axes_z_mm,{}\n",
      formats::location_points_head);
  for (std::size_t i = 0; i < planned.plan.points_mm.size(); ++i) {
    const Vector3 p = planned.plan.points_mm[i], q = p - planned.setup.tool_offset_mm;
    text += fmt::format("{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},\n", i + 1, q.x, q.y, q.z, p.x, p.y, p.z);
  }
  return text;
}

Result<void> write_location_points(const PlannedLocation& planned, const std::string& file) {
  if (std::error_code error; file != "-" && std::filesystem::is_regular_file(file, error)) {
    const auto bytes = whole_file(file);
    if (bytes && (has_lengths(*bytes) || formats::read_location_points(*bytes)))
      return std::unexpected(Error{"found measured lengths there, expected another name", file, {}});
  }
  return write_file(file, location_points_csv(planned));
}

}  // namespace axiometry::app
