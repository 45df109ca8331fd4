// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/csv_values.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_preamble.h"
#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

/// What a spreadsheet that parts lines by this sign would take for a formula: the first cell that begins as one.
std::string formula_in(std::string_view written, char separator) {
  for (const std::string_view line : text::split(written, '\n'))
    for (std::string_view cell : text::split(line, separator)) {
      cell = text::trim(cell);
      while (cell.starts_with('"')) cell = text::trim(cell.substr(1));
      const bool number = !cell.empty() && cell.find_first_not_of("+-.e0123456789\"") == std::string_view::npos;
      if (!cell.empty() && std::string_view("=+-@").contains(cell.front()) && !number && cell.size() > 1)
        return std::string(cell);
    }
  return "";
}

TEST(CsvValues, GiveSpreadsheetsNoFormulaAndOurReaderWhatWasWritten) {
  for (const char* id : {"csv-long", "csv-wide"})
    for (const char* nasty :
         {"=cmd|' /C calc'!A0", "mill;=cmd|' /C calc'!A0", "a, =1+2, \"=3\"", "@SUM(1,@x)", "a\t=1+1", "x;-y;+z",
          "\\\",=1", "ends with \\,=\\", "mill, -0.5; +3", "'=1", "plain", ",=", "=;=;=1"}) {
      const Format& format = *find_format(id);
      auto test = format.read("target_mm,direction,run,deviation_um\n0,up,1,-1\n0,up,2,-2\n5,up,1,2\n5,up,2,3\n");
      if (!test) test = format.read("target_mm,direction,run1_um,run2_um\n0,up,-1,-2\n5,up,2,3\n");
      ASSERT_TRUE(test) << test.error().to_string();
      test->provenance.file = nasty;
      test->metadata.machine.name = nasty;
      test->metadata.conditions.comment = nasty;
      test->metadata.equipment = {{.role = nasty, .manufacturer = "b", .type = nasty, .serial_number = "-7"}};
      test->metadata.environment.sensors = {{.role = "air", .location = nasty, .start = {}, .end = {}}};
      const std::string written = format.write(*test);
      for (const char separator : {',', ';', '\t'}) EXPECT_EQ(formula_in(written, separator), "") << written;
      const auto again = format.read(written);
      ASSERT_TRUE(again) << again.error().to_string() << written;
      EXPECT_EQ(again->metadata.machine.name, nasty);
      EXPECT_EQ(again->metadata.conditions.comment, nasty);
      ASSERT_EQ(again->metadata.equipment.size(), 1u);
      EXPECT_EQ(again->metadata.equipment[0].role, nasty);
      EXPECT_EQ(again->metadata.equipment[0].type, nasty);
      ASSERT_EQ(again->metadata.environment.sensors.size(), 1u);
      EXPECT_EQ(again->metadata.environment.sensors[0].location, nasty);
    }
}

TEST(CsvPreamble, TakesManyRecordsInTheirOrderAndAnEmptyOneTakesThemBack) {
  std::string text = "# equipment: away\n# equipment:\n# sensors: air | here | 20 | 21\n";
  for (std::size_t k = 0; k < read_budget::records; ++k)
    text += fmt::format("# equipment: Laser | Maker | L{0} | {0}\n", k);
  const auto preamble = read_preamble(text + "target_mm,direction,run,deviation_um\n");
  ASSERT_TRUE(preamble) << preamble.error().to_string();
  const auto metadata = metadata_of(*preamble, AxisKind::linear, '.');
  ASSERT_TRUE(metadata) << metadata.error().to_string();
  ASSERT_EQ(metadata->equipment.size(), read_budget::records);
  EXPECT_EQ(metadata->equipment.front().type, "L0");
  EXPECT_EQ(metadata->equipment.back().serial_number, "255");
  EXPECT_EQ(metadata->environment.sensors.size(), 1u);
}

}  // namespace
}  // namespace axiometry::formats
