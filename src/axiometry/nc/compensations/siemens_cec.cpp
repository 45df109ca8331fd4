// SPDX-License-Identifier: Apache-2.0
//
// Sag and angularity compensation of SINUMERIK: a table for each direction of travel of the input axis, which is moved
// itself, or another one.
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/compensations/siemens_lines.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable siemens_cec_axis_table;

namespace siemens_cec {
namespace {

constexpr std::string_view sign =
    "A positive number moves the axis in the negative direction: it is what is too far (inferred of these tables).";

const std::string& output_of(const AxisTableOptions& options) {
  return options.output_axis.empty() ? options.axis : options.output_axis;
}

void write_table(std::string& text, unsigned table, std::string_view direction, const std::vector<double>& values,
                 const siemens::Grid& grid, const AxisTableOptions& options, bool is_modulo) {
  for (std::size_t k = 0; k < values.size(); ++k)
    fmt::format_to(std::back_inserter(text), "$AN_CEC[{},{}]={}\n", table, k,
                   fixed_number(-values[k] * unit_per_deviation(options), table_decimals(options)));
  fmt::format_to(std::back_inserter(text),
                 "$AN_CEC_INPUT_AXIS[{0}]=({1})\n$AN_CEC_OUTPUT_AXIS[{0}]=({7})\n$AN_CEC_STEP[{0}]={2}\n"
                 "$AN_CEC_MIN[{0}]={3}\n$AN_CEC_MAX[{0}]={4}\n$AN_CEC_DIRECTION[{0}]={5}\n"
                 "$AN_CEC_MULT_BY_TABLE[{0}]=0\n$AN_CEC_IS_MODULO[{0}]={6}\n",
                 table, options.axis, grid.step, grid.first, grid.last, direction, is_modulo ? 1 : 0,
                 output_of(options));
}

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, siemens_cec_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  AxisTableOptions output = options;
  output.axis = output_of(options);
  AXIOMETRY_TRY_VOID(check_axis_word(output));
  const siemens::Grid grid = siemens::grid_of_table(correction, options);
  const bool is_modulo = is_whole_turn(correction);
  std::string text = "%_N_NC_CEC_INI\nCHANDATA(1)\n" + comment_lines(";", sign_of(siemens_cec_axis_table, options));
  const bool is_one = correction.same_both_ways();
  write_table(text, options.number, is_one ? "0" : "1", correction.values(Direction::up), grid, options, is_modulo);
  if (!is_one)
    write_table(text, options.number + 1, "-1", correction.values(Direction::down), grid, options, is_modulo);
  return text + "M17\n";
}

struct Table {
  siemens::Values values;
  siemens::Frame frame;
  std::optional<double> direction, multiplied;
  bool has_input = false, has_output = false;
};

Result<void> take_axis(const TableLine& line, const Assignment& a, AxisTableOptions& options, bool& has_it) {
  std::string_view axis = a.value;
  if (axis.size() > 2 && axis.front() == '(' && axis.back() == ')') axis = text::trim(axis.substr(1, axis.size() - 2));
  if (has_it || !is_axis_named(axis, options))
    return fail(fmt::format("found the axis {}, expected {} once", text::quoted(axis), text::quoted(options.axis)),
                {line.number, 0});
  has_it = true;
  return {};
}

Result<void> take_output(const TableLine& line, const Assignment& a, AxisTableOptions& options, bool& has_it) {
  if (options.output_axis.empty()) return take_axis(line, a, options, has_it);
  AxisTableOptions output = options;
  output.axis = options.output_axis;
  output.axis_told = true;
  return take_axis(line, a, output, has_it);
}

Result<void> take(const TableLine& line, AxisTableOptions& options, std::map<long long, Table>& tables) {
  constexpr std::string_view expected = "$AN_CEC[TABLE,N]=NUMBER or what belongs to it";
  constexpr long long tables_most = 1000;
  const auto a = assignment_of(line.text);
  const auto number = a && !a->indices.empty() ? whole_number(a->indices[0]) : std::nullopt;
  if (!number || *number < 0 || *number > tables_most) return refused(line, expected);
  Table& table = tables[*number];
  const std::string name = text::to_lower(a->name);
  if (name == "$an_cec_input_axis") return take_axis(line, *a, options, table.has_input);
  if (name == "$an_cec_output_axis") return take_output(line, *a, options, table.has_output);
  const auto value = parse_number(a->value);
  if (!value) return refused(line, expected);
  if (name == "$an_cec" && a->indices.size() == 2) return table.values.put(a->indices[1], *value, line);
  if (!name.starts_with("$an_cec_") || a->indices.size() != 1) return refused(line, expected);
  const std::string_view part = std::string_view(name).substr(8);
  if (part == "direction" && !table.direction) {
    if (*value != 0.0 && *value != 1.0 && *value != -1.0) return refused(line, "a direction of 0, 1 or -1");
    table.direction = value;
    return {};
  }
  if (part == "mult_by_table" && !table.multiplied) {
    if (*value != 0.0) return refused(line, "a table that is not multiplied by another");
    table.multiplied = value;
    return {};
  }
  if (!table.frame.put(part, *value)) return refused(line, expected);
  return {};
}

Result<AxisCorrection> curve_of(const Table& table, const AxisTableOptions& options) {
  if (!table.has_input || !table.has_output || !table.direction)
    return fail("found a table without an input axis, an output axis or a direction, expected all three");
  AXIOMETRY_TRY(const std::size_t count, table.frame.points(options));
  AXIOMETRY_TRY(std::vector<double> values, table.values.all(count));
  for (double& value : values) value /= -unit_per_deviation(options);
  const double unit = position_per_unit(options);
  std::vector<double> down = values;
  return even_correction(options.kind, *table.frame.min * unit, *table.frame.step * unit, std::move(values),
                         std::move(down));
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  std::map<long long, Table> tables;
  AxisTableOptions named = options;
  AXIOMETRY_TRY(const std::vector<TableLine> lines, siemens::assignments(text));
  for (const TableLine& line : lines) AXIOMETRY_TRY_VOID(take(line, named, tables));
  std::optional<AxisCorrection> up, down;
  for (const auto& [number, table] : tables) {
    AXIOMETRY_TRY(const AxisCorrection curve, curve_of(table, options));
    for (const auto& [side, other] : {std::pair(&up, -1.0), std::pair(&down, 1.0)}) {
      if (*table.direction == other) continue;
      if (*side) return fail(fmt::format("found table {} beside another of its direction, expected one", number));
      *side = curve;
    }
  }
  if (!up || !down) return fail("found a table for one direction, expected one for each, or one for both");
  if (up->positions() != down->positions())
    return fail("found tables of different positions for the two directions, expected the same");
  return AxisCorrection::make(options.kind, up->positions(), up->values(Direction::up), down->values(Direction::down));
}

}  // namespace
}  // namespace siemens_cec

const AxisTable siemens_cec_axis_table = {
    .id = "siemens-cec",
    .title = "SINUMERIK 840D, 828D, 802D, a table for each direction (CEC)",
    .extension = ".ini",
    .curves = TableCurves::each_way,
    .limits = {.equidistant = true, .closes = true},
    .uses = {.number = true, .output_axis = true, .turned_sign = true},
    .sign = siemens_cec::sign,
    .loading =
        "MD18342[t] must be at least the number of points (828D: 8 tables of at most 200). Switch the tables off "
        "(MD32710 of the axis, SD41300[t]), load the file as a part program of initialisation, switch both on, "
        "reference the axis. MD32720 limits what the tables add. The axis is named as the machine axis, AX1.",
    .verified =
        "Layout, names, and that two tables with opposite directions give a position-dependent backlash: manuals "
        "of 802D, 828D and 840D.",
    .inferred =
        "The sign: taken as that of the leadscrew errors of the same control. A re-test after loading tells it. "
        "That comments behind ; are taken in the file. How the tables are switched off and on.",
    .turned_sign =
        "A positive number moves the axis in the positive direction: it is what is too short (turned against what was "
        "inferred).",
    .write = siemens_cec::write,
    .read = siemens_cec::read,
    .recognises = [](std::string_view text) { return text.substr(0, 4096).find("$AN_CEC") != text.npos; },
};

}  // namespace axiometry::nc
