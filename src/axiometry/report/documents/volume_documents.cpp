// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/report/documents/volumetric_sections.h"
#include "axiometry/report/figures/tracking/predicted_line.h"
#include "axiometry/report/sections/fact.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/translated.h"
#include "axiometry/report/volumetric.h"

namespace axiometry::report {
namespace {

using volumetric::Estimate;
using volumetric::LineComparison;
using volumetric::PredictedLine;

Document volume_document(std::string title, std::string edition, const SourceFile& result, const Options& options) {
  Document document;
  document.kind = "Volumetric calibration";
  document.title = std::move(title);
  document.edition = std::move(edition);
  document.running_head = translated(document.title, options);
  document.running_status = document.edition;
  document.identity = {{plain("Result"), file_cell(result.file)}};
  return document;
}

std::string with_u(const Estimate& e, const char* unit, const Options& options) {
  return fmt::format("{} {}, u = {} {}", format_fixed(e.value, 2, options.numbers), unit,
                     format_fixed(e.u, 2, options.numbers), unit);
}

std::string chance_text(double probability, const Options& options) {
  constexpr double printed_least = 1e-4;
  if (probability >= printed_least) return format_fixed(probability, 4, options.numbers);
  return "< " + format_fixed(printed_least, 4, options.numbers);
}

Section predicted_section(const PredictedTestSubject& subject, const Options& options) {
  const PredictedLine& predicted = subject.predicted;
  const auto place = [&](Vector3 at) {
    return fmt::format("{}; {}; {}", format_fixed(at.x, 1, options.numbers), format_fixed(at.y, 1, options.numbers),
                       format_fixed(at.z, 1, options.numbers));
  };
  Facts facts{"", {}};
  facts.facts = {{plain("Line"), verbatim_cell(predicted.line.name)},
                 {plain("Tool"), verbatim_cell(subject.tool)},
                 fact("From X; Y; Z / mm", place(predicted.line.from_mm)),
                 fact("To X; Y; Z / mm", place(predicted.line.to_mm)),
                 {plain(predicted.has_directions ? "E, bidirectional systematic deviation"
                                                 : "E of the mean of both directions, without reversal"),
                  text_cell(with_u(predicted.systematic, "µm", options))},
                 {plain("Slope"), text_cell(with_u(predicted.slope_um_per_m, "µm/m", options))},
                 {plain("B, reversal value"),
                  predicted.has_directions
                      ? text_cell(fmt::format("{} µm", format_fixed(predicted.reversal_um, 2, options.numbers)))
                  : predicted.untold_reversals.empty()
                      ? text_cell("not told: the errors have no directions")
                      : text_cell("not told: not all errors of this line are known by direction")}};
  Section section{"prediction", "Prediction", true, {std::move(facts)}};
  if (subject.comparison) {
    const LineComparison& c = *subject.comparison;
    Facts held{"", {}};
    held.facts = {{plain("Measured test"), file_cell(subject.sources.back().file)},
                  {plain("χ²"), text_cell(fmt::format("{} (ν = {})", format_fixed(c.chi_squared, 1, options.numbers),
                                                      c.degrees_of_freedom))},
                  {plain("Probability of as much by chance"), text_cell(chance_text(c.probability, options))}};
    if (c.reversal)
      held.facts.push_back({plain("B of the measured test, which the errors do not hold"),
                            text_cell(fmt::format("{} µm", format_fixed(c.reversal->largest_um, 2, options.numbers)))});
    section.blocks.emplace_back(std::move(held));
  }
  section.blocks.emplace_back(predicted_line_figure(predicted, subject.comparison, options));
  return section;
}

Section deviations_section(const PredictedTestSubject& subject, const Options& options) {
  const PredictedLine& predicted = subject.predicted;
  Table table;
  table.columns = {{plain("Position / mm"), Align::decimal, true}};
  const auto column = [&](const char* head) { table.columns.push_back({plain(head), Align::decimal}); };
  column(predicted.has_directions ? "↑ / µm" : "Deviation / µm");
  column("u / µm");
  if (predicted.has_directions) {
    column("↓ / µm");
    column("u / µm");
  }
  if (subject.comparison) {
    column(subject.comparison->by_direction ? "Measured ↑ / µm" : "Measured / µm");
    column("Difference over u");
    if (subject.comparison->by_direction) {
      column("Measured ↓ / µm");
      column("Difference over u");
    }
  }
  const std::size_t m = predicted.up.size();
  for (std::size_t k = 0; k < m; ++k) {
    auto& row = table.rows.emplace_back();
    const auto put = [&](double x, int decimals) {
      row.push_back(text_cell(format_fixed(x, decimals, options.numbers)));
    };
    put(predicted.line.positions_mm[k], 2);
    put(predicted.up[k].value, 2);
    put(predicted.up[k].u, 2);
    if (predicted.has_directions) {
      put(predicted.down[k].value, 2);
      put(predicted.down[k].u, 2);
    }
    if (!subject.comparison) continue;
    for (std::size_t at = k; at < subject.comparison->measured_um.size(); at += m) {
      put(subject.comparison->measured_um[at], 2);
      put(subject.comparison->normalised[at], 1);
    }
  }
  table.notes = {
      plain("Less the mean of all: the zero of a deviation curve is a convention. u: standard uncertainty (k = 1).")};
  table.dense = true;
  return {"deviations", "Deviations", true, {std::move(table)}};
}

void add_findings(std::span<const volumetric::VolumetricFinding> all, Document& document) {
  if (all.empty()) return;
  Section findings{"findings", "Findings", false, {}};
  for (const volumetric::VolumetricFinding& f : all)
    findings.blocks.emplace_back(Paragraph{sentence(f.message), f.serious ? Tone::bad : Tone::normal});
  document.sections.push_back(std::move(findings));
}

}  // namespace

Document compose(const VolumeFieldSubject& subject, const Options& options) {
  Document document = volume_document("Error of the tool point over the volume", "ISO 230-1:2012, names of errors",
                                      subject.result, options);
  document.sections = {volume_section(subject.model, subject.fields, options),
                       diagonals_section(subject.model, subject.fields, options)};
  add_findings(subject.findings, document);
  document.sections.push_back(provenance_of_files({&subject.result, 1}));
  return document;
}

Document compose(const PredictedTestSubject& subject, const Options& options) {
  const bool diagonal = subject.predicted.line.name.size() > 1;
  Document document = volume_document("Test predicted from the 21 errors", diagonal ? "ISO 230-6" : "ISO 230-2:2014",
                                      subject.sources.front(), options);
  document.sections = {predicted_section(subject, options)};
  add_findings(subject.findings, document);
  document.sections.push_back(deviations_section(subject, options));
  document.sections.push_back(provenance_of_files(subject.sources));
  return document;
}

}  // namespace axiometry::report
