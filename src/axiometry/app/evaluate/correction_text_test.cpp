// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/correction_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

using testing::HasSubstr;

std::string refusal_of(std::string_view list, CorrectionRequest request = {}) {
  const auto result = choose_corrections(list, request);
  return result ? "nothing" : result.error().message;
}

TEST(CorrectionText, AddsWhatIsNamed) {
  CorrectionRequest request;
  ASSERT_TRUE(choose_corrections("sign, gain", request));
  ASSERT_TRUE(choose_corrections("air=edlen,dead-path", request));
  EXPECT_TRUE(request.sign && request.gain && request.dead_path);
  EXPECT_EQ(request.air, AirEquation::edlen);
  EXPECT_FALSE(request.expansion || request.drift);
  ASSERT_TRUE(choose_corrections("nde,drift", request));
  EXPECT_TRUE(request.expansion && request.drift);
}

TEST(CorrectionText, TakesCiddorWhereNoEquationIsNamed) {
  CorrectionRequest request;
  ASSERT_TRUE(choose_corrections("air", request));
  EXPECT_EQ(request.air, AirEquation::ciddor);
}

TEST(CorrectionText, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(refusal_of("dead_path"), "found the correction \"dead_path\", expected perhaps dead-path");
  EXPECT_EQ(refusal_of("everything"),
            "found the correction \"everything\", expected some of sign,gain,air=ciddor,air=edlen,dead-path,nde,drift");
  EXPECT_THAT(refusal_of(""), HasSubstr("found the correction \"\""));
  EXPECT_THAT(refusal_of("sign,"), HasSubstr("found the correction \"\""));
  EXPECT_EQ(refusal_of("air=owens"), "found the equation \"owens\" of air, expected ciddor or edlen");
}

TEST(CorrectionText, RefusesTwoEquationsOfAir) {
  EXPECT_THAT(refusal_of("air=ciddor,air=edlen"), HasSubstr("two equations"));
  EXPECT_EQ(refusal_of("air=ciddor,air"), "nothing");
}

}  // namespace
}  // namespace axiometry::app
