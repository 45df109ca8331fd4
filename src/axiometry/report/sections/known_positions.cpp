// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/sections/known_positions.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/report/sections/sections.h"

namespace axiometry::report {
namespace {

constexpr std::size_t known_rows_most = 120;  // JSON has all

Paragraph known_in_words(const KnownPositions& known, AxisKind kind, const Options& options) {
  const auto text = [&](double x) {
    return fmt::format("{} {}", format_fixed(x, 2, options.numbers), deviation_unit(kind));
  };
  if (!known.at_targets)
    return {plain("To within what positions are known nobody can say; the notes tell why."), Tone::caution};
  std::string words = fmt::format(
      "At each target about 95 % of approaches or more will end within {} of their position, once the zero is shifted "
      "by {}, if the axis stays as it is.",
      text(*known.at_targets), text(known.zero));
  words += known.anywhere
               ? fmt::format(" Anywhere between the first target and the last: within {}.", text(*known.anywhere))
               : " What it is between the targets nobody can say; the notes tell why.";
  return {plain(words), Tone::normal};
}

Table known_table(const KnownPositions& known, AxisKind kind, const Options& options) {
  Table table;
  const std::string_view unit = deviation_unit(kind);
  table.columns = {{plain(fmt::format("Target / {}", position_unit(kind))), Align::decimal, true},
                   {plain(fmt::format("Left ↑ / {}", unit)), Align::decimal},
                   {plain(fmt::format("U / {}", unit)), Align::decimal},
                   {plain(fmt::format("Left ↓ / {}", unit)), Align::decimal},
                   {plain(fmt::format("U / {}", unit)), Align::decimal}};
  const auto number = [&](double x) { return text_cell(format_fixed(x, 2, options.numbers)); };
  const auto add = [&](std::size_t k) {
    const KnownPositions::Row& target = known.targets[k];
    auto& row = table.rows.emplace_back();
    row.push_back(text_cell(format_fixed(target.target.in_native(), 4, options.numbers)));
    for (const auto* side : {&target.up, &target.down}) {
      row.push_back(*side ? number((*side)->residual) : quiet_cell("–"));
      row.push_back(*side && (*side)->U ? number(*(*side)->U) : quiet_cell("–"));
    }
  };
  const std::size_t count = known.targets.size();
  const std::size_t step = count <= known_rows_most ? 1 : (count - 2) / (known_rows_most - 1) + 1;
  for (std::size_t k = 0; k + 1 < count; k += step) add(k);
  add(count - 1);
  table.notes = {
      plain("Left: the mean deviation with the table as the control reads and rounds it, about the mean of all, by the "
            "readings that made the table."),
      plain(
          "U: of the position that one approach ends at, for about 95 %: the uncertainty of the mean deviation (Lira & "
          "Cargill, eq. 8), and the scatter of the approach itself.")};
  for (const std::string& note : known.notes) table.notes.push_back(sentence(note));
  if (step > 1)
    table.notes.push_back(
        plain(fmt::format("{} of {} targets: the result as JSON has all.", table.rows.size(), count)));
  table.dense = true;
  return table;
}

}  // namespace

Section known_positions_section(const KnownPositions& known, AxisKind kind, const Options& options) {
  Section section{"known", "Known to within, with the table", true, {}};
  section.blocks.emplace_back(known_in_words(known, kind, options));
  section.blocks.emplace_back(known_table(known, kind, options));
  return section;
}

}  // namespace axiometry::report
