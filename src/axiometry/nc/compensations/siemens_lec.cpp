// SPDX-License-Identifier: Apache-2.0
//
// Leadscrew error compensation of SINUMERIK: interpolated between points of one spacing, the ends held. What is in the
// table is taken off the command: a positive value moves the axis in the negative direction.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/compensations/siemens_lines.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable siemens_lec_axis_table;

namespace siemens_lec {
namespace {

constexpr std::string_view sign = "A positive number moves the axis in the negative direction: it is what is too far.";

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, siemens_lec_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  const siemens::Grid grid = siemens::grid_of_table(correction, options);
  const std::string place = fmt::format("[{},{}]", options.number, options.axis);
  AXIOMETRY_TRY(const double backlash, backlash_of(correction));
  std::string text = "%_N_AX_EEC_INI\nCHANDATA(1)\n" + comment_lines(";", sign);
  if (backlash != 0.0) text += backlash_line(";", siemens_lec_axis_table, backlash, options);
  for (std::size_t k = 0; k < correction.positions().size(); ++k)
    fmt::format_to(
        std::back_inserter(text), "$AA_ENC_COMP[{},{},{}]={}\n", options.number, k, options.axis,
        fixed_number(-correction.values(Direction::up)[k] * unit_per_deviation(options), table_decimals(options)));
  fmt::format_to(std::back_inserter(text),
                 "$AA_ENC_COMP_STEP{0}={1}\n$AA_ENC_COMP_MIN{0}={2}\n$AA_ENC_COMP_MAX{0}={3}\n"
                 "$AA_ENC_COMP_IS_MODULO{0}={4}\nM17\n",
                 place, grid.step, grid.first, grid.last, is_whole_turn(correction) ? 1 : 0);
  return text;
}

struct Found {
  siemens::Values values;
  siemens::Frame frame;
};

/// One line of the table of this axis and encoder.
Result<void> take(const TableLine& line, AxisTableOptions& options, Found& found) {
  constexpr std::string_view expected =
      "$AA_ENC_COMP[ENCODER,N,AXIS]=NUMBER or one of its _STEP, _MIN, _MAX, _IS_MODULO";
  const auto assignment = assignment_of(line.text);
  const auto value = assignment ? parse_number(assignment->value) : std::nullopt;
  if (!value || assignment->indices.size() < 2) return refused(line, expected);
  AXIOMETRY_TRY_VOID(check_axis_named(assignment->indices.back(), options, line));
  if (whole_number(assignment->indices[0]) != static_cast<long long>(options.number))
    return fail(
        fmt::format("found the encoder {}, expected {} alone", text::quoted(assignment->indices[0]), options.number),
        {line.number, 0});
  const std::string name = text::to_lower(assignment->name);
  if (name == "$aa_enc_comp" && assignment->indices.size() == 3)
    return found.values.put(assignment->indices[1], *value, line);
  if (name.starts_with("$aa_enc_comp_") && assignment->indices.size() == 2 &&
      found.frame.put(std::string_view(name).substr(13), *value))
    return {};
  return refused(line, expected);
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  Found found;
  AxisTableOptions named = options;
  AXIOMETRY_TRY(const std::vector<TableLine> lines, siemens::assignments(text));
  for (const TableLine& line : lines) AXIOMETRY_TRY_VOID(take(line, named, found));
  AXIOMETRY_TRY(const std::size_t count, found.frame.points(options));
  AXIOMETRY_TRY(std::vector<double> values, found.values.all(count));
  for (double& value : values) value /= -unit_per_deviation(options);
  const double unit = position_per_unit(options);
  AXIOMETRY_TRY(const double backlash, backlash_in(text, ";", siemens_lec_axis_table, options));
  std::vector<double> down = values;
  for (double& value : down) value -= backlash;
  return even_correction(options.kind, *found.frame.min * unit, *found.frame.step * unit, std::move(values),
                         std::move(down));
}

}  // namespace
}  // namespace siemens_lec

const AxisTable siemens_lec_axis_table = {
    .id = "siemens-lec",
    .title = "SINUMERIK 840D, 828D, 808D, leadscrew errors (EEC)",
    .extension = ".ini",
    .curves = TableCurves::both_ways,
    .limits = {.equidistant = true, .closes = true},
    .uses = {.number = true},
    .sign = siemens_lec::sign,
    .loading =
        "MD38000 must be at least the number of points (808D: at most 200), and changing it clears the memory. Set "
        "MD32700 of the axis to 0, load the file as a part program of initialisation, set MD32700 to 1, reference the "
        "axis. The unit is that of MD10240. With one curve, and a number for the reversal beside it, the head of the "
        "file says what is to be added to MD32450 (BACKLASH). All points of an old table are replaced only where the "
        "new one has as many.",
    .verified =
        "Layout, names, sign, that the ends hold and that one curve serves both directions: function manuals of 840D, "
        "828D and 808D. That MD32450 is positive where the encoder leads the machine, which is lost motion, and may be "
        "negative: parameter manual of 808D.",
    .inferred =
        "That comments behind ; are taken in the file. That MD32450 is driven in full at each reversal into the "
        "negative "
        "direction, as it is predicted.",
    .backlash = "MD32450",
    .write = siemens_lec::write,
    .read = siemens_lec::read,
    .recognises = [](std::string_view text) { return text.substr(0, 4096).find("$AA_ENC_COMP") != text.npos; },
};

}  // namespace axiometry::nc
