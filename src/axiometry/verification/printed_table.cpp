// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/printed_table.h"

#include <algorithm>

namespace axiometry::verification {

std::string text_of(const report::RichText& text) {
  std::string all;
  for (const report::TextRun& run : text) {
    all += run.text;
    if (run.bar) all += "\u0304";
  }
  return all;
}

PrintedTable::PrintedTable(const report::Table& table) : table_(&table), caption_(text_of(table.caption)) {
  for (const report::Column& column : table.columns) heads_.push_back(text_of(column.head));
  for (const report::ColumnGroup& group : table.groups)
    groups_.resize(groups_.size() + group.columns, text_of(group.head));
  groups_.resize(heads_.size());
}

std::optional<std::size_t> PrintedTable::column(std::string_view head) const {
  const auto found = std::ranges::find(heads_, head);
  if (found == heads_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - heads_.begin());
}

std::string PrintedTable::cell(std::size_t row, std::string_view head) const {
  const auto found = column(head);
  return found ? cell(row, *found) : std::string();
}

std::optional<Interval> scale_of_unit(std::string_view unit) {
  if (unit == "µm" || unit == "″") return Interval(1);
  if (unit == "mm") return Interval(1) / Interval(1000);
  if (unit == "nm") return Interval(1000);
  if (unit == "°") return Interval(1) / Interval(3600);
  return std::nullopt;
}

int coarse_places(const Interval& U, int digits) {
  int coarse = 0;
  // 99.5 is shown as 100 with two digits.
  while (coarse < 30 && U.upper() >= Interval::of(Decimal{2 * power_of_ten(digits) - 1, coarse}).lower() / 2) ++coarse;
  return coarse;
}

std::string_view bare_symbol(std::string_view text) {
  constexpr std::string_view star = "\u2009*)";
  if (text.ends_with(star)) text.remove_suffix(star.size());
  return text;
}

bool says_nothing(std::string_view text) { return !decimal_of(text).has_value(); }

}  // namespace axiometry::verification
