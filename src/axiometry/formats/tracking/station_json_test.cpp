// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/station_json.h"

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
