// SPDX-License-Identifier: Apache-2.0
#include "cli/text/claims_text.h"

#include <fmt/format.h>

#include "axiometry/report/claim_text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/finding_text.h"
#include "axiometry/report/translated.h"
#include "cli/text/findings_text.h"
#include "cli/text/flags_of_words.h"
#include "cli/text/title_text.h"

namespace axiometry::cli {
namespace {

constexpr std::size_t answer_width = 6;

/// "feed speed is not stated (5.1); …": departures stand among the findings, and so does what the report lacks.
std::string not_stated(const app::Evaluated& e, const iso230_2::Claim& claim, const report::Options& options) {
  if (claim.kind != iso230_2::ClaimKind::tested) return "";
  std::string text;
  for (const iso230_2::Finding& point : claim.against)
    if (point.severity == iso230_2::Severity::missing)
      text += fmt::format(
          "{}{} ({})", text.empty() ? report::colon(options) : report::semicolon(options),
          report::translated(report::shown_message(point, e.assessment, e.test.metadata.axis.kind, options), options),
          point.clause);
  return text;
}

}  // namespace

std::string claims_text(const app::Evaluated& e, const iso230_2::Claims& claims, const report::Options& options,
                        const Terminal& terminal) {
  std::string text;
  for (const iso230_2::Claim& claim : claims) {
    const std::string answer = left(report::translated(claim.holds() ? "yes" : "no", options), answer_width);
    text += claim.holds()                    ? terminal.green(answer)
            : report::is_contradicted(claim) ? terminal.red(answer)
                                             : terminal.yellow(answer);
    std::string line = report::translated(claim.title, options);
    if (claim.holds() && claim.kind == iso230_2::ClaimKind::tested)
      line += ", " + report::translated(iso230_2::word_of_the_tester(e.test, e.environment()), options);
    if (!claim.holds()) {
      const std::string against = iso230_2::against_text(claim);
      line += std::string(report::colon(options)) + with_flags(report::translated(against, options), against);
    }
    line += not_stated(e, claim, options);
    text += wrapped(report::printable(line), terminal.width(), answer_width) + "\n";
  }
  return text + "\n";
}

}  // namespace axiometry::cli
