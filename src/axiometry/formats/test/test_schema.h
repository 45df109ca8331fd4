// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/base/json/json.h"

namespace axiometry::formats {

/// Value of the member "format" in a test file; the number changes when old files no longer read.
inline constexpr std::string_view test_format_name = "axiometry-test/1";

/// JSON Schema (draft 2020-12) of the test format, made from the table of metadata fields and that of
/// units. schema/axiometry-test.schema.json is this text.
std::string test_schema();

/// An object of these members, in this order.
json::Value object(std::initializer_list<std::pair<std::string_view, json::Value>> members);

/// The kinds that an item may have which may also be null.
json::Value or_null(std::string_view type);

/// JSON Schema of a text that may be null.
json::Value text_schema(std::string_view description);

/// JSON Schema of one group of metadata, "axis", as an object that has no other members.
json::Value metadata_group_schema(std::string_view group);

}  // namespace axiometry::formats
