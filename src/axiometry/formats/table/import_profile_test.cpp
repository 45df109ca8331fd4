// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/table/import_profile.h"
#include "tests/support/repository_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace axiometry::formats {
namespace {

ImportProfile full_profile() {
  ImportProfile p;
  p.encoding = TextEncoding::latin1;
  p.delimiter = Delimiter::blanks;
  p.decimal_mark = ',';
  p.comment = "";
  p.skip_lines = 4;
  p.header_lines = 2;
  p.end = "Mittel \"µ\"";
  p.layout = TableLayout::wide;
  p.columns = {{.role = ImportRole::target, .name = "Soll"},
               {.role = ImportRole::deviation, .unit = find_unit("nm"), .direction = Direction::down, .run = 3},
               {.role = ImportRole::time}};
  p.target_unit = find_unit("mm");
  p.reading_unit = find_unit("um");
  p.direction = DirectionRule::run_parity;
  p.first_direction = Direction::down;
  p.up_words = {"vor"};
  p.down_words = {"rück", "zurück"};
  p.runs = RunRule::names;
  p.first_run = 0;
  p.sign = -1;
  return p;
}

std::string profile_error(std::string bytes) {
  const auto profile = read_profile(bytes);
  return profile ? "no error" : profile.error().to_string();
}

TEST(ImportProfile, GivesBackWhatWasWritten) {
  for (const ImportProfile& p :
       {full_profile(), ImportProfile{.columns = {{.role = ImportRole::target}, {.role = ImportRole::position}}}}) {
    const std::string text = write_profile(p);
    const auto again = read_profile(text);
    ASSERT_TRUE(again) << again.error().to_string() << text;
    EXPECT_EQ(write_profile(*again), text);
    EXPECT_EQ(again->columns.size(), p.columns.size());
    EXPECT_EQ(again->direction, p.direction);
    EXPECT_EQ(again->target_unit, p.target_unit);
    EXPECT_EQ(again->first_run, p.first_run);
    EXPECT_EQ(again->sign, p.sign);
    EXPECT_EQ(again->end, p.end);
    EXPECT_EQ(again->down_words, p.down_words);
    EXPECT_EQ(again->columns[1].unit, p.columns[1].unit);
    EXPECT_EQ(again->columns[1].run, p.columns[1].run);
  }
}

TEST(ImportProfile, RefusesFaultsWithTheirPlace) {
  const std::string begin = "{\"format\": \"axiometry-import-profile/1\",\n";
  const std::string columns = " \"columns\": [{\"role\": \"target\"}, {\"role\": \"deviation\"}]";
  EXPECT_EQ(profile_error("{}"),
            "line 1:1: found no \"format\": \"axiometry-import-profile/1\", expected an import profile");
  EXPECT_EQ(profile_error(begin + columns + "}"), "no error");
  EXPECT_EQ(profile_error(begin + columns + ", \"delimter\": \"tab\"}"),
            "line 2:70: found the unknown member \"delimter\" in the profile, expected perhaps \"delimiter\"");
  EXPECT_EQ(profile_error(begin + columns + ", \"delimiter\": \"|\"}"),
            "line 2:71: found \"|\", expected one of comma, semicolon, tab, blanks for delimiter");
  EXPECT_EQ(profile_error(begin + columns + ", \"first_run\": 2}"),
            "line 2:71: found 2, expected a whole number from 0 to 1 for first_run");
  EXPECT_EQ(profile_error(begin + columns + ", \"sign\": 0}"), "line 2:66: found 0, expected 1 or -1 for sign");
  EXPECT_EQ(
      profile_error(begin + columns + ", \"target_unit\": \"furlong\"}"),
      "line 2:73: found \"furlong\", expected one of um, mm, nm, m, in, uin, arcsec, deg, mdeg, rad, mrad, urad for "
      "target_unit");
  EXPECT_EQ(profile_error(begin + " \"columns\": [{\"role\": \"target\"}]}"),
            "line 2:13: found no column of deviations or positions, expected one");
  EXPECT_EQ(profile_error(begin + " \"columns\": [{\"role\": \"deviation\"}]}"),
            "line 2:13: found no column of the role target, expected one");
  EXPECT_EQ(profile_error(begin +
                          " \"columns\": [{\"role\": \"target\"}, {\"role\": \"target\"}, {\"role\": \"position\"}]}"),
            "line 2:13: found 2 columns of the role target, expected one");
  EXPECT_EQ(
      profile_error(begin +
                    " \"layout\": \"transposed\", \"columns\": [{\"role\": \"deviation\"}, {\"role\": \"run\"}]}"),
      "line 2:37: found a transposed table whose readings are not its last column, expected one that stands for all");
}

TEST(ImportProfile, TheSchemaInTheRepositoryIsTheOneTheProgramPrints) {
  EXPECT_EQ(testing_support::repository_file("schema/axiometry-import-profile.schema.json"), profile_schema());
}

}  // namespace
}  // namespace axiometry::formats
