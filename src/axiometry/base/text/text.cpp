// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/text/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/utf8.h"

namespace axiometry::text {
namespace {

constexpr std::string_view blanks = " \t\r\n";

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// Where it is below the limit, and else the limit: what leads below it stays less than that off the diagonal.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
  std::vector<std::size_t> row(b.size() + 1, limit);
  for (std::size_t j = 0; j < std::min(row.size(), limit); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    const std::size_t first = i > limit ? i - limit : 0, last = std::min(b.size(), i + limit - 1);
    std::size_t diagonal = std::exchange(row[first], std::min(i, limit)), least = row[first];
    for (std::size_t j = first + 1; j <= last; ++j) {
      const std::size_t substitution = diagonal + (lower(a[i - 1]) != lower(b[j - 1]));
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution, limit});
      least = std::min(least, row[j]);
    }
    if (least == limit) return limit;
  }
  return row.back();
}

}  // namespace

std::string_view trim(std::string_view s) {
  const std::size_t first = s.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return s.substr(first, s.find_last_not_of(blanks) - first + 1);
}

std::string to_lower(std::string_view s) {
  std::string result(s);
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

bool equal_ignoring_case(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

std::vector<std::string_view> split(std::string_view s, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = s.find(separator);
    parts.push_back(s.substr(0, end));
    if (end == std::string_view::npos) return parts;
    s.remove_prefix(end + 1);
  }
}

std::vector<std::string_view> words(std::string_view s) {
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t begin = s.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return result;
    s.remove_prefix(begin);
    const std::size_t end = s.find_first_of(blanks);
    result.push_back(s.substr(0, end));
    if (end == std::string_view::npos) return result;
    s.remove_prefix(end);
  }
}

std::optional<std::size_t> invalid_utf8(std::string_view s) {
  for (std::size_t k = 0; k < s.size();) {
    const Character character = character_at(s, k);
    if (!character.valid()) return k;
    k += character.length;
  }
  return std::nullopt;
}

std::string quoted(std::string_view s) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  std::size_t shown = 0;
  for (std::size_t k = 0; k < s.size(); ++shown) {
    if (shown == longest) return result + "…\"";
    const Character character = character_at(s, k);
    if (!character.valid() || character.code < 0x20 || character.code == 0x7F) {
      result += fmt::format("\\x{:02X}", static_cast<unsigned char>(s[k]));
    } else {
      result += s.substr(k, character.length);
    }
    k += character.length;
  }
  return result + "\"";
}

std::string csv_cell(std::string_view s, char separator) {
  if (s.find_first_of("\"\r\n") == s.npos && s.find(separator) == s.npos) return std::string(s);
  std::string cell = "\"";
  for (char c : s) cell.append(c == '"' ? 2 : 1, c);
  return cell + "\"";
}

namespace {

constexpr std::string_view formula_beginnings = "=+-@\t\r";
constexpr std::string_view cell_ends = ",;\t\r\n";

/// Whether a spreadsheet that parts lines by the sign in front takes the cell that begins here for a number: "-0.5" is
/// no formula.
bool is_number_cell(std::string_view s, char in_front) {
  const std::string ends = {in_front, '\r', '\n'};
  std::string_view cell = trim(s.substr(0, s.find_first_of(ends)));
  if (cell.ends_with('"')) cell.remove_suffix(1);
  double value = 0.0;
  const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
  const auto read = std::from_chars(begin, cell.data() + cell.size(), value);
  return read.ec == std::errc() && read.ptr == cell.data() + cell.size();
}

}  // namespace

/// A spreadsheet of another country parts lines elsewhere, whatever is quoted: what is behind any of the separators in
/// use may become a cell.
std::string no_formula(std::string_view s) {
  std::string safe;
  bool begins = true;
  char in_front = '\n';
  for (std::size_t k = 0; k < s.size(); ++k) {
    const bool ends = cell_ends.contains(s[k]);
    const bool formula = begins && formula_beginnings.contains(s[k]) && k + 1 < s.size();
    if (formula && (k == 0 || (!ends && !is_number_cell(s.substr(k), in_front)))) safe += '\'';
    safe += s[k];
    if (ends) in_front = s[k];
    begins = ends || (begins && (s[k] == ' ' || s[k] == '"'));
  }
  return safe;
}

std::optional<std::string_view> nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
  std::optional<std::string_view> best;
  if (word.size() > read_budget::name_bytes) return best;
  std::size_t best_distance = word.size() / 3 + 1;
  for (std::string_view candidate : candidates) {
    if (candidate.size() > word.size() + best_distance) continue;
    if (word.size() >= candidate.size() + best_distance) continue;  // at least so many letters go
    const std::size_t distance = edit_distance(word, candidate, best_distance);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace axiometry::text
