// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/volumetric_result_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "axiometry/volumetric/known_machine_test_support.h"

namespace axiometry::formats {
namespace {

using ::testing::HasSubstr;
using volumetric::Coefficients;
using volumetric::CurveBasis;
using volumetric::CurveKind;
using volumetric::ErrorModel;
using volumetric::Reversal;

/// Small: straight lines over each axis, some coefficients, one direction that the lengths do not tell.
ErrorModel small_model() {
  const auto basis = [](double low, double high) { return *CurveBasis::make(CurveKind::nodes, low, high, 2); };
  const Coefficients coefficients({basis(0, 1000), basis(0, 600), basis(-500, 0)}, Reversal::constant);
  const std::size_t n = coefficients.raw();
  std::vector<double> values(n, 0.0), covariance(n * n, 0.0), unseen(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    values[i] = 0.25 * static_cast<double>(i) - 3.0;
    covariance[i * n + i] = 1.0 + static_cast<double>(i);
  }
  covariance[1] = covariance[n] = 0.5;
  unseen[coefficients.squareness()] = 1.0;
  const auto machine = volumetric::testing::known_machine();
  return ErrorModel({machine, coefficients, values, covariance, {unseen}, machine.travel});
}

std::string file_of(const ErrorModel& model) {
  json::Value root = json::Value::object();
  root.add("model", error_model_value(model));
  return json::dump(root, 0);
}

std::string refusal_of(std::string text, const std::string& what, const std::string& instead) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  text.replace(at, what.size(), instead);
  const auto model = read_error_model(text);
  return model ? "none" : model.error().to_string();
}

TEST(VolumetricResultJson, IsReadBackAsItIsWritten) {
  const ErrorModel model = small_model();
  const auto again = read_error_model(file_of(model));
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(again->parts().values, model.parts().values);
  EXPECT_EQ(again->parts().covariance, model.parts().covariance);
  EXPECT_EQ(again->parts().unseen, model.parts().unseen);
  EXPECT_EQ(again->coefficients().reversal(), Reversal::constant);
  EXPECT_EQ(again->coefficients().basis(2), model.coefficients().basis(2));
  EXPECT_EQ(file_of(*again), file_of(model));
  EXPECT_FALSE(again->squareness(volumetric::Squareness::C0Y)) << "what was not told has no number afterwards";
}

TEST(VolumetricResultJson, RefusesWhatIsNoResult) {
  const auto none = read_error_model("{}");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().to_string(), HasSubstr("the result of a volumetric calibration"));
  const std::string text = file_of(small_model());
  EXPECT_THAT(refusal_of(text, "\"nodes\"", "\"waves\""), HasSubstr("expected b-spline, legendre or nodes"));
  EXPECT_THAT(refusal_of(text, "\"size\":2", "\"size\":2.5"), HasSubstr("whole number from 1 to 400"));
  EXPECT_THAT(refusal_of(text, "\"constant\"", "\"both\""), HasSubstr("expected none, constant or curves"));
  EXPECT_THAT(refusal_of(text, "\"coefficients\":[", "\"coefficients\":[1,"), HasSubstr("numbers of coefficients"));
  EXPECT_THAT(refusal_of(text, "\"coefficients\":[-3", "\"coefficients\":[1e7"),
              HasSubstr("expected errors of a machine"));
  EXPECT_THAT(refusal_of(text, "\"covariance\":[1", "\"covariance\":[-1"), HasSubstr("variance below 0"));
  EXPECT_THAT(refusal_of(text, "\"covariance\":[1,0.5", "\"covariance\":[1,50"), HasSubstr("covariance"));
}

}  // namespace
}  // namespace axiometry::formats
