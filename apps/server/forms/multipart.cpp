// SPDX-License-Identifier: Apache-2.0
#include "server/forms/multipart.h"

#include <algorithm>
#include <optional>

#include "axiometry/base/text/text.h"
#include "server/http/target.h"

namespace axiometry::server {
namespace {

constexpr std::size_t parts_max = 100;
constexpr std::size_t head_max = 4096;
constexpr std::size_t boundary_max = 70;

/// The field cut at semicolons that stand outside quotation marks.
std::vector<std::string_view> fields_of(std::string_view field) {
  std::vector<std::string_view> parts;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < field.size(); ++k) {
    if (field[k] == '\\' && quoted) {
      ++k;
    } else if (field[k] == '"') {
      quoted = !quoted;
    } else if (field[k] == ';' && !quoted) {
      parts.push_back(field.substr(begin, k - begin));
      begin = k + 1;
    }
  }
  parts.push_back(field.substr(begin));
  return parts;
}

/// Without quotation marks. Browsers send " as %22 and leave backslashes alone (WHATWG): only \" is an escape.
std::optional<std::string> unquoted(std::string_view value) {
  if (!value.starts_with('"')) return std::string(value);
  if (value.size() < 2 || !value.ends_with('"')) return {};
  std::string text;
  const std::string_view inner = value.substr(1, value.size() - 2);
  for (std::size_t k = 0; k < inner.size(); ++k) {
    if (inner[k] == '"') return {};
    if (inner[k] == '\\' && k + 1 < inner.size() && inner[k + 1] == '"') ++k;
    text += inner[k];
  }
  return text;
}

std::optional<std::string> parameter(std::string_view field, std::string_view name) {
  const auto parts = fields_of(field);
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const std::size_t equals = parts[k].find('=');
    if (equals == std::string_view::npos) continue;
    if (text::equal_ignoring_case(text::trim(parts[k].substr(0, equals)), name))
      return unquoted(text::trim(parts[k].substr(equals + 1)));
  }
  return {};
}

Result<std::string> boundary_of(std::string_view content_type) {
  const auto boundary = parameter(content_type, "boundary");
  const bool sound = boundary && !boundary->empty() && boundary->size() <= boundary_max && !boundary->ends_with(' ') &&
                     std::ranges::all_of(*boundary, [](char c) {
                       return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                              std::string_view("'()+_,-./:=? ").contains(c);
                     });
  if (!sound) return fail("found a form without a sound boundary, expected multipart/form-data; boundary=…");
  return *boundary;
}

Result<void> read_part_head(std::string_view head, FormPart& part) {
  while (!head.empty()) {
    const std::size_t end = std::min(head.find("\r\n"), head.size());
    const std::string_view line = head.substr(0, end);
    head.remove_prefix(std::min(end + 2, head.size()));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || colon == 0)
      return fail("found " + text::quoted(line) + " at the head of a part of the form, expected a header field");
    const std::string_view name = line.substr(0, colon);
    const std::string_view value = text::trim(line.substr(colon + 1));
    if (text::equal_ignoring_case(name, "content-disposition")) {
      if (!text::equal_ignoring_case(text::trim(fields_of(value).front()), "form-data"))
        return fail("found a part of the form that is no form-data");
      part.name = header_parameter(value, "name");
      part.is_file = has_header_parameter(value, "filename");
      part.file_name = header_parameter(value, "filename");
    } else if (text::equal_ignoring_case(name, "content-type")) {
      part.content_type = value;
    } else if (text::equal_ignoring_case(name, "content-transfer-encoding") &&
               !text::equal_ignoring_case(value, "binary")) {
      return fail("found a part of the form with a transfer encoding, expected its bytes as they are (RFC 7578, 4.7)");
    }
  }
  if (part.name.empty() && !part.is_file) return fail("found a part of the form without a name");
  return {};
}

}  // namespace

bool is_form(std::string_view content_type) {
  return text::equal_ignoring_case(text::trim(fields_of(content_type).front()), "multipart/form-data");
}

std::string header_parameter(std::string_view field, std::string_view name) {
  if (const auto extended = parameter(field, std::string(name) + "*")) {
    constexpr std::string_view charset = "utf-8''";
    if (text::to_lower(extended->substr(0, charset.size())) == charset)
      if (auto decoded = percent_decoded(std::string_view(*extended).substr(charset.size()))) return *decoded;
  }
  return parameter(field, name).value_or("");
}

bool has_header_parameter(std::string_view field, std::string_view name) {
  return parameter(field, name) || parameter(field, std::string(name) + "*");
}

Result<std::vector<FormPart>> form_parts(std::string_view content_type, std::string_view body) {
  AXIOMETRY_TRY(const std::string boundary, boundary_of(content_type));
  const std::string first = "--" + boundary;
  const std::string delimiter = "\r\n" + first;
  if (!body.starts_with(first)) return fail("found a form that does not begin with its boundary");
  body.remove_prefix(first.size());
  std::vector<FormPart> parts;
  while (true) {
    if (body == "--" || body == "--\r\n") return parts;
    if (!body.starts_with("\r\n")) return fail("found a form with something behind a boundary, expected a line break");
    body.remove_prefix(2);
    if (parts.size() == parts_max) return fail("found a form of more than 100 parts, expected at most 100");
    const bool no_head = body.starts_with("\r\n");
    const std::size_t head_end = no_head ? 0 : body.substr(0, head_max).find("\r\n\r\n");
    if (head_end == std::string_view::npos) return fail("found a part of the form without an end of its head");
    FormPart part;
    AXIOMETRY_TRY_VOID(read_part_head(body.substr(0, head_end), part));
    body.remove_prefix(head_end + (no_head ? 2 : 4));
    // An empty part ends at once: its line break is that of its head.
    const std::size_t end = body.find(delimiter);
    if (end == std::string_view::npos) return fail("found a form without its last boundary: it was cut off");
    part.bytes = body.substr(0, end);
    body.remove_prefix(end + delimiter.size());
    parts.push_back(std::move(part));
  }
}

}  // namespace axiometry::server
