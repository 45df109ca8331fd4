// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

const std::string csv_header =
    "cycle,direction,target,selected_reference_slot,selected_reference_pv,reference_mean,reference_std,rbv_mean,rbv_"
    "std,"
    "command_mean,ref_error,rbv_error,ref1_pv,ref1_mean,ref1_std,ref1_error,timestamp\r\n";

std::string csv_row(const std::string& begin, const std::string& mean, const std::string& error,
                    const std::string& time) {
  return begin + ",0,IOC:LASER," + mean + ",0.0002,9,9,9," + error + ",9,IOC:LASER,9,9,9,2026-03-07T" + time + "\r\n";
}

const std::string csv_file = csv_header + csv_row("1,forward,0.0", "-0.0029", "-0.0029", "23:30:43") +
                             csv_row("1,forward,248.325", "248.3214", "-0.0036", "23:30:46") +
                             csv_row("1,reverse,248.325", "248.3264", "0.0014", "23:30:49") +
                             csv_row("1,reverse,0.0", "0.0011", "0.0011", "23:30:52");

const std::string report_head =
    "# ecmc ISO 230 Bidirectional Positioning Report\n\n- Settle time: `2.50000 s`\n\n## Per-Target Results\n\n"
    "| Target | Mean |\n| --- | --- |\n| 0.0 | 9 |\n\n## Raw Measured Points\n\n"
    "Selected reference for report/error columns: `IOC:LASER`\n\n"
    "| Cycle | Direction | Target | Raw Ref Mean | Raw Ref Std | RBV Mean | RBV Std | Raw Ref Err | RBV Err | "
    "Timestamp "
    "|\n| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
const std::string report = report_head +
                           "| 1 | forward | 0.00000 | -0.00290 | 0.0 | 9 | 9 | -0.00290 | 9.0 | 2026-03-07 23:30:43 |\n"
                           "| 1 | forward | 248.32500 | 248.32140 | 0.0 | 9 | 9 | -0.00361 | 9.0 | 2026-03-07 23:30:46 "
                           "|\n\n## Later\n\n| a |\n";

Result<Test> read_ecmc(const std::string& text, std::string_view id) {
  const auto format = recognise(text);
  EXPECT_TRUE(format && (*format)->id == id) << (format ? (*format)->id : format.error().to_string());
  return find_format(id)->read(text);
}

std::string ecmc_error(const std::string& text, std::string_view id) {
  const auto test = read_ecmc(text, id);
  return test ? "no error" : test.error().to_string();
}

TEST(EcmcCfgCsv, TakesTheErrorsOfTheReference) {
  const auto test = read_ecmc(csv_file, "ecmc-cfg-csv");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.targets()[1].in_native(), 248.325);
  EXPECT_NEAR(test->series.reading(1, Direction::up, 0)->in_native(), -3.6, 1e-12);
  EXPECT_NEAR(test->series.reading(0, Direction::down, 0)->in_native(), 1.1, 1e-12);
  EXPECT_EQ(test->times_s, (std::vector<double>{0, 3, 9, 6}));
  EXPECT_EQ(test->metadata.conditions.date, "2026-03-07");
  EXPECT_EQ(test->metadata.conditions.comment, "Reference IOC:LASER");
  ASSERT_EQ(test->provenance.remarks.size(), 1u);
  EXPECT_EQ(test->provenance.remarks[0].message, "found lengths without a unit; they were taken in mm");
}

TEST(EcmcCfgCsv, TellsWhereTheErrorIsNotTheMeanMinusTheTarget) {
  const auto test = read_ecmc(csv_file + csv_row("2,forward,0.0", "0.5", "0.25", "23:31:00"), "ecmc-cfg-csv");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.reading(0, Direction::up, 1)->in_native(), 250.0);
  ASSERT_EQ(test->provenance.remarks.size(), 2u);
  EXPECT_TRUE(test->provenance.remarks[1].message.contains("0.25 mm"));
}

TEST(EcmcCfgCsv, TakesWholeTargetsAsExactWhenItComparesErrorAndMean) {
  const auto test = read_ecmc(csv_header + csv_row("1,forward,0", "0.01", "0", "23:30:43") +
                                  csv_row("1,forward,248", "248.01", "0", "23:30:46"),
                              "ecmc-cfg-csv");
  ASSERT_TRUE(test) << test.error().to_string();
  ASSERT_EQ(test->provenance.remarks.size(), 2u);
  EXPECT_TRUE(test->provenance.remarks[1].message.contains("differ from its mean minus the target by up to 0.0"));
}

TEST(EcmcCfgCsv, LeavesAnEmptyErrorMissing) {
  const auto test = read_ecmc(csv_file + csv_row("2,forward,0.0", "", "", "23:31:00") +
                                  csv_row("2,forward,248.325", "248.325", "0", "23:31:05"),
                              "ecmc-cfg-csv");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_FALSE(test->series.reading(0, Direction::up, 1));
  EXPECT_EQ(test->series.count(1, Direction::up), 2u);
}

TEST(EcmcCfgCsv, LeavesOtherCsvFilesToTheGeneralReader) {
  const auto format = recognise("cycle,direction,target_mm,ref_error_um\n1,forward,0,1\n");
  ASSERT_TRUE(format);
  EXPECT_EQ((*format)->id, "csv-long");
}

TEST(EcmcCfgCsv, RefusesWhatIsBroken) {
  EXPECT_EQ(ecmc_error(csv_header, "ecmc-cfg-csv"),
            "found no readings below the header on line 1, expected one per row");
  EXPECT_EQ(ecmc_error(csv_file + "2,forward,0", "ecmc-cfg-csv"),
            "line 6:11: found 3 fields, expected 17 as in the header on line 1; the file ends here, is it cut off?");
  EXPECT_EQ(ecmc_error(csv_file + csv_row("1,sideways,0", "0", "0", "23:30:43"), "ecmc-cfg-csv"),
            "line 6:3: found \"sideways\", expected the direction forward or reverse");
  EXPECT_EQ(ecmc_error(csv_file + csv_row("1,forward,0", "0", "0", "23:30:43"), "ecmc-cfg-csv"),
            "line 6:40: found a second reading of target 0↑ run 1, expected only that on line 2");
  EXPECT_EQ(ecmc_error(csv_file + csv_row("1,forward,5", "0", "nan", "23:30:43"), "ecmc-cfg-csv"),
            "line 6:40: found \"nan\", expected a finite number");
}

TEST(EcmcCfgMd, ReadsTheTableOfMeasuredPointsAlone) {
  const auto test = read_ecmc(report, "ecmc-cfg-md");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.target_count(), 2u);
  EXPECT_NEAR(test->series.reading(1, Direction::up, 0)->in_native(), -3.61, 1e-12);
  EXPECT_EQ(test->metadata.conditions.dwell->in_s(), 2.5);
  EXPECT_EQ(test->metadata.conditions.comment, "Reference IOC:LASER");
  EXPECT_EQ(test->times_s[1], 3.0);
  // −3.60 by the mean, −3.61 by the error: the digits shown explain it.
  EXPECT_EQ(test->provenance.remarks.size(), 1u);
}

TEST(EcmcCfgMd, ReadsOlderReportsWhoseErrorsAreNotCalledRaw) {
  std::string older = report;
  for (std::size_t at; (at = older.find("Raw Ref")) != std::string::npos;) older.replace(at, 7, "Ref");
  EXPECT_TRUE(read_ecmc(older, "ecmc-cfg-md"));
}

TEST(EcmcCfgMd, RefusesWhatIsBroken) {
  EXPECT_EQ(ecmc_error(report_head + "| 1 | forward | 0.0 |", "ecmc-cfg-md"),
            "line 17:1: found 3 cells, expected 10 as in the header on line 15; the file ends here, is it cut off?");
  EXPECT_EQ(ecmc_error("## Raw Measured Points\n", "ecmc-cfg-md"),
            "found no table below '## Raw Measured Points', expected one");
  EXPECT_EQ(ecmc_error("## Raw Measured Points\n| Cycle | Target |\n| --- | --- |\n", "ecmc-cfg-md"),
            "line 2:1: found a table without one of cycle, direction, target and ref_error, expected them all");
}

}  // namespace
}  // namespace axiometry::formats
