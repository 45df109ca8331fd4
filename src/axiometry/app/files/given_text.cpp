// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/given_text.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/app/files/source.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/text/utf8.h"
#include "axiometry/store/records.h"

namespace axiometry::app {
namespace {

struct Rules {
  bool lines = false;
  std::size_t length_max = 0;
};

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code <= 0x9F); }

/// U+202A to U+202E and U+2066 to U+2069.
bool turns_direction(char32_t code) { return (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069); }

Result<std::string> given(std::string_view what, std::string_view raw, const Rules& rules) {
  const std::string_view text = text::trim(raw);
  std::size_t length = 0;
  for (std::size_t at = 0; at < text.size(); ++length) {
    const Character character = character_at(text, at);
    if (!character.valid())
      return fail(fmt::format("found bytes in {} that are no UTF-8, expected text in UTF-8", what));
    const bool layout = character.code == '\n' || character.code == '\t' || character.code == '\r';
    if ((is_control(character.code) && !(layout && rules.lines)) || turns_direction(character.code))
      return fail(fmt::format("found the control character U+{:04X} in {}, expected plain text",
                              static_cast<std::uint32_t>(character.code), what));
    at += character.length;
  }
  if (length > rules.length_max)
    return fail(fmt::format("found {} characters in {}, expected at most {}", length, what, rules.length_max));
  return std::string(text);
}

}  // namespace

Result<std::string> given_line(std::string_view what, std::string_view text) {
  return given(what, text, {.length_max = line_length_max});
}

Result<std::string> given_text(std::string_view what, std::string_view text) {
  return given(what, text, {.lines = true, .length_max = text_length_max});
}

Result<std::string> given_file_name(std::string_view name) {
  AXIOMETRY_TRY(std::string last, given_line("the name of the file", base_name(std::string(name))));
  if (last.empty() || last == "." || last == "..") last = "unnamed";
  return last;
}

Result<std::int64_t> given_number(std::string_view what, const json::Value& value) {
  constexpr auto largest = static_cast<double>(store::id_max);
  if (value.is(json::Kind::number) && value.number() >= 1.0 && value.number() <= largest &&
      value.number() == std::floor(value.number()))
    return static_cast<std::int64_t>(value.number());
  return fail(fmt::format("found {} for {}, expected a whole number from 1",
                          value.is(json::Kind::number) ? format_exact(value.number())
                                                       : std::string(json::kind_name(value.kind())),
                          what),
              value.at());
}

Result<int> given_version(std::string_view what, const json::Value& value) {
  AXIOMETRY_TRY(const std::int64_t number, given_number(what, value));
  return static_cast<int>(number);
}

}  // namespace axiometry::app
