// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "axiometry/app/files/given_text.h"
#include "axiometry/formats/text/json_members.h"

/// Members of a request that people write for the archive: lines, texts, numbers of records.
namespace axiometry::app {

/// Nothing where it is not there. `given` is given_line or given_text; its failures get the member's place.
template <typename Given>
Result<void> take_given(formats::JsonMembers& members, std::string_view name, std::optional<std::string>& target,
                        const Given& given) {
  const json::Value* value = members.optional(name);
  if (value == nullptr) return {};
  AXIOMETRY_TRY(const std::string text, formats::text_in(*value, name));
  auto line = given(name, text);
  if (!line) return fail(line.error().message, value->at());
  target = *std::move(line);
  return {};
}

/// A number of a record, or null for none; nothing where it is not there. `object` is what `members` are of.
Result<void> take_id(formats::JsonMembers& members, const json::Value& object, std::string_view name,
                     std::optional<std::optional<std::int64_t>>& target);

/// Of JSON that was checked to be an object when it was kept; an empty one of anything else.
json::Value object_of_text(const std::string& text);

}  // namespace axiometry::app
