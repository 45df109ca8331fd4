// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/model/fields.h"
#include "axiometry/model/test.h"

/// Values of `# key: value` lines, so that what is written can be read again.
namespace axiometry::formats {

/// Puts the value of a line into the metadata. It is plain text as set_field_text() has it or, where that could not
/// hold it, JSON: a string in quotation marks, a record as an array. What is no JSON is plain text. Fails as
/// set_field_text() does.
Result<void> set_line_value(Metadata& metadata, const Field& field, std::string_view value);

/// The lines above the header of a CSV file: where the test comes from, as a comment, what its reader told of it, and
/// all its metadata.
std::string metadata_lines(const Test& test);

}  // namespace axiometry::formats
