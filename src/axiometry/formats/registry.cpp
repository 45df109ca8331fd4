// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_columns.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/passed_over.h"
#include "axiometry/formats/table/generic_delimited.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/other_tables.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace {

std::string_view first_line(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return text::trim(text.substr(begin, text.find('\n', begin) - begin));
}

/// nullptr when no format fits. A guess is made only where no format is surer: it costs more than a look at the header.
/// Fails where no format is sure and all that keeps a guess from being made is a unit that the numbers speak against.
Result<const Format*> best_for(std::string_view text) {
  constexpr int score_of_a_guess = 10;
  const Format* const guessing = find_format(any_table_format);
  const Format* best = nullptr;
  int best_score = 0;
  for (const Format* format : format_table()) {
    if (format == guessing) continue;
    const int score = format->recognise(text);
    if (score <= best_score) continue;
    best = format;
    best_score = score;
  }
  if (best_score >= score_of_a_guess) return best;
  if (guessing->recognise(text) > best_score) return guessing;
  if (best != nullptr) AXIOMETRY_TRY_VOID(check_unit_believed(text));
  return best;
}

}  // namespace

const Format* find_format(std::string_view id) {
  for (const Format* format : format_table())
    if (text::equal_ignoring_case(format->id, id)) return format;
  return nullptr;
}

Result<const Format*> recognise(std::string_view head) {
  AXIOMETRY_TRY_VOID(check_no_other_error(head));
  const auto readable = readable_text(head);
  // UTF-16 and the line ends of old Macs: some readers decode them, the others say what is wrong. What none knows would
  // not be known as UTF-8 either, so that nobody is told to save it as such.
  const auto decoded = readable ? DecodedText{} : decoded_text(head.substr(0, head.size() / 2 * 2));
  if (!decoded) return std::unexpected(readable.error());
  const std::string_view text = readable ? *readable : decoded->text;
  AXIOMETRY_TRY_VOID(check_no_other_table(text));
  AXIOMETRY_TRY(const Format* best, best_for(text));
  if (best != nullptr) return best;
  constexpr std::size_t longest_character = 4;  // the head may end within one
  if (const auto bad = text::invalid_utf8(text); bad && *bad + longest_character < text.size())
    AXIOMETRY_TRY_VOID(check_utf8(text));
  AXIOMETRY_TRY_VOID(check_table(text));
  return fail(fmt::format("found text that begins with {}, expected one of the {} formats that can be read; a CSV file "
                          "begins with a header such as {}",
                          text::quoted(first_line(text)), format_table().size(), long_table_head(AxisKind::linear)),
              {1, 1});
}

Result<void> check_passed_over(std::string_view head) {
  const auto readable = readable_text(head);
  if (!readable && is_packed(head)) return std::unexpected(readable.error());
  if (!check_no_other_error(head)) return {};
  const auto decoded = readable ? DecodedText{} : decoded_text(head.substr(0, head.size() / 2 * 2));
  if (!decoded) return {};
  const std::string_view text = readable ? *readable : decoded->text;
  if (!check_no_other_table(text)) return {};
  const auto best = best_for(text);
  if (!best) return std::unexpected(best.error());
  return *best == nullptr ? check_table(text) : Result<void>();
}

}  // namespace axiometry::formats
