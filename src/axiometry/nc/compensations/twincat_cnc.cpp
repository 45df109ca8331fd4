// SPDX-License-Identifier: Apache-2.0
//
// Axis compensation of ISG kernels, TwinCAT CNC among them: a list achskw of positions and deviations in whole 0.1 µm
// or 0.0001 degrees, for each direction of travel; actual less set position, which the control takes off. The ends
// hold.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable twincat_cnc_axis_table;

namespace twincat_cnc {
namespace {

constexpr double per_position = 1e4;  ///< counts per mm or °
constexpr long long count_most = 999'999'999;

double deviation_of_count(AxisKind kind) { return deviation_per_position(kind) / per_position; }

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, twincat_cnc_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options, "-"));
  const std::vector<double>& positions = correction.positions();
  const auto setpoint = [&](std::size_t k) { return std::llround(positions[k] * per_position); };
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (std::abs(positions[k] * per_position) > static_cast<double>(count_most) ||
        (k > 0 && setpoint(k) == setpoint(k - 1)))
      return fail(fmt::format("found a position of {}, expected them 0.0001 apart at least and at most {} counts",
                              format_rounded(positions[k]), count_most));
  std::string text;
  fmt::format_to(std::back_inserter(text),
                 "kopf.achs_nr {}\nkopf.log_achs_name {}\nkw.ssfk.interval 0\nkw.ssfk.kw_startpos {}\n"
                 "kw.ssfk.kw_nr_max {}\nkw.ssfk.unit 1\nkw.ssfk.bilateral 1\n",
                 options.number > 0 ? options.number : 1, options.axis, setpoint(0), positions.size());
  if (is_whole_turn(correction)) text += "kw.ssfk.modulo 1\n";
  for (std::size_t k = 0; k < positions.size(); ++k)
    fmt::format_to(std::back_inserter(text), "kw.ssfk.table[{}].setpoint {}\n", k, setpoint(k));
  const double count = deviation_of_count(options.kind);
  for (const auto& [name, direction] : {std::pair("pos", Direction::up), std::pair("neg", Direction::down)})
    for (std::size_t k = 0; k < positions.size(); ++k)
      fmt::format_to(std::back_inserter(text), "kw.ssfk.table[{}].{} {}\n", k, name,
                     -counts(correction.values(direction)[k], count));
  return text;
}

struct List {
  std::map<std::string, long long, std::less<>> head;                          ///< "interval", "bilateral", …
  std::map<std::string, std::map<long long, long long>, std::less<>> columns;  ///< "setpoint", "pos", "neg"
};

/// "table[3].pos" behind "kw.ssfk."; nothing where it is no such name.
Result<void> take_entry(const TableLine& line, std::string_view name, long long value, List& list) {
  const std::size_t close = name.find("].");
  const auto k = close == std::string_view::npos ? std::nullopt : whole_number(name.substr(6, close - 6));
  const std::string_view column = close == std::string_view::npos ? "" : name.substr(close + 2);
  if (!k || *k < 0 || (column != "setpoint" && column != "pos" && column != "neg"))
    return refused(line, "kw.ssfk.table[N].setpoint, .pos or .neg");
  if (!list.columns[std::string(column)].emplace(*k, value).second) return refused(line, "each entry once");
  return {};
}

Result<List> list_of(std::string_view text, AxisTableOptions options) {
  List list;
  for (const TableLine& line : lines_of(text)) {
    const std::vector<std::string_view> words = text::words(line.text.substr(0, line.text.find('#')));
    if (words.empty()) continue;
    if (words.size() != 2) return refused(line, "NAME VALUE");
    if (words[0] == "kopf.log_achs_name") {
      if (!is_axis_named(words[1], options))
        return fail(fmt::format("found the axis {}, expected {}", text::quoted(words[1]), text::quoted(options.axis)),
                    {line.number, 0});
      continue;
    }
    const auto value = whole_number(words[1]);
    if (!value) return refused(line, "NAME and a whole number");
    if (words[0] == "kopf.achs_nr") continue;
    if (!words[0].starts_with("kw.ssfk.")) return refused(line, "a line of kopf. or kw.ssfk.");
    const std::string_view name = words[0].substr(8);
    if (name.starts_with("table["))
      AXIOMETRY_TRY_VOID(take_entry(line, name, *value, list));
    else if (!list.head.emplace(std::string(name), *value).second)
      return refused(line, "each item once");
  }
  return list;
}

/// One column, all of its entries.
Result<std::vector<double>> column_of(const List& list, std::string_view name, std::size_t count, double factor) {
  const auto column = list.columns.find(name);
  const std::size_t found = column == list.columns.end() ? 0 : column->second.size();
  if (found != count || found == 0 || column->second.rbegin()->first != static_cast<long long>(count) - 1)
    return fail(
        fmt::format("found {} entries of {}, expected {} (kw_nr_max), from 0 without a gap", found, name, count));
  std::vector<double> values;
  for (const auto& [k, value] : column->second) values.push_back(factor * static_cast<double>(value));
  return values;
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  AXIOMETRY_TRY(const List list, list_of(text, options));
  const auto head = [&](std::string_view name) {
    const auto found = list.head.find(name);
    return found == list.head.end() ? 0 : found->second;
  };
  for (const auto& [name, value] : list.head)
    if (name != "interval" && name != "kw_startpos" && name != "kw_nr_max" && name != "unit" && name != "bilateral" &&
        name != "modulo")
      return fail(
          fmt::format("found kw.ssfk.{}, expected interval, kw_startpos, kw_nr_max, unit, bilateral, modulo or "
                      "table",
                      text::quoted(name)));
  const long long count = head("kw_nr_max");
  if (count < 1 || count > static_cast<long long>(twincat_cnc_axis_table.limits.points))
    return fail(
        fmt::format("found {} positions (kw_nr_max), expected 1 to {}", count, twincat_cnc_axis_table.limits.points));
  if (head("unit") != 1) return fail(fmt::format("found the unit {}, expected 1", head("unit")));
  const auto points = static_cast<std::size_t>(count);
  std::vector<double> positions;
  if (head("interval") > 0) {
    for (long long k = 0; k < count; ++k)
      positions.push_back(static_cast<double>(head("kw_startpos") + k * head("interval")) / per_position);
  } else {
    AXIOMETRY_TRY(positions, column_of(list, "setpoint", points, 1.0));
    for (double& position : positions) position /= per_position;
  }
  const double factor = -deviation_of_count(options.kind);
  AXIOMETRY_TRY(std::vector<double> up, column_of(list, "pos", points, factor));
  std::vector<double> down = up;
  if (head("bilateral") == 0 && list.columns.contains("neg"))
    return fail("found entries of the negative direction without kw.ssfk.bilateral 1, expected it");
  if (head("bilateral") != 0) {
    AXIOMETRY_TRY(down, column_of(list, "neg", points, factor));
  }
  return AxisCorrection::make(options.kind, std::move(positions), std::move(up), std::move(down));
}

}  // namespace
}  // namespace twincat_cnc

const AxisTable twincat_cnc_axis_table = {
    .id = "twincat-cnc",
    .title = "Beckhoff TwinCAT CNC and ISG kernels, axis compensation (achskw)",
    .extension = ".lis",
    .curves = TableCurves::each_way,
    .limits = {.points = 1500, .closes = true},
    .uses = {.number = true, .inch = false},
    .sign = "A positive number moves the axis in the negative direction: it is actual less set position.",
    .loading =
        "Name the list as the axis compensation of this axis among the start-up lists, switch the spindle error "
        "compensation (ssfk) of the axis on, start the control anew, and home the axis. The name of the axis is "
        "kopf.log_achs_name, the number its kopf.achs_nr.",
    .verified =
        "Names, units of 0.1 um and 0.0001 degrees, at most 1500 positions, both directions, that the ends hold, "
        "and the sign by a worked example: the manual of the kernel.",
    .inferred =
        "Which unit kw.ssfk.unit 1 stands for, that modulo 1 is a whole turn, that # begins a comment. How it is "
        "loaded.",
    .write = twincat_cnc::write,
    .read = twincat_cnc::read,
    .recognises = [](std::string_view text) { return text.substr(0, 4096).find("kw.ssfk.") != text.npos; },
};

}  // namespace axiometry::nc
