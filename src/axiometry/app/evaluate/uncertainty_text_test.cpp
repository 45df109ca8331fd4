// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/uncertainty_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

using testing::HasSubstr;

TEST(UncertaintyText, TurnsTheNamedMethodsOn) {
  UncertaintyOptions options;
  ASSERT_TRUE(choose_methods("annex-a, gum", options));
  EXPECT_TRUE(options.gum);
  EXPECT_FALSE(options.monte_carlo);
  ASSERT_TRUE(choose_methods("monte-carlo", options));
  EXPECT_TRUE(options.monte_carlo);
}

TEST(UncertaintyText, NamesTheMethodThatWasPerhapsMeant) {
  UncertaintyOptions options;
  EXPECT_THAT(choose_methods("gum,montecarlo", options).error().message, HasSubstr("perhaps monte-carlo"));
  EXPECT_FALSE(choose_methods("", options));
}

TEST(UncertaintyText, ReadsTrialsAsANumberOrAuto) {
  UncertaintyOptions options;
  ASSERT_TRUE(choose_trials("1e6", options));
  EXPECT_EQ(options.trials.propagation.trials, 1'000'000u);
  ASSERT_TRUE(choose_trials("auto", options));
  EXPECT_FALSE(options.trials.propagation.trials.has_value());
  for (const char* bad : {"99", "1.5e2.5", "1000.5", "2e9", "-1000", "many", ""})
    EXPECT_FALSE(choose_trials(bad, options)) << bad;
}

}  // namespace
}  // namespace axiometry::app
