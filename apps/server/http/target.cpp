// SPDX-License-Identifier: Apache-2.0
#include "server/http/target.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "axiometry/base/text/text.h"

namespace axiometry::server {
namespace {

std::optional<unsigned> hexadecimal_digit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return {};
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

Result<std::string> path_segment(std::string_view raw) {
  AXIOMETRY_TRY(std::string segment, percent_decoded(raw));
  if (segment == "." || segment == ".." || segment.contains('\\') || segment.contains('/'))
    return fail(fmt::format("found {} in the path, expected a name", text::quoted(segment)));
  return segment;
}

Result<std::string> path_of(std::string_view raw) {
  if (!raw.starts_with('/'))
    return fail(fmt::format("found the request target {}, expected a path that begins with /", text::quoted(raw)));
  std::string path;
  const auto segments = text::split(raw.substr(1), '/');
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].empty() && i + 1 < segments.size()) return fail("found // in the path, expected a name between");
    AXIOMETRY_TRY(const std::string segment, path_segment(segments[i]));
    path += "/" + segment;
  }
  return path;
}

Result<std::string> query_text(std::string_view raw) {
  std::string with_blanks(raw);
  std::ranges::replace(with_blanks, '+', ' ');
  return percent_decoded(with_blanks);
}

}  // namespace

Result<std::string> percent_decoded(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      decoded += text[i];
      continue;
    }
    const auto high = i + 2 < text.size() ? hexadecimal_digit(text[i + 1]) : std::nullopt;
    const auto low = high ? hexadecimal_digit(text[i + 2]) : std::nullopt;
    if (!low)
      return fail(fmt::format("found {}, expected two hexadecimal digits after %", text::quoted(text.substr(i, 3))));
    decoded += static_cast<char>(*high * 16 + *low);
    i += 2;
  }
  if (std::ranges::any_of(decoded, is_control))
    return fail(fmt::format("found a control character in {}, expected none", text::quoted(decoded)));
  if (text::invalid_utf8(decoded)) return fail(fmt::format("found {}, expected UTF-8", text::quoted(decoded)));
  return decoded;
}

Result<Target> parse_target(std::string_view raw) {
  if (std::ranges::any_of(raw, [](char c) { return c <= ' ' || c >= 0x7F || c == '#'; }))
    return fail(fmt::format("found the request target {}, expected percent-encoding", text::quoted(raw)));
  const std::size_t mark = std::min(raw.find('?'), raw.size());
  Target target;
  AXIOMETRY_TRY(target.path, path_of(raw.substr(0, mark)));
  if (mark == raw.size()) return target;
  for (const std::string_view part : text::split(raw.substr(mark + 1), '&')) {
    if (part.empty()) continue;
    const std::size_t equals = std::min(part.find('='), part.size());
    AXIOMETRY_TRY(std::string name, query_text(part.substr(0, equals)));
    AXIOMETRY_TRY(std::string value, query_text(part.substr(std::min(equals + 1, part.size()))));
    target.query.emplace_back(std::move(name), std::move(value));
  }
  return target;
}

}  // namespace axiometry::server
