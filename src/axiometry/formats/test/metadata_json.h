// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/model/fields.h"
#include "axiometry/model/metadata.h"

/// The metadata of a test as members of a JSON object: a field's key is its path ("machine.name"), so
/// that the table of fields is the only list of names.
namespace axiometry::formats {

/// Adds a member for every group that has something given.
void add_metadata(json::Value& object, const Metadata& metadata);

/// Takes every member of `object` but those named in `others`. Fails, with the place, on unknown names
/// (the message says the nearest one) and on values that the field does not allow. null is "not given".
Result<Metadata> metadata_from(const json::Value& object, std::span<const std::string_view> others);

}  // namespace axiometry::formats
