// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/table/generic_columns.h"
#include "axiometry/formats/table/generic_delimited.h"
#include "axiometry/formats/table/generic_shape.h"
#include "axiometry/formats/text/head_words.h"

/// A guess in the making: what is known of the table, and what was decided so far. Private to the generic importer; the
/// steps come in the order of the declarations.
namespace axiometry::formats::generic {

struct Draft {
  TableShape shape;
  std::vector<Head> heads;         ///< one per column; all unknown without a header
  std::vector<ColumnFacts> facts;  ///< one per column
  DefaultUnits stated;             ///< units for the whole file, above the table
  Guess guess;

  ImportColumn& column(std::size_t c) { return guess.profile.columns[c]; }
  /// `column 2 "Soll [mm]"`.
  std::string called(std::size_t c) const;
  std::optional<std::size_t> find(ImportRole role) const;
  void decide(std::string key, std::string value, double confidence, std::string reason);
  void ask(std::string key, std::string question);
  void give_role(std::size_t c, ImportRole role, double confidence, std::string reason);
};

/// "Axis" above a few whole numbers that come back: each may be another axis, whose rows are none of this one.
bool may_number_axes(std::string_view name, const ColumnFacts& facts);
void ask_about_axes(Draft& draft, std::size_t c, const ColumnFacts& facts);

/// Whether the targets stand across; then everything is decided here.
bool decide_transposed(Draft& draft);

/// Which column holds what, in a table with its targets in a column.
void decide_columns(Draft& draft);

/// Units of targets and readings, and the sign of deviations beside measured positions.
void decide_units(Draft& draft);

/// Where directions and runs come from.
void decide_rules(Draft& draft);

}  // namespace axiometry::formats::generic
