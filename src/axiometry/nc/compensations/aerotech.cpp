// SPDX-License-Identifier: Apache-2.0
//
// Axis calibration of Aerotech controllers: values at one spacing, interpolated, the ends held, one curve.
#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable aerotech_axis_table;

namespace aerotech {
namespace {

constexpr std::string_view sign =
    "A positive number moves the axis in the positive direction: it is added (inferred); with NEGCOR in the negative.";

/// How many counts of CORUNIT=PRIMARY/1000 a µm or ″ is.
double correction_unit(const AxisTableOptions& options) { return 1000.0 * unit_per_deviation(options); }

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, aerotech_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  const std::vector<double>& positions = correction.positions();
  const auto step = common_step(positions);
  AXIOMETRY_CONTRACT(step);  // check_limits()
  const double unit = position_per_unit(options);
  const int decimals = table_decimals(options);
  std::string text = comment_lines(";", sign_of(aerotech_axis_table, options));
  fmt::format_to(std::back_inserter(text), ":START {} POSUNIT=PRIMARY CORUNIT=PRIMARY/1000 SAMPDIST={} OFFSET={}\n",
                 options.axis, trimmed_fixed(*step / unit, decimals + 2),
                 trimmed_fixed(positions.front() / unit, decimals));
  for (const double value : correction.values(Direction::up))
    fmt::format_to(std::back_inserter(text), "{}\n", fixed_number(value * correction_unit(options), decimals - 2));
  return text + ":END\n";
}

struct Head {
  double spacing = 0.0, first = 0.0, sign = 1.0;
};

Result<Head> head_of(const TableLine& line, AxisTableOptions options) {
  constexpr std::string_view expected =
      ":START AXIS POSUNIT=PRIMARY CORUNIT=PRIMARY/1000 SAMPDIST=NUMBER OFFSET=NUMBER";
  const std::vector<std::string_view> words = text::words(line.text);
  if (words.size() < 2 || words[0] != ":START") return refused(line, expected);
  if (!is_axis_named(words[1], options))
    return fail(fmt::format("found the axis {}, expected {}", text::quoted(words[1]), text::quoted(options.axis)),
                {line.number, 0});
  std::optional<double> spacing, first;
  bool has_units[2] = {false, false}, is_negated = false;
  for (const std::string_view word : std::span(words).subspan(2)) {
    bool is_new = false;
    if (word == "NEGCOR") {
      is_new = !std::exchange(is_negated, true);
    } else if (word == "POSUNIT=PRIMARY") {
      is_new = !std::exchange(has_units[0], true);
    } else if (word == "CORUNIT=PRIMARY/1000") {
      is_new = !std::exchange(has_units[1], true);
    } else if (word.starts_with("SAMPDIST=") || word.starts_with("OFFSET=")) {
      std::optional<double>& place = word.starts_with('S') ? spacing : first;
      is_new = !place;
      place = parse_number(word.substr(word.find('=') + 1));
      is_new = is_new && place;
    }
    if (!is_new) return refused(line, expected);
  }
  if (!spacing || !(*spacing > 0.0) || !first || !has_units[0] || !has_units[1]) return refused(line, expected);
  return Head{*spacing, *first, is_negated ? -1.0 : 1.0};
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  std::optional<Head> head;
  bool has_ended = false;
  std::vector<double> values;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text.substr(0, line.text.find(';')));
    if (line.text.empty()) continue;
    if (has_ended) return refused(line, "nothing behind :END");
    if (!head) {
      AXIOMETRY_TRY(head, head_of(line, options));
    } else if (line.text == ":END") {
      has_ended = true;
    } else {
      const auto numbers = numbers_of(line.text);
      if (!numbers) return refused(line, "numbers, or :END");
      for (const double number : *numbers) values.push_back(head->sign * number / correction_unit(options));
    }
  }
  if (!has_ended) return fail("found no :END, expected one: the table may be cut");
  std::vector<double> down = values;
  const double unit = position_per_unit(options);
  return even_correction(options.kind, head->first * unit, head->spacing * unit, std::move(values), std::move(down));
}

}  // namespace
}  // namespace aerotech

const AxisTable aerotech_axis_table = {
    .id = "aerotech",
    .title = "Aerotech Automation1, axis calibration",
    .extension = ".cal",
    .curves = TableCurves::both_ways,
    .limits = {.equidistant = true, .closes = true},
    .uses = {.turned_sign = true},
    .sign = aerotech::sign,
    .loading =
        "Name it among the calibration files of the controller, switch the calibration of the axis on, reset the "
        "controller, and home the axis: calibration is active once it is homed.",
    .verified =
        "That tables are text in UTF-8, add to the axis, are linear between points, hold their ends, and serve both "
        "directions alike: the control's help.",
    .inferred =
        "The keywords, what OFFSET counts from, and the sign: a program that is in use writes the deviation itself, "
        "which would be the opposite. A re-test after loading tells it; NEGCOR in the head turns it round. How it is "
        "loaded.",
    .turned_sign =
        "A positive number moves the axis in the negative direction: it is taken off (turned against what was "
        "inferred); with NEGCOR in the positive.",
    .write = aerotech::write,
    .read = aerotech::read,
    .recognises = [](std::string_view text) { return text.substr(0, 1024).find(":START ") != text.npos; },
};

}  // namespace axiometry::nc
