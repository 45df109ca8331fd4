// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2_assessment.h"

#include <algorithm>

#include "axiometry/model/plan.h"
#include "axiometry/standards/iso230_2_artefact.h"

namespace axiometry::iso230_2 {
namespace {

/// Results of another cycle than the standard one never stand without saying so (1, Annex B).
std::string_view label_of(const Metadata& metadata, const Series& series) {
  if (const std::string_view label = cycle_label(metadata.conditions.cycle); !label.empty()) return label;
  const bool both = series.has(Direction::up) && series.has(Direction::down);
  return both ? "" : "one direction of approach only, not for acceptance";
}

}  // namespace

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::departure: return "departure";
    case Severity::missing: return "missing";
    case Severity::note: return "note";
  }
  return "";
}

bool Assessment::conforming() const {
  return std::ranges::none_of(findings, [](const Finding& finding) { return finding.severity == Severity::departure; });
}

Assessment assess(const Test& test, Depth depth) {
  Assessment result;
  result.evaluation = evaluate(test.series);
  result.annex_a = annex_a(test.metadata, test.series, result.evaluation);
  result.findings = find_departures(test.metadata, test.series, result.evaluation, result.annex_a, depth);
  if (depth == Depth::every_finding) {
    for (Finding& finding : artefact_findings(test)) result.findings.push_back(std::move(finding));
    std::ranges::stable_sort(result.findings, {}, &Finding::severity);
  }
  result.label = label_of(test.metadata, test.series);
  return result;
}

}  // namespace axiometry::iso230_2
