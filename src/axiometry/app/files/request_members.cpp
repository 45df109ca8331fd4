// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/request_members.h"

#include <fmt/format.h>

#include <cmath>

namespace axiometry::app {

using formats::JsonMembers;
using json::Value;

Result<void> take_switch(JsonMembers& members, std::string_view name, bool& target) {
  const Value* value = members.optional(name);
  if (value == nullptr) return {};
  if (!value->is(json::Kind::boolean))
    return fail(fmt::format("{}: found {}, expected true or false", name, json::kind_name(value->kind())), value->at());
  target = value->boolean();
  return {};
}

Result<void> take_number(JsonMembers& members, std::string_view name, std::optional<double>& target) {
  const Value* value = members.optional(name);
  if (value == nullptr) return {};
  AXIOMETRY_TRY(target, formats::number_in(*value, name));
  return {};
}

Result<std::optional<double>> whole_member(JsonMembers& members, std::string_view name, WholeNumbers range) {
  std::optional<double> x;
  AXIOMETRY_TRY_VOID(take_number(members, name, x));
  if (!x || (*x >= range.least && *x <= range.most && *x == std::floor(*x))) return x;
  return fail(
      fmt::format("{}: found {}, expected a whole number from {:.0f} to {:.0f}", name, *x, range.least, range.most),
      members.optional(name)->at());
}

}  // namespace axiometry::app
