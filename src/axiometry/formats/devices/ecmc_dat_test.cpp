// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

constexpr std::string_view recording = R"(TEST_DATA=# Input data
# UNIT=deg in a comment means nothing
REF_PV=IOC:Enc01-PosAct
UNIT=mm
CYCLES=2
POSITIONS=2
DEC=8
TGT_DATA[2]=-4.88
REF_DATA_FWD[2,1]=-4.8801
TGT_DATA[1]=.24
REF_DATA_FWD[1,1]=.2399
REF_DATA_BWD[ 1 , 2 ] = .2411
REF_DATA_FWD[1,2]=.2398
REF_DATA_FWD[2,2]=-4.8802
REF_DATA_BWD[1,1]=.241
REF_DATA_BWD[2,1]=-4.879
REF_DATA_BWD[2,2]=-4.8791
  )";

TEST(EcmcDat, GivesDeviationsOfTheReferenceFromTheTargets) {
  const auto format = recognise(recording);
  ASSERT_TRUE(format);
  EXPECT_EQ((*format)->id, "ecmc-dat");
  const auto test = (*format)->read(recording);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.targets()[0].in_native(), -4.88);
  EXPECT_NEAR(test->series.reading(0, Direction::up, 0)->in_native(), -0.1, 1e-9);
  EXPECT_NEAR(test->series.reading(1, Direction::down, 1)->in_native(), 1.1, 1e-9);
  EXPECT_EQ(test->metadata.conditions.comment, "REF_PV IOC:Enc01-PosAct");
}

TEST(EcmcDat, TakesTheCountsFromTheDataWhenTheHeaderPromisesNone) {
  const auto test =
      find_format("ecmc-dat")
          ->read(
              "TGT_DATA[3]=0\nTGT_DATA[7]=1\nREF_DATA_FWD[3,1]=0\nREF_DATA_FWD[7,1]=1.001\nREF_DATA_FWD[7,2]=1.002\n");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.run_count(), 2u);
  EXPECT_EQ(test->series.count(0, Direction::up), 1u);
  EXPECT_FALSE(test->series.has(Direction::down));
}

TEST(EcmcDat, KeepsMissingReadingsMissingUnderTheCountsOfTheHeader) {
  const auto test = find_format("ecmc-dat")
                        ->read(
                            "CYCLES=2\nPOSITIONS=2\nTGT_DATA[1]=0\nTGT_DATA[2]=1\nREF_DATA_FWD[1,1]=0\n"
                            "REF_DATA_FWD[2,1]=1.001\nREF_DATA_FWD[2,2]=1.002\n");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.run_count(), 2u);
  EXPECT_FALSE(test->series.reading(0, Direction::up, 1));
  EXPECT_NEAR(test->series.reading(1, Direction::up, 1)->in_native(), 2.0, 1e-9);
  EXPECT_FALSE(test->series.has(Direction::down));
}

TEST(EcmcDat, CountsTheDataAndTellsWhereTheHeaderSaysOtherwise) {
  const auto test = find_format("ecmc-dat")
                        ->read(
                            "CYCLES=5\nPOSITIONS=8\nTGT_DATA[1]=0\nTGT_DATA[2]=1\nREF_DATA_FWD[1,1]=0\n"
                            "REF_DATA_FWD[2,1]=1.001\n");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.target_count(), 2u);
  EXPECT_EQ(test->series.run_count(), 1u);
  ASSERT_EQ(test->provenance.remarks.size(), 2u);
  EXPECT_EQ(test->provenance.remarks[0].message,
            "found POSITIONS=8 on line 2 and data of 2 positions; the data were counted");
  EXPECT_EQ(test->provenance.remarks[1].message, "found CYCLES=5 on line 1 and data of 1 cycle; the data were counted");
}

TEST(EcmcDat, MakesARotaryAxisOfDegrees) {
  const auto test =
      find_format("ecmc-dat")
          ->read("UNIT=deg\nTGT_DATA[1]=0\nTGT_DATA[2]=90\nREF_DATA_FWD[1,1]=0.001\nREF_DATA_FWD[2,1]=90\n");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->metadata.axis.kind, AxisKind::rotary);
  EXPECT_NEAR(test->series.reading(0, Direction::up, 0)->in_native(), 3.6, 1e-9);
}

}  // namespace
}  // namespace axiometry::formats
