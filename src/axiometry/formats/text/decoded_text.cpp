// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/decoded_text.h"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace {

using namespace std::string_view_literals;

unsigned byte_at(std::string_view bytes, std::size_t k) { return static_cast<unsigned char>(bytes[k]); }

/// Nothing when a byte has no meaning in the encoding, or when this system does not know it.
std::optional<std::string> from_encoding(std::string_view bytes, const char* encoding) {
  const iconv_t converter = iconv_open("UTF-8", encoding);
  if (converter == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string input(bytes);
  std::string output(2 * bytes.size() + 16, '\0');  // no encoding here takes more than three bytes for two, or for one
  char* in = input.data();
  std::size_t in_left = input.size();
  std::size_t filled = 0;
  bool done = false;
  while (!done) {
    char* out = output.data() + filled;
    std::size_t out_left = output.size() - filled;
    const std::size_t result = iconv(converter, &in, &in_left, &out, &out_left);
    filled = static_cast<std::size_t>(out - output.data());
    done = result != static_cast<std::size_t>(-1) || errno != E2BIG;
    if (!done) output.resize(2 * output.size());
  }
  iconv_close(converter);
  if (in_left > 0) return std::nullopt;
  output.resize(filled);
  return output;
}

const char* utf16_of(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE\0\0"sv)) return nullptr;  // UTF-32
  if (bytes.starts_with("\xFF\xFE"sv)) return "UTF-16LE";
  if (bytes.starts_with("\xFE\xFF"sv)) return "UTF-16BE";
  if (bytes.size() < 4) return nullptr;
  if (bytes[0] != '\0' && bytes[1] == '\0' && bytes[2] != '\0' && bytes[3] == '\0') return "UTF-16LE";
  if (bytes[0] == '\0' && bytes[1] != '\0' && bytes[2] == '\0' && bytes[3] != '\0') return "UTF-16BE";
  return nullptr;
}

/// Letters of Latin-1 beyond ASCII mostly stand alone among ASCII, so they rarely make valid pairs, and the pairs they
/// make are rare characters.
bool looks_like_gbk(std::string_view bytes) {
  std::size_t common = 0;
  std::size_t rare = 0;
  for (std::size_t k = 0; k < bytes.size(); ++k) {
    const unsigned lead = byte_at(bytes, k);
    if (lead < 0x80) continue;
    if (lead < 0x81 || lead == 0xFF || k + 1 == bytes.size()) return false;
    const unsigned trail = byte_at(bytes, ++k);
    if (trail < 0x40 || trail == 0x7F || trail == 0xFF) return false;
    const bool symbol = lead >= 0xA1 && lead <= 0xA9;
    const bool first_level = lead >= 0xB0 && lead <= 0xD7;
    ++(trail >= 0xA1 && (symbol || first_level) ? common : rare);
  }
  return common > 0 && common >= 3 * rare;
}

bool ends_lines_in_cr(std::string_view text) { return text.contains('\r') && !text.contains('\n'); }

}  // namespace

Result<DecodedText> decoded_text(std::string_view bytes) {
  DecodedText result{std::string(bytes), "UTF-8"};
  if (const char* utf16 = utf16_of(bytes)) {
    auto text = from_encoding(bytes, utf16);
    if (!text)
      return fail(fmt::format("found {} text that is cut or broken, expected whole characters", utf16), {1, 1});
    result = {std::move(*text), "UTF-16"};
  }
  if (ends_lines_in_cr(text::trim(result.text))) {
    std::ranges::replace(result.text, '\r', '\n');
    result.old_line_ends = true;
  }
  AXIOMETRY_TRY(const std::string_view text, readable_text(result.text));
  if (text.size() < result.text.size()) result.text.erase(0, result.text.size() - text.size());
  if (!text::invalid_utf8(result.text)) return result;
  const std::pair<const char*, std::string_view> pages[] = {
      {"GBK", "GBK"}, {"WINDOWS-1252", "Windows-1252"}, {"ISO-8859-1", "Latin-1"}};
  for (const auto& [name, title] : pages) {
    if (title == "GBK" && !looks_like_gbk(result.text)) continue;
    if (auto decoded = from_encoding(result.text, name)) {
      result.text = std::move(*decoded);
      result.encoding = title;
      return result;
    }
  }
  AXIOMETRY_TRY_VOID(check_utf8(result.text));
  return result;
}

Result<DecodedText> decoded_as(std::string_view bytes, std::string_view encoding) {
  if (encoding == "UTF-8") {
    AXIOMETRY_TRY_VOID(check_utf8(bytes));
    return decoded_text(bytes);
  }
  constexpr std::pair<std::string_view, const char*> names[] = {
      {"UTF-16", "UTF-16"}, {"GBK", "GBK"}, {"Windows-1252", "WINDOWS-1252"}, {"Latin-1", "ISO-8859-1"}};
  for (const auto& [title, name] : names) {
    if (title != encoding) continue;
    const char* marked = title == "UTF-16" ? utf16_of(bytes) : nullptr;
    auto text = from_encoding(bytes, marked != nullptr ? marked : name);
    if (!text) break;
    AXIOMETRY_TRY(DecodedText result, decoded_text(*text));
    result.encoding = title;
    return result;
  }
  return fail(fmt::format("found bytes that have no meaning in {}, expected text in it", encoding));
}

std::vector<SourceRemark> encoding_remarks(const DecodedText& decoded) {
  std::vector<SourceRemark> remarks;
  if (decoded.encoding != "UTF-8")
    remarks.push_back({false, fmt::format("found text that is not UTF-8; it was read as {}", decoded.encoding)});
  if (decoded.old_line_ends) remarks.push_back({false, "found lines that end in CR alone; they were read as lines"});
  return remarks;
}

}  // namespace axiometry::formats
