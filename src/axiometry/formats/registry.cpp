// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/base/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/generic_delimited.h"
#include "axiometry/formats/text_source.h"

namespace axiometry::formats {
namespace {

std::string titles() {
  std::string list;
  for (const Format* format : format_table())
    list += fmt::format("{}{} ({})", list.empty() ? "" : "; ", format->id, format->title);
  return list;
}

std::string_view first_line(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text::trim(text.substr(begin, text.find('\n', begin) - begin));
}

}  // namespace

const Format* find_format(std::string_view id) {
  for (const Format* format : format_table())
    if (text::equal_ignoring_case(format->id, id)) return format;
  return nullptr;
}

Result<const Format*> recognise(std::string_view head) {
  AXIOMETRY_TRY(const std::string_view text, readable_text(head));
  const Format* best = nullptr;
  int best_score = 0;
  for (const Format* format : format_table()) {
    const int score = format->recognise(text);
    if (score <= best_score) continue;
    best = format;
    best_score = score;
  }
  if (best != nullptr) return best;
  constexpr std::size_t longest_character = 4;  // the head may end within one
  if (const auto bad = text::invalid_utf8(text); bad && *bad + longest_character < text.size())
    AXIOMETRY_TRY_VOID(check_utf8(text));
  if (const std::string question = open_question(text); !question.empty()) return fail(question, {1, 1});
  return fail(fmt::format("found text that begins with {}, expected one of: {}; a CSV file begins with a header "
                          "such as target_mm,direction,run,deviation_um",
                          text::quoted(first_line(text)), titles()),
              {1, 1});
}

}  // namespace axiometry::formats
