// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/machine_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;
using volumetric::KinematicChain;
using volumetric::MachineModel;

constexpr double travel_least_mm = 1.0;
constexpr std::size_t names_most = 256;  // most tools, and most stations

Result<void> check_near(Vector3 at, const Value& value) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(at[k]) > largest_stated)
      return fail(fmt::format("found the coordinate {}, expected at most 1e9 mm", format_exact(at[k])), value.at());
  return {};
}

Result<TravelBox> travel_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "travel_mm"));
  TravelBox travel;
  for (std::size_t a = 0; a < 3; ++a) {
    AXIOMETRY_TRY(const Value* range, members.required(linear_axis_names[a]));
    AXIOMETRY_TRY(const std::vector<Value>* ends, items_in(*range, linear_axis_names[a]));
    if (ends->size() != 2)
      return fail(fmt::format("found {} for the travel of {}, expected its two ends", counted(ends->size(), "number"),
                              linear_axis_names[a]),
                  range->at());
    AXIOMETRY_TRY(travel.lowest_mm[a], number_in(ends->front(), linear_axis_names[a]));
    AXIOMETRY_TRY(travel.highest_mm[a], number_in(ends->back(), linear_axis_names[a]));
    if (!(travel.highest_mm[a] - travel.lowest_mm[a] >= travel_least_mm) ||
        std::abs(travel.lowest_mm[a]) > largest_stated || std::abs(travel.highest_mm[a]) > largest_stated)
      return fail(
          fmt::format(
              "found a travel of {} from {} to {} mm, expected its lower end first, 1 mm at least, within 1e9 mm",
              linear_axis_names[a], format_exact(travel.lowest_mm[a]), format_exact(travel.highest_mm[a])),
          range->at());
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return travel;
}

/// Name and place, in the order of the file.
Result<std::vector<std::pair<std::string, Vector3>>> places_from(const Value& value, std::string_view what) {
  if (!value.is(Kind::object))
    return fail(
        fmt::format("found {} for {}, expected an object of names with [x, y, z]", json::kind_name(value.kind()), what),
        value.at());
  if (value.members().size() > names_most)
    return fail(fmt::format("found {} members of {}, expected at most {}", value.members().size(), what, names_most),
                value.at());
  std::vector<std::pair<std::string, Vector3>> places;
  for (const auto& [name, member] : value.members()) {
    AXIOMETRY_TRY(const Vector3 at, vector_in(member, name));
    AXIOMETRY_TRY_VOID(check_near(at, member));
    if (name.empty()) return fail(fmt::format("found an empty name in {}, expected one", what), member.at());
    places.emplace_back(name, at);
  }
  return places;
}

Result<double> uncertainty_in(JsonMembers& members, std::string_view name, double usual, const Value& at) {
  double value = usual;
  AXIOMETRY_TRY_VOID(members.take(name, value));
  if (value >= 0.0 && value <= 1e4) return value;
  return fail(fmt::format("found {} of {}, expected 0 to 10000", name, format_exact(value)), at.at());
}

Result<void> take_instrument(const Value& value, MachineModel& machine) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "instrument"));
  AXIOMETRY_TRY(const double a, uncertainty_in(members, "a_um", machine.ranging.constant.in_um(), value));
  AXIOMETRY_TRY(const double b, uncertainty_in(members, "b_um_per_m", machine.ranging.per_length.in_um_per_m(), value));
  machine.ranging = {Length::um(a), RelativeLength::um_per_m(b)};
  if (const Value* scale = members.optional("scale_u_um_per_m")) {
    AXIOMETRY_TRY(const double u, number_in(*scale, "scale_u_um_per_m"));
    if (!(u >= 0.0 && u <= 1e6))
      return fail(fmt::format("found scale_u_um_per_m of {}, expected 0 or more", format_exact(u)), scale->at());
    machine.scale_uncertainty = RelativeLength::um_per_m(u);
  }
  return members.finish();
}

Result<void> take_functional_points(const Value& value, MachineModel& machine) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "functional_point_mm"));
  for (std::size_t a = 0; a < 3; ++a) {
    AXIOMETRY_TRY_VOID(members.take(linear_axis_names[a], machine.functional_point_mm[a]));
    AXIOMETRY_TRY_VOID(check_near(machine.functional_point_mm[a], value));
  }
  return members.finish();
}

}  // namespace

Result<MachineFile> read_machine(std::string_view bytes) {
  AXIOMETRY_TRY(const Value root, json::parse(bytes));
  return machine_from(root);
}

Result<MachineFile> machine_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "machine"));
  AXIOMETRY_TRY(const Value* chain_value, members.required("chain"));
  AXIOMETRY_TRY(const std::string chain_text, text_in(*chain_value, "chain"));
  auto chain = KinematicChain::make(chain_text);
  if (!chain) return fail(chain.error().message, chain_value->at());
  AXIOMETRY_TRY(const Value* travel, members.required("travel_mm"));
  MachineModel machine{.chain = *chain};
  AXIOMETRY_TRY(machine.travel, travel_from(*travel));
  AXIOMETRY_TRY_VOID(members.take("name", machine.name));
  members.pass_over("$schema");
  AXIOMETRY_TRY(const Value* tools, members.required("tools_mm"));
  AXIOMETRY_TRY(const auto tool_places, places_from(*tools, "tools_mm"));
  if (tool_places.empty()) return fail("found no tool, expected at least one, as {\"T1\": [0, 0, -150]}", tools->at());
  for (const auto& [name, offset] : tool_places) machine.tools.push_back({name, offset});
  if (const Value* stations = members.optional("stations_mm")) {
    AXIOMETRY_TRY(const auto places, places_from(*stations, "stations_mm"));
    for (const auto& [name, at] : places) machine.stations.push_back({name, at});
  }
  if (const Value* instrument = members.optional("instrument"))
    AXIOMETRY_TRY_VOID(take_instrument(*instrument, machine));
  AXIOMETRY_TRY(const double repeatability, uncertainty_in(members, "repeatability_um", 0.0, value));
  machine.repeatability = Length::um(repeatability);
  constexpr double sigma_least_um = 1e-6;
  if (!(machine.sigma_um(1000.0) >= sigma_least_um))
    return fail("found instrument and machine without any uncertainty, expected one of at least 1e-6 µm to weigh by",
                value.at());
  if (const Value* points = members.optional("functional_point_mm"))
    AXIOMETRY_TRY_VOID(take_functional_points(*points, machine));
  AXIOMETRY_TRY(const std::vector<std::string> others, members.others());
  MachineFile file{std::move(machine)};
  if (!others.empty())
    file.remarks.push_back(fmt::format("passed over the member{} {} of the machine's file",
                                       others.size() == 1 ? "" : "s", fmt::join(others, ", ")));
  return file;
}

Value machine_value(const MachineModel& machine) {
  Value value = Value::object();
  if (!machine.name.empty()) value.add("name", machine.name);
  value.add("chain", machine.chain.text());
  Value& travel = value.add("travel_mm", Value::object());
  for (std::size_t a = 0; a < 3; ++a)
    travel.add(linear_axis_names[a], Value::array({machine.travel.lowest_mm[a], machine.travel.highest_mm[a]}));
  Value& tools = value.add("tools_mm", Value::object());
  for (const volumetric::Tool& tool : machine.tools) tools.add(tool.name, vector_value(tool.offset_mm));
  if (!machine.stations.empty()) {
    Value& stations = value.add("stations_mm", Value::object());
    for (const volumetric::NamedStation& station : machine.stations)
      stations.add(station.name, vector_value(station.at_mm));
  }
  Value& instrument = value.add("instrument", Value::object());
  instrument.add("a_um", machine.ranging.constant.in_um());
  instrument.add("b_um_per_m", machine.ranging.per_length.in_um_per_m());
  if (machine.scale_uncertainty) instrument.add("scale_u_um_per_m", machine.scale_uncertainty->in_um_per_m());
  value.add("repeatability_um", machine.repeatability.in_um());
  const bool has_points =
      std::ranges::any_of(machine.functional_point_mm, [](const Vector3& c) { return !(c == Vector3{}); });
  if (has_points) {
    Value& points = value.add("functional_point_mm", Value::object());
    for (std::size_t a = 0; a < 3; ++a) points.add(linear_axis_names[a], vector_value(machine.functional_point_mm[a]));
  }
  return value;
}

}  // namespace axiometry::formats
