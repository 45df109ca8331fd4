// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/tracking_json.h"

#include "axiometry/app/files/source.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/station_bounds.h"

namespace axiometry::app {
namespace {

using formats::matrix_value;
using formats::vector_value;
using json::Value;
using tracking::LinearFit;
using tracking::RefinedFit;

Value list(std::span<const double> numbers) {
  Value array = Value::array();
  for (double x : numbers) array.push(x);
  return array;
}

Value linear_to_json(const LinearFit& fit) {
  const bool solved = fit.rank == 5;
  const auto or_null = [&](Value value) { return solved ? std::move(value) : Value(); };
  Value object = Value::object();
  object.add("station", or_null(vector_value(fit.station_mm)));
  object.add("L0", or_null(fit.L0_mm));
  object.add("psi", or_null(fit.psi_mm2));
  object.add("rank", fit.rank);
  object.add("numerical_rank", fit.numerical_rank);
  object.add("rank_tolerance", fit.rank_tolerance);
  object.add("condition", fit.condition);
  object.add("singular_values", list(fit.singular_values));
  object.add("covariance", or_null(matrix_value(fit.covariance_mm2)));
  object.add("residuals", or_null(list(fit.residuals_mm)));
  object.add("equation_residuals", or_null(list(fit.equation_residuals_mm2)));
  object.add("redundant_residual", or_null(fit.redundant_residual_mm2));
  object.add("misclosure", or_null(fit.misclosure_mm2));
  object.add("misclosure_u", or_null(fit.misclosure_u_mm2));
  return object;
}

Value refined_to_json(const RefinedFit& fit) {
  Value object = Value::object();
  object.add("station", vector_value(fit.station_mm));
  object.add("L0", fit.L0_mm);
  object.add("covariance", matrix_value(fit.covariance_mm2));
  object.add("covariance_stated", matrix_value(fit.covariance_stated_mm2));
  Matrix3 wide = fit.covariance_stated_mm2;
  for (auto& row : wide)
    for (double& x : row) x *= widening_for_bounds(fit.chi_squared, fit.degrees_of_freedom);
  object.add("covariance_for_bounds", matrix_value(wide));
  object.add("inflation", fit.inflation);
  object.add("L0_variance", fit.L0_variance_mm2);
  object.add("residuals", list(fit.residuals_mm));
  object.add("sigma", list(fit.sigma_mm));
  object.add("chi_squared", fit.chi_squared);
  object.add("degrees_of_freedom", fit.degrees_of_freedom);
  object.add("chance", fit.chance);
  object.add("condition", fit.condition);
  object.add("singular_values", list(fit.singular_values));
  object.add("iterations", fit.iterations);
  object.add("converged", fit.converged);
  return object;
}

Value units_to_json() {
  Value object = Value::object();
  object.add("lengths", "mm");
  object.add("covariance", "mm^2");
  object.add("psi", "mm^2");
  object.add("misclosure", "mm^2");
  object.add("equation_residuals", "mm^2");
  object.add("redundant_residual", "mm^2");
  return object;
}

Value options_to_json(const LocateRequest& request) {
  const tracking::StationOptions& options = request.options;
  Value object = Value::object();
  object.add("ranging_constant_um", options.ranging.constant.in_um());
  object.add("ranging_per_length_um_per_m", options.ranging.per_length.in_um_per_m());
  object.add("machine_sigma_um", options.machine_sigma_mm * 1000.0);
  object.add("near", options.near_mm ? vector_value(*options.near_mm) : Value());
  object.add("tool_offset", vector_value(request.tool_offset_mm));
  return object;
}

Value location_points_to_json(std::span<const LocationPoint> points) {
  Value array = Value::array();
  for (const LocationPoint& p : points) {
    Value& row = array.push(Value::object());
    row.add("at", vector_value(p.at_mm));
    row.add("length_difference", p.length_difference_mm);
  }
  return array;
}

}  // namespace

Value to_json(const Located& located) {
  const tracking::StationLocation& location = located.location;
  const RefinedFit& refined = location.refined;
  const bool both = location.has_linear();
  Value object = Value::object();
  object.add("result", "station-location");
  object.add("units", units_to_json());
  object.add("linear", location.linear ? linear_to_json(*location.linear) : Value());
  object.add("refined", refined_to_json(refined));
  object.add("difference", both ? vector_value(location.difference_mm) : Value());
  object.add("difference_u", both ? vector_value(location.difference_u_mm) : Value());
  object.add("misclosure", both ? Value(location.linear->misclosure_mm2) : Value());
  object.add("critical_surface", tracking::critical_surface_name(location.surface));
  object.add("eccentricity", location.eccentricity ? Value(*location.eccentricity) : Value());
  object.add("mirror", refined.mirror_mm ? vector_value(*refined.mirror_mm) : Value());
  object.add("findings", findings_value(location.findings));
  object.add("points", location_points_to_json(located.points));
  object.add("options", options_to_json(located.request));
  Value& source = object.add("source", Value::object());
  source.add("file", located.request.file);
  source.add("sha256", located.sha256);
  object.add("program", program_to_json());
  return object;
}

Value to_json(const PlannedLocation& planned) {
  const tracking::LocationQuality& quality = planned.plan.quality;
  Value object = Value::object();
  object.add("result", "location-points");
  Value& points = object.add("points", Value::array());
  for (Vector3 p : planned.plan.points_mm) {
    Value& row = points.push(Value::object());
    row.add("axes", vector_value(p - planned.setup.tool_offset_mm));
    row.add("reflector", vector_value(p));
  }
  Value& expected = object.add("expected", Value::object());
  expected.add("covariance_mm2", matrix_value(quality.covariance_mm2));
  expected.add("amplification", vector_value(quality.amplification));
  expected.add("condition_refined", quality.condition_refined);
  expected.add("condition_linear", quality.condition_linear);
  Value& remarks = object.add("remarks", Value::array());
  for (const std::string& remark : planned.plan.remarks) remarks.push(remark);
  object.add("program", program_to_json());
  return object;
}

}  // namespace axiometry::app
