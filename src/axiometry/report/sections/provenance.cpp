// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/base/version.h"
#include "axiometry/report/sections/sections.h"

namespace axiometry::report {

namespace {

/// A report goes to customers: the file's name is theirs to know, the folders of this machine are not.
std::string_view file_name(std::string_view path) {
  if (path == "-") return "standard input";
  return path.substr(path.find_last_of("/\\") + 1);  // npos + 1 is 0
}

TableCell or_not_recorded(std::string_view text) { return text.empty() ? quiet_cell("not recorded") : text_cell(text); }

}  // namespace

Section provenance_section(const Subject& subject) {
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
  return {"provenance", "Provenance", false, {std::move(facts)}};
}

}  // namespace axiometry::report
