// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/assessment/assessment.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include "axiometry/model/fields.h"
#include "axiometry/model/plan.h"
#include "axiometry/standards/iso230_2/rules/order_by_times.h"
#include "axiometry/standards/iso230_2/severity_order.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/reading_correction.h"

namespace axiometry::iso230_2 {
namespace {

/// Results of another cycle than the standard one never stand without saying so (1, Annex B).
std::string_view label_of(const Metadata& metadata, const Series& series) {
  if (const std::string_view label = cycle_label(metadata.conditions.cycle_or_standard()); !label.empty()) return label;
  const bool both = series.has_both_directions();
  return both ? "" : "one direction of approach only, not for acceptance";
}

/// How the inputs of the uncertainty were resolved, where that is not plain.
void add_input_remarks(std::vector<Finding>& findings, const ResolvedInputs& inputs) {
  for (const ResolvedRemark& remark : inputs.remarks) {
    findings.push_back(
        {"uncertainty-input", "8.2.1", remark.missing ? Severity::missing : Severity::note, remark.message});
    if (const Field* field = find_field(remark.key)) findings.back().fields.push_back(field->key);
  }
}

/// What the reader of the file had to say and what else must be known of the readings, each among its like. They rest
/// on no clause.
void add_remarks(std::vector<Finding>& findings, const Test& test, Depth depth) {
  std::vector<SourceRemark> remarks = test.provenance.remarks;
  std::ranges::move(remarks_on_readings(test), std::back_inserter(remarks));
  std::size_t departures = 0;
  for (SourceRemark& remark : remarks) {
    if (remark.departs)
      findings.insert(findings.begin() + static_cast<std::ptrdiff_t>(departures++),
                      {"source-remark", source_clause, Severity::departure, std::move(remark.message)});
    else if (depth == Depth::every_finding)
      findings.push_back({"source-remark", source_clause, Severity::note, std::move(remark.message)});
  }
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
  result.inputs = resolve_inputs(test.metadata, test.series, test.provenance.stated);
  result.annex_a = annex_a(test.metadata, test.series, result.evaluation, test.provenance.stated);
  result.findings = find_departures(test.metadata, test.series, result.evaluation, result.annex_a, depth);
  std::ranges::move(order_findings(test), std::back_inserter(result.findings));
  if (depth == Depth::departures_only)
    result.progression = find_progression(test.metadata, test.series, result.evaluation, result.annex_a);
  else if (const auto told = std::ranges::find(result.findings, "ordered-progression", &Finding::id);
           told != result.findings.end())
    result.progression = *told;
  if (depth == Depth::every_finding)
    for (Finding& finding : artefact_findings(test)) result.findings.push_back(std::move(finding));
  result.method_of_record = test.metadata.gum.method;
  result.uncorrected = uncorrected_effects(test);
  if (depth == Depth::every_finding)
    for (const UncorrectedEffect& effect : result.uncorrected)
      result.findings.push_back({"uncorrected-effect", "4.1", Severity::note,
                                 effect.reason() + "; no verdict on which it could matter is given"});
  if (depth == Depth::every_finding) add_input_remarks(result.findings, result.inputs);
  add_remarks(result.findings, test, depth);
  sort_by_severity(result.findings);
  result.label = label_of(test.metadata, test.series);
  return result;
}

}  // namespace axiometry::iso230_2
