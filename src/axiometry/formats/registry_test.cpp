// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/passed_over.h"
#include "tests/support/manual_example.h"

namespace axiometry::formats {
namespace {

TEST(Registry, EveryFormatDescribesItself) {
  std::set<std::string_view> ids;
  for (const Format* format : format_table()) {
    EXPECT_TRUE(ids.insert(format->id).second) << format->id;
    EXPECT_EQ(find_format(format->id), format);
    EXPECT_FALSE(format->title.empty() || format->extensions.empty() || format->manual.empty()) << format->id;
    EXPECT_NE(format->recognise, nullptr);
    EXPECT_NE(format->read, nullptr);
    EXPECT_EQ(format->holds_many == nullptr, format->read_many == nullptr) << format->id;
  }
  EXPECT_EQ(ids, (std::set<std::string_view>{"api-pos", "camonitor", "csv-long", "csv-wide", "ecmc-cfg-csv",
                                             "ecmc-cfg-md", "ecmc-dat", "etalon-exchange", "generic", "heidenhain-nd",
                                             "isg-csv", "json", "renishaw-rtl"}));
}

TEST(Registry, RecognisesTheExampleOfEveryManual) {
  for (const Format* format : format_table()) {
    const auto found = recognise(testing_support::manual_example(format->manual));
    ASSERT_TRUE(found) << format->id << ": " << found.error().to_string();
    EXPECT_EQ((*found)->id, format->id);
  }
}

TEST(Registry, ReadsTheExampleOfEveryManualThatIsWhole) {
  for (const Format* format : format_table()) {
    const std::string example = testing_support::manual_example(format->manual);
    if (example.find("…") != std::string::npos) continue;
    const auto test = format->read(example);
    EXPECT_TRUE(test) << format->id << ": " << test.error().to_string();
  }
}

/// Names of columns that lack a direction alone look like those of another format, which would miss the direction.
TEST(Registry, SaysThatAUnitIsDoubtedWhereThatIsAllThatIsOpen) {
  const auto answer = [](double factor) {
    std::string table = "target_mm,deviation_um\n";
    for (const int target : {0, 100, 200, 300, 300, 200, 100, 0})
      table += fmt::format("{},{}\n", target, factor * (1.0 + 0.01 * target));
    const auto found = recognise(table);
    return found ? std::string((*found)->id) : found.error().to_string();
  };
  EXPECT_EQ(answer(1.0), "generic");
  for (const double factor : {1e-3, 1e4}) {
    const std::string said = answer(factor);
    EXPECT_TRUE(said.starts_with("line 2: found an open question, expected \"reading_unit\"")) << said;
    EXPECT_TRUE(said.contains("are they really in µm (column 2 \"deviation_um\")?")) << said;
  }
}

TEST(Registry, SaysWhatStandsInTheWayOfATableThatIsNotRecognised) {
  const std::string table =
      "Consigne [mm];Sens;Écart [µm]\n0;aller;0.5\n100;aller;0.6\n200;aller;0.4\n200;retour;0.7\n"
      "100;retour;0.8\n0;retour;0.9\n";
  const auto answer = [](const std::string& text) {
    const auto found = recognise(text);
    return found ? std::string((*found)->id) : found.error().to_string();
  };
  EXPECT_EQ(answer(table), "generic");
  EXPECT_EQ(answer(table + "\nMoyenne\n0;0.6\n100;0.6\n"),
            "line 10:1: found 2 fields, expected 3 as in the rest of the table");
  std::string longer = table;
  longer.replace(longer.find("0.6\n"), 4, "0.6;9\n");
  EXPECT_EQ(answer(longer), "line 3:15: found 4 fields, expected 3 as in the rest of the table");
  const auto in_utf16 = [](const std::string& ascii) {
    std::string bytes = "\xFF\xFE";
    for (const char c : ascii) bytes += {c, '\0'};
    return bytes;
  };
  longer = "target [mm];way;d [µm]\n" + longer.substr(longer.find('\n') + 1);
  longer.replace(longer.find("µ"), 2, "u");
  EXPECT_EQ(answer(in_utf16(longer)), answer(longer));
  EXPECT_EQ(answer(in_utf16(longer)), "line 3:15: found 4 fields, expected 3 as in the rest of the table");
  EXPECT_TRUE(answer("Dear Sir,\nours of 4 5\nwith 1 2 3\n").contains("found text that begins with \"Dear Sir,\""));
}

TEST(Registry, PassesOverNoTableWithAQuestionAndNothingPacked) {
  const auto said = [](std::string_view bytes) {
    const auto passed = check_passed_over(bytes);
    return passed ? std::string() : passed.error().to_string();
  };
  std::string table = "unit = mm\n[X]\n";
  for (int i = -4; i <= 4; ++i) table += fmt::format("{}.000, 0.0{}08, -0.0{}04\n", 5 * i, 5 + i, 6 + i);
  EXPECT_TRUE(said(table).contains("found an open question")) << said(table);
  EXPECT_TRUE(said("\x1F\x8B\x08").contains("a gzip archive"));
  EXPECT_TRUE(said(std::string_view("PK\x03\x04\0", 5)).contains("a ZIP archive or a spreadsheet"));
  EXPECT_EQ(said("Dear Sir,\nours of 4 5\nwith 1 2 3\n"), "");
  EXPECT_EQ(said("%PDF-1.7\n"), "");
  EXPECT_EQ(said("# error: EYX\nposition_mm,direction,run,reading_um\n0,up,1,1\n"), "");
}

TEST(Registry, KnowsNoOtherFormat) { EXPECT_EQ(find_format("xlsx"), nullptr); }

}  // namespace
}  // namespace axiometry::formats
