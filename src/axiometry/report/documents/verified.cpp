// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/verified.h"

#include <fmt/format.h>

namespace axiometry::report {

std::string verified_statement(const VerifiedFigures& verified) {
  std::string text =
      fmt::format("{} figures and {} verdicts recomputed, none differs", verified.figures, verified.verdicts);
  if (verified.compared > 0)
    text += fmt::format("; {} figures of GUM and Monte Carlo compared, not recomputed", verified.compared);
  return text;
}

}  // namespace axiometry::report
