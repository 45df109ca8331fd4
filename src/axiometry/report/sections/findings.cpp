// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/sections/sections.h"

namespace axiometry::report {

namespace {

using iso230_2::Severity;

TableCell severity_cell(Severity severity) {
  switch (severity) {
    case Severity::departure: return {strong("Departure"), Tone::bad};
    case Severity::missing: return {strong("Missing"), Tone::caution};
    case Severity::note: return {plain("Note"), Tone::quiet};
  }
  return {};
}

}  // namespace

Section finding_section(std::span<const iso230_2::Finding> findings) {
  Section section{"findings", "Findings", false, {}};
  if (findings.empty()) {
    section.blocks.emplace_back(
        Paragraph{plain("None: nothing departs from clauses 4 to 8, and nothing they ask for is missing.")});
    return section;
  }
  Table table;
  table.columns = {
      {plain("Kind"), Align::start, true}, {plain("Clause")}, {plain("Finding"), Align::start, false, true}};
  for (Severity severity : {Severity::departure, Severity::missing, Severity::note})
    for (const auto& finding : findings)
      if (finding.severity == severity)
        table.rows.push_back(
            {severity_cell(severity), text_cell(finding.clause), TableCell{sentence(finding.message)}});
  section.blocks.emplace_back(std::move(table));
  return section;
}

}  // namespace axiometry::report
