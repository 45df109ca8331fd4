// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/report/document.h"
#include "axiometry/verification/exact.h"

/// A table as its reader sees it: texts by the head of their column.
namespace axiometry::verification {

/// The texts of all runs, a bar as U+0304.
std::string text_of(const report::RichText& text);

class PrintedTable {
 public:
  explicit PrintedTable(const report::Table& table);

  std::string_view caption() const { return caption_; }
  std::size_t row_count() const { return table_->rows.size(); }
  std::size_t column_count() const { return heads_.size(); }
  std::string_view head(std::size_t column) const { return heads_[column]; }
  /// Of the group that the column belongs to; empty without groups.
  std::string_view group(std::size_t column) const { return groups_[column]; }
  std::optional<std::size_t> column(std::string_view head) const;
  std::string cell(std::size_t row, std::size_t column) const { return text_of(table_->rows[row][column].text); }
  /// Empty where there is no such column.
  std::string cell(std::size_t row, std::string_view head) const;

 private:
  const report::Table* table_;
  std::string caption_;
  std::vector<std::string> heads_;
  std::vector<std::string> groups_;
};

/// How large one native unit (µm, ″) is in a unit as it is printed: "mm" 0.001. Nothing for what is no unit.
std::optional<Interval> scale_of_unit(std::string_view unit);

/// How many places before the decimal mark are no digits of numbers that end with so many digits of U: 2 for 4271.
int coarse_places(const Interval& U, int digits);

/// "A↑" of "A↑ *)".
std::string_view bare_symbol(std::string_view text);

/// Whether the text says that there is no number: empty, a dash, words.
bool says_nothing(std::string_view text);

}  // namespace axiometry::verification
