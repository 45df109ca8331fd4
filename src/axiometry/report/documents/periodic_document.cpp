// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/version.h"
#include "axiometry/report/periodic.h"
#include "axiometry/report/sections/sections.h"

namespace axiometry::report {
namespace {

using iso230_2::PeriodicDirection;
using iso230_2::PeriodicError;
using iso230_2::Severity;

/// The sections that reports of tests share look at a whole subject; of this one they read the test and the findings.
struct Borrowed {
  iso230_2::Assessment assessment;
  explicit Borrowed(const PeriodicError& result) {
    assessment.findings = result.findings;
    assessment.label = result.label;
  }
};

Notice status(const PeriodicError& result) {
  if (result.conforming())
    return {Tone::normal,
            plain("Periodic positioning error (Annex C)"),
            {plain("An investigation, not an acceptance test: the parameters of clause 3 are not stated.")}};
  Notice notice{
      Tone::bad, plain("Periodic positioning error, from a test that departs from Annex C; see Findings"), {}};
  for (const auto& finding : result.findings)
    if (finding.severity == Severity::departure) notice.lines.push_back(sentence(finding.message));
  return notice;
}

/// Of the periods that were searched, and of no others.
std::string nothing_significant(const PeriodicDirection& d, const std::string& direction, AxisKind kind) {
  if (d.period_known)
    return fmt::format("No significant error{} of the period {} was found", direction,
                       iso230_2::period_text(d.period.value.in_native(), kind));
  return fmt::format("No significant periodic error{} was found with a period from {} to {}", direction,
                     iso230_2::period_text(d.spectrum.back().period.in_native(), kind),
                     iso230_2::period_text(d.spectrum.front().period.in_native(), kind));
}

/// "3.02 µm peak to valley with a period of 10.003 mm (↑)"
Notice outcome(const PeriodicDirection& d, bool both, AxisKind kind, const Options& options) {
  const auto rows = periodic_rows(d, kind, options);
  const auto with_unit = [](const PeriodicRow& row) {
    const std::string value = row.U.empty() || row.U == "0" ? row.value : fmt::format("{} ± {}", row.value, row.U);
    return value + (row.unit == "°" ? "" : "\u00a0") + row.unit;
  };
  const auto& range = *std::ranges::find(rows, "Peak to valley of the curve", &PeriodicRow::title);
  const std::string direction = both ? fmt::format(" {}", arrow(d.direction)) : "";
  if (!d.significant) return {Tone::normal, plain(nothing_significant(d, direction, kind)), {}};
  return {Tone::normal,
          plain(fmt::format("Period{} {}: {} peak to valley", direction, with_unit(rows.front()), with_unit(range))),
          {}};
}

Table result_table(const PeriodicDirection& d, AxisKind kind, const Options& options) {
  Table table;
  table.columns = {{plain("Quantity"), Align::start, true, true},
                   {plain("Symbol")},
                   {plain("Value"), Align::decimal},
                   {italic("U"), Align::decimal},
                   {plain("Unit")}};
  for (const PeriodicRow& row : periodic_rows(d, kind, options))
    table.rows.push_back({text_cell(row.title),
                          {symbol(row.symbol)},
                          text_cell(row.value),
                          row.U.empty() ? quiet_cell("–") : text_cell(row.U),
                          text_cell(row.unit)});
  table.notes = {joined({italic("U"), plain(" = "), italic("k u"), plain(" with "), italic("k"),
                         plain(fmt::format(" = {} for a probability of about 95\u00a0%, from the residuals of the fit "
                                           "alone: nothing of the instrument is in it.",
                                           format_fixed(d.coverage_factor, 2, options.numbers)))}),
                 plain("The peak to valley is that of the fitted curve; the range of the deviations also holds their "
                       "noise, and grows with the number of targets.")};
  return table;
}

Section result_section(const PeriodicDirection& d, bool both, AxisKind kind, const Options& options) {
  Section section{both ? fmt::format("results-{}", d.direction == Direction::up ? "up" : "down") : "results",
                  both ? fmt::format("Results, {} approaches ({})",
                                     d.direction == Direction::up ? "positive" : "negative", arrow(d.direction))
                       : "Results",
                  true,
                  {}};
  section.blocks.emplace_back(result_table(d, kind, options));
  section.blocks.emplace_back(harmonic_table(d, kind, options));
  return section;
}

Section method_section(const PeriodicError& result) {
  const bool known = result.directions.front().period_known;
  std::string text =
      "The deviations of a direction, averaged over its runs, are fitted by a straight line and a periodic curve at "
      "once, by least squares. ";
  text += known ? "The period was given. "
                : "The period is that of the highest peak of the least-squares spectrum with a line (generalised "
                  "Lomb–Scargle), refined by the fit. ";
  text +=
      "Harmonics above the first belong to the curve where white noise alone would make them as large in less than 1 % "
      "of tests. The line is removed in this report only; the readings stay as they were measured.";
  return {"method", "Method", false, {Paragraph{plain(text)}}};
}

}  // namespace

Document compose(const PeriodicSubject& subject, const Options& options) {
  const Borrowed borrowed(subject.result);
  const Subject whole{subject.test, borrowed.assessment, {}};
  const AxisKind kind = subject.test.metadata.axis.kind;
  const bool both = subject.result.directions.size() > 1;

  Document document = title_page(whole, options);
  document.kind = "Periodic positioning error";
  const std::string& name = subject.test.metadata.axis.name;
  document.title = fmt::format("Periodic positioning error of {}", name.empty() ? "an NC axis" : "axis " + name);
  document.edition =
      fmt::format("{}{}, Annex C", subject.result.conforming() ? "" : "departs from ", iso230_2::edition);
  document.running_status = document.edition + (document.label.empty() ? "" : " · " + document.label);
  document.status = {status(subject.result)};
  put_label(document, document.label);
  for (const auto& d : subject.result.directions) document.status.push_back(outcome(d, both, kind, options));

  for (const auto& d : subject.result.directions) document.sections.push_back(result_section(d, both, kind, options));
  Section figures{"figures", "Figures", true, {}};
  for (Figure& figure : periodic_figures(subject, options)) figures.blocks.emplace_back(std::move(figure));
  document.sections.push_back(std::move(figures));
  if (subject.result.findings.empty()) {
    document.sections.push_back(
        {"findings",
         "Findings",
         false,
         {Paragraph{plain("None. What is asked for are two periods and four targets per period, as is general "
                          "practice: the text of Annex C was not at hand.")}}});
  } else {
    document.sections.push_back(finding_section(subject.result.findings));
  }
  document.sections.push_back(identification_section(whole, false, options));
  document.sections.push_back(method_section(subject.result));
  document.sections.push_back(provenance_section(whole, options));
  document.sections.push_back(release_section(subject.test.metadata));
  return document;
}

}  // namespace axiometry::report
