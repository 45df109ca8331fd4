// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json_place.h"
#include "axiometry/model/metadata.h"

namespace axiometry::formats {

/// add_metadata() of metadata_json.h without a tree.
void add_metadata(json::Object& object, const Metadata& metadata);

}  // namespace axiometry::formats
