// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json.h"
#include "axiometry/language/language.h"

namespace axiometry::server {

/// What there is to choose from: parameters, fields of the metadata, formats, writers, dialects, corrections, cycles
/// and rules of decision, each from the table that the rest of the program reads. Titles and descriptions in that
/// language.
json::Value vocabulary(language::Language language);

}  // namespace axiometry::server
