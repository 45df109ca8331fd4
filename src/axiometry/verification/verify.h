// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/report/document.h"
#include "axiometry/verification/evidence.h"

/// The second opinion: every printed figure and verdict once more, from the decimals of the readings, in exact and
/// interval arithmetic, by code that shares nothing with the evaluation (tools/check_layers.py holds it to that).
/// What is recomputed, what is not, and within which bounds: docs/theory/verification.md.
namespace axiometry::verification {

/// What goes out to people and programs.
struct Issued {
  const json::Value& result;         ///< what `axiometry evaluate --json` wrote
  const report::Document& document;  ///< report before it is set
  std::string_view table_head{};     ///< head of the table of many tests, and this test's line; both empty: none
  std::string_view table_row{};
  int uncertainty_digits = 2;  ///< significant digits of U in the document
};

struct Counts {
  std::size_t figures = 0;
  std::size_t verdicts = 0;
  std::size_t compared = 0;
};

/// Fails where anything differs, naming the first differences with what was printed and what is right, and where
/// numbers are beyond the arithmetic (1e30): then nothing is verified, and that is said.
Result<Counts> verify(const Issued& issued, const Evidence& evidence);

}  // namespace axiometry::verification
