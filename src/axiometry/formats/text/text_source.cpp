// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/text_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"

namespace axiometry::formats {
namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view bytes;
  std::string_view what;
  std::string_view advice;
  bool packed = false;
};

constexpr Signature signatures[] = {
    {"PK\x03\x04"sv, "a ZIP archive or a spreadsheet", "; save a spreadsheet as CSV", true},
    {"\xD0\xCF\x11\xE0"sv, "an old Office document", "; save a spreadsheet as CSV", true},
    {"%PDF"sv, "a PDF document", ""},
    {"\x89PNG"sv, "a PNG picture", ""},
    {"\x1F\x8B"sv, "a gzip archive", "; unpack it first", true},
    {"<!DOCTYPE html"sv, "a web page (HTML)", "; save its table as CSV"},
    {"<!doctype html"sv, "a web page (HTML)", "; save its table as CSV"},
    {"<html"sv, "a web page (HTML)", "; save its table as CSV"},
    {"<?xml"sv, "an XML document", "; save a table as CSV"},
    {"<svg"sv, "an XML document", "; save a table as CSV"},
};

TextPosition place(std::string_view text, std::size_t offset, std::size_t first_line) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t last_break = before.rfind('\n');
  return {first_line + static_cast<std::size_t>(std::ranges::count(before, '\n')),
          offset - (last_break == std::string_view::npos ? 0 : last_break + 1) + 1};
}

}  // namespace

bool is_packed(std::string_view bytes) {
  return std::ranges::any_of(signatures, [&](const Signature& s) { return s.packed && bytes.starts_with(s.bytes); });
}

Result<std::string_view> readable_text(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) || bytes.starts_with("\0\0\xFE\xFF"sv))
    return fail("found UTF-16 or UTF-32 text, expected UTF-8; save the file as UTF-8", {1, 1});
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  for (const Signature& s : signatures)
    if (bytes.starts_with(s.bytes))
      return fail(fmt::format("found {}, expected a text file{}", s.what, s.advice), {1, 1});
  if (const std::size_t nul = bytes.find('\0'); nul != std::string_view::npos) {
    // UTF-16 without a mark has a NUL in every second byte of its ASCII, and none between them.
    const bool utf16 =
        nul < 2 && bytes.size() >= 4 && bytes[nul + 2] == '\0' && bytes[1 - nul] != '\0' && bytes[3 - nul] != '\0';
    return fail(utf16 ? "found UTF-16 text without a byte order mark, expected UTF-8; save the file as UTF-8"
                      : "found a NUL byte, so this is a binary file, expected a text file",
                place(bytes, nul, 1));
  }
  const std::string_view content = text::trim(bytes);
  if (content.contains('\r') && !bytes.contains('\n'))
    return fail("found lines that end in CR alone, expected LF or CRLF", {1, bytes.find('\r') + 1});
  if (content.empty()) return fail("found an empty file, expected measured deviations");
  return bytes;
}

Result<void> check_utf8(std::string_view text, std::size_t line) {
  const auto offset = text::invalid_utf8(text);
  if (!offset) return {};
  return fail(
      fmt::format(
          "found the byte 0x{:02X}, expected UTF-8; a file in Latin-1 or an ANSI code page must be saved as UTF-8",
          static_cast<unsigned char>(text[*offset])),
      place(text, *offset, line));
}

Result<std::string_view> utf8_text(std::string_view bytes) {
  AXIOMETRY_TRY(const std::string_view text, readable_text(bytes));
  AXIOMETRY_TRY_VOID(check_utf8(text));
  return text;
}

}  // namespace axiometry::formats
