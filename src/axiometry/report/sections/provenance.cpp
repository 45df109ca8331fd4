// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/report/correction_text.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report {

namespace {

/// What the program did to the readings, so that a reader can do it again.
Facts correction_facts(const AppliedCorrection& correction, std::size_t number, const Subject& subject,
                       const Options& options) {
  Facts facts{fmt::format("Correction {}: {}", number, correction.title), {}};
  facts.facts.push_back(
      {plain("Readings"),
       text_cell(fmt::format("applied by this program to the readings of the source, {} each",
                             correction_extent(correction, subject.test.metadata.axis.kind, options)))});
  for (const auto& detail : correction.details)
    facts.facts.push_back({plain(detail.name), text_cell(detail_value(detail, options))});
  return facts;
}

TableCell or_not_recorded(std::string_view text, RichText (*set)(std::string_view)) {
  return text.empty() ? quiet_cell("not recorded") : TableCell{set(text)};
}

}  // namespace

Section provenance_section(const Subject& subject, const Options& options) {
  const Provenance& source = subject.test.provenance;
  Facts facts;
  facts.facts = {
      {plain("Source file"), file_cell(source.file)},
      {plain("SHA-256 of the source"), or_not_recorded(source.sha256, verbatim)},
      {plain("Format"), or_not_recorded(source.format, verbatim)},
      {plain("Program"), text_cell(program_text())},
      {plain("Edition of the standard"), text_cell(fmt::format("{}; {}", edition_of(subject.test.metadata.axis),
                                                               edition_remark(subject.test.metadata.axis)))},
  };
  if (subject.verified)
    facts.facts.push_back({plain("Verification"), text_cell(verified_statement(*subject.verified))});
  if (!subject.trail_head.empty())
    facts.facts.push_back({plain(trail_head_name), TableCell{verbatim(subject.trail_head)}});
  Section section{"provenance", "Provenance", false, {std::move(facts)}};
  std::size_t number = 0;
  for (const AppliedCorrection& correction : source.corrections)
    section.blocks.emplace_back(correction_facts(correction, ++number, subject, options));
  return section;
}

}  // namespace axiometry::report
