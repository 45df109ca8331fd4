// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/verified.h"

#include <fmt/format.h>

#include "axiometry/base/counted.h"

namespace axiometry::report {

std::string verified_statement(const VerifiedFigures& verified) {
  std::string text = fmt::format("{} and {} recomputed, none differs", counted(verified.figures, "figure"),
                                 counted(verified.verdicts, "verdict"));
  if (verified.compared > 0)
    text += fmt::format("; {} of GUM and Monte Carlo compared, not recomputed", counted(verified.compared, "figure"));
  return text;
}

}  // namespace axiometry::report
