// SPDX-License-Identifier: Apache-2.0
//
// Every way in which a file is known to be wrong, with the whole message a user gets. All go the way of a
// user's file: recognised by content, then read.
#include <gtest/gtest.h>

#include <string>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

using namespace std::string_literals;

std::string message_for(std::string_view bytes) {
  const auto format = recognise(bytes.substr(0, 65536));
  if (!format) return format.error().to_string();
  const auto test = (*format)->read(bytes);
  return test ? "no error" : test.error().to_string();
}

struct BadInput {
  std::string what;
  std::string bytes;
  std::string message;
};

class BadInputs : public testing::TestWithParam<BadInput> {};

std::string name_of(const testing::TestParamInfo<BadInput>& input) { return input.param.what; }

TEST_P(BadInputs, AreRefusedWithPlaceAndReason) { EXPECT_EQ(message_for(GetParam().bytes), GetParam().message); }

const std::string header = "target_mm,direction,run,deviation_um\n";

std::string begins_with(const std::string& first_line) {
  return "line 1:1: found text that begins with \"" + first_line + "\", expected one of the " +
         std::to_string(format_table().size()) +
         " formats that can be read; a CSV file begins with a header such as target_mm,direction,run,deviation_um";
}

INSTANTIATE_TEST_SUITE_P(
    Files, BadInputs,
    testing::Values(
        BadInput{"Empty", "", "found an empty file, expected measured deviations"},
        BadInput{"OnlyBlanks", " \r\n\n", "found an empty file, expected measured deviations"},
        BadInput{"Spreadsheet", "PK\x03\x04\x14",
                 "line 1:1: found a ZIP archive or a spreadsheet, expected a text file; save a spreadsheet as CSV"},
        BadInput{"WebPage", "<!DOCTYPE html>\n<p>1, 2, 3</p>\n<p>2, 3, 4</p>\n",
                 "line 1:1: found a web page (HTML), expected a text file; save its table as CSV"},
        BadInput{"Xml", "<?xml version=\"1.0\"?>\n<p>1, 2, 3</p>\n<p>2, 3, 4</p>\n",
                 "line 1:1: found an XML document, expected a text file; save a table as CSV"},
        BadInput{"Binary", "\x7F"s + "ELF\x02\x01\0\0\0"s,
                 "line 1:7: found a NUL byte, so this is a binary file, expected a text file"},
        BadInput{"Utf32", "\xFF\xFE\0\0t\0\0\0"s,
                 "line 1:1: found UTF-16 or UTF-32 text, expected UTF-8; save the file as UTF-8"},
        BadInput{"Utf16", "\xFF\xFEt\0a\0"s, begins_with("ta")},
        BadInput{"Utf16WithoutMark", "t\0a\0r\0"s, begins_with("tar")},
        BadInput{"OldMacLinesOfSomethingElse", "Dear Sir,\rthe machine is fine.\r", begins_with("Dear Sir,")},
        BadInput{"SomethingElse", "Dear Sir,\nthe machine is fine.\n", begins_with("Dear Sir,")}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    CsvLong, BadInputs,
    testing::Values(
        BadInput{"Latin1ThatNoFormatKnows",
                 "Stra\xDF"
                 "e;1\n2;3\n",
                 "line 1:5: found the byte 0xDF, expected UTF-8; a file in Latin-1 or an ANSI code page must be saved "
                 "as UTF-8"},
        BadInput{"NoHeader", "0,up,1,0.5\n10,up,1,0.7\n",
                 "line 1:1: found a row of readings, expected a header above it that names the columns, such as "
                 "target_mm,direction,run,deviation_um"},
        BadInput{"ColumnsOfBlanks", "target_mm  up1_um  down1_um\n0 1 2\n",
                 "line 1:1: found columns separated by blanks, expected commas, semicolons or tabs between them"},
        BadInput{"OnlyAHeader", header, "found no readings below the header on line 1, expected one per line"},
        BadInput{"NotANumber", header + "0,up,1,nan\n", "line 2:8: found \"nan\", expected a finite number"},
        BadInput{"Infinite", header + "0,up,1,-inf\n", "line 2:8: found \"-inf\", expected a finite number"},
        BadInput{"Overflow", header + "0,up,1,1e999\n", "line 2:8: found \"1e999\", expected a finite number"},
        BadInput{"TooLarge", header + "0,up,1,2e9\n",
                 "line 2:8: found a deviation of 2e+09 µm, expected a magnitude up to 1e9"},
        BadInput{"MissingTarget", header + ",up,1,2\n", "line 2:1: found \"\", expected a finite number"},
        BadInput{"ShortRow", header + "0,up,1,1\n10,up,1\n20,up,1,3\n",
                 "line 3:7: found 3 fields, expected 4 as in the header on line 1"},
        BadInput{"LongRow", header + "0,up,1,1,7\n",
                 "line 2:10: found 5 fields, expected 4 as in the header on line 1; numbers with a decimal comma need "
                 "semicolons or "
                 "tabs between the columns"},
        BadInput{"DecimalCommaBetweenCommas", header + "0,5,up,1,1,2\n",
                 "line 2:10: found 6 fields, expected 4 as in the header on line 1; numbers with a decimal comma need "
                 "semicolons or "
                 "tabs between the columns"},
        BadInput{"QuotedThousand", header + "\"1,250\",up,1,1\n",
                 "line 2:1: found \"1,250\" in a file separated by commas, expected a number with a decimal point"},
        BadInput{"CutOff", header + "0,up,1,1\n10,up,1,2\n20,u",
                 "line 4:4: found 2 fields, expected 4 as in the header on line 1; the file ends here, is it cut off?"},
        BadInput{"TwoDecimalMarks", "target_mm;direction;run;deviation_um\n0,5;up;1;1,5\n1,5;up;1;2.5\n",
                 "line 3:10: found \"2.5\" with a decimal point, expected a decimal comma as on line 2"},
        BadInput{"ThousandsMark", "target_mm;direction;run;deviation_um\n1.234,5;up;1;1,5\n",
                 "line 2:1: found \"1.234,5\" with a comma and a point, expected a number with one decimal mark; marks "
                 "between "
                 "thousands must be removed"},
        BadInput{"ThousandsBlank", "target_mm;direction;run;deviation_um\n1 234,5;up;1;1,5\n",
                 "line 2:1: found \"1 234,5\", expected a finite number; marks between thousands must be removed"},
        BadInput{"RowOfMeans", header + "0,up,1,1\nMean,,,1\n",
                 "line 3:1: found \"Mean\", expected a finite number; rows of means and totals must be removed"},
        BadInput{"UnitInACell", header + "0 mm,up,1,1\n",
                 "line 2:1: found \"0 mm\", expected a finite number; units belong in the header alone"},
        BadInput{"SecondReadingThroughFloatNoise", header + "0.3,up,1,1\n10,up,1,2\n0.30000000000000004,up,1,3\n",
                 "line 4:1: found a second reading of target 0.3↑ run 1, expected only that on line 2"},
        BadInput{"SecondReading", header + "0,up,1,1\n10,up,1,2\n0.0,up,1,3\n",
                 "line 4:1: found a second reading of target 0↑ run 1, expected only that on line 2"},
        BadInput{"UnknownUnit", "target_mm,direction,run,deviation_furlong\n0,up,1,1\n",
                 "line 1:25: found the unknown unit \"furlong\" in the column \"deviation_furlong\", expected one of "
                 "um, mm, nm, m, in, "
                 "uin, arcsec, deg, mdeg, rad, mrad, urad"},
        BadInput{"NoUnit", "target_mm,direction,run,deviation\n0,up,1,1\n",
                 "line 1:25: found the column \"deviation\" without a unit, expected one in its name such as "
                 "deviation_um or deviation_arcsec, or a first line '# unit: um'"},
        BadInput{"MixedUnits", "target_mm,direction,run,deviation_arcsec\n0,up,1,1\n",
                 "line 1:25: found targets in mm and readings in arcsec, expected both as lengths or both as angles"},
        BadInput{"KindDisagrees", "# axis.kind: rotary\n" + header + "0,up,1,1\n10,up,1,1\n",
                 "line 1:14: found axis.kind = \"rotary\" and columns in units of a linear axis, expected the same"},
        BadInput{"OneTarget", header + "5,up,1,1\n5,down,1,1\n",
                 "line 2: found 1 target position, expected at least 2"},
        BadInput{"NoDirections", "target_mm,run,deviation_um\n0,1,1\n",
                 "line 1:1: found no direction column, expected target, direction, run and deviation"},
        BadInput{"EmptyDirection", header + "0,,1,1\n",
                 "line 2:3: found \"\", expected a direction: up, down, ↑, ↓, +, -, forward, backward, reverse, "
                 "positive or negative"},
        BadInput{"NeitherRunsNorDirections", "target_mm,deviation_um\n0,1\n",
                 "line 1:1: found no direction column, expected target, direction, run and deviation"},
        BadInput{"NoTarget", "direction,run,deviation_um\nup,1,1\n",
                 "line 1:1: found no target column, expected one such as target_mm or target_deg"},
        BadInput{"UnknownColumn", "target_mm,direction,run,deviation_um,colour\n0,up,1,1,red\n",
                 "line 1:38: found the unknown column \"colour\", expected target, direction, run and deviation, or "
                 "one column per run"},
        BadInput{
            "SameColumnTwice", "target_mm,target_mm,direction,run,deviation_um\n0,0,up,1,1\n",
            "line 1:11: found the columns \"target_mm\" and \"target_mm\" of the same meaning, expected one of them"},
        BadInput{"AbsurdRun", header + "0,up,1000000000,1\n",
                 "line 2:6: found the run \"1000000000\", expected a whole number from 1 to 10000"},
        BadInput{"RunZero", header + "0,up,0,1\n",
                 "line 2:6: found the run \"0\", expected a whole number from 1 to 10000; runs count from 1, so add 1 "
                 "to every run, or read the file as the format generic"},
        BadInput{"RunOfGigabytes", header + "0,up,10000,1\n10,up,1,1\n",
                 "line 2: found run 10000 among 2 readings, expected consecutive run numbers"},
        BadInput{"RunOfGigabytesInAColumn", "target_mm,up5000_um\n0,1\n10,1\n20,1\n",
                 "line 3:1: found run 5000 among 2 readings, expected consecutive run numbers"},
        BadInput{"NothingMeasuredAtATarget", header + "0,up,1,1\n10,up,1,\n",
                 "line 2: found no reading at target 10, expected at least one"},
        BadInput{"OpenQuote", header + "\"0,up,1,1\n",
                 "line 2:1: found a quoted field that does not end on its line, expected a closing quote"},
        BadInput{"TextAfterQuote", header + "\"0\"5,up,1,1\n",
                 "line 2:4: found \"5\" after a closing quote, expected the end of the field"},
        BadInput{"MetadataBelowTheHeader", header + "# machine: Mill\n0,up,1,1\n",
                 "line 2:1: found metadata below the header, expected it above line 1"},
        BadInput{"UnknownKey", "# machine.nam: Mill\n" + header + "0,up,1,1\n",
                 "line 1:3: found the unknown key \"machine.nam\", expected perhaps machine.name"},
        BadInput{"MisspelledKey", "# inspectr: Mill\n" + header + "0,up,1,1\n",
                 "line 1:3: found the unknown key \"inspectr\", expected perhaps inspector"},
        BadInput{"KeyTwice", "# axis: X\n# axis.name: Y\n" + header + "0,up,1,1\n10,up,1,1\n",
                 "line 2:14: found a second value of axis.name, expected only that on line 1"},
        BadInput{"WrongValue", "# feed: fast\n" + header + "0,up,1,1\n10,up,1,1\n",
                 "line 1:9: found test.feed = \"fast\", expected a number"},
        BadInput{"AnotherTurn", "target_deg,direction,run,position_deg\n0,up,1,359.999\n90,up,1,90\n",
                 "line 2:8: found a measured position 359.999° from its target, expected both within half a turn"},
        BadInput{"PositionsNamedDeviations",
                 "target_mm,direction,run,deviation_mm\n0,up,1,0.001\n100,up,1,100.002\n200,down,1,199.99\n",
                 "line 2: found deviations as large as the target positions, expected measured minus target; a column "
                 "of measured positions is named so, as in measured_mm or measured_deg"},
        BadInput{"EmptyTestName", "test,target_mm,direction,run,deviation_um\n,0,up,1,1\n",
                 "line 2:1: found an empty test name, expected one in every row"},
        BadInput{"TestNamedLikeAComment", "test,target_mm,direction,run,deviation_um\nA,0,up,1,1\n#2,0,up,1,1\n",
                 "line 3:1: found a row that begins with #, expected names of tests that do not"},
        BadInput{
            "TestComesBack",
            "test,target_mm,direction,run,deviation_um\nA,0,up,1,1\nA,9,up,1,1\nB,0,up,1,1\nB,9,up,1,1\nA,0,down,1,1\n",
            "line 4:1: found a second test \"B\", expected one test"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    CsvWide, BadInputs,
    testing::Values(
        BadInput{"MixedUnits", "target_mm,up1_um,down1_mm\n0,1,1\n",
                 "line 1:18: found the column \"down1_mm\" in mm beside \"up1_um\" in um, expected one unit"},
        BadInput{"RunTwice", "target_mm,up1_um,run 1 up_um\n0,1,1\n",
                 "line 1:18: found the columns \"up1_um\" and \"run 1 up_um\" for one run, expected one of them"},
        BadInput{"TargetTwice", "target_mm,up1_um\n0,1\n5,1\n0.00,2\n",
                 "line 4:1: found a second row of target 0, expected only that on line 2"},
        BadInput{"TargetTwiceInADirection", "target_mm,direction,run1_um\n0,up,1\n5,up,1\n0,up,2\n",
                 "line 4:1: found a second row of target 0↑, expected only that on line 2"},
        BadInput{"NoDirection", "target_mm,run1_um,run2_um\n0,1,1\n",
                 "line 1:11: found the column \"run1_um\" without a direction, expected up or down in its name or a "
                 "direction column"},
        BadInput{"Ragged", "target_mm;up1_um;down1_um\n0;1;2\n5;1\n",
                 "line 3:3: found 2 fields, expected 3 as in the header on line 1"},
        BadInput{"PositionsNamedRuns", "Position [mm];Run 1 + [mm];Run 1 - [mm]\n0;0,001;0,002\n90;90,001;90,003\n",
                 "line 1:1: found deviations as large as the target positions, expected measured minus target; a "
                 "column of measured positions is named so, as in measured_mm or measured_deg"},
        BadInput{"NoRows", "target_mm,up1_um\n",
                 "found no readings below the header on line 1, expected one row per target"},
        BadInput{"OneTarget", "target_mm,up1_um\n7,1\n", "line 1:1: found 1 target position, expected at least 2"},
        BadInput{"AbsurdRun", "target_mm,up999999999_um\n0,1\n",
                 "line 1:11: found the run \"999999999\", expected a whole number from 1 to 10000"},
        BadInput{"NotANumber", "target_mm,up1_um\n0,one\n", "line 2:3: found \"one\", expected a finite number"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    EcmcDat, BadInputs,
    testing::Values(
        BadInput{"Twice", "TGT_DATA[1]=0\nTGT_DATA[2]=1\nREF_DATA_FWD[1,1]=0\nREF_DATA_FWD[1,1]=0\n",
                 "line 4:1: found REF_DATA_FWD[1,1] again, expected only that on line 3"},
        BadInput{"NoTarget", "TGT_DATA[1]=0\nTGT_DATA[2]=1\nREF_DATA_FWD[3,1]=0\n",
                 "line 3:19: found a reading of position 3, expected TGT_DATA[3] to say its target"},
        BadInput{"TargetsAlone", "TGT_DATA[1]=5\nTGT_DATA[2]=0\n",
                 "found no reading at target 0, expected at least one"},
        BadInput{"NotANumber", "TGT_DATA[1]=0\nREF_DATA_FWD[1,1]=\n",
                 "line 2:19: found \"\", expected a finite number"},
        BadInput{"Unit", "UNIT=furlong\nTGT_DATA[1]=0\n",
                 "line 1:6: found the unknown unit \"furlong\", expected one of um, mm, nm, m, in, uin, arcsec, deg, "
                 "mdeg, rad, mrad, urad"},
        BadInput{"Index", "TGT_DATA[0]=0\n", "line 1:1: found the index \"0\", expected a whole number from 1"},
        BadInput{"CutInsideALine", "TGT_DATA[1]=0\nTGT_DATA[2]=1\nREF_DATA_F",
                 "line 3:1: found \"REF_DATA_F\", expected KEY=value"}),
    name_of);

const std::string rtl_head = "HEADER::\nFile type: rtl\nTARGET DATA::\nTargets :\n0 5\nFlags: 0 0 2 0\nRUNS::\n";

INSTANTIATE_TEST_SUITE_P(
    RenishawRtl, BadInputs,
    testing::Values(
        BadInput{"OnlyItsHead", "HEADER::\nFile type: rtl\n",
                 "found no section TARGET DATA::, expected HEADER::, TARGET DATA::, RUNS:: and DEVIATIONS::"},
        BadInput{"NoType", "HEADER::\nTARGET DATA::\n",
                 "found no file type, expected HEADER:: with 'File type : rtl' (linear) or 'rta' (angular)"},
        BadInput{"NoReadings", rtl_head + "DEVIATIONS::\nRun Target Data:\nEOF::\n",
                 "found no readings below DEVIATIONS::, expected one per line"},
        BadInput{"NotANumber", rtl_head + "DEVIATIONS::\n1 1 x\n", "line 9:5: found \"x\", expected a finite number"},
        BadInput{"NoTargets", "HEADER::\nFile type: rtl\nTARGET DATA::\nRUNS::\nDEVIATIONS::\n",
                 "found no targets, expected a list of them below 'Targets :'"},
        BadInput{"AbsurdRun", rtl_head + "DEVIATIONS::\n20001 1 0\n",
                 "line 9:1: found the run \"20001\", expected a whole number from 1 to 20000"},
        BadInput{
            "CutOff", rtl_head + "DEVIATIONS::\n1 1 0\n1 2",
            "line 10:1: found \"1 2\", expected three numbers: run, target and deviation; the file ends here, is it "
            "cut off?"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    OtherInstruments, BadInputs,
    testing::Values(
        BadInput{
            "CamonitorWithoutTest", "A:Laser 2026-04-06 12:00:00.1 0\n",
            "found no variable with TestNumber in its name, expected the numbers of an ISO 230-2 test; a first line "
            "'# TEST_PV=NAME' names another"},
        BadInput{"EtalonCutOff", "[EXX]\nGridpoints = {\n 0 0\n",
                 "line 1:1: found no } behind the grid points of EXX, expected one; is the file cut off?"},
        BadInput{"IsgWithoutRows", "X EXX\n",
                 "found no positioning error of a linear axis, expected one of EXX, EYY and EZZ"},
        BadInput{"HeidenhainCutOff", "#\nND-280 MM\n",
                 "found no end mark, expected # or * behind the last value; is the table cut off?"},
        BadInput{"ApiWithoutRows", "Position Bidirectional Avg Error\n",
                 "found no averages, expected rows of position and error below 'Position  Bidirectional Avg Error'"},
        BadInput{"EcmcReportWithoutTable", "# ecmc ISO 230 Bidirectional Positioning Report\n",
                 "found no table below '## Raw Measured Points', expected one"}),
    name_of);

std::string json_test(std::string_view series, std::string_view others = "") {
  return "{\"format\": \"axiometry-test/1\",\n" + std::string(others) + " \"series\": {" + std::string(series) + "}}";
}

INSTANTIATE_TEST_SUITE_P(
    Json, BadInputs,
    testing::Values(
        BadInput{"OtherJson", "{\"a\": 1}",
                 "line 1:1: found no member \"format\", expected \"format\": \"axiometry-test/1\""},
        BadInput{"LaterFormat", "{\"format\": \"axiometry-test/9\"}",
                 "line 1:12: found the format \"axiometry-test/9\", expected \"axiometry-test/1\""},
        BadInput{"NoSeries", "{\"format\": \"axiometry-test/1\"}",
                 "line 1:1: found no member \"series\", expected an object with targets and readings"},
        BadInput{"UnknownMember", json_test("", " \"machin\": {},\n"),
                 "line 2:12: found the unknown member \"machin\" in the test, expected perhaps \"machine\""},
        BadInput{"UnknownMemberOfAGroup", json_test("", " \"machine\": {\"nam\": \"M\"},\n"),
                 "line 2:21: found the unknown member \"nam\" in machine, expected perhaps \"name\""},
        BadInput{"UnknownMemberOfSeries", json_test("\"units\": \"um\""),
                 "line 2:22: found the unknown member \"units\" in series, expected perhaps \"unit\""},
        BadInput{"WrongKind", json_test("", " \"test\": {\"feed\": \"fast\"},\n"),
                 "line 2:19: found test.feed that is a string, expected a number"},
        BadInput{"OutOfRange", json_test("", " \"test\": {\"dwell_s\": -1},\n"),
                 "line 2:22: found test.dwell_s = -1, expected a number from 0 to 1e+06"},
        BadInput{"UnknownUnit", json_test("\"unit\": \"furlong\""),
                 "line 2:21: found the unknown unit \"furlong\", expected one of um, mm, nm, m, in, uin, arcsec, deg, "
                 "mdeg, rad, mrad, urad"},
        BadInput{"MixedUnits",
                 json_test("\"unit\": \"um\", \"target_unit\": \"deg\", \"targets\": [0, 1], \"up\": [[1, 1]]"),
                 "line 2:21: found targets in deg and readings in um, expected both as lengths or both as angles"},
        BadInput{"KindDisagrees",
                 json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0, 1], \"up\": [[1, 1]]",
                           " \"axis\": {\"kind\": \"rotary\"},\n"),
                 "line 2:19: found axis.kind \"rotary\" and readings in units of a linear axis, expected the same"},
        BadInput{"RaggedRun",
                 json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0, 1], \"up\": [[1, 1],\n [2]]"),
                 "line 3:2: found a run of 1 reading, expected 2, one per target (null where it is missing)"},
        BadInput{"ReadingIsText",
                 json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0, 1], \"up\": [[1,\n \"2\"]]"),
                 "line 3:2: found a reading of the kind string, expected a number or null"},
        BadInput{"OneTarget", json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0], \"up\": [[1]]"),
                 "line 2:59: found 1 target position, expected at least 2"},
        BadInput{"TargetTwice",
                 json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0, 1, 0.0], \"up\": [[1, 1, 1]]"),
                 "line 2:66: found the target 0 a second time, expected each once"},
        BadInput{"NoRuns", json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0, 1]"),
                 "line 2:12: found no runs, expected readings in \"up\" or \"down\" or both"},
        BadInput{"TimesOfAnotherShape",
                 json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0, 1], \"up\": [[1, 1]]",
                           " \"times_s\": {\"up\": [[1, 2], [3, 4]]},\n"),
                 "line 2:13: found times of 2 runs, expected at most 1 as there are readings of"},
        BadInput{"TimesOfAnUnknownDirection",
                 json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0, 1], \"up\": [[1, 1]]",
                           " \"times_s\": {\"left\": [[1, 2]]},\n"),
                 "line 2:22: found the unknown member \"left\" in times_s, expected up and down"},
        BadInput{"SourceWithoutItsFile",
                 json_test("\"unit\": \"um\", \"target_unit\": \"mm\", \"targets\": [0, 1], \"up\": [[1, 1]]",
                           " \"source\": {\"sha256\": \"\"},\n"),
                 "line 2:12: found no member \"file\", expected a string"},
        BadInput{"CutOff", "{\"format\": \"axiometry-test/1\", \"series\": {\"unit\"",
                 "line 1:49: found the end of the text, expected ':'"},
        BadInput{"NestedDeeply", "{\"a\":" + std::string(100000, '['),
                 "line 1:69: found nesting deeper than 64 levels, expected less"},
        BadInput{"Nan", json_test("\"targets\": [NaN]"), "line 2:25: found \"NaN\", expected a JSON value"},
        BadInput{"Overflow", json_test("\"targets\": [1e400]"),
                 "line 2:25: found \"1e400\", expected a number up to 1.8e308"}),
    name_of);

TEST(BadInput, AGigabyteOfJsonIsRefusedBeforeItIsRead) {
  std::string bytes = "{\"format\": \"axiometry-test/1\"";
  bytes.resize((std::size_t{64} << 20) + 1, ' ');
  EXPECT_EQ(message_for(bytes), "found 67108865 bytes, expected at most 67108864");
}

}  // namespace
}  // namespace axiometry::formats
