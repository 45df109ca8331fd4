// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/compensations/step_settings.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc::steps {
namespace {

constexpr std::string_view range_mark = " range ";

}  // namespace

Result<unsigned> axis_number(const AxisTableOptions& options, std::size_t count) {
  constexpr std::string_view letters = "XYZABC";
  const std::size_t k = options.axis.size() == 1 ? letters.find(options.axis[0]) : letters.npos;
  if (k == letters.npos || k >= count)
    return fail(
        fmt::format("found the axis {}, expected one of {}", text::quoted(options.axis), letters.substr(0, count)));
  return static_cast<unsigned>(k);
}

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options, const AxisTable& table,
                          const Spelling& spelling) {
  AXIOMETRY_TRY_VOID(check_limits(correction, table));
  AXIOMETRY_TRY(const double backlash, backlash_of(correction));
  if (backlash < 0.0)
    return fail(
        fmt::format("found a backlash of {:.3f} {}, expected 0 or more: the axis goes too far at a reversal, which "
                    "this control cannot take back",
                    backlash, deviation_unit(correction.kind())));
  const std::vector<double>& positions = correction.positions();
  const std::vector<double>& up = correction.values(Direction::up);
  const double per_position = deviation_per_position(options.kind);
  const double scale =
      positions.size() < 2 ? 0.0 : (up.back() - up.front()) / (positions.back() - positions.front()) / per_position;
  std::string text = comment_lines(spelling.comment, sign);
  if (positions.size() > 1)
    fmt::format_to(std::back_inserter(text), "{}{}{} to {}\n", spelling.comment, range_mark,
                   trimmed_fixed(positions.front(), 6), trimmed_fixed(positions.back(), 6));
  if (options.steps_per_unit > 0.0)
    fmt::format_to(std::back_inserter(text), "{}{}\n", spelling.steps,
                   fixed_number(options.steps_per_unit * (1.0 + scale), 6));
  else if (scale != 0.0)
    fmt::format_to(std::back_inserter(text),
                   "{} left out: a scale of {} to the present steps per unit, which were not told\n", spelling.comment,
                   fixed_number(1.0 + scale, 9));
  fmt::format_to(std::back_inserter(text), "{}{}\n", spelling.backlash, fixed_number(backlash / per_position, 6));
  for (const std::string& line : spelling.beside) text += line + '\n';
  return text;
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options, const Spelling& spelling) {
  std::optional<double> steps, backlash;
  std::pair range{options.reference - 1000.0, options.reference + 1000.0};
  std::size_t beside = 0;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text);
    if (line.text.starts_with(fmt::format("{}{}", spelling.comment, range_mark))) {
      const auto words = text::words(line.text);
      const auto low = words.size() == 5 ? parse_number(words[2]) : std::nullopt;
      const auto high = words.size() == 5 ? parse_number(words[4]) : std::nullopt;
      if (!low || !high || !(*low < *high)) return refused(line, "range LOW to HIGH");
      range = {*low, *high};
      continue;
    }
    line.text = text::trim(line.text.substr(0, line.text.find(spelling.comment)));
    if (line.text.empty()) continue;
    if (beside < spelling.beside.size() && line.text == spelling.beside[beside]) {
      ++beside;
      continue;
    }
    const bool is_steps = line.text.starts_with(spelling.steps);
    std::optional<double>& place = is_steps ? steps : backlash;
    const std::string& key = is_steps ? spelling.steps : spelling.backlash;
    const auto number =
        !place && line.text.starts_with(key) ? parse_number(text::trim(line.text.substr(key.size()))) : std::nullopt;
    if (!number || *number < 0.0)
      return refused(line, fmt::format("{}NUMBER or {}NUMBER, once", spelling.steps, spelling.backlash));
    place = number;
  }
  if (!backlash || beside < spelling.beside.size())
    return fail(fmt::format("found no {}NUMBER{}, expected it", spelling.backlash,
                            spelling.beside.empty() ? "" : " with what switches it on"));
  if (steps && !(options.steps_per_unit > 0.0))
    return fail("found steps per unit, expected those without the table beside them, to tell the scale");
  const double scale = steps ? *steps / options.steps_per_unit - 1.0 : 0.0;
  const double per_position = deviation_per_position(options.kind);
  std::vector<double> up, down;
  for (const double position : {range.first, range.second}) {
    up.push_back(scale * (position - options.reference) * per_position);
    down.push_back(up.back() - *backlash * per_position);
  }
  return AxisCorrection::make(options.kind, {range.first, range.second}, std::move(up), std::move(down));
}

}  // namespace axiometry::nc::steps
