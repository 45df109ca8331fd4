// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace axiometry::report {

/// How much of a result a second, independent way has found again, without any difference
/// (docs/theory/verification.md).
struct VerifiedFigures {
  std::size_t figures = 0;   ///< recomputed, at every place where they are printed
  std::size_t verdicts = 0;  ///< decided again
  std::size_t compared = 0;  ///< figures of GUM and Monte Carlo that agree wherever printed, but were not recomputed
};

/// "412 figures and 3 verdicts recomputed, none differs", and how many figures were not. Without full stop.
std::string verified_statement(const VerifiedFigures& verified);

}  // namespace axiometry::report
