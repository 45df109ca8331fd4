// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

constexpr std::size_t columns_on_a_page = 12;  // of readings, beside number and position of the target

/// Runs of one direction that stand beside each other.
struct Strip {
  Direction direction = Direction::up;
  std::size_t first_run = 0;
  std::size_t runs = 0;
};

std::vector<Direction> directions_of(const Series& series) {
  std::vector<Direction> directions;
  for (Direction direction : {Direction::up, Direction::down})
    if (series.has(direction)) directions.push_back(direction);
  return directions;
}

/// Both directions side by side while they fit, else a table per direction, else also per part of the runs.
std::vector<std::vector<Strip>> layout(const Series& series) {
  const std::size_t runs = series.run_count();
  const auto directions = directions_of(series);
  std::vector<std::vector<Strip>> tables;
  if (runs * directions.size() <= columns_on_a_page) {
    tables.emplace_back();
    for (Direction direction : directions) tables.back().push_back({direction, 0, runs});
    return tables;
  }
  const std::size_t parts = (runs + columns_on_a_page - 1) / columns_on_a_page;
  const std::size_t each = (runs + parts - 1) / parts;
  for (Direction direction : directions)
    for (std::size_t first = 0; first < runs; first += each)
      tables.push_back({{direction, first, std::min(each, runs - first)}});
  return tables;
}

std::string_view direction_text(Direction direction) {
  return direction == Direction::up ? "Approach ↑ from below" : "Approach ↓ from above";
}

}  // namespace

void note_left_out(Table& table, const ShownTargets& shown) {
  if (shown.note) table.notes.push_back(sentence(*shown.note));
}

std::vector<Table> reading_tables(const Series& series, const ShownTargets& shown, AxisKind kind,
                                  std::string_view title, const Options& options) {
  const int decimals = position_decimals(series.targets());
  std::vector<Table> tables;
  for (const auto& strips : layout(series)) {
    Table table;
    table.dense = true;
    table.caption =
        joined({plain(fmt::format("{} ", title)), symbol("x_ij"), plain(fmt::format(", {}", deviation_unit(kind))),
                plain(tables.empty() ? "" : " (continued)")});
    table.groups = {{plain("Target"), 2}};
    table.columns = {{italic("i"), Align::decimal, true},
                     {joined({symbol("P_i"), plain(fmt::format(", {}", position_unit(kind)))}), Align::decimal}};
    for (const Strip& strip : strips) {
      table.groups.push_back({plain(direction_text(strip.direction)), strip.runs});
      for (std::size_t run = strip.first_run; run < strip.first_run + strip.runs; ++run) {
        const bool first = run == strip.first_run;
        const RichText number = plain(fmt::format("{}", run + 1));
        table.columns.push_back(
            {first ? joined({italic("j"), plain(" = "), number}) : number, Align::decimal, false, false, first});
      }
    }
    for (const std::size_t target : shown.places) {
      std::vector<TableCell> row = {
          text_cell(fmt::format("{}", target + 1)),
          text_cell(format_fixed(series.targets()[target].in_native(), decimals, options.numbers))};
      for (const Strip& strip : strips)
        for (std::size_t run = strip.first_run; run < strip.first_run + strip.runs; ++run)
          row.push_back(deviation_cell(series.reading(target, strip.direction, run), options));
      table.rows.push_back(std::move(row));
    }
    note_left_out(table, shown);
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace axiometry::report
