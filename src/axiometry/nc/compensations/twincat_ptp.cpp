// SPDX-License-Identifier: Apache-2.0
//
// Position compensation of TwinCAT PTP: an array of positions and of what is added to them, as the PLC initialises it.
#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable twincat_ptp_axis_table;

namespace twincat_ptp {
namespace {

constexpr std::string_view behind_axis = "_Compensation";  // stands behind the axis in the name of the array
constexpr std::string_view sign = "A positive number moves the axis in the positive direction: it is added.";

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, twincat_ptp_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  const std::size_t last = correction.positions().size() - 1;
  std::string text = comment_lines("//", sign);
  fmt::format_to(std::back_inserter(text), "{}{} : ARRAY[0..{}] OF ST_PositionCompensationTableElement := [\n",
                 options.axis, behind_axis, last);
  for (std::size_t k = 0; k <= last; ++k)
    fmt::format_to(
        std::back_inserter(text), "  (Position := {}, Compensation := {}){}\n",
        fixed_number(correction.positions()[k] / position_per_unit(options), table_decimals(options)),
        fixed_number(correction.values(Direction::up)[k] * unit_per_deviation(options), table_decimals(options)),
        k < last ? "," : "];");
  return text;
}

/// "(Position := A, Compensation := B)" with what ends it.
struct Element {
  double position = 0.0, compensation = 0.0;
  bool is_last = false;
};
std::optional<Element> element_of(std::string_view text) {
  Element element;
  text = text::trim(text);
  if (text.ends_with("];")) {
    element.is_last = true;
    text.remove_suffix(2);
  } else if (text.ends_with(',')) {
    text.remove_suffix(1);
  } else {
    return std::nullopt;
  }
  text = text::trim(text);
  if (text.size() < 2 || text.front() != '(' || text.back() != ')') return std::nullopt;
  const std::vector<std::string_view> parts = text::split(text.substr(1, text.size() - 2), ',');
  if (parts.size() != 2) return std::nullopt;
  for (const std::size_t k : {0uz, 1uz}) {
    const std::size_t assigned = parts[k].find(":=");
    if (assigned == std::string_view::npos) return std::nullopt;
    const auto number = parse_number(text::trim(parts[k].substr(assigned + 2)));
    if (!number ||
        !text::equal_ignoring_case(text::trim(parts[k].substr(0, assigned)), k == 0 ? "Position" : "Compensation"))
      return std::nullopt;
    (k == 0 ? element.position : element.compensation) = *number;
  }
  return element;
}

/// N of "NAME : ARRAY[0..N] OF …".
std::optional<long long> last_index(std::string_view text) {
  const std::size_t begin = text.find("ARRAY[0.."), end = text.find(']');
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) return std::nullopt;
  return whole_number(text.substr(begin + 9, end - begin - 9));
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  const bool is_named_for_axis = text.contains(sign);  // the array, as it is here; elsewhere its name says nothing
  AxisTableOptions named = options;
  std::optional<long long> stated;
  bool is_closed = false;
  std::vector<double> positions, values;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text.substr(0, line.text.find("//")));
    if (line.text.empty()) continue;
    if (!stated) {
      stated = last_index(line.text);
      if (!stated) return refused(line, "NAME : ARRAY[0..N] OF ST_PositionCompensationTableElement := [");
      std::string_view name = text::trim(line.text.substr(0, line.text.find(':')));
      if (is_named_for_axis && name.ends_with(behind_axis) && name != behind_axis) {
        name.remove_suffix(behind_axis.size());
        AXIOMETRY_TRY_VOID(check_axis_named(name, named, line));
      }
      continue;
    }
    const auto element = is_closed ? std::nullopt : element_of(line.text);
    if (!element) return refused(line, "(Position := A, Compensation := B), and ]; behind the last");
    positions.push_back(element->position * position_per_unit(options));
    values.push_back(element->compensation / unit_per_deviation(options));
    is_closed = element->is_last;
  }
  if (!is_closed || *stated + 1 != std::ssize(values))
    return fail(
        fmt::format("found {} elements, expected {} and ]; behind the last", values.size(), stated.value_or(-1) + 1));
  std::vector<double> down = values;
  return AxisCorrection::make(options.kind, std::move(positions), std::move(values), std::move(down));
}

}  // namespace
}  // namespace twincat_ptp

const AxisTable twincat_ptp_axis_table = {
    .id = "twincat-ptp",
    .title = "Beckhoff TwinCAT PTP, table of position compensation",
    .extension = ".st",
    .curves = TableCurves::both_ways,
    .limits = {.closes = true},
    .sign = twincat_ptp::sign,
    .loading =
        "Put the array among the variables of the PLC and hand it to the function block of position compensation, "
        "with the axis in the units of the table (mm or inch as it is scaled; degrees), then enable the block.",
    .verified =
        "That the table is an array of Position and Compensation, LREAL, and that the compensation is added: the "
        "manual of the function block.",
    .inferred =
        "The name of the structure's type. That positions beyond the ends hold the end's value. How it is loaded.",
    .write = twincat_ptp::write,
    .read = twincat_ptp::read,
    .recognises =
        [](std::string_view text) {
          return text.substr(0, 4096).find("PositionCompensationTableElement") != text.npos;
        },
};

}  // namespace axiometry::nc
