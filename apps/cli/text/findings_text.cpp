// SPDX-License-Identifier: Apache-2.0
#include "cli/text/findings_text.h"

#include <algorithm>

#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/translated.h"
#include "cli/text/flags_of_words.h"

namespace axiometry::cli {
namespace {

using iso230_2::Severity;

std::string severity_word(Severity severity, const report::Options& options) {
  return options.language == language::Language::german && severity == Severity::departure
             ? "Abweichung"  // the book's word is too long for a column
             : report::translated(iso230_2::severity_name(severity), options);
}

std::string severity_text(Severity severity, std::size_t width, const report::Options& options,
                          const Terminal& terminal) {
  const std::string name = left(severity_word(severity, options), width);
  return severity == Severity::departure ? terminal.red(name)
         : severity == Severity::missing ? terminal.yellow(name)
                                         : terminal.faint(name);
}

}  // namespace

std::string findings_text(std::span<const iso230_2::Finding> findings, const report::Options& options,
                          const Terminal& terminal) {
  std::string text;
  std::size_t width = 9;
  std::size_t clause_width = 7;
  for (const auto& finding : findings) {
    width = std::max(width, display_width(severity_word(finding.severity, options)));
    clause_width = std::max(clause_width, display_width(report::translated(finding.clause, options)));
  }
  ++width;
  ++clause_width;
  for (const auto& finding : findings)
    text += severity_text(finding.severity, width, options, terminal) +
            left(report::translated(finding.clause, options), clause_width) +
            wrapped(report::printable(with_flags(report::translated(finding.message, options), finding.message)),
                    terminal.width(), width + clause_width) +
            "\n";
  return text.empty() ? text : text + "\n";
}

}  // namespace axiometry::cli
