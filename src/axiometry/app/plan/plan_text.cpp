// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/plan/plan_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "axiometry/app/files/unexpected_text.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/standards/iso230_2/programme.h"

namespace axiometry::app {
namespace {

/// The numbers between the colons; nothing when one is none.
std::optional<std::vector<double>> colon_numbers(std::string_view text) {
  std::vector<double> numbers;
  for (std::string_view part : text::split(text, ':')) {
    const auto x = parse_number(text::trim(part));
    if (!x) return std::nullopt;
    numbers.push_back(*x);
  }
  return numbers;
}

/// Before they are built.
Result<void> check_count(double count, std::string_view text) {
  if (count <= static_cast<double>(iso230_2::targets_most)) return {};
  return fail(fmt::format("found {}, {:.10g} positions in all, expected at most {}", text::quoted(text), count,
                          iso230_2::targets_most));
}

Result<void> append_range(std::vector<double>& positions, const std::vector<double>& range, std::string_view text) {
  const double from = range[0], to = range[1], every = range[2];
  if (!(every > 0.0) || !(from <= to))
    return unexpected_text(text, "FROM:TO:EVERY with FROM below TO and EVERY above 0");
  const double steps = std::floor((to - from) / every + 1e-9);
  AXIOMETRY_TRY_VOID(check_count(static_cast<double>(positions.size()) + steps + 1.0, text));
  for (double k = 0.0; k <= steps; ++k) {
    // 0:1:0.1 shall give 0.3, not 0.30000000000000004.
    const double x = from + k * every;
    positions.push_back(std::round(x * 1e9) / 1e9);
  }
  return {};
}

}  // namespace

Result<iso230_2::Stretch> parse_stretch(std::string_view text) {
  const auto numbers = colon_numbers(text);
  if (!numbers || numbers->size() != 2) return unexpected_text(text, "FROM:TO such as 0:500");
  return iso230_2::Stretch{Position::native((*numbers)[0]), Position::native((*numbers)[1])};
}

Result<iso230_2::Stretch> parse_area(std::string_view text, AxisKind kind) {
  const auto numbers = colon_numbers(text);
  if (!numbers || numbers->size() > 2) return unexpected_text(text, "FROM or FROM:TO such as 1000:3000");
  const double from = numbers->front();
  const double to = numbers->size() == 2 ? numbers->back() : from + iso230_2::normal_stretch(kind).in_native();
  return iso230_2::Stretch{Position::native(from), Position::native(to)};
}

Result<std::vector<double>> parse_positions(std::string_view text) {
  std::vector<double> positions;
  for (std::string_view part : text::split(text, ',')) {
    const auto numbers = colon_numbers(part);
    if (numbers && numbers->size() == 3) {
      AXIOMETRY_TRY_VOID(append_range(positions, *numbers, part));
    } else if (numbers && numbers->size() == 1) {
      positions.push_back(numbers->front());
    } else {
      return unexpected_text(part, "a position, or positions as FROM:TO:EVERY");
    }
    AXIOMETRY_TRY_VOID(check_count(static_cast<double>(positions.size()), part));
  }
  return positions;
}

Result<std::vector<Approach>> parse_sequence(std::string_view text) {
  std::vector<Approach> sequence;
  std::map<std::pair<std::size_t, Direction>, std::size_t> runs;
  for (std::string_view line : text::split(text, '\n')) {
    std::string words(line.substr(0, line.find('#')));
    std::ranges::replace_if(
        words, [](char c) { return c == ',' || c == '\r'; }, ' ');
    for (std::string_view word : text::words(words)) {
      const auto number = parse_count(word.substr(0, word.size() - 1));
      if (!number || *number == 0 || (word.back() != '+' && word.back() != '-'))
        return unexpected_text(word, "the number of a target and its direction, such as 3+ or 3-");
      const Direction direction = word.back() == '+' ? Direction::up : Direction::down;
      const auto target = static_cast<std::size_t>(*number - 1);
      if (sequence.size() == most_planned_readings)
        return fail(fmt::format("found more than {} approaches, expected at most {}", most_planned_readings,
                                most_planned_readings));
      sequence.push_back({target, direction, runs[{target, direction}]++});
    }
  }
  if (sequence.empty()) return unexpected_text(text, "approaches such as 1+ 2+ 2- 1-");
  return sequence;
}

}  // namespace axiometry::app
