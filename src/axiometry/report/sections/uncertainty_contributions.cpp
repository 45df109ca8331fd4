// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/figures/contribution.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

using iso230_2::Contribution;

/// What it pays most to improve, parameter by parameter.
Facts advice(const std::vector<Contribution>& all, const Subject& subject, const Options& options) {
  Facts facts{
      fmt::format("What to improve first ({})", iso230_2::method_title(contributing_method(subject.assessment))), {}};
  for (std::size_t p : main_parameters(subject.assessment.evaluation.parameters))
    if (const auto first = leading(all, p, subject.assessment))
      facts.facts.push_back({joined({plain("Uncertainty of "), symbol(iso230_2::parameters[p].symbol)}),
                             text_cell(leading_statement(*first, subject.test.metadata.axis.kind, options) + ".")});
  return facts;
}

/// A last row with u of every parameter. One on which nothing acts has none, which is not 0.
void add_total(Table& table, const Subject& subject, const Options& options) {
  const ParameterScale scale = parameter_scale(subject.test.metadata.axis.kind, options.unit);
  std::vector<TableCell> row = {{strong("All together")}};
  for (std::size_t p = 0; p < std::size(iso230_2::parameters); ++p) {
    if (!(subject.assessment.evaluation.parameters.*iso230_2::parameters[p].member)) continue;
    const double u = standard_uncertainty(subject.assessment, p);
    row.push_back(u > 0.0 ? TableCell{strong(shown_uncertainty(Deviation::native(u), scale, options))}
                          : quiet_cell("–"));
  }
  table.rows.push_back(std::move(row));
}

}  // namespace

Table contribution_table(const std::vector<Contribution>& all, const Subject& subject, const Options& options) {
  const ParameterScale scale = parameter_scale(subject.test.metadata.axis.kind, options.unit);
  Table table;
  table.dense = true;
  table.columns = {{plain("Input"), Align::start, true, true}};
  table.rows.resize(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) table.rows[k].push_back(text_cell(all[k].title));
  for (const auto& parameter : iso230_2::parameters) {
    if (!(subject.assessment.evaluation.parameters.*parameter.member)) continue;
    const auto p = static_cast<std::size_t>(&parameter - iso230_2::parameters);
    table.columns.push_back({symbol(parameter.symbol), Align::decimal});
    for (std::size_t k = 0; k < all.size(); ++k)
      table.rows[k].push_back(all[k].u[p] == 0.0
                                  ? quiet_cell("–")
                                  : text_cell(shown_uncertainty(Deviation::native(all[k].u[p]), scale, options)));
  }
  return table;
}

Section contribution_section(const Subject& subject, const Options& options) {
  Section section{"contributions", "Contributions to the uncertainty", true, {}};
  const auto& assessment = subject.assessment;
  const auto all = contributions(assessment);
  if (auto figure = contribution_figure(subject, options)) {
    section.blocks.emplace_back(advice(all, subject, options));
    section.blocks.emplace_back(*std::move(figure));
  }
  const bool by_trials = !all.empty() && contributing_method(assessment) == iso230_2::UncertaintyMethod::monte_carlo;
  if (by_trials) {
    Table table = contribution_table(all, subject, options);
    const ParameterScale scale = parameter_scale(subject.test.metadata.axis.kind, options.unit);
    table.caption = joined({plain("Monte Carlo: standard uncertainty "), italic("u"),
                            plain(fmt::format(" from each input alone, {}", scale.unit))});
    add_total(table, subject, options);
    table.notes = {
        joined({plain("Every input is varied alone, the others stay at their estimates; all together is "), italic("u"),
                plain(" of the run. The squares add up as far as the evaluation is linear and the inputs "
                      "are independent.")})};
    section.blocks.emplace_back(std::move(table));
  }
  section.blocks.emplace_back(input_table(subject, options));
  return section;
}

}  // namespace axiometry::report
