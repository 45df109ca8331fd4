// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "axiometry/report/claim_text.h"
#include "axiometry/report/correction_text.h"
#include "axiometry/report/finding_text.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report {

namespace {

using iso230_2::Finding;
using iso230_2::Severity;

constexpr std::size_t departures_named = 3;      // on the first page; all of them stand in the findings
constexpr std::size_t running_head_length = 72;  // characters
constexpr std::size_t running_number_length = 32;
constexpr std::size_t running_status_length = 110;

/// Short names, since these stand side by side.
constexpr std::pair<std::string_view, std::string_view> identity_fields[] = {{"Machine", "machine.name"},
                                                                             {"Serial number", "machine.serial_number"},
                                                                             {"Date of test", "test.date"},
                                                                             {"Report number", "test.report_number"}};

/// What an auditor looks for next; left out where it was not given.
constexpr std::pair<std::string_view, std::string_view> further_identity_fields[] = {{"Laboratory", "test.laboratory"},
                                                                                     {"Customer", "test.customer"},
                                                                                     {"Location", "machine.location"},
                                                                                     {"Inspector", "test.inspector"}};

/// "Example Instruments, LI-1, 1234": the artefact, or the first of the equipment.
RichText instrument_of(const Metadata& metadata) {
  const auto named = [](const std::string& what, const std::string& serial_number) {
    RichText text = verbatim(what);
    if (!what.empty() && !serial_number.empty()) text = joined({text, plain(", "), verbatim(serial_number)});
    return text;
  };
  if (!metadata.artefact.type.empty()) return named(metadata.artefact.type, metadata.artefact.serial_number);
  if (metadata.equipment.empty()) return {};
  const Equipment& first = metadata.equipment.front();
  const std::string& type = first.type.empty() ? first.role : first.type;
  const bool both = !first.manufacturer.empty() && !type.empty();
  return named(first.manufacturer + (both ? ", " : "") + type, first.serial_number);
}

std::size_t count(const std::vector<Finding>& findings, Severity severity) {
  return static_cast<std::size_t>(std::ranges::count(findings, severity, &Finding::severity));
}

/// What the result may be called, with what speaks most against more.
Notice claim_notice(const Subject& subject, const iso230_2::Claims& claims, const Options& options) {
  const Axis& axis = subject.test.metadata.axis;
  const iso230_2::Claim& tested = claim(claims, iso230_2::ClaimKind::tested);
  const iso230_2::Claim& reported = claim(claims, iso230_2::ClaimKind::reported);
  const bool bad = is_contradicted(tested);
  Notice notice{tested.holds() ? Tone::normal
                : bad          ? Tone::bad
                               : Tone::caution,
                plain(standing_text(claims, axis)),
                {}};
  const std::size_t departures = count(tested.against, Severity::departure);
  for (const Finding& finding : tested.against) {
    if (finding.severity != Severity::departure) continue;
    if (notice.lines.size() == departures_named) {
      notice.lines.push_back(plain(fmt::format("… and {} more.", departures - departures_named)));
      break;
    }
    notice.lines.push_back(finding_line(shown_finding(finding, subject.assessment, axis.kind, options)));
  }
  if (const std::size_t missing = count(tested.against, Severity::missing); missing > 0)
    notice.lines.push_back(plain(
        missing == 1 ? std::string("1 point of clauses 4 and 5 was not stated or not kept; see Claims.")
                     : fmt::format("{} points of clauses 4 and 5 were not stated or not kept; see Claims.", missing)));
  if (tested.holds() && !is_diagonal(axis))
    notice.lines.push_back(plain("On the word of who tested for what no item states (4.1, 4.2, 5.1); see Claims."));
  if (!reported.holds())
    notice.lines.push_back(plain("Not everything that the report shall state was given; see Claims."));
  return notice;
}

/// At most so many characters, since running heads have one line; cut ones end in "…".
std::string shortened(std::string_view text, std::size_t characters) {
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    const bool begins_character = (static_cast<unsigned char>(text[end]) & 0xC0) != 0x80;
    if (begins_character && ++count > characters) return fmt::format("{}…", text.substr(0, end));
  }
  return std::string(text);
}

std::string running_head(const Metadata& metadata, const Options& options) {
  std::string head =
      translated(metadata.axis.name.empty() ? description_of(metadata.axis) : title_of(metadata.axis), options);
  if (!metadata.machine.name.empty()) head += " · " + metadata.machine.name;
  return shortened(head, running_head_length);
}

std::string running_status(const Subject& subject, const iso230_2::Claims& claims, const Options& options) {
  std::string status = standing_name(claims, subject.test.metadata.axis);
  if (!subject.assessment.label.empty()) status += " · " + subject.assessment.label;
  return shortened(translated(status, options), running_status_length);
}

}  // namespace

std::vector<Fact> further_identity(const Metadata& metadata) {
  std::vector<Fact> facts;
  for (const auto& [name, key] : further_identity_fields)
    if (TableCell value = stated(key, metadata); value.tone != Tone::quiet)
      facts.push_back({plain(name), std::move(value)});
  if (RichText instrument = instrument_of(metadata); !plain_text(instrument).empty())
    facts.push_back({plain("Instrument"), {std::move(instrument)}});
  return facts;
}

Document title_page(const Subject& subject, const Options& options) {
  const Metadata& metadata = subject.test.metadata;
  const auto& assessment = subject.assessment;
  Document document;
  const Axis& axis = metadata.axis;
  document.title = is_diagonal(axis) ? "Diagonal displacement test of a machine tool"
                                     : "Positioning accuracy and repeatability of an NC axis";
  const iso230_2::Claims claims = iso230_2::claims_of(subject.test, assessment);
  const bool holds = claim(claims, iso230_2::ClaimKind::tested).holds();
  document.edition = standing_name(claims, axis);
  document.identity = {{plain(is_diagonal(axis) ? "Diagonal" : "Axis"), text_cell(description_of(axis))}};
  for (const auto& [name, key] : identity_fields) document.identity.push_back({plain(name), stated(key, metadata)});
  std::ranges::move(further_identity(metadata), std::back_inserter(document.identity));
  if (!holds) document.status.push_back(claim_notice(subject, claims, options));
  if (auto notice = tolerance_notice(subject, options)) document.status.push_back(*std::move(notice));
  if (holds) document.status.push_back(claim_notice(subject, claims, options));
  if (is_diagonal(axis))
    document.status.push_back(
        {Tone::caution,
         plain("Errors of several axes may cancel along a diagonal"),
         {plain("A small result proves little alone: all diagonals of the set and the single axes "
                "belong beside it.")}});
  if (const std::string corrected = correction_statement(subject.test.provenance.corrections); !corrected.empty())
    document.status.push_back(
        {Tone::normal,
         plain(corrected),
         {plain("What was done stands in Provenance, the readings as measured behind the results at the targets.")}});
  put_label(document, assessment.label);
  document.running_head = running_head(metadata, options);
  if (!metadata.conditions.report_number.empty())
    document.running_number =
        shortened(translated("Report " + metadata.conditions.report_number, options), running_number_length);
  document.running_status = running_status(subject, claims, options);
  document.date = metadata.conditions.date;
  return document;
}

}  // namespace axiometry::report
