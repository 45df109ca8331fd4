// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

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

constexpr std::string_view none = "None: no rule has anything to say. What may be claimed stands in Claims.";

/// What several tests have in common.
struct Shared {
  const iso230_2::Finding* finding = nullptr;
  std::string names;
};

std::vector<Shared> merged(std::span<const NamedFindings> tests) {
  std::vector<Shared> all;
  for (const NamedFindings& test : tests)
    for (const iso230_2::Finding& finding : test.findings) {
      const auto same = std::ranges::find_if(all, [&](const Shared& shared) {
        return shared.finding->severity == finding.severity && shared.finding->clause == finding.clause &&
               shared.finding->message == finding.message;
      });
      if (same == all.end())
        all.push_back({&finding, std::string(test.name)});
      else
        same->names += fmt::format(", {}", test.name);
    }
  return all;
}

}  // namespace

RichText finding_line(const iso230_2::Finding& finding) {
  RichText line = sentence(finding.message);
  if (line.back().text.ends_with('.')) line.back().text.pop_back();
  const bool is_number = finding.clause.find_first_of(' ') == std::string::npos;  // 5.3.2, not Annex B
  return joined({line, plain(" ("), is_number ? verbatim(finding.clause) : plain(finding.clause), plain(").")});
}

Section finding_section(std::span<const NamedFindings> tests) {
  Section section{"findings", "Findings", false, {}};
  const std::vector<Shared> all = merged(tests);
  if (all.empty()) {
    section.blocks.emplace_back(Paragraph{plain(none)});
    return section;
  }
  Table table;
  table.columns = {{plain("Kind"), Align::start, true},
                   {plain("Clause")},
                   {plain("Lines")},
                   {plain("Finding"), Align::start, false, true}};
  for (Severity severity : {Severity::departure, Severity::missing, Severity::note})
    for (const Shared& shared : all)
      if (shared.finding->severity == severity)
        table.rows.push_back({severity_cell(severity), text_cell(shared.finding->clause), verbatim_cell(shared.names),
                              TableCell{sentence(shared.finding->message)}});
  section.blocks.emplace_back(std::move(table));
  return section;
}

Section finding_section(std::span<const iso230_2::Finding> findings) {
  Section section{"findings", "Findings", false, {}};
  if (findings.empty()) {
    section.blocks.emplace_back(Paragraph{plain(none)});
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
