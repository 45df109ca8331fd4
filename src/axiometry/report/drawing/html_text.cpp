// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/html_text.h"
#include "axiometry/report/drawing/utf8.h"

#include <fmt/format.h>

namespace axiometry::report::html {

namespace {

std::string tagged(const TextRun& run) {
  std::string text = escaped(run.text);
  if (run.bar) {
    const bool tall = !run.text.empty() && run.text.front() >= 'A' && run.text.front() <= 'Z';
    text = fmt::format("<span class=\"bar{}\" role=\"img\" aria-label=\"{} bar\">{}</span>", tall ? " tall" : "", text,
                       text);
  }
  if (run.italic) text = fmt::format("<i>{}</i>", text);
  if (run.bold) text = fmt::format("<b>{}</b>", text);
  if (run.script == Script::sub) text = fmt::format("<sub>{}</sub>", text);
  if (run.script == Script::super) text = fmt::format("<sup>{}</sup>", text);
  return text;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (char c : cleaned(text)) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string rich(const RichText& text) {
  std::string out;
  for (const TextRun& run : text) out += tagged(run);
  return out;
}

std::string css_string(std::string_view text) {
  std::string out = "\"";
  for (char c : cleaned(text)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool harmless =
        byte >= 0x80 || c == ' ' || (c >= '0' && c <= '9') || ((c | 0x20) >= 'a' && (c | 0x20) <= 'z');
    if (harmless) {
      out += c;
    } else {
      out += fmt::format("\\{:06x}", byte);
    }
  }
  return out + "\"";
}

std::size_t length(std::string_view text) {
  std::size_t characters = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    const bool combining = byte == 0xCC;  // U+0300 to U+033F
    if ((byte & 0xC0) != 0x80 && !combining) ++characters;
  }
  return characters;
}

}  // namespace axiometry::report::html
