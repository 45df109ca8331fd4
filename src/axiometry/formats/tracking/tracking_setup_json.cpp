// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/aligned.h"

namespace axiometry::formats {
namespace {

using json::Value;

Result<void> check_size(double x, std::string_view what, const Value& at) {
  if (x > 0.0 && x <= largest_stated) return {};
  return fail(fmt::format("found {} of {}, expected one above 0 and up to 1e9", what, format_exact(x)), at.at());
}

Result<void> check_order(Vector3 lowest, Vector3 highest, std::string_view what, const Value& at) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(lowest[k] <= highest[k]) || std::abs(lowest[k]) > largest_stated || std::abs(highest[k]) > largest_stated)
      return fail(fmt::format("found {} from {} to {} mm in {}, expected it to grow and to stay within 1e9", what,
                              format_exact(lowest[k]), format_exact(highest[k]), "XYZ"[k]),
                  at.at());
  return {};
}

Result<Vector3> required_vector(JsonMembers& members, std::string_view name) {
  AXIOMETRY_TRY(const Value* value, members.required(name));
  return vector_in(*value, name);
}

/// "lowest_mm" and "highest_mm".
Result<TravelBox> box_from(const Value& value, std::string_view what) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, std::string(what)));
  TravelBox box;
  AXIOMETRY_TRY(box.lowest_mm, required_vector(members, "lowest_mm"));
  AXIOMETRY_TRY(box.highest_mm, required_vector(members, "highest_mm"));
  AXIOMETRY_TRY_VOID(members.finish());
  AXIOMETRY_TRY_VOID(check_order(box.lowest_mm, box.highest_mm, what, value));
  return box;
}

Result<Station> station_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "station"));
  Station station;
  AXIOMETRY_TRY(station.position_mm, required_vector(members, "position_mm"));
  if (const Value* covariance = members.optional("covariance_mm2")) {
    AXIOMETRY_TRY(station.covariance_mm2, covariance_in(*covariance, "covariance_mm2"));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  if (norm(station.position_mm) > largest_stated)
    return fail("found a station farther than 1e9 mm, expected one at the machine", value.at());
  return station;
}

Result<TrackerLimits> limits_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "limits"));
  TrackerLimits limits;
  for (const auto& [name, member] :
       {std::pair{"range_least_mm", &limits.range_least_mm}, std::pair{"range_most_mm", &limits.range_most_mm},
        std::pair{"elevation_lowest_deg", &limits.elevation_lowest_deg},
        std::pair{"elevation_highest_deg", &limits.elevation_highest_deg},
        std::pair{"incidence_most_deg", &limits.incidence_most_deg},
        std::pair{"safe_radius_mm", &limits.safe_radius_mm}, std::pair{"line_least_mm", &limits.line_least_mm}})
    AXIOMETRY_TRY_VOID(members.take(name, *member));
  AXIOMETRY_TRY_VOID(members.take("reflector_axis", limits.reflector_axis));
  AXIOMETRY_TRY_VOID(members.finish());
  const auto ordered = [&](double least, double most, double lowest, double highest) {
    return least >= lowest && least < most && most <= highest;
  };
  if (!ordered(limits.range_least_mm, limits.range_most_mm, 0.0, largest_stated))
    return fail(fmt::format("found a range of {} to {} mm, expected it to grow from 0 or more",
                            format_exact(limits.range_least_mm), format_exact(limits.range_most_mm)),
                value.at());
  if (!ordered(limits.elevation_lowest_deg, limits.elevation_highest_deg, -90.0, 90.0))
    return fail(fmt::format("found elevations of {}° to {}°, expected them to grow within ±90°",
                            format_exact(limits.elevation_lowest_deg), format_exact(limits.elevation_highest_deg)),
                value.at());
  if (!(limits.incidence_most_deg > 0.0 && limits.incidence_most_deg <= 180.0))
    return fail(fmt::format("found an incidence of at most {}°, expected one above 0 and up to 180°",
                            format_exact(limits.incidence_most_deg)),
                value.at());
  if (!(limits.safe_radius_mm >= 0.0 && limits.line_least_mm >= 0.0 && norm(limits.reflector_axis) > 1e-6 &&
        norm(limits.reflector_axis) < 1e6))
    return fail("found a safe radius or a least length below 0, or a reflector without an axis, expected none of these",
                value.at());
  return limits;
}

Result<SphereObstacle> sphere_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "sphere"));
  SphereObstacle sphere;
  AXIOMETRY_TRY(sphere.centre_mm, required_vector(members, "centre_mm"));
  AXIOMETRY_TRY_VOID(members.take("radius_mm", sphere.radius_mm));
  AXIOMETRY_TRY_VOID(members.finish());
  AXIOMETRY_TRY_VOID(check_size(sphere.radius_mm, "a radius", value));
  return sphere;
}

Result<CylinderObstacle> cylinder_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "cylinder"));
  CylinderObstacle cylinder;
  AXIOMETRY_TRY(cylinder.base_mm, required_vector(members, "base_mm"));
  AXIOMETRY_TRY_VOID(members.take("radius_mm", cylinder.radius_mm));
  AXIOMETRY_TRY_VOID(members.take("height_mm", cylinder.height_mm));
  AXIOMETRY_TRY_VOID(members.finish());
  AXIOMETRY_TRY_VOID(check_size(cylinder.radius_mm, "a radius", value));
  AXIOMETRY_TRY_VOID(check_size(cylinder.height_mm, "a height", value));
  return cylinder;
}

Result<Obstacle> obstacle_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "obstacle"));
  Obstacle obstacle;
  AXIOMETRY_TRY_VOID(members.take("name", obstacle.name));
  const Value *box = members.optional("box"), *sphere = members.optional("sphere"),
              *cylinder = members.optional("cylinder");
  AXIOMETRY_TRY_VOID(members.finish());
  if ((box != nullptr) + (sphere != nullptr) + (cylinder != nullptr) != 1)
    return fail("found an obstacle without exactly one shape, expected a box, a sphere or a cylinder", value.at());
  if (box != nullptr) {
    AXIOMETRY_TRY(const TravelBox corners, box_from(*box, "box"));
    obstacle.shape = BoxObstacle{corners.lowest_mm, corners.highest_mm};
  } else if (sphere != nullptr) {
    AXIOMETRY_TRY(obstacle.shape, sphere_from(*sphere));
  } else {
    AXIOMETRY_TRY(obstacle.shape, cylinder_from(*cylinder));
  }
  return obstacle;
}

Value shape_value(const BoxObstacle& box) {
  return object({{"lowest_mm", vector_value(box.lowest_mm)}, {"highest_mm", vector_value(box.highest_mm)}});
}
Value shape_value(const SphereObstacle& sphere) {
  return object({{"centre_mm", vector_value(sphere.centre_mm)}, {"radius_mm", sphere.radius_mm}});
}
Value shape_value(const CylinderObstacle& cylinder) {
  return object({{"base_mm", vector_value(cylinder.base_mm)},
                 {"radius_mm", cylinder.radius_mm},
                 {"height_mm", cylinder.height_mm}});
}

Value obstacle_value(const Obstacle& obstacle) {
  constexpr std::array<std::string_view, 3> shapes = {"box", "sphere", "cylinder"};  // in the order of the variant
  Value value = Value::object();
  if (!obstacle.name.empty()) value.add("name", obstacle.name);
  value.add(shapes[obstacle.shape.index()],
            std::visit([](const auto& shape) { return shape_value(shape); }, obstacle.shape));
  return value;
}

Value limits_value(const TrackerLimits& limits) {
  return object({{"range_least_mm", limits.range_least_mm},
                 {"range_most_mm", limits.range_most_mm},
                 {"elevation_lowest_deg", limits.elevation_lowest_deg},
                 {"elevation_highest_deg", limits.elevation_highest_deg},
                 {"reflector_axis", vector_value(limits.reflector_axis)},
                 {"incidence_most_deg", limits.incidence_most_deg},
                 {"safe_radius_mm", limits.safe_radius_mm},
                 {"line_least_mm", limits.line_least_mm}});
}

}  // namespace

Result<RangingUncertainty> ranging_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "ranging"));
  RangingUncertainty ranging;
  double constant = ranging.constant.in_um(), per_length = ranging.per_length.in_um_per_m();
  AXIOMETRY_TRY_VOID(members.take("constant_um", constant));
  AXIOMETRY_TRY_VOID(members.take("per_length_um_per_m", per_length));
  AXIOMETRY_TRY_VOID(members.finish());
  constexpr double least = 1e-6, most = 1e6;
  if (!(constant >= 0.0 && per_length >= 0.0 && constant + per_length >= least && constant + per_length <= most))
    return fail(fmt::format("found an uncertainty of lengths of {} µm + {} µm/m, expected one above 0",
                            format_exact(constant), format_exact(per_length)),
                value.at());
  return RangingUncertainty{Length::um(constant), RelativeLength::um_per_m(per_length)};
}

Result<TrackingSetup> tracking_setup_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "setup"));
  TrackingSetup setup;
  AXIOMETRY_TRY(const Value* travel, members.required("travel"));
  AXIOMETRY_TRY(setup.travel, box_from(*travel, "travel"));
  AXIOMETRY_TRY_VOID(members.take("tool_offset_mm", setup.tool_offset_mm));
  setup.station = no_station();
  if (const Value* station = members.optional("station")) {
    AXIOMETRY_TRY(setup.station, station_from(*station));
  }
  if (const Value* limits = members.optional("limits")) {
    AXIOMETRY_TRY(setup.limits, limits_from(*limits));
  }
  if (const Value* ranging = members.optional("ranging")) {
    AXIOMETRY_TRY(setup.ranging, ranging_from(*ranging));
  }
  if (const Value* list = members.optional("obstacles")) {
    AXIOMETRY_TRY(const auto* items, items_in(*list, "obstacles"));
    for (const Value& item : *items) {
      AXIOMETRY_TRY(setup.obstacles.emplace_back(), obstacle_from(item));
    }
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return setup;
}

Value tracking_setup_value(const TrackingSetup& setup) {
  Value whole = object({{"travel", shape_value(BoxObstacle{setup.travel.lowest_mm, setup.travel.highest_mm})},
                        {"tool_offset_mm", vector_value(setup.tool_offset_mm)}});
  Value station = object({{"position_mm", vector_value(setup.station.position_mm)}});
  if (setup.station.covariance_mm2) station.add("covariance_mm2", matrix_value(*setup.station.covariance_mm2));
  Value obstacles = Value::array();
  for (const Obstacle& obstacle : setup.obstacles) obstacles.push(obstacle_value(obstacle));
  if (!is_aligned(setup)) {
    whole.add("station", std::move(station));
    whole.add("limits", limits_value(setup.limits));
  }
  whole.add("ranging", object({{"constant_um", setup.ranging.constant.in_um()},
                               {"per_length_um_per_m", setup.ranging.per_length.in_um_per_m()}}));
  whole.add("obstacles", std::move(obstacles));
  return whole;
}

}  // namespace axiometry::formats
