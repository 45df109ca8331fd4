// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/station_json.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

std::string station_error(std::string_view json) {
  const auto station = read_station(json);
  return station ? "no error" : station.error().to_string();
}

TEST(StationJson, TheRefinedStationOfALocationIsRead) {
  const auto station = read_station(R"({"linear": {"station": [1, 2, 3]},
    "refined": {"station": [653.6, -27.13, 262.18], "L0": 5,
                "covariance": [[4e-6, 1e-6, 0], [1e-6, 9e-6, 0], [0, 0, 1e-4]]}, "findings": []})");
  ASSERT_TRUE(station) << station.error().to_string();
  EXPECT_EQ(station->position_mm, (Vector3{653.6, -27.13, 262.18}));
  ASSERT_TRUE(station->covariance_mm2);
  EXPECT_EQ((*station->covariance_mm2)[0][1], 1e-6);
  EXPECT_EQ((*station->covariance_mm2)[2][2], 1e-4);
}

TEST(StationJson, TheCovarianceThatBoundsNeedIsReadInPlaceOfTheOther) {
  const auto station = read_station(R"({"refined": {"station": [1, 2, 3],
    "covariance": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "covariance_for_bounds": [[6, 0, 0], [0, 6, 0], [0, 0, 6]]}})");
  ASSERT_TRUE(station && station->covariance_mm2);
  EXPECT_EQ((*station->covariance_mm2)[1][1], 6.0);
}

TEST(StationJson, AResultOfAnOlderVersionIsAsWideAsBoundsNeedIt) {
  // Six points, ν = 2, χ² = 50: its covariance was multiplied by 25 alone. F(2, 2) is 19 at 95 %, χ² of two 5.99.
  const auto station =
      read_station(R"({"refined": {"station": [1, 2, 3], "covariance": [[25, 5, 0], [5, 25, 0], [0, 0, 25]],
    "covariance_stated": [[1, 0.2, 0], [0.2, 1, 0], [0, 0, 1]], "inflation": 25, "chi_squared": 50,
    "degrees_of_freedom": 2}})");
  ASSERT_TRUE(station && station->covariance_mm2);
  EXPECT_NEAR((*station->covariance_mm2)[1][1], 25.0 * 2.0 * 19.0 / 5.991464547, 1e-6);
  EXPECT_NEAR((*station->covariance_mm2)[0][1], 5.0 * 2.0 * 19.0 / 5.991464547, 1e-6);
  // Residuals as small as stated: F(2, 2) is in it as soon as it is more than what is stated, and nothing is taken off.
  const auto of = [](double chi_squared, int nu) {
    const auto read =
        read_station(fmt::format(R"({{"refined": {{"station": [1, 2, 3], "chi_squared": {}, "degrees_of_freedom": {},
      "covariance": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}}})",
                                 chi_squared, nu));
    return (*read->covariance_mm2)[0][0];
  };
  EXPECT_EQ(of(0.01, 2), 1.0);
  EXPECT_NEAR(of(2.0, 2), 2.0 * 19.0 / 5.991464547, 1e-8);
  EXPECT_EQ(of(0.0, 0), 1.0);
  const auto wrong = [](std::string_view members) {
    return station_error(
        fmt::format(R"({{"refined": {{"station": [1, 2, 3], "covariance": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
      {}}}}})",
                    members));
  };
  EXPECT_TRUE(wrong(R"("chi_squared": -1, "degrees_of_freedom": 2)").contains("found chi_squared = -1"));
  EXPECT_TRUE(wrong(R"("chi_squared": 1e308, "degrees_of_freedom": 1)").contains("found chi_squared = 1e+308"));
  EXPECT_TRUE(wrong(R"("chi_squared": 1, "degrees_of_freedom": 1.5)").contains("found degrees_of_freedom = 1.5"));
  EXPECT_TRUE(wrong(R"("chi_squared": "1", "degrees_of_freedom": 2)").contains("found \"chi_squared\" of the kind"));
}

TEST(StationJson, AHandWrittenStationNeedsNoCovariance) {
  const auto station = read_station(R"({"station": [650, -30, 260]})");
  ASSERT_TRUE(station) << station.error().to_string();
  EXPECT_EQ(station->position_mm, (Vector3{650, -30, 260}));
  EXPECT_FALSE(station->covariance_mm2);
  EXPECT_FALSE(read_station(R"({"station": [650, -30, 260], "covariance": null})")->covariance_mm2);
}

TEST(StationJson, AStationThatItsLocationSaysNotToUseIsRefused) {
  const std::string message = station_error(
      R"({"refined": {"station": [1, 2, 3]}, "findings": [{"severity": "note", "message": "n"},
          {"severity": "serious", "message": "the length at point 3 was misread"}]})");
  EXPECT_NE(message.find("line 2:11: found a station that should not be used as it is: the length at point 3"),
            std::string::npos)
      << message;
  EXPECT_TRUE(read_station(R"({"station": [1, 2, 3], "findings": [{"severity": "note", "message": "n"}]})"));
}

TEST(StationJson, WhatIsWrongIsNamedWithItsPlace) {
  EXPECT_EQ(station_error("[1]"), "line 1:1: found array at the top, expected an object with the station");
  EXPECT_NE(station_error("{}").find("line 1:1: found no member \"station\""), std::string::npos);
  EXPECT_NE(station_error(R"({"station": [1, 2]})")
                .find("line 1:13: found \"station\" with 2 values, expected three numbers"),
            std::string::npos);
  EXPECT_NE(station_error(R"({"station": [1, "2", 3]})").find("line 1:17: found \"station\" of the kind string"),
            std::string::npos);
  EXPECT_NE(station_error(R"({"station": [1, 2e12, 3]})").find("found the coordinate 2e+12"), std::string::npos);
  EXPECT_NE(station_error(R"({"station": [1, 2, 3], "covariance": [[1, 0, 0], [0, -1, 0], [0, 0, 1]]})")
                .find("found the variance -1 of Y"),
            std::string::npos);
  EXPECT_NE(station_error(R"({"station": [1, 2, 3], "covariance": [[1, 0, 0], [0.1, 1, 0], [0, 0, 1]]})")
                .find("expected a symmetric matrix"),
            std::string::npos);
  EXPECT_NE(station_error(R"({"station": [1, 2, 3], "covariance": [[1, 2, 0], [2, 1, 0], [0, 0, 1]]})")
                .find("found the covariances 2 and 2 of Y and X"),
            std::string::npos);
  // Each pair may be so, all three may not: the variance of (1, 1, -1) would be -2.4.
  EXPECT_NE(station_error(R"({"station": [1, 2, 3], "covariance": [[1, -0.9, 0.9], [-0.9, 1, 0.9], [0.9, 0.9, 1]]})")
                .find("expected a positive semidefinite matrix"),
            std::string::npos);
}

}  // namespace
}  // namespace axiometry::formats
