// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/measured_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace axiometry::app {
namespace {

using testing::HasSubstr;

/// Tests in one file, all with the same equipment above the table.
std::string table(int equipment, int tests) {
  std::string text = "# machine.name: Mill\n# axis.name: X\n";
  for (int k = 0; k < equipment; ++k) text += "# equipment: a|b|c|1\n";
  text += "test,target_mm,direction,run,deviation_um\n";
  for (int test = 1; test <= tests; ++test)
    for (const char* direction : {"up", "down"})
      for (int target = 0; target < 3; ++target)
        for (int run = 1; run <= 2; ++run)
          text += fmt::format("t{},{},{},{},{}\n", test, target * 100, direction, run, 0.1 * run + target);
  return text;
}

TEST(MeasuredFile, RefusesEquipmentThatNoSetUpHasBeforeEveryTestHoldsIt) {
  EXPECT_TRUE(read_measured(table(100, 3), "run.csv"));
  const auto refused = read_measured(table(200, 2000), "run.csv");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(),
              HasSubstr("found 200 pieces of test equipment in one test, expected at most"));
}

TEST(MeasuredFile, KnowsWhatItsTestsTakeInMemoryAndNotOnlyTheFile) {
  const std::string bytes = table(100, 200);
  const auto read = read_measured(bytes, "run.csv");
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(read->tests.size(), 200u);
  EXPECT_GT(read->memory, 200 * 100 * sizeof(Equipment));
}

TEST(MeasuredFile, RefusesWhatIsTheSameForAllWhereItTakesTheMemory) {
  std::string bytes = table(0, 2000);
  std::string recording = "# uncertainty.drift_recording: 0";
  for (int k = 1; k < 20'000; ++k) recording += " 1";
  bytes.insert(0, recording + "\n");
  const auto refused = read_measured(bytes, "run.csv");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("more than 128 MiB of memory up to test"));
}

}  // namespace
}  // namespace axiometry::app
