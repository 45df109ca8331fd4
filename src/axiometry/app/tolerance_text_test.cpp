// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tolerance_text.h"

#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

double limit_of(std::string_view text, AxisKind kind) {
  const auto parsed = parse_tolerance(text);
  EXPECT_TRUE(parsed) << text;
  const auto tolerances = tolerances_for(kind, {*parsed});
  EXPECT_TRUE(tolerances) << text;
  return tolerances->front().limit.in_native();
}

std::string refusal(std::string_view text) {
  const auto parsed = parse_tolerance(text);
  return parsed ? "" : parsed.error().message;
}

TEST(ToleranceText, ConvertsEveryUnitToTheAxisUnit) {
  EXPECT_EQ(limit_of("A=10um", AxisKind::linear), 10.0);
  EXPECT_EQ(limit_of("A = 10 µm", AxisKind::linear), 10.0);
  EXPECT_EQ(limit_of("R_up=0.003mm", AxisKind::linear), 3.0);
  EXPECT_EQ(limit_of("B=250nm", AxisKind::linear), 0.25);
  EXPECT_EQ(limit_of("A↑=8arcsec", AxisKind::rotary), 8.0);
  EXPECT_EQ(limit_of("E=0.01deg", AxisKind::rotary), 36.0);
}

TEST(ToleranceText, RefusesWhatItCannotRead) {
  EXPECT_EQ(refusal("A"), "found the tolerance \"A\", expected PARAMETER=LIMIT such as A=10um");
  EXPECT_EQ(
      refusal("Q=1um"),
      "found the tolerance \"Q=1um\", expected one of the parameters A, A_up, A_down, E, E_up, E_down, M, R, R_up, "
      "R_down, B, B_mean");
  EXPECT_EQ(refusal("A=10"), "found the tolerance \"A=10\", expected a limit with its unit um, mm, nm, arcsec or deg");
  EXPECT_EQ(refusal("A=-1um"),
            "found the tolerance \"A=-1um\", expected a limit that is a number, 0 or more, with a decimal point");
  EXPECT_EQ(refusal("A=ten um"),
            "found the tolerance \"A=ten um\", expected a limit that is a number, 0 or more, with a decimal point");
}

TEST(ToleranceText, DoesNotMixLengthsAndAngles) {
  const auto result = tolerances_for(AxisKind::rotary, {*parse_tolerance("A=10um")});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "found the tolerance A=10um for a rotary axis, expected a limit in arcsec or deg");
}

}  // namespace
}  // namespace axiometry::app
