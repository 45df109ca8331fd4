// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/correction_text.h"
#include "axiometry/report/rules.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {
namespace {

constexpr int least_digits = 2;
constexpr int finest_decimals = 6;

/// "+2.7", "−0.3", "0.0".
std::string with_sign(double x, int decimals, const Options& options) {
  const std::string text = format_fixed(x, decimals, options.numbers);
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return x > 0.0 && !is_zero ? "+" + text : text;
}

/// Decimals of a value beside those of all others.
int decimals_of(double x, int usual) {
  return x == 0.0 ? usual : std::clamp(decimals_for(std::abs(x), least_digits), usual, finest_decimals);
}

std::string percent(double part, const Options& options) {
  const double x = 100.0 * part;
  return format_fixed(x, x == 0.0 ? 0 : std::clamp(decimals_for(std::abs(x), least_digits), 0, finest_decimals),
                      options.numbers) +
         "\u00a0%";
}

/// With the decimals of the value, more where it is narrow.
std::string interval_text(const standards::FigureInterval& interval, int decimals, const Options& options) {
  const double low = interval.low.in_native(), high = interval.high.in_native();
  const int own = decimals_of(high - low, decimals);
  return fmt::format("{} to {}", format_fixed(low, own, options.numbers), format_fixed(high, own, options.numbers));
}

RuleRow rule_row(const standards::ComparedFigure& compared, const Options& options) {
  const standards::RuleFigure& figure = *compared.figure;
  RuleRow row;
  row.title = figure.title;
  row.symbol = figure.symbol;
  row.clause = figure.clause;
  row.absence = compared.absence;
  row.evidence_source = standards::evidence_source(figure.evidence);
  row.evidence = standards::evidence_words(figure.evidence);
  row.departs_by = figure.departs_by;
  const int usual = *options.deviation_decimals;
  const int decimals = compared.value ? decimals_of(compared.value->in_native(), usual) : usual;
  if (compared.value) row.value = format_fixed(compared.value->in_native(), decimals, options.numbers);
  if (compared.interval) row.interval = interval_text(*compared.interval, decimals, options);
  row.no_interval = compared.no_interval_because;
  if (compared.share_of_travel) row.share_of_travel = percent(*compared.share_of_travel, options);
  if (compared.counterpart == nullptr) return row;
  row.counterpart = compared.counterpart->symbol;
  if (compared.counterpart_value)
    row.counterpart_value = format_fixed(compared.counterpart_value->in_native(),
                                         decimals_of(compared.counterpart_value->in_native(), usual), options.numbers);
  if (const auto difference = compared.difference())
    row.difference = with_sign(difference->in_native(), decimals, options);
  if (const auto relative = compared.relative_difference())
    row.relative = with_sign(100.0 * *relative, 0, options) + "\u00a0%";
  return row;
}

TableCell cell_or_dash(const std::string& text) { return text.empty() ? quiet_cell("–") : text_cell(text); }

/// With what there is not, and why.
TableCell title_cell(const RuleRow& row) {
  if (!row.absence.empty()) return text_cell(fmt::format("{} (no value: {})", row.title, row.absence));
  if (!row.no_interval.empty()) return text_cell(fmt::format("{} (no interval: {})", row.title, row.no_interval));
  return text_cell(row.title);
}

constexpr std::size_t interval_column = 5;

/// Of the first group.
void drop_column(Table& table, std::size_t column) {
  const auto at = static_cast<std::ptrdiff_t>(column);
  table.columns.erase(table.columns.begin() + at);
  --table.groups.front().columns;
  for (auto& row : table.rows) row.erase(row.begin() + at);
}

Section figures_by_rule(const RulesSubject& subject, const Options& options) {
  const std::string unit(deviation_unit(subject.test.metadata.axis.kind));
  Table table;
  table.dense = true;
  table.columns = {{plain("Rule"), Align::start, true},
                   {plain("Figure"), Align::start, false, true},
                   {plain("Symbol")},
                   {plain(fmt::format("Value in {}", unit)), Align::decimal},
                   {plain("Of T"), Align::decimal},
                   {plain("Interval")},
                   {plain("Beside"), Align::start, false, false, true},
                   {plain(fmt::format("Value in {}", unit)), Align::decimal},
                   {plain("Difference"), Align::decimal},
                   {plain("Relative"), Align::decimal},
                   {plain("Evidence"), Align::start, false, false, true}};
  table.groups = {{{}, 6}, {plain(iso230_2::edition), 4}, {{}, 1}};
  for (const standards::ComparedRule& rule : subject.comparison.rules)
    for (const RuleRow& row : rule_rows(rule, subject.comparison, options))
      table.rows.push_back({verbatim_cell(rule.rule->name), title_cell(row),
                            row.symbol.empty() ? quiet_cell("–") : TableCell{symbol(row.symbol)},
                            cell_or_dash(row.value), cell_or_dash(row.share_of_travel),
                            row.interval.empty() ? quiet_cell("–") : text_cell(row.interval),
                            row.counterpart.empty() ? quiet_cell("–") : TableCell{symbol(row.counterpart)},
                            cell_or_dash(row.counterpart_value), cell_or_dash(row.difference),
                            cell_or_dash(row.relative), text_cell(row.evidence_source)});
  table.notes = {sentence(standards::evidence_note), sentence(standards::no_conformity_stated),
                 sentence(standards::uncertainty_statement(subject.comparison))};
  if (!subject.comparison.trials) drop_column(table, interval_column);
  return {"results", "Figures by rule", true, {std::move(table)}};
}

Section formulas_section(const RulesSubject& subject, const Options& options) {
  Table table;
  table.columns = {{plain("Rule"), Align::start, true},
                   {plain("Figure"), Align::start, false, true},
                   {plain("Beside")},
                   {plain("Differs by"), Align::start, false, true}};
  for (const standards::ComparedRule& rule : subject.comparison.rules)
    for (const RuleRow& row : rule_rows(rule, subject.comparison, options))
      if (!row.departs_by.empty())
        table.rows.push_back({verbatim_cell(rule.rule->name), text_cell(row.title), TableCell{symbol(row.counterpart)},
                              text_cell(row.departs_by)});
  Section section{"formulas", "How the rules differ", false, {}};
  Facts facts;
  for (const standards::ComparedRule& rule : subject.comparison.rules)
    facts.facts.push_back({verbatim(rule.rule->name), text_cell(rule.rule->remark)});
  section.blocks.emplace_back(std::move(facts));
  if (!table.rows.empty()) section.blocks.emplace_back(std::move(table));
  return section;
}

std::vector<Notice> standing_of_rules(const RulesSubject& subject) {
  std::vector<Notice> all;
  all.push_back(
      {Tone::normal,
       plain("The same readings by several rules"),
       {sentence(standards::no_conformity_stated), sentence(standards::uncertainty_statement(subject.comparison))}});
  if (!subject.comparison.iso230_2.conforming())
    all.push_back({Tone::bad, plain(fmt::format("The test departs from {}; see Findings", iso230_2::edition)), {}});
  if (const std::string corrected = correction_statement(subject.test.provenance.corrections); !corrected.empty())
    all.push_back({Tone::normal, plain(corrected), {}});
  return all;
}

Section warnings_section(const RulesSubject& subject) {
  Notice notice{Tone::caution, plain("Figures of one name that are not the same"), {}};
  for (const auto& warning : subject.comparison.warnings) notice.lines.push_back(sentence(warning.message));
  return {"warnings", "What must not be compared", true, {std::move(notice)}};
}

}  // namespace

std::vector<RuleRow> rule_rows(const standards::ComparedRule& rule, const standards::RuleComparison& comparison,
                               const Options& asked) {
  const Options options = fitted(asked, comparison.iso230_2.evaluation.parameters);
  std::vector<RuleRow> rows;
  for (const standards::ComparedFigure& figure : rule.figures) rows.push_back(rule_row(figure, options));
  return rows;
}

Document compose(const RulesSubject& subject, const Options& options) {
  const standards::RuleComparison& comparison = subject.comparison;
  const Subject whole{subject.test, comparison.iso230_2, {}};
  Document document = title_page(whole, options);
  document.kind = "Comparison of rules";
  const std::string& name = subject.test.metadata.axis.name;
  document.title = fmt::format("Figures by several rules of {}", name.empty() ? "an NC axis" : "axis " + name);
  document.edition =
      fmt::format("{}{} and other rules", comparison.iso230_2.conforming() ? "" : "departs from ", iso230_2::edition);
  document.running_status = document.edition + (document.label.empty() ? "" : " · " + document.label);
  document.status = standing_of_rules(subject);
  put_label(document, document.label);
  document.sections.push_back(figures_by_rule(subject, options));
  if (!comparison.warnings.empty()) document.sections.push_back(warnings_section(subject));
  document.sections.push_back(formulas_section(subject, options));
  if (!comparison.findings.empty()) document.sections.push_back(finding_section(comparison.findings));
  document.sections.push_back(identification_section(whole, false, options));
  document.sections.push_back(provenance_section(whole, options));
  document.sections.push_back(release_section(subject.test.metadata));
  return document;
}

}  // namespace axiometry::report
