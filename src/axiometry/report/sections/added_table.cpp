// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/sections/added_table.h"

#include <fmt/format.h>

#include "axiometry/base/text/number_text.h"
#include "axiometry/report/sections/sections.h"

namespace axiometry::report {

namespace {

/// Two points are a straight line, which some controls continue beyond them.
const char* sign_note(std::size_t positions, bool rolls_over) {
  if (positions <= 2)
    return "Added to the commanded position: a positive value moves the axis in the positive direction.";
  return rolls_over ? "Added to the commanded position: a positive value moves the axis in the positive direction. The "
                      "control interpolates linearly; beyond the ends it does not hold the last value."
                    : "Added to the commanded position: a positive value moves the axis in the positive direction. The "
                      "control interpolates linearly and holds the last value beyond the ends.";
}

}  // namespace

Table added_table(const AxisCorrection& applied, std::size_t rows_most, bool rolls_over, const Options& options) {
  const AxisKind kind = applied.kind();
  const std::size_t count = applied.positions().size();
  Table table;
  table.columns = {{plain(fmt::format("Position / {}", position_unit(kind))), Align::decimal, true},
                   {plain(fmt::format("Added ↑ / {}", deviation_unit(kind))), Align::decimal},
                   {plain(fmt::format("Added ↓ / {}", deviation_unit(kind))), Align::decimal}};
  const auto add = [&](std::size_t k) {
    table.rows.push_back({text_cell(format_fixed(applied.positions()[k], 4, options.numbers)),
                          text_cell(format_fixed(applied.values(Direction::up)[k], 3, options.numbers)),
                          text_cell(format_fixed(applied.values(Direction::down)[k], 3, options.numbers))});
  };
  const std::size_t spaces = rows_most > 2 ? rows_most - 1 : 1;
  const std::size_t step = count <= rows_most ? 1 : (count - 2) / spaces + 1;
  for (std::size_t k = 0; k + 1 < count; k += step) add(k);
  add(count - 1);
  table.notes = {plain(sign_note(count, rolls_over))};
  if (step > 1)
    table.notes.push_back(
        plain(fmt::format("{} of {} positions: all are in the file for the control.", table.rows.size(), count)));
  table.dense = true;
  return table;
}

}  // namespace axiometry::report
