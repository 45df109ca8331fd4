// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/report/document.h"
#include "axiometry/verification/ledger.h"
#include "axiometry/verification/result_check.h"

namespace axiometry::verification {

/// Reads the numbers back out of a report before it is set, in English (writers translate words alone), and compares
/// each with what check_result() found of the test, at the places that it is printed to: half a unit of the last one,
/// and what rounding may do before. Verdicts and figures of the GUM and Monte Carlo methods must be those of the
/// result.
///
/// Read are the words about verdicts on the first page, the tables of parameters, decisions, methods, readings, results
/// at the targets, the budget of Annex A and what it corrects. A table of parameters or positions that is not found
/// is a difference. `uncertainty_digits`: significant digits of U.
void check_document(const report::Document& document, const json::Value& result, const Found& found,
                    const Evidence& evidence, int uncertainty_digits, Ledger& ledger);

/// One line of the table of many tests (`--report all.csv`) against its head: the parameters and their U in full
/// precision, and which parameters got which verdict.
void check_table_row(std::string_view head, std::string_view row, const json::Value& result, const Found& found,
                     Ledger& ledger);

}  // namespace axiometry::verification
