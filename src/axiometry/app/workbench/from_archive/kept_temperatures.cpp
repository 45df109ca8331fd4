// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/from_archive/kept_temperatures.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/surroundings.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;

constexpr std::size_t most_roles = 64;  // sensors of a log

Result<void> take_limit(JsonMembers& members, std::string_view name, double least, std::optional<double>& limit) {
  const Value* member = members.optional(name);
  if (member == nullptr) return {};
  AXIOMETRY_TRY(const double x, formats::number_in(*member, name));
  if (x < least || x > hottest_hall_C)
    return fail(fmt::format("found {} = {}, expected a number from {} to {}", name, format_exact(x),
                            format_exact(least), format_exact(hottest_hall_C)),
                member->at());
  limit = x;
  return {};
}

Result<void> take_line(JsonMembers& members, std::string_view name, std::string& text) {
  const Value* member = members.optional(name);
  if (member == nullptr) return {};
  AXIOMETRY_TRY(const std::string raw, formats::text_in(*member, name));
  auto line = given_line(name, raw);
  if (!line) return fail(line.error().message, member->at());
  text = *std::move(line);
  return {};
}

Result<void> take_roles(JsonMembers& members, formats::SensorRoles& roles) {
  const Value* list = members.optional("sensors");
  if (list == nullptr) return {};
  AXIOMETRY_TRY(const auto* items, formats::items_in(*list, "sensors"));
  if (items->size() > most_roles)
    return fail(fmt::format("found {} sensors, expected at most {}", items->size(), most_roles), list->at());
  for (const Value& item : *items) {
    AXIOMETRY_TRY(JsonMembers sensor, JsonMembers::of(item, "a sensor"));
    std::pair<std::string, std::string> role;
    AXIOMETRY_TRY_VOID(take_line(sensor, "name", role.first));
    AXIOMETRY_TRY_VOID(take_line(sensor, "role", role.second));
    AXIOMETRY_TRY_VOID(sensor.finish());
    if (role.second != "machine" && role.second != "equipment" && role.second != "air" && role.second != "none")
      return fail(fmt::format("found the role {} of a sensor, expected machine, equipment, air or none",
                              text::quoted(role.second)),
                  item.at());
    roles.push_back(std::move(role));
  }
  return {};
}

bool is_hash(std::string_view text) {
  constexpr std::size_t digits = 64;
  return text.size() == digits && text.find_first_not_of("0123456789abcdef") == text.npos;
}

}  // namespace

json::Value to_json(const KeptTemperatures& kept) {
  Value object = Value::object();
  object.add("sha256", kept.sha256);
  object.add("name", kept.name);
  if (!kept.began.empty()) object.add("began", kept.began);
  if (!kept.ended.empty()) object.add("ended", kept.ended);
  if (!kept.roles.empty()) {
    Value& sensors = object.add("sensors", Value::array());
    for (const auto& [name, role] : kept.roles) {
      Value& sensor = sensors.push(Value::object());
      sensor.add("name", name);
      sensor.add("role", role);
    }
  }
  if (kept.lowest_C) object.add("lowest_C", *kept.lowest_C);
  if (kept.highest_C) object.add("highest_C", *kept.highest_C);
  if (kept.rate_C_per_h) object.add("rate_C_per_h", *kept.rate_C_per_h);
  if (kept.gradient_C) object.add("gradient_C", *kept.gradient_C);
  return object;
}

Result<KeptTemperatures> kept_temperatures_from(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "temperatures"));
  KeptTemperatures kept;
  AXIOMETRY_TRY_VOID(take_line(members, "sha256", kept.sha256));
  AXIOMETRY_TRY_VOID(take_line(members, "name", kept.name));
  AXIOMETRY_TRY_VOID(take_line(members, "began", kept.began));
  AXIOMETRY_TRY_VOID(take_line(members, "ended", kept.ended));
  AXIOMETRY_TRY_VOID(take_roles(members, kept.roles));
  AXIOMETRY_TRY_VOID(take_limit(members, "lowest_C", coldest_hall_C, kept.lowest_C));
  AXIOMETRY_TRY_VOID(take_limit(members, "highest_C", coldest_hall_C, kept.highest_C));
  AXIOMETRY_TRY_VOID(take_limit(members, "rate_C_per_h", 0.0, kept.rate_C_per_h));
  AXIOMETRY_TRY_VOID(take_limit(members, "gradient_C", 0.0, kept.gradient_C));
  AXIOMETRY_TRY_VOID(members.finish());
  if (!is_hash(kept.sha256))
    return fail(fmt::format("found {} as the SHA-256 of a temperature log, expected 64 hexadecimal digits",
                            text::quoted(kept.sha256)),
                value.at());
  return kept;
}

LogWithTest log_with_test(const KeptTemperatures& kept, std::string bytes) {
  LogWithTest log{kept.name, std::move(bytes), {kept.began, kept.ended, kept.roles, {}}};
  auto& agreed = log.request.agreed;
  if (kept.lowest_C) agreed.lowest = Temperature::celsius(*kept.lowest_C);
  if (kept.highest_C) agreed.highest = Temperature::celsius(*kept.highest_C);
  agreed.rate = kept.rate_C_per_h;
  if (kept.gradient_C) agreed.machine_gradient = TemperatureDifference::kelvin(*kept.gradient_C);
  return log;
}

}  // namespace axiometry::app
