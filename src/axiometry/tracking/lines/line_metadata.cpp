// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lines/line_metadata.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "axiometry/base/text/number_text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/tracking/geometry/machine_axes.h"

namespace axiometry::tracking {
namespace {

std::string capitals(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

std::string station_text(Vector3 p) {
  return fmt::format("({}; {}; {}) mm", format_exact(rounded_to_um(p.x)), format_exact(rounded_to_um(p.y)),
                     format_exact(rounded_to_um(p.z)));
}

Axis axis_of(const LineDescription& d) {
  const Axis& planned = d.line.plan.axis;
  Axis axis = d.given.axis;
  axis.name = planned.name.empty() ? capitals(d.line.id) : planned.name;
  axis.kind = planned.kind;
  axis.line_origin_mm = planned.line_origin_mm;
  axis.line_direction = planned.line_direction;
  if (planned.travel_begin) axis.travel_begin = planned.travel_begin;
  if (planned.travel_end) axis.travel_end = planned.travel_end;
  if (planned.expected_period) axis.expected_period = planned.expected_period;
  if (!planned.scale_type.empty()) axis.scale_type = planned.scale_type;
  if (planned.scale_expansion) axis.scale_expansion = planned.scale_expansion;
  if (!planned.compensation.empty()) axis.compensation = planned.compensation;
  if (!planned.compensation_points.empty()) axis.compensation_points = planned.compensation_points;
  axis.measurement_line = planned.measurement_line;
  if (axis.measurement_line.empty())
    axis.measurement_line = is_aligned(d.setup) ? "along an interferometer that is aligned with it"
                                                : fmt::format("away from a tracking interferometer at {}",
                                                              station_text(d.setup.station.position_mm));
  return axis;
}

/// "Y = 300 mm; Z = 350 mm", where the axes that stand are; "none" where all of them move.
std::string resting_axes(const Axis& axis) {
  const auto line = spatial_line(axis);
  if (!line) return "";
  std::string text;
  for (std::size_t k = 0; k < 3; ++k)
    if (!axis_moves(line->direction, k))
      text += fmt::format("{}{} = {} mm", text.empty() ? "" : "; ", axis_names[k],
                          format_exact(rounded_to_um(line->origin_mm[k])));
  return text.empty() ? "none" : text;
}

/// "X 0 to 800 mm, Y 0 to 600 mm, Z -500 to 0 mm"
std::string travels_text(const TravelBox& travel) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k)
    text += fmt::format("{}{} {} to {} mm", k == 0 ? "" : ", ", axis_names[k], format_exact(travel.lowest_mm[k]),
                        format_exact(travel.highest_mm[k]));
  return text;
}

bool device_given(const Metadata& given) {
  const AnnexAInputs& annex = given.uncertainty;
  return annex.device_calibration || annex.device_calibration_per_length || annex.device_error_range;
}

Deviation ranging_um(const LineDescription& d) {
  const RangingUncertainty& ranging = d.setup.ranging;
  const double um = ranging.constant.in_um() + ranging.per_length.in_um_per_m() * d.travel_mm / 1000.0;
  return Deviation::native(std::round(um * 1e5) / 1e5);  // reports show an input as it stands: no digits of a quotient
}

}  // namespace

Metadata line_metadata(const LineDescription& d) {
  const Plan& plan = d.line.plan;
  Metadata m = d.given;
  m.axis = axis_of(d);
  if (m.machine.name.empty()) m.machine.name = plan.machine;
  if (m.machine.axes_travel.empty()) m.machine.axes_travel = travels_text(d.setup.travel);
  m.conditions.cycle = plan.cycle;
  if (!m.conditions.feed) m.conditions.feed = plan.feed;
  if (!m.conditions.dwell) m.conditions.dwell = plan.dwell;
  if (m.conditions.warm_up.empty() && plan.warm_up_runs > 0)
    m.conditions.warm_up = fmt::format("{} there and back over the measurement travel at {} mm/min",
                                       plan.warm_up_runs == 1 ? "once" : fmt::format("{} times", plan.warm_up_runs),
                                       format_exact(plan.feed));
  if (m.conditions.axes_not_under_test.empty()) m.conditions.axes_not_under_test = resting_axes(m.axis);
  const Vector3 t = d.setup.tool_offset_mm;
  m.conditions.tool_offset_mm = {t.x, t.y, t.z};
  if (!device_given(d.given)) m.uncertainty.device_calibration = ranging_um(d);
  if (!is_aligned(d.setup)) m.tracking.station_position = d.geometry.foot;
  m.tracking.station_uncertainty_mm.clear();
  if (const auto& covariance = d.setup.station.covariance_mm2) {
    const OffsetUncertainty offset = offset_uncertainty(*covariance, d.geometry.direction);
    m.tracking.station_uncertainty_mm = {offset.larger_mm, offset.smaller_mm};
  }
  return m;
}

std::vector<SourceRemark> line_remarks(const LineDescription& d) {
  std::vector<SourceRemark> remarks;
  const RangingUncertainty& ranging = d.setup.ranging;
  if (!device_given(d.given))
    remarks.push_back(
        {false,
         fmt::format("the calibration uncertainty of the device is that of the instrument of the plan, U = {} µm + "
                     "{} µm/m over the measured travel of {} mm: {} µm",
                     format_exact(ranging.constant.in_um()), format_exact(ranging.per_length.in_um_per_m()),
                     format_fixed(d.travel_mm, 1), format_fixed(ranging_um(d).in_native(), 2))});
  if (!is_aligned(d.setup) && !d.setup.station.covariance_mm2)
    remarks.push_back({false,
                       "nothing is known about the uncertainty of the station, so that the length difference "
                       "that it causes is not part of the uncertainty"});
  return remarks;
}

}  // namespace axiometry::tracking
