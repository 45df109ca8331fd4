// SPDX-License-Identifier: Apache-2.0
//
// What readers of CSV accept. What they refuse stands in bad_input_test.cpp.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "axiometry/base/read_budget.h"
#include "axiometry/formats/format.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "tests/support/repository_file.h"

namespace axiometry::formats {
namespace {

axiometry::Test read_as(std::string_view id, std::string_view bytes) {
  const auto format = recognise(bytes);
  EXPECT_TRUE(format) << format.error().to_string();
  EXPECT_EQ((*format)->id, id);
  auto test = (*format)->read(bytes);
  EXPECT_TRUE(test) << test.error().to_string();
  return *std::move(test);
}

double at(const axiometry::Test& test, std::size_t target, Direction direction, std::size_t run) {
  return test.series.reading(target, direction, run)->in_native();
}

TEST(CsvLong, ReadsTheExampleOfTheStandard) {
  const axiometry::Test test = read_as("csv-long", testing_support::repository_file("examples/iso230-2-table2.csv"));
  EXPECT_EQ(test.series.target_count(), 11u);
  EXPECT_EQ(test.series.run_count(), 5u);
  EXPECT_EQ(test.metadata.axis.name, "X");
  EXPECT_EQ(test.metadata.equipment.size(), 2u);
  EXPECT_EQ(test.metadata.uncertainty.environmental_variation->in_native(), 1.7);
  EXPECT_NEAR(iso230_2::evaluate(test.series).parameters.B->in_native(), 4.12, 1e-9);
}

TEST(CsvLong, ReadsAnyOrderOfColumnsDelimitersAndDecimalCommas) {
  const axiometry::Test test =
      read_as("csv-long",
              "\xEF\xBB\xBFsep=;\r\n# axis: Y\r\n# dwell: 2,5\r\nDeviation (µm);Run;Direction;Target (mm);Comment\r\n"
              "1,5;1;UP;100,25;\"first; really\"\r\n-0,5;1;Down;100,25;\r\n\r\n2,5;1;up;-,5;\r\n;1;↓;-0,50;missed\r\n");
  ASSERT_EQ(test.series.target_count(), 2u);
  EXPECT_EQ(test.series.targets()[0].in_native(), -0.5);
  EXPECT_EQ(at(test, 1, Direction::up, 0), 1.5);
  EXPECT_EQ(at(test, 1, Direction::down, 0), -0.5);
  EXPECT_EQ(at(test, 0, Direction::up, 0), 2.5);
  EXPECT_FALSE(test.series.reading(0, Direction::down, 0));
  EXPECT_EQ(test.metadata.conditions.dwell->in_s(), 2.5);
}

TEST(CsvLong, ReadsTabsQuotesAndExponents) {
  const axiometry::Test test = read_as(
      "csv-long",
      "\"target_mm\"\t\"direction\"\t\"run\"\t\"deviation_mm\"\n\"0\"\t\"+\"\t\"1\"\t\"1.5e-3\"\n10\t+\t1.0\t+.002\n");
  EXPECT_EQ(at(test, 0, Direction::up, 0), 1.5);
  EXPECT_EQ(at(test, 1, Direction::up, 0), 2.0);
}

TEST(CsvLong, TakesTheTargetFromMeasuredPositions) {
  const axiometry::Test test =
      read_as("csv-long", "target_mm,direction,run,measured_mm\n0,forward,1,0.0012\n500,reverse,1,499.9995\n");
  EXPECT_NEAR(at(test, 0, Direction::up, 0), 1.2, 1e-9);
  EXPECT_NEAR(at(test, 1, Direction::down, 0), -0.5, 1e-9);
}

TEST(CsvLong, RefusesDeviationsUnderANameOfPositions) {
  const std::string bytes = "target_mm,direction,run,Messwert [um]\n0,up,1,0.1\n100,up,1,1.2\n200,up,1,2.0\n";
  const auto format = recognise(bytes);
  ASSERT_TRUE(format);
  const auto test = (*format)->read(bytes);
  ASSERT_FALSE(test);
  EXPECT_TRUE(test.error().message.contains("numbers that do not follow the targets")) << test.error().message;
}

TEST(CsvLong, MakesARotaryAxisOfAngles) {
  const axiometry::Test test = read_as(
      "csv-long", "# axis.kind: rotary\ntarget_deg,direction,run,deviation_deg\n0,up,1,0.001\n90,up,1,-0.002\n");
  EXPECT_EQ(test.metadata.axis.kind, AxisKind::rotary);
  EXPECT_NEAR(at(test, 0, Direction::up, 0), 3.6, 1e-12);
}

TEST(CsvLong, TakesUnitsStatedForTheWholeFile) {
  const axiometry::Test test =
      read_as("csv-long", "# unit: nm\n# target unit: m\ntarget,direction,run,deviation\n0,up,1,500\n1,up,1,-500\n");
  EXPECT_EQ(at(test, 0, Direction::up, 0), 0.5);
  EXPECT_EQ(test.series.targets()[1].in_native(), 1000.0);
}

TEST(CsvLong, UnderstandsMetadataAsPeopleAndSpreadsheetsWriteIt) {
  const axiometry::Test test =
      read_as("csv-long",
              "# A drawing of the machine: see http://example.org\n# ISO 230-2:2014 test: the second one\n"
              "# Machine: Mill 5,,,\n\"# inspector: Roe, Jane\",,,\n#Serial Number: 0815\n# feed: 1000\n# comment: "
              "a\n# comment: b\n"
              "target_mm,direction,run,deviation_um\n0,up,1,1\n1,up,1,1\n# the end\n");
  EXPECT_EQ(test.metadata.machine.name, "Mill 5");
  EXPECT_EQ(test.metadata.conditions.inspector, "Roe, Jane");
  EXPECT_EQ(test.metadata.machine.serial_number, "0815");
  EXPECT_EQ(test.metadata.conditions.feed, 1000.0);
  EXPECT_EQ(test.metadata.conditions.comment, "a; b");
}

TEST(CsvLong, FindsAHeaderThatIsWrittenAsAComment) {
  const axiometry::Test test = read_as(
      "csv-long", "# made of: arrays, by hand, today\n# target_mm,direction,run,deviation_um\n0,up,1,1\n1,up,1,2\n");
  EXPECT_EQ(at(test, 1, Direction::up, 0), 2.0);
}

TEST(CsvLong, SortsTargetsThatWereMeasuredInAnyOrder) {
  const axiometry::Test test =
      read_as("csv-long", "target_mm,direction,run,deviation_um\n20,up,1,3\n0,up,1,1\n10,up,1,2\n10,up,2,5\n");
  EXPECT_EQ(at(test, 0, Direction::up, 0), 1.0);
  EXPECT_EQ(at(test, 1, Direction::up, 1), 5.0);
  EXPECT_EQ(at(test, 2, Direction::up, 0), 3.0);
  EXPECT_EQ(test.series.count(0, Direction::up), 1u);
}

TEST(CsvLong, ComparesDeviationsWithPositionsBesideThem) {
  const std::string head = "target_mm,actual_mm,deviation_um,direction,run\n";
  const auto format = find_format("csv-long");
  const auto same = format->read(head + "0,0.0010,1.0,+,1\n50,50.0021,2.1,+,1\n");
  ASSERT_TRUE(same) << same.error().to_string();
  EXPECT_TRUE(same->provenance.remarks.empty());
  const auto mirrored = format->read(head + "0,0.0010,-1.0,+,1\n50,50.0021,-2.1,+,1\n");
  ASSERT_FALSE(mirrored);
  EXPECT_TRUE(mirrored.error().message.contains("target minus")) << mirrored.error().message;
  const auto fitted = format->read(head + "0,0.0010,1.0,+,1\n50,50.0021,0.1,+,1\n");
  ASSERT_TRUE(fitted) << fitted.error().to_string();
  ASSERT_EQ(fitted->provenance.remarks.size(), 1u);
  EXPECT_TRUE(fitted->provenance.remarks[0].message.contains("differ by up to 2 µm"))
      << fitted->provenance.remarks[0].message;
}

TEST(CsvLong, TellsLabelsThatRunTheOtherWay) {
  const std::string head = "target_mm,deviation_um,direction,run\n";
  const auto format = find_format("csv-long");
  const std::string rows = "0,1,{0},1\n25,1,{0},1\n50,1,{0},1\n50,2,{1},1\n25,2,{1},1\n0,2,{1},1\n";
  const auto right = format->read(head + fmt::format(fmt::runtime(rows), "up", "down"));
  ASSERT_TRUE(right) << right.error().to_string();
  EXPECT_TRUE(right->provenance.remarks.empty());
  const auto swapped = format->read(head + fmt::format(fmt::runtime(rows), "down", "up"));
  ASSERT_TRUE(swapped) << swapped.error().to_string();
  ASSERT_EQ(swapped->provenance.remarks.size(), 1u);
  EXPECT_TRUE(swapped->provenance.remarks[0].message.contains("the other way"));
}

TEST(CsvWide, ReadsOneRowPerTarget) {
  const axiometry::Test test =
      read_as("csv-wide", "target_mm;up1_um;up2_um;down1_um;down2_um\n0;0,1;0,2;0,9;\n250;0,4;0,4;1,1;1,2\n");
  EXPECT_EQ(at(test, 0, Direction::up, 1), 0.2);
  EXPECT_EQ(at(test, 1, Direction::down, 1), 1.2);
  EXPECT_FALSE(test.series.reading(0, Direction::down, 1));
}

TEST(CsvLong, ReadsGermanColumnsAndDirections) {
  const axiometry::Test test = read_as("csv-long",
                                       "Sollposition [mm];Istposition [mm];Richtung;Lauf;Bemerkung\n"
                                       "0,0;0,001;vorwärts;1;\n10,0;10,002;vor;1;\n10,0;9,999;zurück;1;\n");
  EXPECT_NEAR(at(test, 1, Direction::up, 0), 2.0, 1e-9);
  EXPECT_NEAR(at(test, 1, Direction::down, 0), -1.0, 1e-9);
}

TEST(CsvLong, ReadsWhatInstrumentsPrintAboveTheHeader) {
  const axiometry::Test test = read_as("csv-long",
                                       "Positioning test;;;\nMachine:;Mill 5;;\nAxis;X;;\nFirmware;3.1;;\n"
                                       "Inspector: Roe;;;\n;;;\ntarget_mm;direction;run;deviation_um\n"
                                       "0;up;1;1\n1;up;1;1\n");
  EXPECT_EQ(test.metadata.machine.name, "Mill 5");
  EXPECT_EQ(test.metadata.axis.name, "X");
  EXPECT_EQ(test.metadata.conditions.inspector, "Roe");
}

TEST(CsvLong, ReadsAHeaderBehindAMark) {
  const axiometry::Test test = read_as(
      "csv-long", "# written by a script\n# target_mm, direction, run, deviation_um\n0, up, 1, 1\n1, up, 1, 2\n");
  EXPECT_EQ(at(test, 1, Direction::up, 0), 2.0);
}

TEST(CsvLong, TakesTargetsThatDifferByFloatNoiseForOne) {
  const axiometry::Test test = read_as("csv-long",
                                       "target_mm,direction,run,deviation_um\n0,up,1,1\n0.3,up,1,2\n"
                                       "0.30000000000000004,down,1,3\n0.3000000001,up,2,4\n-1e-15,down,1,5\n");
  ASSERT_EQ(test.series.target_count(), 2u);
  EXPECT_EQ(test.series.targets()[1].in_native(), 0.3);
  EXPECT_EQ(at(test, 1, Direction::down, 0), 3.0);
  EXPECT_EQ(at(test, 1, Direction::up, 1), 4.0);
  EXPECT_EQ(at(test, 0, Direction::down, 0), 5.0);
}

TEST(CsvLong, ReadsRowsWithoutTheEmptyCellsAtTheirEnd) {
  const axiometry::Test test = read_as(
      "csv-long", "target_mm,direction,run,deviation_um,note,\n0,up,1,1,first,\n1,up,1,2,\n2,up,1,3\n3,up,1,4,,,,\n");
  EXPECT_EQ(test.series.target_count(), 4u);
}

TEST(CsvWide, ReadsGermanRunsAndIgnoresWhatIsComputed) {
  const axiometry::Test test = read_as("csv-wide",
                                       "i;Position [mm];Lauf 1 + [µm];Lauf 1 - [µm];Mittelwert [µm];Std (µm)\n"
                                       "1;0,0;1,5;-0,5;0,5;1,4\n2;100,0;2,5;0,5;1,5;1,4\n");
  EXPECT_EQ(at(test, 1, Direction::up, 0), 2.5);
  EXPECT_EQ(at(test, 1, Direction::down, 0), 0.5);
  EXPECT_EQ(test.series.run_count(), 1u);
}

TEST(CsvWide, TakesTargetsThatDifferByFloatNoiseForOne) {
  const axiometry::Test test =
      read_as("csv-wide", "target_mm,direction,run1_um\n0,up,1\n0.3,up,2\n0.30000000000000004,down,3\n0,down,4\n");
  ASSERT_EQ(test.series.target_count(), 2u);
  EXPECT_EQ(at(test, 1, Direction::down, 0), 3.0);
}

TEST(CsvWide, ReadsOneRowPerTargetAndDirection) {
  const axiometry::Test test =
      read_as("csv-wide",
              "target_mm,direction,run1_um,run2_um\n0,up,0.1,0.2\n0,down,0.9,0.8\n250,down,1.1,NA\n250,up,0.3,0.4\n");
  EXPECT_EQ(at(test, 0, Direction::down, 1), 0.8);
  EXPECT_EQ(at(test, 1, Direction::up, 0), 0.3);
}

TEST(CsvWide, NumbersColumnsWithoutANumber) {
  const axiometry::Test test =
      read_as("csv-wide", "Target [mm]\tUp [µm]\tUp [µm]\tDown [µm]\n0\t1\t2\t3\n5\t4\t5\t6\n");
  EXPECT_EQ(test.series.run_count(), 2u);
  EXPECT_EQ(at(test, 1, Direction::up, 1), 5.0);
  EXPECT_EQ(at(test, 1, Direction::down, 0), 6.0);
}

TEST(CsvWide, ReadsTheRotaryExample) {
  const axiometry::Test test = read_as("csv-wide", testing_support::repository_file("examples/rotary-table.csv"));
  EXPECT_EQ(test.metadata.axis.kind, AxisKind::rotary);
  EXPECT_EQ(test.series.target_count(), 9u);
  EXPECT_EQ(test.series.run_count(), 5u);
  EXPECT_EQ(test.metadata.uncertainty.device_calibration->in_native(), 0.6);
}

std::string utf16_of(std::string_view ascii) {
  std::string bytes = "\xFF\xFE";
  for (char c : ascii) bytes += {c, '\0'};
  return bytes;
}

TEST(Csv, OfOneTestMayBeInTheCodePageOfItsComputer) {
  const auto latin =
      read_as("csv-long", "# machine: Fr\xE4se\ntarget_mm,direction,run,deviation_\xB5m\n0,up,1,1\n5,up,1,2\n");
  EXPECT_EQ(latin.metadata.machine.name, "Fräse");
  ASSERT_EQ(latin.provenance.remarks.size(), 1u);
  EXPECT_EQ(latin.provenance.remarks[0].message, "found text that is not UTF-8; it was read as Windows-1252");
  EXPECT_FALSE(latin.provenance.remarks[0].departs);
  const auto wide = read_as("csv-wide",
                            "Sollposition [mm];Pr\xFC"
                            "fer;Lauf 1 + [\xB5m]\n0;;1,5\n5;;2,5\n");
  EXPECT_EQ(at(wide, 1, Direction::up, 0), 2.5);
}

TEST(Csv, MayBeTheUnicodeTextOfASpreadsheetOrHaveOldLineEnds) {
  const auto unicode =
      read_as("csv-long", utf16_of("target_mm\tdirection\trun\tdeviation_um\r\n0\tup\t1\t1\r\n5\tup\t1\t2"));
  EXPECT_EQ(at(unicode, 1, Direction::up, 0), 2);
  const auto old = read_as("csv-wide", "target_mm,up1_um\r0,1\r5,2\r");
  EXPECT_EQ(at(old, 1, Direction::up, 0), 2);
  EXPECT_EQ(old.provenance.remarks.size(), 1u);
}

TEST(Csv, ARowOfMoreFieldsThanAnyTableHasIsRefusedBeforeItIsKept) {
  std::string head = "target_mm";
  for (std::size_t run = 1; run <= read_budget::row_cells; ++run) head += ",note";
  const auto read = find_format("csv-wide")->read(head + "\n0,1\n");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "found more than 32768 fields in one row, expected fewer");
  EXPECT_EQ(read.error().at.line, 1u);
}

TEST(Csv, KeepsWhatWasToldWhenTheReadingsWereFirstRead) {
  auto test = read_as("csv-long", "target_mm,direction,run,deviation_um,note\n0,up,1,1,\n5,up,1,2,lost\n");
  ASSERT_EQ(test.provenance.remarks.size(), 1u);
  test.provenance.remarks.insert(test.provenance.remarks.begin(),
                                 {false, "the columns were guessed: column 1, \"a\nb\";"});
  for (const char* format : {"csv-long", "csv-wide"}) {
    const auto again = read_as(format, find_format(format)->write(test));
    ASSERT_EQ(again.provenance.remarks.size(), 2u) << format;
    EXPECT_EQ(again.provenance.remarks[0].message,
              "told when the readings were first read: the columns were guessed: column 1, \"a b\"");
    EXPECT_TRUE(again.provenance.remarks[1].message.ends_with(": nothing was read of the column \"note\""));
    const auto twice = read_as("csv-long", find_format("csv-long")->write(again));
    EXPECT_EQ(twice.provenance.remarks[0].message, again.provenance.remarks[0].message);
  }
}

TEST(Csv, HeadersMayHaveGoneThroughAWrongCodePage) {
  const auto test =
      read_as("csv-long", "Target (\u00C2\u00B0),Direction,Run,Deviation (\u00C2\u00B5rad)\n0,up,1,1\n90,up,1,2\n");
  EXPECT_EQ(test.metadata.axis.kind, AxisKind::rotary);
  EXPECT_NEAR(at(test, 1, Direction::up, 0), 2 * 0.20626480624709636, 1e-12);
}

}  // namespace
}  // namespace axiometry::formats
