// SPDX-License-Identifier: Apache-2.0
//
// Table of nonlinear axis errors of HEIDENHAIN controls (*.COM): positions from the machine datum, the values of the
// axis in the column of its name, those of the negative direction in BACKLASH. config.cma names the table for the axis.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable heidenhain_axis_table;

namespace heidenhain {
namespace {

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, heidenhain_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  const std::vector<double>& positions = correction.positions();
  if (options.kind == AxisKind::rotary && (positions.front() < 0.0 || positions.back() > 360.0))
    return fail(
        fmt::format("found positions from {} to {}, expected 0 to 360, all that the control uses of a rotary axis",
                    format_rounded(positions.front()), format_rounded(positions.back())));
  const int decimals = table_decimals(options);
  std::string text = fmt::format("BEGIN {}.COM {}\nNR AXISPOS BACKLASH {}\n", options.axis,
                                 options.in_inch ? "INCH" : "MM", options.axis);
  for (std::size_t k = 0; k < positions.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", k,
                   fixed_number(positions[k] / position_per_unit(options), decimals),
                   fixed_number(-correction.values(Direction::down)[k] * unit_per_deviation(options), decimals),
                   fixed_number(-correction.values(Direction::up)[k] * unit_per_deviation(options), decimals));
  return text + "[END]\n";
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  std::vector<double> positions, up, down;
  bool has_begun = false, has_head = false, has_ended = false;
  AxisTableOptions named = options;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text);
    if (line.text.empty()) continue;
    const std::vector<std::string_view> words = text::words(line.text);
    if (!has_begun) {
      const std::string_view unit = options.in_inch ? "INCH" : "MM";
      if (words.size() != 3 || words[0] != "BEGIN" || words[2] != unit)
        return refused(line, fmt::format("BEGIN NAME.COM {}", unit));
      has_begun = true;
    } else if (!has_head) {
      if (words.size() != 4 || words[0] != "NR" || words[1] != "AXISPOS" || words[2] != "BACKLASH" ||
          !is_axis_named(words[3], named))
        return refused(line, fmt::format("the columns NR AXISPOS BACKLASH {}", options.axis));
      has_head = true;
    } else if (has_ended) {
      return refused(line, "nothing behind [END]");
    } else if (line.text == "[END]") {
      has_ended = true;
    } else {
      const auto numbers = numbers_of(line.text);
      if (!numbers || numbers->size() != 4 || (*numbers)[0] != static_cast<double>(positions.size()))
        return refused(line, fmt::format("row {} of four numbers", positions.size()));
      positions.push_back((*numbers)[1] * position_per_unit(options));
      down.push_back(-(*numbers)[2] / unit_per_deviation(options));
      up.push_back(-(*numbers)[3] / unit_per_deviation(options));
    }
  }
  if (!has_ended) return fail("found no [END], expected one: the table may be cut");
  return AxisCorrection::make(options.kind, std::move(positions), std::move(up), std::move(down));
}

}  // namespace
}  // namespace heidenhain

const AxisTable heidenhain_axis_table = {
    .id = "heidenhain",
    .title = "HEIDENHAIN, table of axis errors (COM)",
    .extension = ".com",
    .curves = TableCurves::each_way,
    .limits = {.closes = true},
    .uses = {.turned_sign = true},
    .sign = "A positive number moves the axis in the negative direction: it is what is too far (inferred).",
    .loading =
        "Copy the values into a .COM table of the control, name it in the axis' column of config.cma (.CMA), mark "
        "that line active, and switch the nonlinear compensation of the axis on (MP730 of older controls). Positions "
        "are from the machine datum. Older controls want spacings of a power of two times 0.0001 mm and steps "
        "between neighbours of at most a 64th of the spacing.",
    .verified =
        "The columns AXISPOS, BACKLASH (values of the negative direction) and one of the axis' name, config.cma, "
        "that a rotary axis has 0 to 360: pages of technical manuals.",
    .inferred =
        "The sign; that BACKLASH holds the whole value of the negative direction and not the difference; the lines "
        "of the head and the widths of the columns. A re-test after loading tells sign and BACKLASH. How it is loaded.",
    .turned_sign =
        "A positive number moves the axis in the positive direction: it is what is too short (turned against what was "
        "inferred).",
    .write = heidenhain::write,
    .read = heidenhain::read,
    .recognises =
        [](std::string_view text) {
          return text.starts_with("BEGIN ") && text.substr(0, 256).find("AXISPOS") != text.npos;
        },
};

}  // namespace axiometry::nc
