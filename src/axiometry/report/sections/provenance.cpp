// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/base/version.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

/// A report goes to customers: the file's name is theirs to know, the folders of this machine are not.
std::string_view file_name(std::string_view path) {
  if (path == "-") return "standard input";
  return path.substr(path.find_last_of("/\\") + 1);  // npos + 1 is 0
}

/// "11 µm/(m·°C), 21.8 °C at the start to 22.9 °C at the end (mean of 2 sensors)"
std::string part_text(const AppliedExpansionCorrection::Part& part, const Options& options) {
  return fmt::format("{}\u00a0µm/(m·°C), {}\u00a0°C at the start to {}\u00a0°C at the end{}",
                     shown_exact(part.expansion.in_um_per_m_K(), options),
                     format_fixed(part.start.in_celsius(), 2, options.numbers),
                     format_fixed(part.end.in_celsius(), 2, options.numbers),
                     part.sensors > 1 ? fmt::format(" (mean of {} sensors)", part.sensors) : "");
}

/// What the program did to the readings, so that a reader can do it again.
void add_correction(Facts& facts, const AppliedExpansionCorrection& correction, const Options& options) {
  facts.facts.push_back(
      {plain("Correction for expansion"),
       text_cell(fmt::format(
           "applied by this program to the readings of the source, {} to {}\u00a0µm each; none at {}\u00a0mm; "
           "temperatures interpolated over the course of the test",
           format_fixed(correction.smallest.in_native(), 2, options.numbers),
           format_fixed(correction.largest.in_native(), 2, options.numbers),
           shown_exact(correction.datum.in_native(), options)))});
  facts.facts.push_back({plain("Expansion of the machine"), text_cell(part_text(correction.machine, options))});
  if (correction.equipment)
    facts.facts.push_back({plain("Expansion of the equipment"), text_cell(part_text(*correction.equipment, options))});
}

TableCell or_not_recorded(std::string_view text) { return text.empty() ? quiet_cell("not recorded") : text_cell(text); }

}  // namespace

Section provenance_section(const Subject& subject, const Options& options) {
  const Provenance& source = subject.test.provenance;
  Facts facts;
  facts.facts = {
      {plain("Source file"), or_not_recorded(file_name(source.file))},
      {plain("SHA-256 of the source"), or_not_recorded(source.sha256)},
      {plain("Format"), or_not_recorded(source.format)},
      {plain("Program"), text_cell(fmt::format("Axiometry {}", version))},
      {plain("Edition of the standard"),
       text_cell(fmt::format("{}; Amendment 1:2016 has not been taken into account", iso230_2::edition))},
  };
  if (source.expansion_correction) add_correction(facts, *source.expansion_correction, options);
  return {"provenance", "Provenance", false, {std::move(facts)}};
}

}  // namespace axiometry::report
