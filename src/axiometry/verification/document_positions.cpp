// SPDX-License-Identifier: Apache-2.0
// Readings and results at the targets.
#include <fmt/format.h>

#include <string>
#include <utility>

#include "axiometry/verification/document_parts.h"

namespace axiometry::verification {
namespace {

constexpr std::string_view up_arrow = "↑";
constexpr std::string_view down_arrow = "↓";

bool is_of_readings(const PrintedTable& table) {
  for (std::size_t k = 0; k < table.column_count(); ++k)
    if (table.group(k).starts_with("Approach ")) return true;
  return false;
}

void check_target(const PrintedTable& table, std::size_t row, std::size_t target, const Page& page) {
  page.ledger.text([&] { return fmt::format("target {} in \"{}\"", target + 1, table.caption()); },
                   table.cell(row, std::size_t{1}), page.found.positions[target].target, Interval::of(1e-12));
}

/// A cell that may be empty.
void check_cell(const PrintedTable& table, std::size_t row, std::size_t column, const Exact& right, const Page& page) {
  const std::string printed = table.cell(row, column);
  const auto place = [&] {
    return fmt::format("{} {} of target {} in \"{}\"", table.group(column), table.head(column),
                       table.cell(row, std::size_t{0}), table.caption());
  };
  if (right && !says_nothing(printed)) return page.ledger.text(place, printed, *right, page.found.rounding);
  ++page.ledger.figures;
  if (right || !says_nothing(printed)) page.ledger.differ(place(), printed, right ? shown(*right, 8) : "nothing");
}

void check_readings_table(const PrintedTable& table, const Series& series, const Page& page) {
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto target = target_of(table, row, series.target_count());
    if (!target) {
      page.ledger.differ(fmt::format("line {} of \"{}\"", row + 1, table.caption()), table.cell(row, std::size_t{0}),
                         "the number of a target");
      continue;
    }
    check_target(table, row, *target, page);
    for (std::size_t column = 2; column < table.column_count(); ++column) {
      // "j = 1" and then "2", "3", …
      const std::string_view head = table.head(column);
      const auto run = decimal_of(head.substr(head.rfind(' ') + 1));
      if (!run || run->digits < 1 || run->digits > series.run_count()) continue;
      const Direction direction = table.group(column).contains(down_arrow) ? Direction::down : Direction::up;
      const auto reading = series.reading(*target, direction, run->digits.convert_to<std::size_t>() - 1);
      check_cell(table, row, column, reading ? Exact(Interval::of(reading->in_native())) : std::nullopt, page);
    }
  }
}

Exact around(const ExactCell& cell, int factor) {
  if (!cell.mean || !cell.s) return std::nullopt;
  return *cell.mean + Interval(factor) * *cell.s;
}

/// What a column of results shows, by the words of its head: "x̄_i↑", "s_i", "2s_i", "x̄ − 2s", "R_i", "B_i".
std::optional<Exact> quantity_of(std::string_view head, std::string_view group, const ExactPosition& p) {
  const bool one_way = group.contains(up_arrow) || group.contains(down_arrow);
  const ExactCell& cell = group.contains(down_arrow) ? p.down : p.up;
  const bool is_down = group.contains(down_arrow);
  if (head.contains("− 2s")) return around(cell, -2);
  if (head.contains("+ 2s")) return around(cell, 2);
  if (head.starts_with("2s")) return cell.s ? Exact(Interval(2) * *cell.s) : std::nullopt;
  if (head.starts_with("s")) return cell.s;
  if (head.starts_with("x")) return one_way ? cell.mean : p.mean();
  if (head.starts_with("B")) return p.reversal();
  if (!head.starts_with("R")) return std::nullopt;
  if (!one_way) return p.R();
  return is_down ? p.R_down() : p.R_up();
}

void check_results_table(const PrintedTable& table, const Page& page) {
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto target = target_of(table, row, page.found.positions.size());
    if (!target) continue;
    const ExactPosition& position = page.found.positions[*target];
    check_target(table, row, *target, page);
    for (std::size_t column = 2; column < table.column_count(); ++column)
      if (const auto right = quantity_of(table.head(column), table.group(column), position))
        check_cell(table, row, column, *right, page);
  }
}

}  // namespace

std::optional<std::size_t> target_of(const PrintedTable& table, std::size_t row, std::size_t targets) {
  const auto number = decimal_of(table.cell(row, std::size_t{0}));
  if (!number || number->exponent != 0 || number->digits < 1 || number->digits > targets) return std::nullopt;
  return number->digits.convert_to<std::size_t>() - 1;
}

void check_position_section(const report::Section& section, const Page& page) {
  bool results = false;
  bool readings = false;
  for (const report::Block& block : section.blocks) {
    const auto* table = std::get_if<report::Table>(&block);
    if (table == nullptr) continue;
    const PrintedTable printed(*table);
    if (is_of_readings(printed)) {
      const bool as_measured = printed.caption().contains("as measured");
      const Series* series = as_measured ? page.evidence.as_measured : &page.evidence.series;
      if (series != nullptr) check_readings_table(printed, *series, page);
      readings = readings || !as_measured;
    } else if (printed.caption().contains("Results at the targets")) {
      check_results_table(printed, page);
      results = true;
    }
  }
  if (!results || !readings)
    page.ledger.differ("the tables of readings and results at the targets", "nothing", "both of them");
}

}  // namespace axiometry::verification
