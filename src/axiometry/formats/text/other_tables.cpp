// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/other_tables.h"

#include <algorithm>
#include <string>
#include <vector>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/text_lines.h"

namespace axiometry::formats {
namespace {

/// Known by the names of columns that no table of readings has together.
struct OtherTable {
  std::vector<std::string_view> columns;
  const char* refusal;
};

const std::vector<OtherTable>& known_other_tables() {
  static const std::vector<OtherTable> tables = {
      {{"record", "target_unit", "name", "value"},
       "found a report as CSV, which holds results, expected the readings that it was made from"},
      {{"file", "test", "axis", "kind", "conforming"},
       "found a table of the results of many tests, expected the readings that it was made from"},
      {{"name", "kind", "travel_up_to"},
       "found tolerance tables, expected a measured test, beside which such a file is given"},
      {{"line", "target", "direction", "run", "length_difference_mm"},
       "found lengths of a tracking interferometer, expected a measured test; 'axiometry tracking evaluate' takes "
       "them"},
      {{"station", "tool", "segment", "length_mm"},
       "found lengths of a volumetric calibration, expected a measured test; 'axiometry volumetric identify' takes "
       "them"}};
  return tables;
}

/// Names of the columns in the first line that is no comment, in lower case.
std::vector<std::string> columns_above(std::string_view text) {
  std::vector<std::string> columns;
  for (const TextLine& line : content_lines(text)) {
    if (line.text.starts_with('#')) continue;
    const auto many = [&](char mark) { return std::ranges::count(line.text, mark); };
    const char mark = *std::ranges::max_element(std::string_view(",;\t"), {}, many);
    for (std::string_view name : text::split(line.text, mark)) {
      name = text::trim(name);
      if (name.size() > 1 && name.starts_with('"') && name.ends_with('"')) name = name.substr(1, name.size() - 2);
      columns.push_back(text::to_lower(name));
    }
    break;
  }
  return columns;
}

}  // namespace

Result<void> check_no_other_table(std::string_view text) {
  const std::vector<std::string> columns = columns_above(text);
  const auto is_there = [&](std::string_view name) { return std::ranges::find(columns, name) != columns.end(); };
  for (const OtherTable& table : known_other_tables())
    if (std::ranges::all_of(table.columns, is_there)) return fail(table.refusal);
  return {};
}

}  // namespace axiometry::formats
