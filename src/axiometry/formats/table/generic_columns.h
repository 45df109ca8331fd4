// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/formats/table/generic_shape.h"

/// What the numbers of a column look like, whatever its name. Private to the generic importer.
namespace axiometry::formats::generic {

struct ColumnFacts {
  std::vector<double> values;  ///< one per row; NaN where there is no number
  std::size_t numbers = 0;
  std::size_t missing = 0;
  std::size_t words = 0;               ///< cells that are no numbers
  std::vector<std::string> spellings;  ///< spellings of the words, each once, at most five
  bool whole = true;                   ///< every number is whole
  std::size_t distinct = 0;            ///< different numbers
  double least = 0.0;
  double largest = 0.0;

  double range() const { return largest - least; }
  double magnitude() const;  ///< largest absolute number
  /// A few cells that are no numbers do not make it a column of words: the reader refuses them.
  bool numeric() const { return numbers > 4 * words; }
};

/// `from`: the first row that counts.
std::vector<ColumnFacts> facts_of(const TableShape& shape, std::size_t from = 0);

/// 1, 2, 3, … or 0, 1, 2, … down the rows.
bool counts_rows(const ColumnFacts& column);

/// The whole numbers from 0 or 1 on, each as often as every other or nearly so.
bool counts_runs(const ColumnFacts& column);

/// Whether the numbers rise, or fall, from each row to the next.
bool is_monotone(const std::vector<double>& values);

/// Few values that come back, or values that rise or fall all the way: what targets look like.
bool may_be_target(const ColumnFacts& column);

/// Whether every number of `column` lies within a hundredth of the range of `target` from that of the same row.
bool is_close_to(const ColumnFacts& column, const ColumnFacts& target);

/// +1 and −1 only, and both.
bool is_signs(const ColumnFacts& column);

}  // namespace axiometry::formats::generic
