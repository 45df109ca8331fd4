// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/tolerance_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/series.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;

constexpr std::string_view two_tables =
    "# limits of the hall\n"
    "name,kind,travel_up_to,unit,rule,A,R_up\n"
    "Mill,linear,800,um,,20,7\n"
    "Mill,linear,500,um,iso14253-1,16,\n"
    "Mill,rotary,360,arcsec,,18,6\n"
    "Grinder,linear,,mm,guard-band=1um,0.008,0.003\n";

ToleranceTable table(std::string_view text) {
  auto read = read_tolerance_table(text, "limits.csv");
  EXPECT_TRUE(read) << read.error().to_string();
  return *std::move(read);
}

/// "line:column: message"
std::string refusal_of_table(std::string_view text) {
  const auto read = read_tolerance_table(text, "limits.csv");
  if (read) return "";
  const Error& e = read.error();
  return std::to_string(e.at.line) + ":" + std::to_string(e.at.column) + ": " + e.message;
}

Series series_over(double travel) { return testing_support::make_series({0.1, 0.1 + travel}, {{1, 2}}, {{1, 2}}); }

std::size_t line_for(double travel, std::string_view name = "Mill", AxisKind kind = AxisKind::linear) {
  static const ToleranceTable both = table(two_tables);
  const auto band = select_band(both, name, kind, series_over(travel));
  EXPECT_TRUE(band) << band.error().message;
  return (*band)->line;
}

TEST(ToleranceTable, ReadsLimitsInTheUnitOfTheirRow) {
  const ToleranceTable both = table(two_tables);
  ASSERT_EQ(both.bands.size(), 4u);
  EXPECT_EQ(both.bands[1].limits.size(), 1u);  // an empty cell is no limit
  EXPECT_EQ(both.bands[2].kind, AxisKind::rotary);
  EXPECT_EQ(both.bands[3].limits.at(0).limit.in_native(), 8.0);
  EXPECT_EQ(both.bands[3].limits.at(1).parameter->key, "R_up");
  EXPECT_EQ(both.bands[3].rule->guard_band, 1.0);
  EXPECT_EQ(both.bands[3].limits.at(0).source, iso230_2::ToleranceSource::table);
}

TEST(ToleranceTable, ReadsWhatASpreadsheetWithDecimalCommasWrites) {
  const ToleranceTable one =
      table("\xEF\xBB\xBFName;Kind;Travel_up_to;Unit;a;R↑;;\r\n\r\n\"Mill; large\";linear;500,5;µm;16,5;6;;\r\n");
  ASSERT_EQ(one.bands.size(), 1u);
  EXPECT_EQ(one.bands[0].name, "Mill; large");
  EXPECT_EQ(one.bands[0].travel_max->in_native(), 500.5);
  EXPECT_EQ(one.bands[0].limits.at(0).limit.in_native(), 16.5);
}

TEST(ToleranceTable, ChoosesTheNarrowestBandWhateverTheOrderOfTheRows) {
  EXPECT_EQ(line_for(300), 4u);
  EXPECT_EQ(line_for(500), 4u);  // 500.1 − 0.1 is not quite 500
  EXPECT_EQ(line_for(500.01), 3u);
  EXPECT_EQ(line_for(800), 3u);
  EXPECT_EQ(line_for(359, "mill", AxisKind::rotary), 5u);
  EXPECT_EQ(line_for(1e5, "GRINDER"), 6u);
}

TEST(ToleranceTable, ListsWhatThereIsWhenNothingFits) {
  const ToleranceTable both = table(two_tables);
  const auto message = [&](std::string_view name, AxisKind kind, double travel) {
    const auto band = select_band(both, name, kind, series_over(travel));
    return band ? std::string() : band.error().message;
  };
  EXPECT_EQ(message("", AxisKind::linear, 100),
            "found no name of a tolerance table, expected one of those in limits.csv: Mill; Grinder");
  EXPECT_EQ(message("Lathe", AxisKind::linear, 100),
            "found the tolerance table \"Lathe\", expected one of those in limits.csv: Mill; Grinder");
  EXPECT_EQ(message("Grinder", AxisKind::rotary, 100),
            "found a rotary axis, expected one that the tolerance table \"Grinder\" in limits.csv has limits for");
  EXPECT_EQ(message("Mill", AxisKind::linear, 900),
            "found a measured travel of 900 mm, expected one that the tolerance table \"Mill\" in limits.csv has "
            "limits for: up to 800 mm");
}

TEST(ToleranceTable, NeedsNoNameWhenThereIsOne) {
  const ToleranceTable one = table("name,kind,travel_up_to,unit,A\nMill,linear,,um,20\n");
  EXPECT_TRUE(select_band(one, "", AxisKind::linear, series_over(1)));
}

TEST(ToleranceTable, RefusesAHeaderThatItDoesNotUnderstand) {
  EXPECT_THAT(refusal_of_table(""), HasSubstr("found no limits, expected a header"));
  EXPECT_THAT(refusal_of_table("# nothing\n"), HasSubstr("found no limits, expected a header"));
  EXPECT_EQ(refusal_of_table("name,kind,travel_upto,unit,A\n"),
            "1:11: found the column \"travel_upto\", expected perhaps travel_up_to");
  EXPECT_THAT(refusal_of_table("name,kind,travel_up_to,unit,Q\n"),
              HasSubstr("1:29: found the column \"Q\", expected one of"));
  EXPECT_EQ(refusal_of_table("name,kind,travel_up_to,unit,A,a\n"),
            "1:31: found the column \"a\" a second time, expected each once");
  EXPECT_THAT(refusal_of_table("name,kind,unit,A\n"), HasSubstr("1:1: found no column travel_up_to"));
  EXPECT_THAT(refusal_of_table("name,kind,travel_up_to,unit,rule\n"), HasSubstr("1:1: found no column of limits"));
}

TEST(ToleranceTable, RefusesACellThatIsNotWhatItsColumnSays) {
  const auto row = [](std::string_view cells) {
    return refusal_of_table("name,kind,travel_up_to,unit,rule,A,E\n" + std::string(cells) + "\n");
  };
  EXPECT_EQ(row(",linear,500,um,,1,1"), "2:1: found an empty name, expected that of a tolerance table");
  EXPECT_EQ(row("M,straight,500,um,,1,1"), "2:3: found the kind \"straight\", expected linear or rotary");
  EXPECT_THAT(row("M,linear,-5,um,,1,1"), HasSubstr("2:10: found the travel \"-5\", expected a number above 0"));
  EXPECT_THAT(row("M,linear,0,um,,1,1"), HasSubstr("2:10: found the travel \"0\""));
  EXPECT_THAT(row("M,linear,wide,um,,1,1"), HasSubstr("2:10: found \"wide\", expected a finite number"));
  EXPECT_EQ(row("M,linear,5,arcsec,,1,1"), "2:12: found the unit \"arcsec\" for a linear axis, expected um, mm or nm");
  EXPECT_EQ(row("M,linear,5,,,1,1"), "2:12: found the unit \"\" for a linear axis, expected um, mm or nm");
  EXPECT_THAT(row("M,linear,5,um,strict,1,1"), HasSubstr("2:15: found the rule \"strict\""));
  EXPECT_THAT(row("M,linear,5,um,guard-band=3arcsec,1,1"), HasSubstr("2:15: found the rule guard-band=3arcsec for a"));
  EXPECT_THAT(row("M,linear,5,um,,-1,1"), HasSubstr("2:16: found the limit \"-1\" of A, expected a number above 0"));
  EXPECT_THAT(row("M,linear,5,um,,1,0"), HasSubstr("2:18: found the limit \"0\" of E"));
  EXPECT_THAT(row("M,linear,5,um,,nan,1"), HasSubstr("2:16: found \"nan\", expected a finite number"));
  EXPECT_THAT(row("M,linear,5,um,,1e9,1"), HasSubstr("2:16: found the limit \"1e9\" of A"));
  EXPECT_EQ(row("M,linear,5,um,,,"), "2:1: found a row without a limit, expected at least one");
  EXPECT_THAT(row("M,linear"), HasSubstr("2:3: found 2 fields, expected 7"));
  EXPECT_THAT(row("M,linear,5,um,,1,1,1"), HasSubstr("2:20: found 8 fields, expected 7"));
}

TEST(ToleranceTable, RefusesABandThatIsGivenTwice) {
  EXPECT_EQ(refusal_of_table(
                "name,kind,travel_up_to,unit,A\nMill,linear,500,um,1\nMill,rotary,500,deg,1\nmill,linear,500.0,mm,1\n"),
            "4:1: found a second row of \"mill\" for linear axes, up to 500 mm, expected only that on line 2");
  EXPECT_THAT(refusal_of_table("name,kind,travel_up_to,unit,A\nM,linear,,um,1\nM,linear,,um,2\n"),
              HasSubstr("any travel"));
}

TEST(ToleranceTableName, MayHoldColonsInTheNameAndInTheFile) {
  const testing_support::TemporaryFolder folder;
  const std::string plain = folder.written("limits.csv", "x");
  const std::string odd = folder.written("a:b.csv", "x");
  EXPECT_EQ(parse_table_name(plain).name, "");
  EXPECT_EQ(parse_table_name(plain + ":Mill: large").file, plain);
  EXPECT_EQ(parse_table_name(plain + ":Mill: large").name, "Mill: large");
  EXPECT_EQ(parse_table_name(odd).file, odd);
  EXPECT_EQ(parse_table_name(odd + ":Mill").name, "Mill");
  EXPECT_EQ(parse_table_name("none.csv:Mill").file, "none.csv:Mill");
}

TEST(ToleranceTable, NamesTheFileThatCannotBeRead) {
  const auto none = open_tolerance_table("no/such/limits.csv");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().to_string(), HasSubstr("no/such/limits.csv: cannot open"));
}

}  // namespace
}  // namespace axiometry::app
