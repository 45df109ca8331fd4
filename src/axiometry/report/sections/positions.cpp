// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

using iso230_2::PositionResult;
using MaybeDeviation = std::optional<Deviation>;

MaybeDeviation around(const MaybeDeviation& mean, const MaybeDeviation& s, double factor) {
  if (!mean || !s) return std::nullopt;
  return Deviation::native(mean->in_native() + factor * s->in_native());
}

MaybeDeviation twice(const MaybeDeviation& s) {
  if (!s) return std::nullopt;
  return Deviation::native(iso230_2::coverage_factor * s->in_native());
}

/// One column of results, and where its values come from.
struct Quantity {
  std::string_view symbol;
  MaybeDeviation (*value)(const PositionResult&);
};

constexpr double k = iso230_2::coverage_factor;

constexpr Quantity quantities_up[] = {
    {"x̄_i↑", [](const PositionResult& p) { return p.mean_up; }},
    {"s_i↑", [](const PositionResult& p) { return p.s_up; }},
    {"2s_i↑", [](const PositionResult& p) { return twice(p.s_up); }},
    {"x̄ − 2s", [](const PositionResult& p) { return around(p.mean_up, p.s_up, -k); }},
    {"x̄ + 2s", [](const PositionResult& p) { return around(p.mean_up, p.s_up, k); }},
    {"R_i↑", [](const PositionResult& p) { return p.R_up; }},
};

constexpr Quantity quantities_down[] = {
    {"x̄_i↓", [](const PositionResult& p) { return p.mean_down; }},
    {"s_i↓", [](const PositionResult& p) { return p.s_down; }},
    {"2s_i↓", [](const PositionResult& p) { return twice(p.s_down); }},
    {"x̄ − 2s", [](const PositionResult& p) { return around(p.mean_down, p.s_down, -k); }},
    {"x̄ + 2s", [](const PositionResult& p) { return around(p.mean_down, p.s_down, k); }},
    {"R_i↓", [](const PositionResult& p) { return p.R_down; }},
};

constexpr Quantity quantities_both[] = {
    {"x̄_i", [](const PositionResult& p) { return p.mean; }},
    {"B_i", [](const PositionResult& p) { return p.reversal; }},
    {"R_i", [](const PositionResult& p) { return p.R; }},
};

struct QuantityGroup {
  std::string_view title;
  std::vector<Quantity> quantities;
};

/// Those that exist at some target: with one approach per direction there is no s, and nothing made of it.
std::vector<Quantity> existing(std::span<const Quantity> quantities, std::span<const PositionResult> positions) {
  std::vector<Quantity> found;
  for (const Quantity& quantity : quantities)
    if (std::ranges::any_of(positions, [&](const PositionResult& p) { return quantity.value(p).has_value(); }))
      found.push_back(quantity);
  return found;
}

std::vector<QuantityGroup> groups_for(const Series& series, std::span<const PositionResult> positions) {
  const bool up = series.has(Direction::up);
  const bool down = series.has(Direction::down);
  std::vector<QuantityGroup> groups;
  if (up) groups.push_back({"Unidirectional ↑", existing(quantities_up, positions)});
  if (down) groups.push_back({"Unidirectional ↓", existing(quantities_down, positions)});
  if (up && down) groups.push_back({"Bidirectional", existing(quantities_both, positions)});
  std::erase_if(groups, [](const QuantityGroup& group) { return group.quantities.empty(); });
  return groups;
}

Table result_table(const Subject& subject, const ShownTargets& shown, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const auto groups = groups_for(subject.test.series, subject.assessment.evaluation.positions);
  const int decimals = position_decimals(subject.test.series.targets());
  Table table;
  table.dense = true;
  table.caption =
      joined({plain(fmt::format("Table 2 (concluded) – Results at the targets, {}", deviation_unit(kind)))});
  table.groups = {{plain("Target"), 2}};
  table.columns = {{italic("i"), Align::decimal, true},
                   {joined({symbol("P_i"), plain(fmt::format(", {}", position_unit(kind)))}), Align::decimal}};
  for (const auto& group : groups) {
    table.groups.push_back({plain(group.title), group.quantities.size()});
    for (const Quantity& quantity : group.quantities)
      table.columns.push_back(
          {symbol(quantity.symbol), Align::decimal, false, false, &quantity == group.quantities.data()});
  }
  for (const std::size_t place : shown.places) {
    const PositionResult& position = subject.assessment.evaluation.positions[place];
    std::vector<TableCell> row = {text_cell(fmt::format("{}", place + 1)),
                                  text_cell(format_fixed(position.target.in_native(), decimals, options.numbers))};
    for (const auto& group : groups)
      for (const Quantity& quantity : group.quantities)
        row.push_back(deviation_cell(quantity.value(position), options));
    table.rows.push_back(std::move(row));
  }
  note_left_out(table, shown);
  return table;
}

}  // namespace

Section position_section(const Subject& subject, const Options& options) {
  Section section{"positions", "Deviations and results at the target positions", true, {}};
  const Test& test = subject.test;
  const AxisKind kind = test.metadata.axis.kind;
  const ShownTargets shown = shown_targets(subject.assessment.evaluation);
  const std::string_view title =
      test.as_measured ? "Table 2 – Positioning deviations, corrected," : "Table 2 – Positioning deviations";
  for (Table& table : reading_tables(test.series, shown, kind, title, options))
    section.blocks.emplace_back(std::move(table));
  section.blocks.emplace_back(result_table(subject, shown, options));
  if (test.as_measured)
    for (Table& table : reading_tables(*test.as_measured, shown, kind, "Positioning deviations as measured,", options))
      section.blocks.emplace_back(std::move(table));
  return section;
}

}  // namespace axiometry::report
