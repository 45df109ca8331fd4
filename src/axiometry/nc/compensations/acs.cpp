// SPDX-License-Identifier: Apache-2.0
//
// ACS motion controllers: the command of the motor is that of the axis and a MAP() of it, an array of points at one
// spacing, interpolated between.
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable acs_axis_table;

namespace acs {
namespace {

constexpr std::string_view before_axis = "Comp";  // stands before the axis in the name of the array
constexpr std::string_view sign = "A positive number moves the axis in the positive direction: it is added.";

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, acs_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  const std::vector<double>& positions = correction.positions();
  const auto step = common_step(positions);
  AXIOMETRY_CONTRACT(step);  // check_limits()
  const double unit = position_per_unit(options);
  const std::string name = std::string(before_axis) + options.axis;
  std::string text = comment_lines("!", sign);
  fmt::format_to(std::back_inserter(text), "GLOBAL REAL {}({})\n", name, positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k)
    fmt::format_to(
        std::back_inserter(text), "{}({})={}\n", name, k,
        fixed_number(correction.values(Direction::up)[k] * unit_per_deviation(options), table_decimals(options)));
  fmt::format_to(
      std::back_inserter(text),
      "MFLAGS({0}).#DEFCON=0\nCONNECT RPOS({0})=APOS({0})+MAP(APOS({0}),{1},{2},{3})\nDEPENDS {0},{0}\nSTOP\n",
      options.number, name, trimmed_fixed(positions.front() / unit, table_decimals(options)),
      trimmed_fixed(*step / unit, table_decimals(options) + 2));
  return text;
}

struct Program {
  bool is_named_for_axis = false;  ///< the array, as it is here; elsewhere "CompTable" is a name like any
  std::string_view name{};
  long long size = 0;
  std::map<long long, double> points{};
  std::optional<std::pair<double, double>> start_and_step{};
};

Result<void> take_connect(const TableLine& line, const AxisTableOptions& options, Program& program) {
  const std::string head = fmt::format("CONNECT RPOS({0})=APOS({0})+MAP(APOS({0}),", options.number);
  constexpr std::string_view expected = "CONNECT RPOS(AXIS)=APOS(AXIS)+MAP(APOS(AXIS),NAME,START,STEP) of this axis";
  if (!line.text.starts_with(head) || !line.text.ends_with(')') || program.start_and_step)
    return refused(line, expected);
  const auto parts = text::split(line.text.substr(head.size(), line.text.size() - head.size() - 1), ',');
  if (parts.size() != 3 || text::trim(parts[0]) != program.name) return refused(line, expected);
  const auto start = parse_number(text::trim(parts[1])), step = parse_number(text::trim(parts[2]));
  if (!start || !step || !(*step > 0.0)) return refused(line, expected);
  program.start_and_step = {*start, *step};
  return {};
}

Result<void> take(const TableLine& line, AxisTableOptions& options, Program& program) {
  constexpr std::string_view global = "GLOBAL REAL ";
  if (line.text.starts_with(global)) {
    const std::string_view declared = line.text.substr(global.size());
    const std::size_t bracket = declared.find('(');
    const auto size = bracket == std::string_view::npos || !declared.ends_with(')')
                          ? std::nullopt
                          : whole_number(declared.substr(bracket + 1, declared.size() - bracket - 2));
    if (!size || *size < 2 || !program.name.empty()) return refused(line, "GLOBAL REAL NAME(SIZE), once");
    program.name = text::trim(declared.substr(0, bracket));
    if (program.is_named_for_axis && program.name.starts_with(before_axis) && program.name != before_axis)
      AXIOMETRY_TRY_VOID(check_axis_named(program.name.substr(before_axis.size()), options, line));
    program.size = *size;
    return {};
  }
  if (line.text.starts_with("CONNECT ")) return take_connect(line, options, program);
  const std::array known = {fmt::format("MFLAGS({}).#DEFCON=0", options.number),
                            fmt::format("DEPENDS {0},{0}", options.number), std::string("STOP")};
  if (text::is_one_of(line.text, known)) return {};
  const auto a = assignment_of(line.text);
  const auto k = a && a->indices.size() == 1 && a->name == program.name ? whole_number(a->indices[0]) : std::nullopt;
  const auto value = a ? parse_number(a->value) : std::nullopt;
  if (!k || *k < 0 || *k >= program.size || !value) return refused(line, "NAME(POINT)=NUMBER within its size");
  if (!program.points.emplace(*k, *value).second) return refused(line, "each point once");
  return {};
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  Program program{.is_named_for_axis = text.contains(sign)};
  AxisTableOptions named = options;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text.substr(0, line.text.find('!')));
    if (!line.text.empty()) AXIOMETRY_TRY_VOID(take(line, named, program));
  }
  if (!program.start_and_step) return fail("found no CONNECT of this axis, expected one");
  if (std::ssize(program.points) != program.size)
    return fail(
        fmt::format("found {} points, expected {}, the size of the array", program.points.size(), program.size));
  std::vector<double> values;
  for (const auto& [k, value] : program.points) values.push_back(value / unit_per_deviation(options));
  std::vector<double> down = values;
  const double unit = position_per_unit(options);
  return even_correction(options.kind, program.start_and_step->first * unit, program.start_and_step->second * unit,
                         std::move(values), std::move(down));
}

}  // namespace
}  // namespace acs

const AxisTable acs_axis_table = {
    .id = "acs",
    .title = "ACS SPiiPlus, MAP in the command of the motor",
    .extension = ".prg",
    .curves = TableCurves::both_ways,
    .limits = {.equidistant = true, .closes = true},
    .uses = {.number = true},
    .sign = acs::sign,
    .loading =
        "Load it into a buffer and run that once the axis is homed, as part of the start. The number is the axis of "
        "the controller; the table is in its user units, mm (or inch) and degrees.",
    .verified =
        "The commands, and that the table is added to the command of the motor: a script in use that writes them.",
    .inferred = "That the ends hold beyond the table.",
    .write = acs::write,
    .read = acs::read,
    .recognises = [](std::string_view text) { return text.substr(0, 1024).find("GLOBAL REAL Comp") != text.npos; },
};

}  // namespace axiometry::nc
