// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/report/document.h"
#include "axiometry/verification/ledger.h"
#include "axiometry/verification/printed_table.h"
#include "axiometry/verification/result_check.h"

/// The parts of check_document(), one per section of the report.
namespace axiometry::verification {

/// What every part compares with.
struct Page {
  const json::Value& result;
  const Found& found;
  const Evidence& evidence;
  int uncertainty_digits;
  Ledger& ledger;
};

/// The place of the target of a row by its number in the first column; nothing where it is none.
std::optional<std::size_t> target_of(const PrintedTable& table, std::size_t row, std::size_t targets);

/// The row of `tolerances` of a parameter; nullptr when it has no limit.
const json::Value* decision_of(const json::Value& result, std::string_view parameter_key);

void check_title(const report::Document& document, const Page& page);
void check_parameter_section(const report::Section& section, const Page& page);
void check_decision_section(const report::Section& section, const Page& page);
void check_method_section(const report::Section& section, const Page& page);
void check_position_section(const report::Section& section, const Page& page);
void check_annex_a_section(const report::Section& section, const Page& page);

}  // namespace axiometry::verification
