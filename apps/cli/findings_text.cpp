// SPDX-License-Identifier: Apache-2.0
#include "findings_text.h"

#include "axiometry/report/utf8.h"

namespace axiometry::cli {
namespace {

using iso230_2::Severity;

std::string severity_text(Severity severity, const Terminal& terminal) {
  const std::string name = left(iso230_2::severity_name(severity), 10);
  return severity == Severity::departure ? terminal.red(name)
         : severity == Severity::missing ? terminal.yellow(name)
                                         : terminal.faint(name);
}

}  // namespace

std::string findings_text(std::span<const iso230_2::Finding> findings, const Terminal& terminal) {
  std::string text;
  for (const auto& finding : findings)
    text += severity_text(finding.severity, terminal) + left(finding.clause, 8) +
            wrapped(report::printable(finding.message), terminal.width(), 18) + "\n";
  return text.empty() ? text : text + "\n";
}

}  // namespace axiometry::cli
