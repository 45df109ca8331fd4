// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/model/aligned.h"
#include "axiometry/report/conformity_text.h"
#include "axiometry/report/documents/lines_sections.h"
#include "axiometry/report/figures/figures.h"
#include "axiometry/report/finding_text.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/readings/runs_made.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report {
namespace {

using iso230_2::Severity;
using uncertainty::Verdict;

constexpr std::size_t departures_named = 3;  // on the first page

/// "ISO 230-2:2014 and ISO 230-6:2002", of what was measured.
std::string editions(const LinesSubject& subject) {
  const bool axes = std::ranges::any_of(
      subject.lines, [](const AssessedLine& line) { return !is_diagonal(line.line.test.metadata.axis); });
  if (!has_diagonal(subject)) return std::string(iso230_2::edition);
  return axes ? fmt::format("{} and {}", iso230_2::edition, iso230_6::edition)
              : fmt::format("{}, parameters as in {}", iso230_6::edition, iso230_2::edition);
}

bool is_tested(const AssessedLine& line) {
  return claim(iso230_2::claims_of(line.line.test, line.assessment), iso230_2::ClaimKind::tested).holds();
}

std::string names_of(const LinesSubject& subject, bool tested) {
  std::string names;
  for (const AssessedLine& line : subject.lines)
    if (is_tested(line) == tested) names += (names.empty() ? "" : ", ") + line.line.id;
  return names;
}

bool all_conform(const LinesSubject& subject) { return names_of(subject, false).empty() && !subject.lines.empty(); }

/// The findings of every line in the unit that was asked for.
std::vector<std::vector<iso230_2::Finding>> findings_of(const LinesSubject& subject, const Options& options) {
  std::vector<std::vector<iso230_2::Finding>> all;
  for (const AssessedLine& line : subject.lines)
    all.push_back(
        shown_findings(line.assessment.findings, line.assessment, line.line.test.metadata.axis.kind, options));
  return all;
}

Section findings_of_lines(const LinesSubject& subject, const Options& options) {
  const auto findings = findings_of(subject, options);
  std::vector<NamedFindings> named;
  for (std::size_t k = 0; k < findings.size(); ++k) named.push_back({subject.lines[k].line.id, findings[k]});
  return finding_section(named);
}

bool any_departs(const LinesSubject& subject) {
  return std::ranges::any_of(subject.lines, [](const AssessedLine& line) { return !line.assessment.conforming(); });
}

Notice conformance_notice(const LinesSubject& subject, const Options& options) {
  if (all_conform(subject))
    return {Tone::normal, plain(fmt::format("All lines tested in accordance with {}", editions(subject))), {}};
  Notice notice{any_departs(subject) ? Tone::bad : Tone::caution,
                plain("Not every line may be called tested in accordance with its standard, see Claims"),
                {}};
  if (const std::string good = names_of(subject, true); !good.empty())
    notice.lines.push_back(plain(fmt::format("Tested in accordance with the standard: {}.", good)));
  notice.lines.push_back(plain(fmt::format("Evaluated with its formulas only: {}.", names_of(subject, false))));
  std::vector<std::string> named;
  for (const AssessedLine& line : subject.lines)
    for (const iso230_2::Finding& finding : line.assessment.findings) {
      const bool told = std::ranges::find(named, finding.message) != named.end();
      if (finding.severity != Severity::departure || told || named.size() >= departures_named) continue;
      named.push_back(finding.message);
      const AxisKind kind = line.line.test.metadata.axis.kind;
      notice.lines.push_back(joined({strong_verbatim(line.line.id), plain(": "),
                                     finding_line(shown_finding(finding, line.assessment, kind, options))}));
    }
  return notice;
}

/// "3 lines do not conform, 1 is undecided, 3 conform"
std::string heading_of(const LinesSubject& subject) {
  std::array<std::size_t, 3> counts{};
  constexpr std::array<Verdict, 3> verdicts = {Verdict::does_not_conform, Verdict::undecided, Verdict::conforms};
  constexpr std::array<std::array<std::string_view, 2>, 3> words = {
      {{"does not conform", "do not conform"}, {"is undecided", "are undecided"}, {"conforms", "conform"}}};
  for (const AssessedLine& line : subject.lines)
    for (std::size_t k = 0; k < verdicts.size(); ++k)
      counts[k] += iso230_2::overall_verdict(line.judgements) == verdicts[k] ? 1 : 0;
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (counts[k] > 0)
      text += fmt::format("{}{}{} {}", text.empty() ? "" : ", ", counts[k],
                          !text.empty()    ? ""
                          : counts[k] == 1 ? " line"
                                           : " lines",
                          words[k][counts[k] == 1 ? 0 : 1]);
  return text.empty() ? "no verdict" : text;
}

/// "Does not conform: E, A" of each line that was judged, the worst first; all in one.
std::optional<Notice> tolerances_notice(const LinesSubject& subject) {
  constexpr std::pair<Verdict, std::string_view> words[] = {{Verdict::does_not_conform, "does not conform"},
                                                            {Verdict::undecided, "is undecided"},
                                                            {Verdict::conforms, "conforms"},
                                                            {Verdict::not_applicable, "has no verdict"}};
  std::optional<Notice> notice;
  for (const auto& [verdict, word] : words)
    for (const AssessedLine& line : subject.lines) {
      const RichText symbols = symbols_with(line.judgements, verdict);
      if (symbols.empty()) continue;
      if (!notice)
        notice = Notice{tone_of(verdict), plain(fmt::format("Tolerances: line {} {}", line.line.id, word)), {}};
      notice->lines.push_back(
          joined({plain("Line "), strong_verbatim(line.line.id), plain(fmt::format(" {}: ", word)), symbols}));
    }
  if (notice && notice->lines.size() > 1) notice->heading = plain(fmt::format("Tolerances: {}", heading_of(subject)));
  return notice;
}

std::vector<Notice> status(const LinesSubject& subject, const Options& options) {
  std::vector<Notice> all;
  if (!all_conform(subject)) all.push_back(conformance_notice(subject, options));
  Notice serious{Tone::bad, plain("The lengths or the station are in doubt"), {}};
  for (const tracking::Finding& finding : subject.evaluation.findings)
    if (finding.serious) serious.lines.push_back(sentence(finding.message));
  if (!serious.lines.empty()) all.push_back(std::move(serious));
  if (auto notice = tolerances_notice(subject)) all.push_back(*std::move(notice));
  if (all_conform(subject)) all.push_back(conformance_notice(subject, options));
  if (!subject.plan.lost.empty()) {
    Notice lost{Tone::caution,
                plain(is_aligned(subject.plan.setup) ? "Not all lines could be measured"
                                                     : "Not all lines could be measured from this station"),
                {}};
    for (const LostLine& line : subject.plan.lost)
      lost.lines.push_back(joined({strong_verbatim(line.id), plain(": "), prose(line.reason)}));
    all.push_back(std::move(lost));
  }
  return all;
}

std::string line_names(const LinesSubject& subject) {
  std::string names;
  for (const AssessedLine& line : subject.lines) names += (names.empty() ? "" : ", ") + line.line.id;
  return names;
}

Document front_page(const LinesSubject& subject, const Options& options) {
  Document document;
  const bool good = all_conform(subject);
  document.kind = "Test report";
  document.title = is_aligned(subject.plan.setup) ? "Diagonals of a machine tool, by an aligned interferometer"
                   : has_diagonal(subject)        ? "Axes and diagonals of a machine tool, by a tracking interferometer"
                                                  : "Axes of a machine tool, by a tracking interferometer";
  document.edition = good ? editions(subject) : fmt::format("Formulas of {}", editions(subject));
  document.identity = {{plain("Lines"), verbatim_cell(line_names(subject))}};
  const Metadata none;
  const Metadata& metadata = subject.lines.empty() ? none : subject.lines.front().line.test.metadata;
  const std::string& machine = metadata.machine.name.empty() ? subject.plan.machine : metadata.machine.name;
  document.identity.push_back({plain("Machine"), machine.empty() ? quiet_cell("not stated") : verbatim_cell(machine)});
  document.identity.push_back({plain("Serial number"), stated("machine.serial_number", metadata)});
  document.identity.push_back({plain("Date of test"), stated("test.date", metadata)});
  document.identity.push_back({plain("Report number"), stated("test.report_number", metadata)});
  std::ranges::move(further_identity(metadata), std::back_inserter(document.identity));
  document.status = status(subject, options);
  std::string label;
  for (const AssessedLine& line : subject.lines)
    if (label.empty()) label = line.assessment.label;
  put_label(document, std::move(label));
  document.running_head = translated("Lines", options) + " " + line_names(subject);
  if (!machine.empty()) document.running_head += " · " + machine;
  if (!metadata.conditions.report_number.empty())
    document.running_number = translated("Report " + metadata.conditions.report_number, options);
  document.running_status = document.edition + (document.label.empty() ? "" : " · " + document.label);
  document.date = metadata.conditions.date;
  return document;
}

/// What the program writes where all axes move is no word of the user.
TableCell resting_axes_cell(const Metadata& metadata) {
  const std::string& text = metadata.conditions.axes_not_under_test;
  return text.empty() ? quiet_cell("not stated") : text == "none" ? text_cell(text) : verbatim_cell(text);
}

Facts line_facts(const AssessedLine& line, bool aligned, const Options& options) {
  const Test& test = line.line.test;
  const Axis& axis = test.metadata.axis;
  Facts facts;
  const auto add = [&](std::string_view name, std::string value) {
    facts.facts.push_back({plain(name), value.empty() ? quiet_cell("not stated") : text_cell(value)});
  };
  add("Line", description_of(axis));
  add("Moves with growing position", octant_of(axis));
  add("Edition", edition_of(axis));
  facts.facts.push_back({plain("Axes not under test"), resting_axes_cell(test.metadata)});
  const auto& targets = test.series.targets();
  const int decimals = position_decimals(targets);
  add("Targets", fmt::format("{} from {} to {}, up to {} from a direction", targets.size(),
                             shown_mm(targets.front().in_native(), decimals, options),
                             shown_mm(targets.back().in_native(), decimals, options),
                             counted(most_runs_made(test.series), "approach", "approaches")));
  if (!line.line.distances_mm.empty()) {
    const auto [least, most] = std::ranges::minmax(line.line.distances_mm);
    add(aligned ? "Distance from the beginning of the line" : "Distance from the station",
        fmt::format("{} to {}", shown_mm(least, 1, options), shown_mm(most, 1, options)));
  }
  return facts;
}

Table break_table(const std::vector<tracking::BeamBreak>& breaks, const Options& options) {
  Table table;
  table.caption = plain("Breaks of the beam");
  table.columns = {{plain("Before reading"), Align::decimal, true}, {plain("Jump of the length / mm"), Align::decimal}};
  for (const tracking::BeamBreak& found : breaks)
    table.rows.push_back({text_cell(fmt::format("{}", found.before_reading + 1)),
                          text_cell(format_fixed(found.jump_mm, 4, options.numbers))});
  table.notes = {plain("What was measured between two breaks has a dead path of its own.")};
  return table;
}

/// "Figure 2. Bidirectional …" would stand in the report once for each line.
std::string caption(const std::string& title, const std::string& line) {
  const auto end = title.find(". ");
  return fmt::format("Line {}. {}", line,
                     title.starts_with("Figure ") && end != title.npos ? title.substr(end + 2) : title);
}

Section line_section(const AssessedLine& line, bool aligned, const Options& asked) {
  const Options options = fitted(asked, line.assessment.evaluation.parameters);
  const Subject subject = subject_of(line);
  Section section{"line-" + line.line.id,
                  fmt::format("Line {} ({})", line.line.id, standard_of(line.line.test.metadata.axis)),
                  true,
                  {}};
  section.blocks.emplace_back(line_facts(line, aligned, options));
  if (auto all = figures(subject, options); !all.empty()) {
    all.front().title = caption(all.front().title, line.line.id);
    section.blocks.emplace_back(std::move(all.front()));
  }
  for (Block& block : parameter_section(subject, options).blocks) section.blocks.push_back(std::move(block));
  if (!line.line.breaks.empty()) section.blocks.emplace_back(break_table(line.line.breaks, options));
  const auto append = [&](Section part) { std::ranges::move(part.blocks, std::back_inserter(section.blocks)); };
  if (!subject.judgements.empty()) append(conformity_section(subject, options));
  if (line.assessment.gum || line.assessment.monte_carlo) {
    append(method_section(subject, options));
    append(contribution_section(subject, options));
  }
  if (line.assessment.annex_a) append(uncertainty_section(subject, options));
  return section;
}

/// "Machine name: Mill 5" of each group.
std::set<std::string> facts_in(const Section& section) {
  std::set<std::string> all;
  for (const Block& block : section.blocks)
    if (const auto* facts = std::get_if<Facts>(&block))
      for (const Fact& fact : facts->facts)
        all.insert(fmt::format("{}\n{}\n{}", facts->title, plain_text(fact.name), plain_text(fact.value.text)));
  return all;
}

/// What holds for every line. What is a line's own stands with the line.
Section common_identification(const LinesSubject& subject, const Options& options) {
  Section section = identification_section(subject_of(subject.lines.front()), false, options);
  std::erase_if(section.blocks, [](const Block& block) {
    const auto* facts = std::get_if<Facts>(&block);
    return facts != nullptr && facts->title == "Axis under test";
  });
  for (const AssessedLine& line : subject.lines) {
    const std::set<std::string> of_line = facts_in(identification_section(subject_of(line), false, options));
    for (Block& block : section.blocks)
      if (auto* facts = std::get_if<Facts>(&block))
        std::erase_if(facts->facts, [&](const Fact& fact) {
          const std::string name = plain_text(fact.name);
          return name == "Target positions" || name.starts_with("Number of approaches") ||
                 name.starts_with("Tracking interferometer") ||
                 !of_line.contains(fmt::format("{}\n{}\n{}", facts->title, name, plain_text(fact.value.text)));
        });
  }
  std::erase_if(section.blocks, [](const Block& block) {
    const auto* facts = std::get_if<Facts>(&block);
    return facts != nullptr && facts->facts.empty();
  });
  return section;
}

Section lines_provenance(const LinesSubject& subject) {
  Facts facts;
  const auto add = [&](std::string_view name, const std::string& value) {
    facts.facts.push_back({plain(name), value.empty() ? quiet_cell("not recorded") : text_cell(value)});
  };
  const auto add_verbatim = [&](std::string_view name, const std::string& value) {
    facts.facts.push_back({plain(name), value.empty() ? quiet_cell("not recorded") : verbatim_cell(value)});
  };
  facts.facts.push_back({plain("Measured lengths"), file_cell(subject.file)});
  add_verbatim("SHA-256 of the file", subject.sha256);
  if (!subject.plan.title.empty()) add_verbatim("Plan", subject.plan.title);
  for (const SourceFile& other : subject.others) {
    facts.facts.push_back({plain(other.what), file_cell(other.file)});
    add_verbatim("SHA-256 of the file", std::string(other.sha256));
  }
  add("Program", program_text());
  for (const bool diagonal : {false, true})
    for (const AssessedLine& line : subject.lines) {
      const Axis& axis = line.line.test.metadata.axis;
      if (is_diagonal(axis) != diagonal) continue;
      add(diagonal ? "Edition for diagonals" : "Edition for axes",
          fmt::format("{}; {}", edition_of(axis), edition_remark(axis)));
      break;  // the others have the same
    }
  return {"provenance", "Provenance", false, {std::move(facts)}};
}

}  // namespace

Document compose(const LinesSubject& subject, const Options& options) {
  Document document = front_page(subject, options);
  auto& sections = document.sections;
  sections.push_back(overview_section(subject, options));
  if (has_diagonal(subject)) sections.push_back(diagonal_section(subject, options));
  if (subject.evaluation.squareness) sections.push_back(squareness_section(subject, options));
  const bool aligned = is_aligned(subject.plan.setup);
  if (!aligned) sections.push_back(length_difference_section(subject, options));
  for (const AssessedLine& line : subject.lines) sections.push_back(line_section(line, aligned, options));
  sections.push_back(lines_claim_section(subject));
  Section findings = findings_of_lines(subject, options);
  if (auto table = tracking_finding_table(subject.evaluation.findings))
    findings.blocks.insert(findings.blocks.begin(), *std::move(table));
  sections.push_back(std::move(findings));
  sections.push_back(setup_section(subject, options));
  if (!subject.lines.empty()) sections.push_back(common_identification(subject, options));
  for (const AssessedLine& line : subject.lines) {
    Section readings = position_section(subject_of(line), fitted(options, line.assessment.evaluation.parameters));
    readings.id = "readings-" + line.line.id;
    readings.title = fmt::format("Line {}: {}", line.line.id, readings.title);
    sections.push_back(std::move(readings));
  }
  sections.push_back(lines_provenance(subject));
  sections.push_back(release_section(subject.lines.empty() ? Metadata{} : subject.lines.front().line.test.metadata));
  return document;
}

}  // namespace axiometry::report
