// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/raw_log.h"

#include <gtest/gtest.h>

#include "axiometry/app/output.h"
#include "axiometry/app/source.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

class RawLogTest : public testing::Test {
 protected:
  /// "[100]abc [200|]de": arrivals and bytes, a bar where a connection begins.
  std::string played() const {
    std::string text;
    const auto done = play(raw_, [&](const RawPiece& piece) -> Result<void> {
      text += (text.empty() ? "[" : " [") + std::to_string(piece.arrival) + (piece.begins_connection ? "|]" : "]") +
              std::string(piece.bytes);
      return {};
    });
    return done ? text : done.error().message;
  }

  std::string bytes_of(const std::string& name) const { return *Source::open(name)->read_all(1 << 20); }

  testing_support::TemporaryFolder folder_;
  const std::string raw_ = folder_.file("run.raw");
};

TEST_F(RawLogTest, PlaysThePiecesAsTheyCame) {
  {
    auto log = RawLog::create(raw_);
    ASSERT_TRUE(log);
    ASSERT_TRUE(log->append("abc", 100));
    ASSERT_TRUE(log->append("de", 200));
    log->begin_connection();
    ASSERT_TRUE(log->append("f", 300));
  }
  EXPECT_EQ(bytes_of(raw_), "abcdef");
  EXPECT_EQ(played(), "[100]abc [200]de [300|]f");
}

TEST_F(RawLogTest, NeverOverwritesAndGoesOnWhenAsked) {
  { ASSERT_TRUE(RawLog::create(raw_)->append("abc", 100)); }
  EXPECT_FALSE(RawLog::create(raw_));
  {
    auto log = RawLog::resume(raw_);
    ASSERT_TRUE(log);
    log->begin_connection();
    ASSERT_TRUE(log->append("de", 200));
  }
  EXPECT_EQ(played(), "[100]abc [200|]de");
  EXPECT_FALSE(RawLog::resume(folder_.file("none")));
}

TEST_F(RawLogTest, OutlastsAnEndBetweenTimeAndBytes) {
  {
    auto log = RawLog::create(raw_);
    ASSERT_TRUE(log->append("abc", 100));
    ASSERT_TRUE(log->append("", 200));  // a time whose bytes never came
  }
  // and the half of another one
  ASSERT_TRUE(write_file(times_name(raw_), bytes_of(times_name(raw_)) + "1234567"));
  EXPECT_EQ(played(), "[100]abc");
  { ASSERT_TRUE(RawLog::resume(raw_)->append("de", 300)); }
  EXPECT_EQ(played(), "[100]abc [300]de");
}

TEST_F(RawLogTest, RefusesTimesThatDoNotBelongToTheBytes) {
  {
    auto log = RawLog::create(raw_);
    ASSERT_TRUE(log->append("abc", 100));
    ASSERT_TRUE(log->append("de", 200));
  }
  const std::string times = bytes_of(times_name(raw_));
  ASSERT_TRUE(write_file(raw_, "a"));
  EXPECT_TRUE(played().starts_with("found times from byte 3 on, expected them from byte 1"));
  ASSERT_TRUE(write_file(times_name(raw_), "something else"));
  EXPECT_TRUE(played().starts_with("found no times of a raw recording"));
  EXPECT_TRUE(has_times(raw_));
}

}  // namespace
}  // namespace axiometry::app
