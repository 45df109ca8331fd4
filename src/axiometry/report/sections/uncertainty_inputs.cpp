// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/method_values.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

using iso230_2::Effect;

/// What one draw of an input is common to.
std::string_view reach(Effect effect) {
  switch (effect) {
    case Effect::displacement: return "any two positions";
    case Effect::target: return "each target";
    case Effect::target_direction: return "each target and direction";
    case Effect::run: return "each run";
    case Effect::reading: return "each reading";
    default: return "the whole test";
  }
}

std::string shown_u(const std::optional<double>& u, const Options& options) {
  return u ? shown_short(*u, options, 3) : "";
}

Table empty_table() {
  Table table;
  table.caption = plain("Inputs and their distributions");
  table.columns = {{plain("Symbol"), Align::start, true},
                   {plain("Input"), Align::start, false, true},
                   {plain("Distribution"), Align::start, false, true},
                   {italic("u"), Align::decimal},
                   {plain("Unit")},
                   {plain("Common to"), Align::start, false, true},
                   {plain("Source")}};
  return table;
}

std::string with_note(const std::string& title, const std::string& note) {
  return note.empty() ? title : fmt::format("{} ({})", title, note);
}

}  // namespace

Table input_table(const Subject& subject, const Options& options) {
  Table table = empty_table();
  const auto& monte_carlo = subject.assessment.monte_carlo;
  if (monte_carlo) {
    for (const auto& input : monte_carlo->inputs)
      table.rows.push_back({{symbol(input.symbol)},
                            text_cell(with_note(input.title, input.note)),
                            text_cell(shown_distribution(input.distribution, options)),
                            text_cell(shown_u(input.distribution.standard_deviation(), options)),
                            text_cell(input.unit),
                            text_cell(reach(input.effect)),
                            quiet_cell(input.source)});
    for (const std::string& note : monte_carlo->notes) table.notes.push_back(sentence(note));
    return table;
  }
  table.columns.erase(table.columns.begin() + 5);
  for (const auto& source : subject.assessment.gum->sources)
    table.rows.push_back(
        {{symbol(source.symbol)},
         text_cell(with_note(source.title, source.note)),
         source.distribution.empty() ? quiet_cell("–") : text_cell(shown_distribution(source.distribution, options)),
         source.u ? text_cell(shown_u(source.u, options)) : quiet_cell("–"),
         text_cell(source.unit),
         quiet_cell(source.source)});
  return table;
}

}  // namespace axiometry::report
