// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

/// At 100 mm/s, by a clock whose step is `step_s` of the number of a sample.
Result<DynamicMotion> measured(std::size_t samples, const auto& step_s) {
  std::string text = "time [s],position [mm]\n";
  double t = 0.0;
  for (std::size_t k = 0; k < samples; ++k) {
    text += fmt::format("{:.7f},{:.6f}\n", t, 100.0 * t);
    t += step_s(k);
  }
  const testing_support::TemporaryFolder folder;
  return measure_dynamic(folder.written("run.csv", text), {});
}

TEST(DynamicReading, TakesAnEvenClockWhoseTimesAreRounded) {
  const auto motion = measured(20'000, [](std::size_t) { return 1.0 / 3000.0; });
  ASSERT_TRUE(motion) << motion.error().message;
  ASSERT_EQ(motion->stretches.size(), 1u);
  EXPECT_NEAR(motion->stretches[0].velocity, 100.0, 1e-4);
}

TEST(DynamicReading, RefusesAClockThatRunsSlowlyAndThenFast) {
  const auto motion = measured(20'000, [](std::size_t k) { return k < 10'000 ? 0.991e-3 : 1.009e-3; });
  ASSERT_FALSE(motion);
  EXPECT_NE(motion.error().message.find("the clock of the recording is not even"), std::string::npos)
      << motion.error().message;
}

TEST(DynamicReading, RefusesAMissingSampleHoweverFastTheyCome) {
  for (const double step_s : {1e-3, 2e-6, 1e-6, 5e-7}) {
    const auto motion = measured(2000, [&](std::size_t k) { return k == 1000 ? 2.0 * step_s : step_s; });
    ASSERT_FALSE(motion) << step_s;
    EXPECT_NE(motion.error().message.find("samples are missing"), std::string::npos) << motion.error().message;
  }
}

TEST(DynamicReading, TakesTheColumnThatIsStated) {
  std::string text = "time [s],x [mm],y [mm]\n";
  for (int k = 0; k < 2000; ++k) text += fmt::format("{:.3f},{:.3f},{:.3f}\n", 1e-3 * k, 0.1 * k, 0.05 * k);
  const testing_support::TemporaryFolder folder;
  const std::string file = folder.written("run.csv", text);
  const auto unknown = measure_dynamic(file, {});
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message.find("expected the number of the one with the position"), std::string::npos)
      << unknown.error().message;
  DynamicOptions options;
  for (const auto& [axis, velocity] : {std::pair(std::size_t{0}, 100.0), std::pair(std::size_t{1}, 50.0)}) {
    options.stream_axis = axis;
    const auto motion = measure_dynamic(file, options);
    ASSERT_TRUE(motion) << motion.error().message;
    ASSERT_EQ(motion->stretches.size(), 1u);
    EXPECT_NEAR(motion->stretches[0].velocity, velocity, 1e-4);
  }
}

/// Each millisecond by 0.1 mm, but for some lines.
std::string with_lines(const auto& line_of, int count = 2000) {
  std::string text = "time [s],position [mm]\n";
  for (int k = 0; k < count; ++k) text += line_of(k, fmt::format("{:.3f},{:.3f}\n", 1e-3 * k, 0.1 * k));
  return text;
}

TEST(DynamicReading, SkipsWhatIsDamagedWhereNoSampleIsMissingInThePart) {
  const testing_support::TemporaryFolder folder;
  const auto harmed = [](int k, const std::string& line) { return k == 300 || k == 1900 ? "0.3\x01,#\n" : line; };
  const std::string file = folder.written("run.csv", with_lines(harmed));
  DynamicOptions options{.from_s = 0.5, .to_s = 1.5};
  EXPECT_FALSE(measure_dynamic(file, options));
  options.skip_damaged = true;
  const auto motion = measure_dynamic(file, options);
  ASSERT_TRUE(motion) << motion.error().message;
  EXPECT_EQ(motion->record.positions.size(), 1001u);
  EXPECT_NE(std::ranges::find(motion->remarks,
                              "the recording shows 2 lost or damaged samples, none of which is missing "
                              "in the part that is looked at"),
            motion->remarks.end());
  options.to_s = std::nullopt;
  const auto gap = measure_dynamic(file, options);
  ASSERT_FALSE(gap);
  EXPECT_NE(gap.error().message.find("samples are missing"), std::string::npos) << gap.error().message;
}

TEST(DynamicReading, TakesNoEvenGapsForARate) {
  const testing_support::TemporaryFolder folder;
  const auto every_second = [](int k, const std::string& line) { return k % 2 == 0 ? line : "?,?\n"; };
  const auto motion = measure_dynamic(folder.written("run.csv", with_lines(every_second)), {.skip_damaged = true});
  ASSERT_FALSE(motion);
  EXPECT_NE(motion.error().message.find("lost samples in the recording"), std::string::npos) << motion.error().message;
}

}  // namespace
}  // namespace axiometry::app
