// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/compensation.h"
#include "axiometry/report/figures/compensation_curves.h"
#include "axiometry/report/sections/added_table.h"
#include "axiometry/report/sections/fact.h"
#include "axiometry/report/sections/known_positions.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/sections/source_files.h"

namespace axiometry::report {
namespace {

using iso230_2::AxisParameters;

constexpr std::size_t table_rows_most = 400;  // the file itself has the others

struct SystematicError {
  const char* symbol;
  std::optional<Deviation> AxisParameters::*member;
};

/// E, or that of a direction where a test or its re-test has no other: what stands side by side is one parameter.
SystematicError systematic_error(const AxisParameters& before, const AxisParameters* retest) {
  constexpr SystematicError all[] = {
      {"E", &AxisParameters::E}, {"E↑", &AxisParameters::E_up}, {"E↓", &AxisParameters::E_down}};
  const auto has = [&](const SystematicError& of) { return (before.*of.member).has_value(); };
  const auto have_both = [&](const SystematicError& of) { return has(of) && (retest->*of.member).has_value(); };
  const auto* const found = retest != nullptr ? std::ranges::find_if(all, have_both) : std::ranges::find_if(all, has);
  return found != std::end(all) ? *found : *std::ranges::find_if(all, has);
}

Notice compensation_outcome(const CompensationSubject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const auto with_unit = [&](const std::optional<Deviation>& x) {
    return fmt::format("{} {}", format_fixed(x->in_native(), 2, options.numbers), deviation_unit(kind));
  };
  const AxisParameters &before = subject.before.parameters, &predicted = subject.predicted.parameters;
  const SystematicError shown = systematic_error(before, subject.retest ? &subject.retest->parameters : nullptr);
  const char* symbol = shown.symbol;
  const auto of = [&shown](const AxisParameters& p) { return p.*shown.member; };
  Notice notice{Tone::normal,
                plain(fmt::format("{} from {} to {}, as predicted from the same readings", symbol,
                                  with_unit(of(before)), with_unit(of(predicted)))),
                {}};
  if (subject.expected)
    notice.lines.push_back(
        plain(fmt::format("A re-test will scatter anew: {} below {} in 95 % of re-tests, if axis, air, temperatures "
                          "and set-up stay as they are",
                          symbol, with_unit(of(*subject.expected)))));
  notice.lines.push_back(plain("A prediction, not a measurement: only a re-test proves it."));
  if (subject.retest && of(subject.retest->parameters))
    notice.lines = {plain(fmt::format("{} of the re-test: {}", symbol, with_unit(of(subject.retest->parameters))))};
  for (const NamedFinding& finding : subject.findings)
    if (finding.serious) {
      notice.tone = Tone::bad;
      notice.lines.push_back(sentence(finding.message));
    }
  return notice;
}

Section compensation_parameters(const CompensationSubject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  Table table;
  const auto head = [&](const char* words) {
    table.columns.push_back({plain(fmt::format("{} / {}", words, deviation_unit(kind))), Align::decimal});
  };
  table.columns = {{plain("Parameter"), Align::start, true, true}, {plain("Symbol")}};
  head("Before");
  head("Predicted");
  if (subject.expected) head("Re-test, 95 % below");
  if (subject.retest) head("Re-test");
  head("Scatter alone");
  for (const iso230_2::ParameterInfo& parameter : iso230_2::parameters) {
    const auto cell = [&](const AxisParameters& of) {
      const auto& value = of.*parameter.member;
      return value ? text_cell(format_fixed(value->in_native(), 2, options.numbers)) : quiet_cell("–");
    };
    if (!(subject.before.parameters.*parameter.member)) continue;
    auto& row = table.rows.emplace_back();
    row = {text_cell(parameter.title),
           {symbol(parameter.symbol)},
           cell(subject.before.parameters),
           cell(subject.predicted.parameters)};
    if (subject.expected)
      row.push_back(parameter.member == &AxisParameters::B_mean ? quiet_cell("–") : cell(*subject.expected));
    if (subject.retest) row.push_back(cell(subject.retest->parameters));
    row.push_back(cell(subject.scatter));
  }
  table.notes = {
      plain("Predicted: the same readings with the table in the control, as it interpolates and rounds. The table was "
            "made from these readings; what scatter did to their means it corrects too, and a re-test will show that "
            "part again."),
      plain("Scatter alone: the readings without the mean of every target and direction. No table removes this.")};
  if (subject.expected)
    table.notes.push_back(
        plain("Re-test, 95 % below: of simulated re-tests of as many runs, with the scatter of this test, in the table "
              "and in the re-test; if axis, air, temperatures and set-up stay as they are."));
  Section section{"parameters", "Before and predicted", true, {std::move(table)}};
  section.blocks.emplace_back(before_and_predicted_figure(subject, options));
  return section;
}

Section table_section(const CompensationSubject& subject, const Options& options) {
  Section section{"table", "Table", true, {}};
  section.blocks.emplace_back(correction_figure(subject, options));
  Table table = added_table(subject.applied, table_rows_most, subject.control.rolls_over, options);
  if (subject.smoothing > 0.0)
    table.notes.push_back(
        plain(fmt::format("Smoothed (λ = {:.2g}): so the table foretells targets best that were left "
                          "out of it.",
                          subject.smoothing)));
  section.blocks.emplace_back(std::move(table));
  return section;
}

Section control_section(const ControlWords& control) {
  Facts facts{"", {}};
  facts.facts = {fact("Control", control.title), fact("A number in the file", control.sign),
                 fact("Loading", control.loading), fact("Verified of this format", control.verified)};
  if (!control.inferred.empty()) facts.facts.push_back(fact("Inferred, not seen", control.inferred));
  return {"control", "Control", true, {std::move(facts)}};
}

Section named_findings_section(std::span<const NamedFinding> findings) {
  Section section{"findings", "Findings", false, {}};
  for (const NamedFinding& f : findings)
    section.blocks.emplace_back(Paragraph{sentence(f.message), f.serious ? Tone::bad : Tone::normal});
  return section;
}

Section compensation_notes(std::string_view notes) {
  Section section{"notes", "Notes", false, {}};
  for (const std::string_view line : text::split(notes, '\n'))
    if (!text::trim(line).empty()) section.blocks.emplace_back(Paragraph{verbatim(text::trim(line)), Tone::normal});
  return section;
}

}  // namespace

Document compose(const CompensationSubject& subject, const Options& options) {
  const iso230_2::Assessment no_assessment;
  const Subject whole{subject.test, no_assessment, {}};
  Document document = title_page(whole, options);
  const std::string& name = subject.test.metadata.axis.name;
  document.kind = "Compensation";
  document.title = fmt::format("Compensation of {}", name.empty() ? "an NC axis" : "axis " + name);
  document.edition = fmt::format("Formulas of {}", iso230_2::edition);
  document.running_status = "Compensation, predicted";
  document.status = {compensation_outcome(subject, options)};
  document.sections = {compensation_parameters(subject, options),
                       known_positions_section(subject.known, subject.test.metadata.axis.kind, options),
                       table_section(subject, options)};
  if (!subject.findings.empty()) document.sections.push_back(named_findings_section(subject.findings));
  if (!text::trim(subject.notes).empty()) document.sections.push_back(compensation_notes(subject.notes));
  document.sections.push_back(control_section(subject.control));
  document.sections.push_back(identification_section(whole, false, options));
  Section provenance = provenance_section(whole, options);
  if (const Provenance* retest = subject.retest_source)
    provenance.blocks.emplace_back(
        Facts{"Source of the re-test",
              {{plain("Source file"), file_cell(retest->file)},
               {plain("SHA-256 of the source"),
                retest->sha256.empty() ? quiet_cell("not recorded") : verbatim_cell(retest->sha256)}}});
  document.sections.push_back(std::move(provenance));
  return document;
}

}  // namespace axiometry::report
