// SPDX-License-Identifier: Apache-2.0
//
// Files that could be read as something else than they are: statistics as readings, thousands as decimals, another unit
// than the stated one. Each is refused, asked about or told, and what it resembles is read as before.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>

#include "axiometry/formats/format.h"
#include "axiometry/formats/table/generic_delimited.h"

namespace axiometry::formats {
namespace {

using testing::HasSubstr;

/// Read as whatever it is recognised as.
Result<axiometry::Test> read_known(const std::string& bytes) {
  AXIOMETRY_TRY(const Format* format, recognise(bytes));
  return format->read(bytes);
}

std::string answer(const std::string& bytes) {
  const auto test = read_known(bytes);
  if (!test) return test.error().message;
  std::string remarks = "read";
  for (const SourceRemark& remark : test->provenance.remarks) remarks += "; " + remark.message;
  return remarks;
}

TEST(Misread, AMultipleOfTheStandardDeviationIsNoRun) {
  const std::string runs = "0;0.2;1.2;0.4;1.5\n250;2.2;3.2;2.4;3.5\n500;4.2;5.2;4.4;5.5\n";
  for (const std::string name : {"4s", "6 sigma", "2σ"}) {
    const std::string wide = "Consigne [mm];Écart aller 1 [µm];Écart retour 1 [µm];" + name + " aller [µm];" + name +
                             " retour [µm]\n" + runs;
    const auto test = read_known(wide);
    ASSERT_TRUE(test) << test.error().to_string();
    EXPECT_EQ(test->series.run_count(), 1u) << wide;
    EXPECT_THAT(answer("Unit: µm\nPosition [mm];0.5;85.375;170.25\nRun 1 up;0.1;0.2;0.3\nRun 1 down;1.1;1.2;1.3\n" +
                       name + " up;2;2.1;2.2\n" + name + " down;2;2.1;2.3\n"),
                HasSubstr("a limit or a mean?"));
  }
}

TEST(Misread, ASummaryIsNoSeriesOfDeviations) {
  const std::string rows =
      "0.5;up;0.06;0.49\n85.375;up;3.08;0.42\n170.25;up;5.1;0.4\n170.25;down;9.1;0.4\n"
      "85.375;down;7.0;0.3\n0.5;down;4.5;0.5\n";
  for (const std::string head :
       {"Mean (um);Standard deviation (um)", "Moyenne [µm];Écart-type [µm]", "Mean deviation (um);Repeatability (um)",
        "Mittel [µm];Messunsicherheit [µm]", "Media (um);Scarto tipo (um)", "Media (um);Desviación estándar (um)",
        "Mean (um);|error| (um)", "Mean (um);Error yaw (um)", "Mean (um);Vertical deviation (um)",
        "Mean (um);Backlash (um)", "Mean (um);error_rms_um"})
    EXPECT_THAT(answer("Target (mm);Direction;" + head + "\n" + rows), testing::Not(testing::StartsWith("read")))
        << head;
  EXPECT_THAT(
      answer("Target (mm);Direction;Cumulative error (um)\n0;up;0.1\n50;up;0.4\n100;up;0.5\n100;down;1.3\n"
             "50;down;1.1\n0;down;0.9\n0;up;0.2\n50;up;0.5\n100;up;0.5\n100;down;1.2\n50;down;1.0\n0;down;0.8\n"),
      testing::StartsWith("read"));
  EXPECT_THAT(answer("target_mm,direction,run,|error| um\n0,up,1,0.1\n50,up,1,0.4\n50,down,1,1.1\n0,down,1,0.9\n"),
              testing::Not(testing::StartsWith("read")));
}

TEST(Misread, WholeNumbersAmongThousandsAreNotDecimals) {
  const std::string wide = "Target (mm);up1 (um);down1 (um)\n0;1;3\n500;2;5\n1.000;4;6\n1.500;5;9\n";
  EXPECT_THAT(answer(wide), HasSubstr("whose mark may part thousands"));
  EXPECT_THAT(answer("target_mm;direction;run;deviation_nm\n0;up;1;120\n100;up;1;980\n200;up;1;1,020\n200;down;1;870\n"
                     "100;down;1;3,450\n0;down;1;5\n"),
              HasSubstr("\"1,020\" and \"120\" in one column"));
  EXPECT_THAT(answer("Consigne [mm]\tÉcart aller 1 [µm]\tÉcart retour 1 [µm]\n0\t1\t3\n500\t2\t5\n1.000\t4\t6\n"
                     "1.250\t5\t9\n"),
              HasSubstr("points may be decimal marks or part thousands"));
  for (const std::string fine : {"Target (mm);up1 (um);down1 (um)\n0;1;3\n500;2;5\n1000;4;6\n1500;5;9\n",
                                 "Target (mm);up1 (um);down1 (um)\n0.000;1;3\n0.500;2;5\n1.000;4;6\n1.500;5;9\n",
                                 "Target (mm);up1 (um);down1 (um)\n0;0.1;3\n1.125;2;5\n2.125;4;6\n3.5;5;9\n",
                                 "Target (mm),up1 (um),down1 (um)\n0,1,3\n1.125,2,5\n2.125,4,6\n3.250,5,9\n"})
    EXPECT_THAT(answer(fine), testing::StartsWith("read")) << fine;
}

TEST(Misread, PartsOfAUnitAreNoUnit) {
  const std::string rows = "\n0,up,1,1\n50,up,1,4\n50,down,1,11\n0,down,1,9\n";
  for (const std::string name : {"Deviation in 1/10 µm", "Deviation 1/10 µm", "Error in 0.1 µm", "Error in 10 µm"})
    EXPECT_THAT(answer("target_mm,direction,run,\"" + name + "\"" + rows), testing::Not(testing::StartsWith("read")))
        << name;
  EXPECT_THAT(answer("target_mm,direction,run,Deviation in µm" + rows), testing::StartsWith("read"));
}

TEST(Misread, UnitsThatContradictAreRefusedOrTold) {
  const std::string rows = "target_mm,direction,run,deviation\n0,up,1,1\n100,up,1,2\n100,down,1,4\n0,down,1,3\n";
  EXPECT_THAT(answer("# unit: um\n# unit: mm\n" + rows),
              HasSubstr("found the unit mm of the readings, expected only um"));
  EXPECT_THAT(answer("# unit: um\n# units: µm\n" + rows), testing::StartsWith("read"));
  EXPECT_THAT(answer("# unit: um\nUnit,mm\n" + rows), HasSubstr("found the unit mm of the readings, expected only um"));
  EXPECT_EQ(answer("Unit,um\nUnits,um\n" + rows), "read");
  EXPECT_THAT(answer("# unit: mm\ntarget_mm,direction,run,deviation_um\n0,up,1,1\n100,up,1,2\n"),
              HasSubstr("the unit mm that is stated above the table is not that of the column \"deviation_um\""));
  EXPECT_THAT(answer("Units: inch\nPosition       Bidirectional Avg Error\n0.0\t0.0005\n4\t0.0012\n"),
              HasSubstr("found the unit \"inch\", expected none but mm"));
  for (const std::string line : {"Unit = um\n", "// units: um\n", "[UNIT]\nVALUE = inch\n"})
    EXPECT_THAT(answer(line + "[EXX]\nGridpoints = {\n0 0.0005\n100 0.0012\n}\n"), HasSubstr("expected none but mm"));
  EXPECT_THAT(answer("// Unit: mm\n[EXX]\nSIGN = 1\nGridpoints = {\n0 0.0005\n100 0.0012\n}\n"),
              testing::StartsWith("read"));
  EXPECT_THAT(answer("[EXX]\nSIGN = -1\nGridpoints = {\n0 0.0005\n100 0.0012\n}\n"), HasSubstr("found SIGN = \"-1\""));
}

const std::string rtl_beginning = "HEADER::\nFile type  : rtl\n";
const std::string rtl_middle =
    "TARGET DATA::\nTarget-count: 2\nTargets :\n100 200\nRUNS::\nRun-count: 2\nDEVIATIONS::\nRun Target Data:\n";
const std::string rtl_readings = " 1 1 0.100\n 1 2 0.400\n 2 2 1.900\n 2 1 1.600";

TEST(Misread, AnRtlFileIsInItsUnitsAndWhole) {
  EXPECT_THAT(answer(rtl_beginning + "Units: inch\n" + rtl_middle + rtl_readings + "\nEOF::\n"),
              HasSubstr("expected none but mm and um"));
  EXPECT_EQ(answer(rtl_beginning + rtl_middle + rtl_readings + "\nEOF::\n"), "read");
  EXPECT_EQ(answer(rtl_beginning + rtl_middle + rtl_readings + "\n"), "read");
  EXPECT_THAT(answer(rtl_beginning + rtl_middle + rtl_readings), HasSubstr("its last reading may be cut off"));
  EXPECT_THAT(
      answer(rtl_beginning + rtl_middle + " 1 1 100000.1\n 1 2 200000.4\n 2 2 200001.9\n 2 1 100001.6\nEOF::\n"),
      HasSubstr("deviations as large as the target positions"));
}

TEST(Misread, PositionsAreNoDeviationsInJsonEither) {
  EXPECT_THAT(answer(R"({"format":"axiometry-test/1","series":{"unit":"mm","target_unit":"mm","targets":[0,100,200],)"
                     R"("up":[[0.001,100.002,200.003]],"down":[[0.004,100.006,200.007]]}})"),
              HasSubstr("deviations as large as the target positions"));
}

TEST(Misread, LinesOfWhichNothingIsKeptAreTold) {
  const std::string rows = "target_mm;direction;run;deviation_um\n0;up;1;1\n100;up;1;2\n";
  EXPECT_THAT(answer("# air temperature: 68 F\n# free text\nOperator;Jim\nDewpoint;3\n" + rows),
              HasSubstr("2 lines above the table told nothing that is known and were passed over, the first of them "
                        "\"# air temperature: 68 F\""));
  EXPECT_EQ(answer("# free text without a mark\nOperator;Jim\n" + rows), "read");
}

TEST(Misread, ForwardBesideFallingTargetsIsTold) {
  EXPECT_THAT(answer("target_mm,fwd 1_um,rev 1_um\n0,0,3\n-100,1,4\n-200,2,5\n"),
              HasSubstr("both directions are exchanged"));
  EXPECT_EQ(answer("target_mm,up 1_um,down 1_um\n0,0,3\n-100,1,4\n-200,2,5\n"), "read");
  EXPECT_EQ(answer("target_mm,fwd 1_um,rev 1_um\n-200,0,3\n-100,1,4\n0,2,5\n"), "read");
}

TEST(Misread, ARowOfMeansFilledUpWithBlankCellsEndsTheTable) {
  const auto test = read_known(
      "Target [mm]\tDir\tLauf\tAbw. [µm]\n0\thin\t1\t0.1\n100\thin\t1\t0.4\n100\tzurück\t1\t1.1\n"
      "0\tzurück\t1\t0.9\n0\thin\t2\t0.2\n100\thin\t2\t0.5\n100\tzurück\t2\t1.2\n"
      "0\tzurück\t2\t0.8\nMittel\t\t\t0.65\n");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.reading_count(), 8u);
}

}  // namespace
}  // namespace axiometry::formats
