// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"

namespace axiometry::server {

/// One part of a form (RFC 7578); the bytes are those of the body.
struct FormPart {
  std::string name;
  std::string file_name;     ///< as sent: a name and nothing else
  bool is_file = false;      ///< whether there is a file name
  std::string content_type;  ///< empty when not given
  std::string_view bytes;
};

/// Whether a Content-Type is multipart/form-data.
bool is_form(std::string_view content_type);

/// The parts of a form in their order. Strict: fails on a missing or malformed boundary (RFC 2046, 5.1.1), on a body
/// that does not end with the last boundary, on anything between parts, on a part without a name, with a
/// Content-Transfer-Encoding or more than 4 KiB of header fields, and on more than 100 parts.
Result<std::vector<FormPart>> form_parts(std::string_view content_type, std::string_view body);

/// The value of a parameter of a header field: `filename="a.csv"`, quoted or not; an extended one (filename*=UTF-8''…,
/// RFC 8187) has precedence. Nothing when there is none or it is malformed.
std::string header_parameter(std::string_view field, std::string_view name);
bool has_header_parameter(std::string_view field, std::string_view name);

}  // namespace axiometry::server
