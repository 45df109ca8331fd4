// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/report/claim_text.h"
#include "axiometry/report/finding_text.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/standards/environment/environment.h"

namespace axiometry::report {
namespace {

TableCell answer(const iso230_2::Claim& claim) {
  if (claim.holds()) return {strong("Yes"), Tone::good};
  return {strong("No"), is_contradicted(claim) ? Tone::bad : Tone::caution};
}

}  // namespace

Section claim_section(const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const iso230_2::Claims claims = iso230_2::claims_of(subject.test, subject.assessment);
  Section section{"claims", "Claims", false, {}};
  Table table;
  table.columns = {{plain("Claim"), Align::start, true},
                   {plain("Holds")},
                   {plain("Clause")},
                   {plain("What speaks against it"), Align::start, false, true}};
  for (const iso230_2::Claim& claim : claims) {
    if (claim.holds()) table.rows.push_back({text_cell(claim.title), answer(claim), quiet_cell("–"), quiet_cell("–")});
    bool first = true;
    for (const iso230_2::Finding& point : claim.against) {
      table.rows.push_back({first ? text_cell(claim.title) : quiet_cell(""), first ? answer(claim) : quiet_cell(""),
                            text_cell(point.clause),
                            TableCell{sentence(shown_message(point, subject.assessment, kind, options))}});
      first = false;
    }
  }
  table.notes = {
      plain("What was not stated speaks against a claim as what departs from the standard does, but for "
            "what rests on the word of who tested.")};
  if (claim(claims, iso230_2::ClaimKind::tested).holds())
    table.notes.push_back(sentence(iso230_2::word_of_the_tester(subject.test, subject.environment)));
  section.blocks.emplace_back(std::move(table));
  return section;
}

}  // namespace axiometry::report
