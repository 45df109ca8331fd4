// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/table/generic_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace axiometry::formats::generic {
namespace {

std::map<double, std::size_t> counts(const ColumnFacts& column) {
  std::map<double, std::size_t> result;
  for (double x : column.values)
    if (!std::isnan(x)) ++result[x];
  return result;
}

ColumnFacts facts_of_column(const TableShape& shape, std::size_t c, std::size_t from) {
  constexpr std::size_t most_spellings = 5;
  ColumnFacts facts;
  facts.least = std::numeric_limits<double>::infinity();
  facts.largest = -facts.least;
  for (std::size_t r = from; r < shape.rows.size(); ++r) {
    const std::string& cell = shape.rows[r][c];
    const auto number = number_in(cell, shape.decimal_mark);
    facts.values.push_back(number.value_or(std::numeric_limits<double>::quiet_NaN()));
    if (number) {
      ++facts.numbers;
      facts.whole = facts.whole && std::floor(*number) == *number;
      facts.least = std::min(facts.least, *number);
      facts.largest = std::max(facts.largest, *number);
    } else if (cell != "-" && is_missing(cell)) {
      ++facts.missing;
    } else if (is_bad_number(cell)) {
      ++facts.missing;  // the reader refuses it, naming the place
    } else {
      ++facts.words;
      if (facts.spellings.size() < most_spellings && std::ranges::find(facts.spellings, cell) == facts.spellings.end())
        facts.spellings.push_back(cell);
    }
  }
  // "-" is a missing reading among numbers, and a direction among other words.
  if (facts.numbers > 0 && facts.spellings == std::vector<std::string>{"-"}) {
    facts.missing += std::exchange(facts.words, 0);
    facts.spellings.clear();
  }
  facts.distinct = counts(facts).size();
  if (facts.numbers == 0) facts.least = facts.largest = 0.0;
  return facts;
}

}  // namespace

double ColumnFacts::magnitude() const { return std::max(std::abs(least), std::abs(largest)); }

std::vector<ColumnFacts> facts_of(const TableShape& shape, std::size_t from) {
  std::vector<ColumnFacts> facts;
  for (std::size_t c = 0; c < shape.columns; ++c) facts.push_back(facts_of_column(shape, c, from));
  return facts;
}

bool counts_rows(const ColumnFacts& column) {
  if (column.numbers != column.values.size() || column.numbers < 2 || !column.whole) return false;
  if (column.values.front() != 0.0 && column.values.front() != 1.0) return false;
  for (std::size_t k = 1; k < column.values.size(); ++k)
    if (column.values[k] != column.values[k - 1] + 1.0) return false;
  return true;
}

bool counts_runs(const ColumnFacts& column) {
  if (!column.numeric() || !column.whole || column.missing > 0 || column.distinct * 2 > column.numbers) return false;
  if (column.least != 0.0 && column.least != 1.0) return false;
  if (column.range() + 1.0 != static_cast<double>(column.distinct)) return false;
  std::size_t fewest = column.numbers;
  std::size_t most = 0;
  for (const auto& [value, count] : counts(column)) {
    fewest = std::min(fewest, count);
    most = std::max(most, count);
  }
  return most <= 2 * fewest;  // a run may have been broken off
}

bool is_monotone(const std::vector<double>& values) {
  if (values.size() < 2) return false;
  const bool rising = values[1] > values[0];
  for (std::size_t k = 1; k < values.size(); ++k)
    if (!(rising ? values[k] > values[k - 1] : values[k] < values[k - 1])) return false;
  return true;
}

bool may_be_target(const ColumnFacts& column) {
  if (!column.numeric() || column.missing > 0 || column.distinct < 2) return false;
  return column.distinct * 2 <= column.numbers || is_monotone(column.values);
}

bool is_close_to(const ColumnFacts& column, const ColumnFacts& target) {
  constexpr double share = 0.01;
  if (!column.numeric()) return false;
  for (std::size_t k = 0; k < column.values.size(); ++k)
    if (std::abs(column.values[k] - target.values[k]) > share * target.range()) return false;
  return true;
}

bool is_signs(const ColumnFacts& column) {
  return column.numeric() && column.distinct == 2 && column.least == -1.0 && column.largest == 1.0;
}

}  // namespace axiometry::formats::generic
