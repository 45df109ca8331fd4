// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/time/written_date.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry {
namespace {

using std::chrono::year_month;
using std::chrono::year_month_day;

/// Longer texts are remarks; "Donnerstag, den 12. September 2026, 10:30:00 Uhr MESZ" is far shorter.
constexpr std::size_t date_bytes_most = 80;

/// Of each month, without accents and in small letters. "jui" would be two months.
constexpr std::array<std::string_view, 12> month_names = {
    "january jan januar janner jaenner janvier janv",
    "february feb febr februar feber fevrier fevr fev",
    "march mar marz maerz mrz mars",
    "april apr avril avr",
    "may mai",
    "june jun juni juin",
    "july jul juli juillet juill juil",
    "august aug aout",
    "september sept sep septembre",
    "october oct oktober okt octobre",
    "november nov novembre",
    "december dec dezember dez decembre",
};

/// What may stand before a date and says no more than it does.
constexpr std::string_view words_before =
    "mon monday tue tues tuesday wed wednesday thu thur thurs thursday fri friday sat saturday sun sunday "
    "mo montag di dienstag mi mittwoch do donnerstag fr freitag sa samstag sonnabend so sonntag den "
    "lun lundi mardi mer mercredi jeu jeudi ven vendredi sam samedi dim dimanche le";

constexpr std::string_view ordinal_ends[] = {"st", "nd", "rd", "th", "er"};

/// In small letters, blanks for what parts words.
std::string plain_date_text(std::string_view text) {
  constexpr std::pair<std::string_view, char> letters[] = {{"ä", 'a'}, {"Ä", 'a'}, {"é", 'e'},      {"É", 'e'},
                                                           {"û", 'u'}, {"Û", 'u'}, {"\u00A0", ' '}, {"\u202F", ' '},
                                                           {",", ' '}, {";", ' '}};
  std::string plain;
  while (!text.empty()) {
    const auto* found = std::ranges::find_if(letters, [&](const auto& l) { return text.starts_with(l.first); });
    plain += found == std::end(letters) ? text.front() : found->second;
    text.remove_prefix(found == std::end(letters) ? 1 : found->first.size());
  }
  return text::to_lower(plain);
}

std::optional<unsigned> month_named(std::string_view word) {
  for (unsigned k = 0; k < month_names.size(); ++k)
    if (text::is_one_of(word, text::words(month_names[k]))) return k + 1;
  return std::nullopt;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A run of digits or of anything else.
struct Piece {
  std::string_view text;
  std::optional<unsigned> month = {};
  bool number = false;
  bool ordinal = false;  ///< "12th"
};

void add_pieces(std::string_view word, std::vector<Piece>& pieces) {
  bool joined = false;
  while (!word.empty()) {
    const bool number = is_digit(word.front());
    const auto end = std::ranges::find_if(word, [&](char c) { return is_digit(c) != number; });
    const std::string_view run = word.substr(0, static_cast<std::size_t>(end - word.begin()));
    word.remove_prefix(run.size());
    if (!number && joined && word.empty() && text::is_one_of(run, ordinal_ends))
      pieces.back().ordinal = true;
    else
      pieces.push_back({run, number ? std::nullopt : month_named(run), number});
    joined = true;
  }
}

/// "Thursday", and "mar." of "mar. 3 nov. 2026", a Tuesday in November.
void leave_out_words_before(std::vector<Piece>& pieces) {
  const auto months = std::ranges::count_if(pieces, [](const Piece& p) { return p.month.has_value(); });
  const auto says_nothing = [&](const Piece& p) {
    return p.month ? months == 2 && p.text == "mar" : text::is_one_of(p.text, text::words(words_before));
  };
  while (!pieces.empty() && says_nothing(pieces.front())) pieces.erase(pieces.begin());
}

/// Of a plain_date_text(). Times, which have colons, are left out with the zone behind them; what stands behind is
/// looked at only where the year was not yet named, "Nov 12 09:30:00 UTC 2026".
std::vector<Piece> pieces_of(std::string_view plain) {
  std::vector<Piece> pieces;
  bool behind_time = false;
  for (const std::string_view word : text::words(plain)) {
    const bool time = word.contains(':');
    if (time) leave_out_words_before(pieces);
    if (time && pieces.size() >= 3) break;
    const std::size_t marks = word.find_first_of("-./");
    const char mark = marks == std::string_view::npos ? '-' : word[marks];
    const bool zone = behind_time && !is_digit(word.front());
    for (const std::string_view part : text::split(word, mark))
      if (!part.empty() && !time && !zone) add_pieces(part, pieces);
    behind_time = time;
  }
  leave_out_words_before(pieces);
  return pieces;
}

std::optional<int> year_of(const Piece& piece, bool may_be_short) {
  const auto value = parse_count(piece.text);
  if (!piece.number || piece.ordinal || !value) return std::nullopt;
  if (piece.text.size() == 4 && *value >= 1900 && *value <= 2199) return static_cast<int>(*value);
  if (piece.text.size() == 2 && may_be_short) return static_cast<int>(*value < 70 ? 2000 + *value : 1900 + *value);
  return std::nullopt;
}

bool may_go_on(std::span<const Piece> rest) {
  return std::ranges::none_of(rest, [](const Piece& p) { return p.month || year_of(p, false); });
}

}  // namespace

std::optional<year_month_day> written_date(std::string_view raw) {
  if (raw.size() > date_bytes_most) return std::nullopt;
  const std::string plain = plain_date_text(raw);
  const std::vector<Piece> pieces = pieces_of(plain);
  if (pieces.size() < 3 || !may_go_on(std::span(pieces).subspan(3))) return std::nullopt;
  const bool year_first = year_of(pieces[0], false).has_value();
  const bool month_first = pieces[0].month.has_value();
  const Piece& year_piece = pieces[year_first ? 0 : 2];
  const Piece& month_piece = pieces[month_first ? 0 : 1];
  const Piece& day_piece = pieces[year_first ? 2 : month_first ? 1 : 0];
  const auto year = year_of(year_piece, !year_first && pieces.size() == 3);
  const auto day = parse_count(day_piece.text);
  if (!year || !month_piece.month || !day_piece.number || day_piece.text.size() > 2 || !day) return std::nullopt;
  const year_month_day date =
      std::chrono::year(*year) / std::chrono::month(*month_piece.month) / std::chrono::day(static_cast<unsigned>(*day));
  return date.ok() ? std::optional(date) : std::nullopt;
}

std::optional<year_month> written_month(std::string_view raw) {
  if (raw.size() > date_bytes_most) return std::nullopt;
  const std::string plain = plain_date_text(raw);
  const std::vector<Piece> pieces = pieces_of(plain);
  if (pieces.size() != 2) return std::nullopt;
  const bool year_first = pieces[0].number;
  const auto year = year_of(pieces[year_first ? 0 : 1], false);
  const auto month = pieces[year_first ? 1 : 0].month;
  if (!year || !month) return std::nullopt;
  return std::chrono::year(*year) / std::chrono::month(*month);
}

}  // namespace axiometry
