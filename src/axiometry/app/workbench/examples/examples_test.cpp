// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/examples/examples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <thread>

#include "axiometry/app/workbench/examples/example_table2.h"
#include "tests/support/archive.h"

namespace axiometry::app {
namespace {

TEST(Examples, HoldTable2AsTheRepositoryDoes) {
  EXPECT_EQ(example_table2, testing_support::example_file(AXIOMETRY_SOURCE_DIR, "iso230-2-table2.json"));
}

TEST(Examples, FillAnEmptyArchiveAndNoOther) {
  testing_support::Archive archive;
  Workbench workbench(archive.store());
  const auto added = add_examples(workbench);
  ASSERT_TRUE(added) << added.error().to_string();
  EXPECT_EQ(*added, 14u);
  EXPECT_EQ(archive.store().counts()->tests, 14);
  EXPECT_EQ(archive.store().counts()->machines, 4) << "each test found its machine";
  EXPECT_EQ(archive.store().counts()->instruments, 3);
  EXPECT_EQ(*add_examples(workbench), 0u);
  EXPECT_EQ(archive.store().counts()->tests, 14);
}

TEST(Examples, TellAStoryOfGrowingPlay) {
  testing_support::Archive archive;
  Workbench workbench(archive.store());
  ASSERT_TRUE(add_examples(workbench));
  store::TestFilter filter;
  filter.text = "MC7-X-2024-4";
  const auto first = archive.store().tests(filter);
  ASSERT_EQ(first->total, 1);
  const auto trend = archive.store().trend(*first->rows.front().axis, std::vector<std::string>{"B"}, 100);
  ASSERT_TRUE(trend);
  ASSERT_EQ(trend->size(), 8u);
  std::vector<double> play;
  std::vector<std::string> verdicts;
  auto points = *trend;
  std::ranges::sort(points, {}, &store::TrendPoint::measured_on);
  for (const store::TrendPoint& point : points) {
    play.push_back(point.figures.front().value);
    verdicts.push_back(point.figures.front().verdict);
  }
  EXPECT_TRUE(std::is_sorted(play.begin(), play.end() - 1));
  EXPECT_LT(play.back(), 0.5 * play[6]);
  EXPECT_EQ(verdicts.front(), "conforms");
  EXPECT_EQ(verdicts[6], "does not conform");
  EXPECT_EQ(verdicts.back(), "conforms");
}

TEST(Examples, AreTheSameEveryTime) {
  testing_support::Archive one, other;
  for (auto* archive : {&one, &other}) {
    Workbench workbench(archive->store());
    ASSERT_TRUE(add_examples(workbench));
  }
  for (store::Id id = 1; id <= 14; ++id) EXPECT_EQ(one.store().test(id)->sha256, other.store().test(id)->sha256);
}

TEST(Examples, AreLoadedOnceWhenTwoProgramsAsk) {
  for (int round = 0; round < 3; ++round) {
    testing_support::Archive archive;
    std::barrier together(2);
    std::atomic<std::size_t> added = 0;
    const auto load = [&] {
      const auto store = store::Store::open(archive.folder() + "/archive.db");
      ASSERT_TRUE(store) << store.error().to_string();
      Workbench workbench(**store);
      together.arrive_and_wait();
      const auto count = add_examples(workbench);
      ASSERT_TRUE(count) << count.error().to_string();
      added += *count;
    };
    std::thread other(load);
    load();
    other.join();
    EXPECT_EQ(added, 14u);
    EXPECT_EQ(archive.store().counts()->tests, 14);
    EXPECT_EQ(archive.store().counts()->machines, 4);
  }
}

}  // namespace
}  // namespace axiometry::app
