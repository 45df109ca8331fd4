// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/given_members.h"

#include <utility>

namespace axiometry::app {

using json::Value;

Result<void> take_id(formats::JsonMembers& members, const Value& object, std::string_view name,
                     std::optional<std::optional<std::int64_t>>& target) {
  const Value* value = members.optional(name);
  if (value == nullptr) {
    if (object.find(name) != nullptr) target.emplace(std::nullopt);
    return {};
  }
  AXIOMETRY_TRY(const std::int64_t id, given_number(name, *value));
  target.emplace(id);
  return {};
}

Value object_of_text(const std::string& text) {
  auto object = json::parse(text);
  return object && object->is(json::Kind::object) ? *std::move(object) : Value::object();
}

}  // namespace axiometry::app
