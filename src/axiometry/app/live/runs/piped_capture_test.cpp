// SPDX-License-Identifier: Apache-2.0
// What comes through a pipe is nowhere else.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/recordings/raw_times.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/plan/plan_json.h"
#include "tests/support/simulated_recording.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using testing::HasSubstr;
using testing_support::short_plan;

/// What a shell does for `… | axiometry`, as long as it lives.
class PipedInput {
 public:
  explicit PipedInput(std::string bytes) : before_(::dup(STDIN_FILENO)) {
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    ::dup2(ends[0], STDIN_FILENO);
    ::close(ends[0]);
    writer_ = std::thread([to = ends[1], bytes = std::move(bytes)] {
      for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t put = ::write(to, rest.data(), std::min<std::size_t>(rest.size(), 4096));
        if (put <= 0) break;
        rest.remove_prefix(static_cast<std::size_t>(put));
      }
      ::close(to);
    });
  }
  ~PipedInput() {
    for (char rest[4096]; ::read(STDIN_FILENO, rest, sizeof rest) > 0;) continue;  // nobody writes into a broken pipe
    writer_.join();
    ::dup2(before_, STDIN_FILENO);
    ::close(before_);
  }
  PipedInput(const PipedInput&) = delete;
  PipedInput& operator=(const PipedInput&) = delete;

 private:
  int before_;
  std::thread writer_;
};

class PipedCaptureTest : public testing::Test {
 protected:
  Result<CaptureOutcome> capture(const std::string& from, const std::string& raw) const {
    CaptureOptions options;
    options.plan = plan_;
    options.recording.skip_damaged = true;
    return run_capture({.from = from, .raw = raw, .resume = {}, .out = folder_.file("x.json")}, options, {});
  }

  testing_support::TemporaryFolder folder_;
  const std::string plan_ = folder_.written("plan.json", formats::write_plan(short_plan(2)));
  const std::string raw_ = folder_.file("x.json.raw");
};

TEST_F(PipedCaptureTest, EveryByteIsKeptAndGivesTheSameReadingsAgain) {
  std::string bytes = testing_support::recording("good", 3, 2);
  bytes.insert(bytes.find('\n', bytes.size() / 2) + 1, "?\n");  // damaged lines are kept too
  Result<CaptureOutcome> live = fail("not yet");
  {
    const PipedInput pipe(bytes);
    EXPECT_TRUE(standard_input_is_a_stream());
    live = capture("-", raw_);
  }
  ASSERT_TRUE(live) << live.error().to_string();
  EXPECT_EQ(live->result.readings.size(), 12u);
  const std::string kept = folder_.content("x.json.raw");
  EXPECT_TRUE(bytes.starts_with(kept));  // up to the last reading of the plan
  EXPECT_GT(kept.size(), bytes.size() / 2);
  EXPECT_TRUE(has_times(raw_));
  EXPECT_THAT(folder_.content("x.json"), HasSubstr("\"sha256\": \"" + sha256(kept) + "\""));
  const auto again = capture(raw_, "");
  ASSERT_TRUE(again) << again.error().to_string();
  ASSERT_EQ(again->result.readings.size(), 12u);
  for (std::size_t k = 0; k < 12; ++k)
    EXPECT_EQ(again->result.readings[k].deviation, live->result.readings[k].deviation);
}

TEST_F(PipedCaptureTest, WhatIsThereIsNeverOverwritten) {
  folder_.written("x.json.raw", "measured before\n");
  const PipedInput pipe(testing_support::recording("good", 3, 2));
  const auto refused = capture("-", raw_);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("raw data are never overwritten"));
  EXPECT_EQ(folder_.content("x.json.raw"), "measured before\n");
}

TEST_F(PipedCaptureTest, APipeThatBringsNothingLeavesNoFile) {
  const PipedInput pipe("");
  EXPECT_FALSE(capture("-", raw_));
  EXPECT_FALSE(std::filesystem::exists(raw_));
}

TEST_F(PipedCaptureTest, AFileThatIsRedirectedIsThereAlready) {
  const std::string name = folder_.written("run.csv", "0,0\n");
  const int before = ::dup(STDIN_FILENO), file = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  ::dup2(file, STDIN_FILENO);
  EXPECT_FALSE(standard_input_is_a_stream());
  ::dup2(before, STDIN_FILENO);
  for (const int descriptor : {before, file}) ::close(descriptor);
}

}  // namespace
}  // namespace axiometry::app
