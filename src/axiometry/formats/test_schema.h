// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/json.h"

namespace axiometry::formats {

/// Value of the member "format" in a test file; the number changes when old files no longer read.
inline constexpr std::string_view test_format_name = "axiometry-test/1";

/// JSON Schema (draft 2020-12) of the test format, made from the table of metadata fields and that of
/// units. schema/axiometry-test.schema.json is this text.
std::string test_schema();

/// JSON Schema of one group of metadata, "axis", as an object that has no other members.
json::Value metadata_group_schema(std::string_view group);

}  // namespace axiometry::formats
