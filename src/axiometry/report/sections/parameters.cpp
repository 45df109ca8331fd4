// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/assumptions.h"
#include "axiometry/report/conformity_text.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/standards/iso230_2/error_symbol.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report {

namespace {

using iso230_2::Judgement;

/// E_XX,A↑: ISO 230-1 names the error of the axis, ISO 230-2 (8.2.4) the parameter of it.
RichText iso230_1_symbol(std::string_view axis_name, std::string_view parameter_symbol) {
  RichText index = symbol(parameter_symbol);
  for (TextRun& run : index) run.script = Script::sub;
  RichText all = italic("E");
  all.push_back({.text = fmt::format("{0}{0},", axis_name), .script = Script::sub});
  return joined({all, index});
}

RichText starred(RichText symbol, bool acceptance) { return acceptance ? joined({symbol, plain("\u2009*)")}) : symbol; }

std::vector<RichText> notes(const Subject& subject, const Options& options) {
  const auto& assessment = subject.assessment;
  const std::string& label = assessment.label;
  std::vector<RichText> notes = {
      plain(!label.empty() ? fmt::format("*) A parameter for machine acceptance by 8.2; this test: {}.", label)
            : assessment.conforming()
                ? std::string("*) May serve as a basis for machine acceptance (8.2).")
                : std::string("*) A parameter for machine acceptance by 8.2; this test departs from the standard, see "
                              "the findings."))};
  const bool repeated = assessment.evaluation.parameters.R_up || assessment.evaluation.parameters.R_down;
  if (!repeated)
    notes.push_back(joined({plain("Repeatabilities "), italic("R"), plain(" and errors "), italic("A"),
                            plain(" do not exist where each target was approached once per direction (6.2).")}));
  const auto method = iso230_2::method_of_record(assessment);
  const bool others =
      assessment.annex_a.has_value() + assessment.gum.has_value() + assessment.monte_carlo.has_value() > 1;
  if (!method) {
    notes.push_back(joined({plain("The measurement uncertainty "), italic("U"),
                            plain(" was not estimated: no input of Annex A was given.")}));
  } else if (others) {
    notes.push_back(plain(method_statement(assessment)));
  }
  if (method == iso230_2::UncertaintyMethod::annex_a && assessment.annex_a && !assessment.annex_a->missing.empty())
    notes.push_back(joined({italic("U"), plain(" covers only the contributors that were given; see the budget.")}));
  if (const std::string late = uncalibrated_statement(subject.judgements, assessment); !late.empty())
    notes.push_back(with_symbols(late));
  for (const std::string& sentence : interval_assumptions(subject, options)) notes.push_back(with_symbols(sentence));
  if (!subject.judgements.empty())
    notes.push_back(
        plain(fmt::format("Decision rule of the verdicts: {}; see Conformity to tolerances.",
                          rule_title(subject.judgements.front().rule, subject.test.metadata.axis.kind, options))));
  return notes;
}

const Judgement* judgement_of(const iso230_2::ParameterInfo& parameter, std::span<const Judgement> judgements) {
  const auto found = std::ranges::find_if(
      judgements, [&](const Judgement& judgement) { return judgement.tolerance.parameter->key == parameter.key; });
  return found == judgements.end() ? nullptr : &*found;
}

/// What stands beside the values, and by which method.
RichText uncertainty_head(const iso230_2::Assessment& assessment, const Options& options) {
  using enum iso230_2::UncertaintyMethod;
  const auto method = iso230_2::method_of_record(assessment);
  if (method == gum) return joined({italic("U"), plain(" (GUM)")});
  if (method == monte_carlo) {
    const double coverage = assessment.monte_carlo ? assessment.monte_carlo->coverage : 0.95;
    return plain(fmt::format("{} (Monte Carlo)", shown_percent(coverage, options)));
  }
  if (method == annex_a) return joined({italic("U"), plain(" (Annex A, "), italic("k"), plain(" = 2)")});
  return italic("U");
}

TableCell uncertainty_cell(const ShownParameter& shown) {
  if (!shown.interval.empty()) return text_cell(shown.interval);
  return shown.U.empty() ? quiet_cell("–") : text_cell(shown.U);
}

/// The columns that this report needs, in their order.
std::vector<Column> columns(bool with_iso230_1, bool with_tolerances, const RichText& uncertainty) {
  std::vector<Column> all = {{plain("Symbol"), Align::start, true}};
  if (with_iso230_1) all.push_back({plain("ISO 230-1")});
  all.push_back({plain("Parameter"), Align::start, false, true});
  all.push_back({plain("Value"), Align::decimal});
  all.push_back({uncertainty, Align::decimal});
  if (with_tolerances) all.push_back({plain("Tolerance"), Align::decimal});
  all.push_back({plain("Unit")});
  if (with_tolerances) all.push_back({plain("Verdict")});
  all.push_back({plain("Clause")});
  return all;
}

std::vector<TableCell> row(const iso230_2::ParameterInfo& parameter, const Subject& subject, bool with_iso230_1,
                           const Options& options) {
  const Axis& axis = subject.test.metadata.axis;
  const ParameterScale scale = parameter_scale(axis.kind, options.unit);
  const Judgement* judgement = judgement_of(parameter, subject.judgements);
  const ShownParameter shown = judgement != nullptr ? show(*judgement, subject.assessment, axis.kind, options)
                                                    : show(parameter, subject.assessment, axis.kind, options);
  const bool exists = (subject.assessment.evaluation.parameters.*parameter.member).has_value();
  const bool with_tolerances = !subject.judgements.empty();
  std::vector<TableCell> row = {{starred(symbol(parameter.symbol), parameter.acceptance)}};
  if (with_iso230_1) row.push_back({iso230_1_symbol(axis.name, parameter.symbol)});
  row.push_back(text_cell(parameter.title));
  row.push_back(exists ? TableCell{strong(shown.value)} : quiet_cell(shown.value));
  row.push_back(uncertainty_cell(shown));
  if (with_tolerances)
    row.push_back(judgement ? text_cell(shown_limit(judgement->tolerance.limit, scale, options)) : quiet_cell(""));
  row.push_back(exists || judgement ? text_cell(shown.unit) : quiet_cell(""));
  if (with_tolerances) row.push_back(judgement ? verdict_cell(judgement->decision.verdict) : quiet_cell(""));
  row.push_back(quiet_cell(parameter.clause));
  return row;
}

}  // namespace

Section parameter_section(const Subject& subject, const Options& options) {
  const Axis& axis = subject.test.metadata.axis;
  const bool with_iso230_1 = !iso230_2::error_symbol(axis).empty();
  Table table;
  table.columns = columns(with_iso230_1, !subject.judgements.empty(), uncertainty_head(subject.assessment, options));
  for (const auto& parameter : iso230_2::parameters)
    table.rows.push_back(row(parameter, subject, with_iso230_1, options));
  table.notes = notes(subject, options);
  return {"parameters", fmt::format("Parameters of the {}", word_for(axis)), true, {std::move(table)}};
}

}  // namespace axiometry::report
