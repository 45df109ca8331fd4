// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/stamp_judge.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/recording_feed.h"

namespace axiometry::formats {
namespace {

/// The stamps that were settled.
std::string settled(StampJudge& judge, std::initializer_list<double> stamps) {
  std::string text;
  std::size_t number = 0;
  const auto add = [&](std::span<const StampedLine> lines) {
    for (const StampedLine& line : lines) text += fmt::format("{}{:g}", text.empty() ? "" : " ", line.stamp);
  };
  for (const double stamp : stamps) add(judge.push({stamp, 0.0, 10.0 * static_cast<double>(number), ++number, stamp}));
  add(judge.flush());
  return text;
}

TEST(StampJudge, RejectsTheOneThatIsWrong) {
  for (const double wrong : {97.0, 0.5, -4.0, 2.0}) {
    StampJudge judge(StampJudge::Kind::times);
    EXPECT_EQ(settled(judge, {1, 2, 3, wrong, 5, 6, 7}), "1 2 3 5 6 7") << wrong;
    EXPECT_EQ(judge.rejected(), 1u);
  }
  for (const double wrong : {3.5, 4.0, 4.999}) {  // in order, and so not to be seen
    StampJudge judge(StampJudge::Kind::times);
    settled(judge, {1, 2, 3, wrong, 5, 6, 7});
    EXPECT_EQ(judge.rejected(), 0u);
    EXPECT_TRUE(judge.remarks().empty());
  }
  StampJudge first(StampJudge::Kind::times);
  EXPECT_EQ(settled(first, {97, 2, 3, 4}), "2 3 4");
  StampJudge two(StampJudge::Kind::times);
  EXPECT_EQ(settled(two, {1, 2, 0, 0.5, 3, 4, 99, 5, 6}), "1 2 3 4 5 6");
  EXPECT_EQ(two.remarks().front(), "left out 3 lines whose time is out of order, the first is line 3");
}

TEST(StampJudge, TakesAClockThatWasSetAfterFiveLines) {
  StampJudge back(StampJudge::Kind::times);
  EXPECT_EQ(settled(back, {101, 102, 1, 2, 3, 4}), "101 102");  // four might still be wrong
  EXPECT_EQ(back.rejected(), 4u);
  StampJudge set(StampJudge::Kind::times);
  EXPECT_EQ(settled(set, {101, 102, 1, 2, 3, 4, 5, 6}), "101 102 112 113 114 115 116 117");  // 10 s passed
  EXPECT_EQ(set.rejected(), 0u);
  EXPECT_EQ(set.remarks().front(), "the clock of the samples was set back 1 time, first in line 3; it was taken on");
  StampJudge ahead(StampJudge::Kind::times);
  EXPECT_EQ(settled(ahead, {1, 2, 1001, 1002, 1003}), "1 2 1001 1002 1003");
  EXPECT_TRUE(ahead.remarks().empty());  // 10 s passed
  StampJudge leap(StampJudge::Kind::times);
  EXPECT_EQ(settled(leap, {1, 2, 3602, 3603, 3604}), "1 2 3602 3603 3604");
  EXPECT_EQ(leap.remarks().front(),
            "the clock of the samples was set ahead 1 time, first in line 3; it was taken as a gap");
  StampJudge counter(StampJudge::Kind::counts);
  EXPECT_EQ(settled(counter, {101, 102, 1, 2, 3, 4, 5}), "101 102 103 104 105 106 107");
}

TEST(StampJudge, NeverSettlesOutOfOrderWhateverCame) {
  unsigned state = 1;
  for (int round = 0; round < 300; ++round) {
    StampJudge judge(round % 2 == 0 ? StampJudge::Kind::times : StampJudge::Kind::counts);
    double last = -1e300;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 200; ++k) {
      state = state * 1664525u + 1013904223u;
      const double stamp = (state >> 24) % 4 == 0 ? static_cast<double>(state >> 16) : static_cast<double>(k);
      for (const StampedLine& line : judge.push({stamp, 0.0, 0.0, k + 1, stamp})) {
        EXPECT_GE(line.stamp, last);
        last = line.stamp;
        ++count;
      }
    }
    count += judge.flush().size();
    EXPECT_EQ(count + judge.rejected(), 200u);
  }
}

TEST(RecordingsWithWrongStamps, LoseOneLineForEach) {
  RecordingOptions options;
  options.skip_damaged = true;
  const auto read = [&](std::string_view id, std::string_view bytes) {
    const bool counts = id == "umd";
    options.units_per_count = counts ? std::optional(1.0) : std::nullopt;
    options.rate_hz = counts ? std::optional(1.0) : std::nullopt;
    EXPECT_TRUE(testing_support::same_however_cut(id, bytes, options));
    const auto samples = testing_support::read_samples(id, bytes, options);
    std::string text = samples.refusal;
    for (const Sample& s : samples.samples) text += fmt::format("{:g}:{:g} ", s.time_s, s.position);
    return fmt::format("{}lost {}", text, samples.lost);
  };
  EXPECT_EQ(read("time-position", "7.9,1\n7.95,2\n97.96,3\n7.97,4\n7.98,5\n"), "7.9:1 7.95:2 7.97:4 7.98:5 lost 1");
  EXPECT_EQ(read("umd", "0 0 1 0 0 7 0 0\n0 0 2 0 0 8 0 0\n0 0 3 0 0 99 0 0\n0 0 4 0 0 10 0 0\n0 0 5 0 0 11 0 0\n"),
            "0:1 1:2 3:4 4:5 lost 1");  // once, although the count misses it too
  EXPECT_EQ(read("umd",
                 "0 0 1 0 0 7 0 0\n0 0 2 0 0 8 0 0\n0 0 3 0 0 1 0 0\n0 0 4 0 0 2 0 0\n0 0 5 0 0 3 0 0\n"
                 "0 0 6 0 0 4 0 0\n0 0 7 0 0 5 0 0\n"),
            "0:1 1:2 2:3 3:4 4:5 5:6 6:7 lost 0");
  EXPECT_EQ(read("camonitor-stream",
                 "A 2026-11-21 12:00:01 1\nA 2026-11-21 12:00:02 2\nA 2026-12-21 12:00:03 3\n"
                 "A 2026-11-21 12:00:04 4\nA 2026-11-21 12:00:05 5\n"),
            "0:1 1:2 3:4 4:5 lost 1");
}

}  // namespace
}  // namespace axiometry::formats
