// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

using ::testing::HasSubstr;

struct RtlFile {
  std::string type = "rtl";
  std::string targets = "0 50\n100";  // wrapped
  std::string flags = "Flags: 0 0 2 0";
  int run_count = 4;
  std::string rows{};
  std::string others{};
};

std::string text_of(const RtlFile& f) {
  return fmt::format(
      "HEADER::\nFile type  : {}\nOwner      : me\n\nTARGET DATA::\nFiletype  : ISO\nTarget-count: 3\nTargets : "
      "\n{}\n{}\n\nUSER-TEXT::\nMachine: Mill 5\nSerial No: 77\nDate:2026-01-31 12:48:22\nBy: Ada\nAxis:X\nLocation:\n"
      "TITLE:first\n\nRUNS::\nRun-count:{}\n\nDEVIATIONS::\nRun Target Data: \n{}{}EOF::\n",
      f.type, f.targets, f.flags, f.run_count, f.rows, f.others);
}

Result<Test> read_rtl(const std::string& text) {
  const auto format = recognise(text);
  EXPECT_TRUE(format && (*format)->id == "renishaw-rtl");
  return find_format("renishaw-rtl")->read(text);
}

std::string rtl_error(const RtlFile& file) {
  const auto test = read_rtl(text_of(file));
  return test ? "no error" : test.error().to_string();
}

const std::string two_way_rows =
    "  1   1   .1\n  1   2   .2\n  1   3   .3\n  2   3   -.4\n  2   2   -.5\n  2   1   -.6\n"
    "  3   1   1.1\n  3   2   1.2\n  3   3   1.3\n  4   3   1.4\n  4   2   1.5\n  4   1   1.6\n";
const std::string sorted_rows =
    "1 1 .1\n1 2 .2\n1 3 .3\n2 1 -.6\n2 2 -.5\n2 3 -.4\n3 1 1.1\n3 2 1.2\n3 3 1.3\n4 1 1.6\n4 2 1.5\n4 3 1.4\n";

double reading(const Test& test, std::size_t target, Direction direction, std::size_t run) {
  return test.series.reading(target, direction, run)->in_native();
}

TEST(RenishawRtl, PlacesReadingsByRunAndTarget) {
  const auto test = read_rtl(text_of({.rows = two_way_rows}));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.run_count(), 2u);
  EXPECT_TRUE(test->series.complete());
  EXPECT_EQ(test->series.targets()[1].in_native(), 50);
  EXPECT_EQ(reading(*test, 2, Direction::up, 0), .3);
  EXPECT_EQ(reading(*test, 0, Direction::down, 0), -.6);
  EXPECT_EQ(reading(*test, 2, Direction::down, 1), 1.4);
  EXPECT_TRUE(test->provenance.remarks.empty());
}

TEST(RenishawRtl, TellsMachineAndTest) {
  const auto test = read_rtl(text_of({.rows = two_way_rows}));
  ASSERT_TRUE(test);
  EXPECT_EQ(test->metadata.machine.name, "Mill 5");
  EXPECT_EQ(test->metadata.machine.serial_number, "77");
  EXPECT_EQ(test->metadata.machine.location, "");
  EXPECT_EQ(test->metadata.conditions.date, "2026-01-31 12:48:22");
  EXPECT_EQ(test->metadata.conditions.inspector, "Ada");
  EXPECT_EQ(test->metadata.axis.name, "X");
  EXPECT_EQ(test->metadata.conditions.comment, "first");
}

TEST(RenishawRtl, TellsTheAirInAnyOfItsUnits) {
  const auto test = read_rtl(
      text_of({.rows = two_way_rows,
               .others = "EQUIPMENT::\nLaser: ML10\nLaser serial no: 123\nENVIRONMENT::\nAir temp: 20,5 \u00C2\u00B0"
                         "C\nAir Press: 1013.2\nAir Humid: 45 %\nMat temp 1: 21.0 C\nMat temp 2:\nEnv factor: 1\n"
                         "Exp coeff: 0.0000117\nFinal Data:\nAir temp: 68 F\nAir press: 755 mmHg\n"
                         "Mat temp 1: 21.5\nAir humid: high\n"}));
  ASSERT_TRUE(test) << test.error().to_string();
  const Environment& air = test->metadata.environment;
  EXPECT_EQ(air.air_temperature_start->in_celsius(), 20.5);
  EXPECT_NEAR(air.air_temperature_end->in_celsius(), 20.0, 1e-12);
  EXPECT_NEAR(air.air_pressure_start->in_kPa(), 101.32, 1e-9);
  EXPECT_NEAR(air.air_pressure_end->in_kPa(), 100.658, 1e-3);
  EXPECT_EQ(air.air_humidity_start->in_percent(), 45);
  EXPECT_FALSE(air.air_humidity_end);
  ASSERT_EQ(air.sensors.size(), 1u);
  EXPECT_EQ(air.sensors[0].start->in_celsius(), 21.0);
  EXPECT_EQ(air.sensors[0].end->in_celsius(), 21.5);
  EXPECT_NEAR(test->metadata.nde.machine_expansion->in_um_per_m_K(), 11.7, 1e-12);
  EXPECT_FALSE(test->metadata.nde.applied);
  ASSERT_EQ(test->metadata.equipment.size(), 2u);
  EXPECT_EQ(test->metadata.equipment[0].type, "ML10");
  EXPECT_EQ(test->metadata.equipment[1].serial_number, "123");
  ASSERT_EQ(test->provenance.remarks.size(), 2u);
  EXPECT_EQ(test->provenance.remarks[1].message,
            "found \"Air humid: high\" on line 54, which was not understood and is left out");
}

TEST(RenishawRtl, LeavesOutSensorsThatShowZero) {
  const auto test = read_rtl(text_of(
      {.rows = two_way_rows,
       .others = "ENVIRONMENT::\nAir temp: 0.0\nAir Press: 0\nAir Humid: 0 %\nMat temp 1: 20.4\nMat temp 2: 0.00\n"
                 "Mat temp 3: 32 F\nExp coeff: 0\n"}));
  ASSERT_TRUE(test) << test.error().to_string();
  const Environment& air = test->metadata.environment;
  EXPECT_FALSE(air.air_temperature_start);
  EXPECT_FALSE(air.air_pressure_start);
  EXPECT_FALSE(air.air_humidity_start);
  ASSERT_EQ(air.sensors.size(), 2u);
  EXPECT_EQ(air.sensors[0].location, "mat temp 1");
  EXPECT_EQ(air.sensors[1].location, "mat temp 3");
  ASSERT_EQ(test->provenance.remarks.size(), 4u);
  EXPECT_TRUE(test->provenance.remarks[3].message.contains(
      "found \"Mat temp 2: 0.00\" on line 44; it was taken as a sensor that is not connected"));
}

TEST(RenishawRtl, TurnsRunsAroundWhenTheTargetsDescend) {
  const auto test = read_rtl(text_of({.targets = "100 50 0", .rows = two_way_rows}));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(reading(*test, 2, Direction::down, 0), .1);  // the first of the list
  EXPECT_EQ(reading(*test, 0, Direction::up, 0), -.4);
}

TEST(RenishawRtl, TakesSortedRowsOfABidirectionalFileByTheirNumbers) {
  const auto test = read_rtl(text_of({.rows = sorted_rows}));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(reading(*test, 0, Direction::down, 0), -.6);
  ASSERT_EQ(test->provenance.remarks.size(), 1u);
  EXPECT_FALSE(test->provenance.remarks[0].departs);
}

TEST(RenishawRtl, TakesEveryRunOfAUnidirectionalFileTheSameWay) {
  const auto test = read_rtl(text_of({.flags = "Flags : 0 1 2 0", .rows = sorted_rows}));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.run_count(), 4u);
  EXPECT_FALSE(test->series.has(Direction::down));
  EXPECT_EQ(reading(*test, 0, Direction::up, 3), 1.6);
}

TEST(RenishawRtl, LeavesOutTheZerosOfAUnidirectionalFile) {
  const std::string rows =
      "1 1 1\n1 2 2\n1 3 3\n2 3 0\n2 2 0.000\n2 1 0\n3 1 4\n3 2 5\n3 3 6\n4 3 0\n4 2 0\n4 1 -0.0\n";
  const auto one_way = read_rtl(text_of({.flags = "Flags: 0 1 2 0", .rows = rows}));
  ASSERT_TRUE(one_way) << one_way.error().to_string();
  EXPECT_FALSE(one_way->series.has(Direction::down));
  EXPECT_EQ(one_way->series.run_count(), 2u);
  EXPECT_EQ(reading(*one_way, 2, Direction::up, 1), 6);
  const auto two_way = read_rtl(text_of({.rows = rows}));
  ASSERT_TRUE(two_way);
  EXPECT_TRUE(two_way->series.complete());
  EXPECT_EQ(one_way->provenance.remarks.size() + two_way->provenance.remarks.size(), 2u);
}

TEST(RenishawRtl, TellsOfFlagsThatTheRunsContradict) {
  const auto test = read_rtl(text_of({.flags = "Flags: 0 1 2 0", .rows = two_way_rows}));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(reading(*test, 0, Direction::down, 0), -.6);
  ASSERT_EQ(test->provenance.remarks.size(), 1u);
  EXPECT_EQ(test->provenance.remarks[0].message,
            "found flags of a unidirectional test, but even runs that go back along the list of targets; they were "
            "taken as return runs");
}

TEST(RenishawRtl, TellsOfZerosInRunsOfEitherDirection) {
  const auto test =
      read_rtl(text_of({.rows = "1 1 1\n1 2 2\n1 3 3\n2 3 4\n2 2 5\n2 1 6\n3 1 0\n3 2 0\n3 3 0\n4 3 0\n4 2 0\n"
                                "4 1 0\n"}));
  ASSERT_TRUE(test) << test.error().to_string();
  ASSERT_EQ(test->provenance.remarks.size(), 1u);
  EXPECT_EQ(test->provenance.remarks[0].message, "found runs whose readings are all zero; they were taken as measured");
}

TEST(RenishawRtl, ReadsAFirstReadingBesideTheNamesOfTheColumns) {
  std::string text = text_of({.rows = two_way_rows});
  text.erase(text.find("Data: \n") + 6, 1);
  const auto test = read_rtl(text);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_TRUE(test->series.complete());
  EXPECT_EQ(reading(*test, 0, Direction::up, 0), .1);
}

TEST(RenishawRtl, KeepsMissingReadingsMissing) {
  const auto test = read_rtl(text_of({.run_count = 3, .rows = "1 1 1\n1 2 2\n1 3 3\n2 3 4\n3 1 5\n3 3 6\n"}));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.reading_count(), 6u);
  EXPECT_FALSE(test->series.reading(1, Direction::up, 1));
}

TEST(RenishawRtl, MakesSecondsOfArcOfMilliradians) {
  const auto test = read_rtl(text_of({.type = "rta", .targets = "0 90 180", .rows = two_way_rows}));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->metadata.axis.kind, AxisKind::rotary);
  EXPECT_NEAR(reading(*test, 0, Direction::up, 1), 1.1 * 206.26480624709636, 1e-9);
  EXPECT_EQ(test->series.targets()[2].in_native(), 180);
}

TEST(RenishawRtl, RefusesMoreSensorsAndComponentsThanATestHas) {
  std::string sensors, components;
  for (int k = 0; k < 257; ++k) {
    sensors += fmt::format("Mat temp {}: 21.0\n", k);
    components += fmt::format("Laser {}: ML10\n", k);
  }
  EXPECT_THAT(rtl_error({.rows = two_way_rows, .others = "ENVIRONMENT::\n" + sensors}),
              HasSubstr("found more than 256 records of sensors, expected fewer"));
  EXPECT_THAT(rtl_error({.rows = two_way_rows, .others = "EQUIPMENT::\n" + components}),
              HasSubstr("found more than 256 records of equipment, expected fewer"));
}

TEST(RenishawRtl, RefusesWhatContradictsItself) {
  EXPECT_EQ(rtl_error({.type = "rtq", .rows = two_way_rows}),
            "line 2:14: found the file type \"rtq\", expected rtl (linear) or rta (angular)");
  EXPECT_EQ(rtl_error({.targets = "0 50", .rows = two_way_rows}),
            "line 28:7: found the target \"3\", expected a whole number from 1 to 2");
  EXPECT_EQ(rtl_error({.targets = "0 50 100 150", .rows = two_way_rows}),
            "line 7:1: found Target-count 3 and a list of 4 targets, expected the same number");
  EXPECT_EQ(rtl_error({.run_count = 6, .rows = two_way_rows}),
            "line 23:1: found Run-count 6 and data of 4 runs, expected the same number of one-way runs");
  EXPECT_EQ(rtl_error({.run_count = 1, .rows = "1 1 1\n1 2 2\n"}),
            "line 9:1: found no reading of target 3 (100), expected at least one");
  EXPECT_EQ(rtl_error({.targets = "0 100 50", .rows = two_way_rows}),
            "line 9:1: found targets in no order, expected them to ascend or to descend, which tells the direction of "
            "runs");
  EXPECT_EQ(rtl_error({.flags = "", .rows = sorted_rows}),
            "line 30:1: found run 2 with its targets listed along, expected even ones to go back along the list of "
            "targets");
  EXPECT_EQ(rtl_error({.run_count = 1, .rows = "1 3 1\n1 2 2\n1 1 3\n"}),
            "line 27:1: found run 1 with its targets listed backwards, expected odd ones to go along the list of "
            "targets");
  EXPECT_EQ(rtl_error({.run_count = 1, .rows = "1 1 1\n1 2 2\n1 3 3\n1 2 5\n"}),
            "line 30:1: found a second reading of target 50↑ run 1, expected only that on line 28");
  EXPECT_EQ(rtl_error({.rows = "1 1\n"}),
            "line 27:1: found \"1 1\", expected three numbers: run, target and deviation");
}

TEST(RenishawRtl, ReadsThePagesOfOtherLanguages) {
  std::string gbk = text_of({.rows = two_way_rows});
  gbk.replace(gbk.find("Mill 5"), 6, "\xBB\xFA\xB4\xB2");
  const auto chinese = read_rtl(gbk);
  ASSERT_TRUE(chinese) << chinese.error().to_string();
  EXPECT_EQ(chinese->metadata.machine.name, "机床");
  EXPECT_EQ(chinese->provenance.remarks.size(), 1u);
  std::string latin = text_of({.rows = two_way_rows});
  latin.replace(latin.find("Mill 5"), 6, "Fr\xE4se");
  EXPECT_EQ(read_rtl(latin)->metadata.machine.name, "Fräse");
}

}  // namespace
}  // namespace axiometry::formats
