// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "axiometry/formats/table/generic_delimited.h"
#include "axiometry/formats/table/generic_table.h"

/// The shape of a table whose meaning is not yet known. Private to the generic importer.
namespace axiometry::formats::generic {

struct TableShape {
  RowRule rule;
  char decimal_mark = '.';
  bool mark_seen = false;  ///< some number has a decimal mark
  std::size_t columns = 0;
  std::size_t first_line = 0;                  ///< line of the file where the rows begin
  std::size_t row_count = 0;                   ///< rows up to the last one
  std::vector<std::vector<std::string>> rows;  ///< the first of them, at most rows_looked_at, without blank lines
  std::vector<PlainLine> row_lines;            ///< theirs
  std::vector<std::string> names;              ///< one per column; empty without a header
  std::vector<const Unit*> units;              ///< units below the names; empty without such a line
  std::span<const PlainLine> above;            ///< lines above header and rows
  std::size_t header_lines = 0;
  std::string comment = "#";
  std::string end;                       ///< beginning of the first line below the rows
  std::vector<GuessDecision> questions;  ///< questions about delimiter and decimal mark
};

inline constexpr std::size_t rows_looked_at = 5000;

/// The largest block of rows with the same number of cells, two of them numbers at least. Fails when there is none, and
/// when rows of numbers stand below it that have another number of cells.
Result<TableShape> find_shape(std::span<const PlainLine> lines);

/// How many rows with the same number of cells it would look at, whatever stands between and below them.
std::size_t rows_of_table(std::span<const PlainLine> lines);

}  // namespace axiometry::formats::generic
