// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/verify.h"

#include <fmt/format.h>

#include <exception>
#include <string>

#include "axiometry/verification/document_check.h"

namespace axiometry::verification {
namespace {

constexpr std::size_t differences_named = 3;

std::string described(const Ledger& ledger) {
  std::string text;
  for (std::size_t k = 0; k < ledger.differences.size() && k < differences_named; ++k) {
    const Difference& difference = ledger.differences[k];
    text += fmt::format("{}{}: printed {}, right is {}", k == 0 ? "" : "; ", difference.place, difference.printed,
                        difference.right);
  }
  if (ledger.differences.size() > differences_named)
    text += fmt::format("; and {} more", ledger.differences.size() - differences_named);
  return text;
}

}  // namespace

Result<Counts> verify(const Issued& issued, const Evidence& evidence) {
  Ledger ledger;
  try {
    const Found found = check_result(issued.result, evidence, ledger);
    check_document(issued.document, issued.result, found, evidence, issued.uncertainty_digits, ledger);
    if (!issued.table_head.empty()) check_table_row(issued.table_head, issued.table_row, issued.result, found, ledger);
  } catch (const std::exception& beyond) {
    return fail(fmt::format("cannot verify: {}", beyond.what()));
  }
  if (!ledger.agrees())
    return fail(fmt::format("found figures that a second computation does not confirm, so that nothing is issued: {}",
                            described(ledger)));
  return Counts{ledger.figures, ledger.verdicts, ledger.compared};
}

}  // namespace axiometry::verification
