// SPDX-License-Identifier: Apache-2.0
//
// What files of instruments are known to do to a reader: every hazard for every format that it can meet. A reader
// either understands it or refuses it; it never gives other numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// One test of two targets in both directions, ↑ 0.1 and 0.4 µm, ↓ 0.9 and 1.1 µm, in every format that has approaches.
struct Sample {
  std::string id;
  std::string text;
};

const std::vector<Sample> samples = {
    {"csv-long", "target_mm,direction,run,deviation_um\n0,up,1,0.1\n50,up,1,0.4\n50,down,1,1.1\n0,down,1,0.9\n"},
    {"csv-wide", "target_mm,up1_um,down1_um\n0,0.1,0.9\n50,0.4,1.1\n"},
    {"ecmc-dat",
     "TGT_DATA[1]=0\nTGT_DATA[2]=50\nREF_DATA_FWD[1,1]=0.0001\nREF_DATA_FWD[2,1]=50.0004\nREF_DATA_BWD[1,1]=0.0009\n"
     "REF_DATA_BWD[2,1]=50.0011\n"},
    {"ecmc-cfg-csv",
     "cycle,direction,target,selected_reference_pv,ref_error\n1,forward,0,A,0.0001\n1,forward,50,A,0.0004\n"
     "1,reverse,50,A,0.0011\n1,reverse,0,A,0.0009\n"},
    {"ecmc-cfg-md",
     "## Raw Measured Points\n| Cycle | Direction | Target | Raw Ref Err |\n| --- | --- | --- | --- |\n"
     "| 1 | forward | 0 | 0.0001 |\n| 1 | forward | 50 | 0.0004 |\n| 1 | reverse | 50 | 0.0011 |\n"
     "| 1 | reverse | 0 | 0.0009 |\n"},
    {"renishaw-rtl",
     "HEADER::\nFile type : rtl\nTARGET DATA::\nTargets :\n0 50\nFlags: 0 0 2 0\nRUNS::\nRun-count:2\nDEVIATIONS::\n"
     "Run Target Data:\n1 1 0.1\n1 2 0.4\n2 2 1.1\n2 1 0.9\nEOF::\n"},
    {"api-pos",
     "Position  Forward Directional Avg Error\n0  0.0001\n50  0.0004\nPosition  Reverse Directional Avg Error\n"
     "0  0.0009\n50  0.0011\n"},
    {"camonitor",
     "A:Laser 2026-01-31 10:00:00.1 0\nA:PosSet 2026-01-31 10:00:00.2 0\nA:Laser 2026-01-31 10:00:01 0.0001\n"
     "A:TestNumber 2026-01-31 10:00:02 1101\nA:PosSet 2026-01-31 10:00:03 50\nA:Laser 2026-01-31 10:00:04 50.0004\n"
     "A:TestNumber 2026-01-31 10:00:05 1102\nA:Laser 2026-01-31 10:00:06 50.0011\n"
     "A:TestNumber 2026-01-31 10:00:07 2102\nA:PosSet 2026-01-31 10:00:08 0\nA:Laser 2026-01-31 10:00:09 0.0009\n"
     "A:TestNumber 2026-01-31 10:00:10 2101\n"},
};

class Hazards : public testing::TestWithParam<Sample> {
 protected:
  Result<axiometry::Test> read(const std::string& text) const {
    const auto format = recognise(std::string_view(text).substr(0, 65536));
    if (!format) return std::unexpected(format.error());
    EXPECT_EQ((*format)->id, GetParam().id);
    return (*format)->read(text);
  }

  void expect_the_same(const std::string& text) const {
    const auto test = read(text);
    ASSERT_TRUE(test) << test.error().to_string() << "\n" << text;
    ASSERT_EQ(test->series.target_count(), 2u);
    EXPECT_EQ(test->series.reading_count(), 4u);
    EXPECT_EQ(test->series.targets()[1].in_native(), 50);
    EXPECT_NEAR(test->series.reading(0, Direction::up, 0)->in_native(), 0.1, 1e-9);
    EXPECT_NEAR(test->series.reading(1, Direction::up, 0)->in_native(), 0.4, 1e-9);
    EXPECT_NEAR(test->series.reading(1, Direction::down, 0)->in_native(), 1.1, 1e-9);
    EXPECT_NEAR(test->series.reading(0, Direction::down, 0)->in_native(), 0.9, 1e-9);
  }

  const std::string& text() const { return GetParam().text; }
};

INSTANTIATE_TEST_SUITE_P(Formats, Hazards, testing::ValuesIn(samples),
                         [](const auto& of) { return replaced(of.param.id, "-", "_"); });

TEST_P(Hazards, NoneIsInTheSampleItself) { expect_the_same(text()); }

TEST_P(Hazards, LineEndsOfOtherSystems) {
  expect_the_same(replaced(text(), "\n", "\r\n"));
  expect_the_same(replaced(text(), "\n", "\r"));
}

TEST_P(Hazards, BlanksAtTheEndsOfLines) { expect_the_same(replaced(text(), "\n", " \t \n")); }

TEST_P(Hazards, NoLineBreakAtTheEnd) { expect_the_same(text().substr(0, text().size() - 1)); }

TEST_P(Hazards, NumbersThatBeginWithTheirPoint) {
  expect_the_same(replaced(replaced(text(), ",0.", ",."), " 0.", " ."));
}

TEST_P(Hazards, Exponents) {
  const std::string positions = replaced(text(), "50.0011", "5.00011E+01");
  const std::string smaller = replaced(replaced(positions, "0.0001", "1.0E-04"), "0.0011", "+11e-4");
  expect_the_same(replaced(replaced(smaller, ",0.1\n", ",1e-1\n"), " 0.1\n", " 1e-1\n"));
}

TEST_P(Hazards, ByteOrderMarkAndUtf16) {
  expect_the_same("\xEF\xBB\xBF" + text());
  std::string wide = "\xFF\xFE";
  for (char c : text()) wide += {c, '\0'};
  expect_the_same(wide);
}

TEST_P(Hazards, FilesCutAnywhereGiveNoOtherReadings) {
  const double known[] = {0.1, 0.4, 0.9, 1.1};
  for (std::size_t size = 1; size < text().size(); ++size) {
    const auto test = find_format(GetParam().id)->read(text().substr(0, size));
    if (!test) continue;
    // Cut within the last number a shorter one is left: nothing in such a text can show that.
    const bool within_a_number = text()[size] != '\n' && text()[size] != '\r' && text()[size - 1] != '\n';
    for (std::size_t i = 0; i < test->series.target_count(); ++i)
      for (Direction d : {Direction::up, Direction::down}) {
        const auto x = test->series.reading(i, d, 0);
        if (!x || within_a_number) continue;
        const double found = x->in_native();
        EXPECT_TRUE(std::ranges::any_of(known, [&](double k) { return std::abs(found - k) < 1e-9; }))
            << found << " from the first " << size << " bytes";
      }
  }
}

TEST_P(Hazards, NotANumberIsNoReading) {
  for (const char* word : {"nan", "NaN", "inf", "1e999", "#NV", "1.2.3"}) {
    const std::string broken = replaced(replaced(text(), "0.0004", word), "0.4", word);
    const auto test = read(broken);
    EXPECT_FALSE(test && test->series.reading(1, Direction::up, 0)) << word;
  }
}

TEST(RtlHazards, DecimalCommas) {
  const std::string text = replaced(
      "HEADER::\nFile type : rtl\nTARGET DATA::\nTargets :\n0.5 50.5\nFlags: 0 0 2 "
      "0\nRUNS::\nRun-count:1\nDEVIATIONS::\n"
      "1 1 0.1\n1 2 -.4\nENVIRONMENT::\nAir temp: 20.25\n",
      ".", ",");
  const auto test = find_format("renishaw-rtl")->read(text);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.targets()[1].in_native(), 50.5);
  EXPECT_EQ(test->series.reading(1, Direction::up, 0)->in_native(), -0.4);
  EXPECT_EQ(test->metadata.environment.air_temperature_start->in_celsius(), 20.25);
}

TEST(CsvHazards, DecimalCommasBetweenCommasAreRefused) {
  const std::string cfg = "cycle,direction,target,selected_reference_pv,ref_error\n1,forward,0,A,0,0001\n";
  EXPECT_EQ(find_format("ecmc-cfg-csv")->read(cfg).error().to_string(),
            "line 2:17: found 6 fields, expected 5 as in the header on line 1; numbers with a decimal comma need "
            "semicolons or tabs between the columns");
}

TEST(CsvHazards, AllDecimalPointsReplacedEvenInTimes) {
  const std::string text =
      "target_mm;direction;run;deviation_um;time\n0,5;up;1;,4;12:00:00,5\n50,5;up;1;-,0471;12:00:01,5\n";
  const auto test = find_format("csv-long")->read(text);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.reading(1, Direction::up, 0)->in_native(), -0.0471);
}

TEST(LabelHazards, DirectionsThatContradictTheMotionAreRefused) {
  const Sample& log = samples.back();
  const auto swapped = find_format(log.id)->read(replaced(log.text, "1102", "2202"));
  ASSERT_FALSE(swapped);
  EXPECT_TRUE(swapped.error().message.contains("after a move ↑ from 0 to 50, expected ↓")) << swapped.error().message;
}

TEST(CountHazards, RunsMissingAtTheEndAndTargetsWithoutRunsAreTold) {
  const std::string rtl = samples[5].text;
  EXPECT_FALSE(find_format("renishaw-rtl")->read(replaced(rtl, "Run-count:2", "Run-count:10")));
  EXPECT_FALSE(find_format("renishaw-rtl")->read(replaced(rtl, "0 50\n", "0 50 100\n")));
  // An extra run of one reading alone leaves the others missing, never zero.
  const auto extra = find_format("renishaw-rtl")
                         ->read(replaced(replaced(rtl, "Run-count:2", "Run-count:3"), "EOF::", "3 1 0.7\nEOF::"));
  ASSERT_TRUE(extra) << extra.error().to_string();
  EXPECT_EQ(extra->series.reading_count(), 5u);
  EXPECT_FALSE(extra->series.reading(1, Direction::up, 1));
}

TEST(UnitHazards, PositionsUnderTheNameOfDeviationsAreRefused) {
  const std::string text = "target_mm,up1_mm\n0,0.0001\n50,50.0004\n100,100.0002\n";
  EXPECT_FALSE(find_format("csv-wide")->read(text));
}

}  // namespace
}  // namespace axiometry::formats
