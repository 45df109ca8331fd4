// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/test.h"

/// The member `source` of our own JSON: a converted file says where it comes from; so do the results of its evaluation.
namespace axiometry::formats {

/// What of it becomes remarks of the test read: where it was taken from first. Nothing of null. Fails, with its place,
/// on what lacks file, sha256 or format, and on members of other names or kinds.
Result<std::vector<SourceRemark>> source_from(const json::Value& source);

json::Value source_to_json(const Provenance& source);

}  // namespace axiometry::formats
