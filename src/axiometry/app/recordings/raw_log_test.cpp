// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/raw_log.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <limits>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/source.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

class RawLogTest : public testing::Test {
 protected:
  /// "[100]abc [200|]de": arrivals and bytes, a bar where a connection begins, ? where the arrival is not known.
  std::string played() {
    std::string text;
    const auto done = play(raw_, [&](const RawPiece& piece) -> Result<void> {
      text += (text.empty() ? "[" : " [") + (piece.arrival ? std::to_string(*piece.arrival) : "?") +
              (piece.begins_connection ? "|]" : "]") + std::string(piece.bytes);
      return {};
    });
    remarks_.clear();
    if (done)
      for (const std::string& remark : *done) remarks_ += (remarks_.empty() ? "" : "; ") + remark;
    return done ? text : done.error().message;
  }

  std::string bytes_of(const std::string& name) const { return *Source::open(name)->read_all(1 << 20); }
  std::string times() const { return bytes_of(times_name(raw_)); }
  void set_times(const std::string& bytes) { ASSERT_TRUE(write_file(times_name(raw_), bytes)); }

  void write_three() {
    auto log = RawLog::create(raw_);
    ASSERT_TRUE(log);
    ASSERT_TRUE(log->append("abc", 100));
    ASSERT_TRUE(log->append("de", 200));
    ASSERT_TRUE(log->begin_connection());
    ASSERT_TRUE(log->append("f", 300));
  }

  testing_support::TemporaryFolder folder_;
  const std::string raw_ = folder_.file("run.raw");
  std::string remarks_;
};

TEST_F(RawLogTest, PlaysThePiecesAsTheyCame) {
  write_three();
  EXPECT_EQ(bytes_of(raw_), "abcdef");
  EXPECT_EQ(played(), "[100]abc [200]de [300|]f");
  EXPECT_EQ(remarks_, "");
}

TEST_F(RawLogTest, NeverOverwritesAndGoesOnWhenAsked) {
  { ASSERT_TRUE(RawLog::create(raw_)->append("abc", 100)); }
  EXPECT_FALSE(RawLog::create(raw_));
  {
    auto log = RawLog::resume(raw_);
    ASSERT_TRUE(log);
    ASSERT_TRUE(log->begin_connection());
    ASSERT_TRUE(log->append("de", 200));
  }
  EXPECT_EQ(played(), "[100]abc [200|]de");
  EXPECT_EQ(remarks_, "");
  EXPECT_FALSE(std::filesystem::exists(times_name(raw_) + ".old"));
  EXPECT_FALSE(RawLog::resume(folder_.file("none")));
}

/// No file may have a byte while it lives: as on a disk without room, where names can still be given.
class NoRoom {
 public:
  NoRoom() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit none{0, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &none);
  }
  ~NoRoom() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  NoRoom(const NoRoom&) = delete;
  NoRoom& operator=(const NoRoom&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST_F(RawLogTest, LeavesNothingWhereItCannotBeBegun) {
  const auto begun = [&] {
    const NoRoom none;
    return RawLog::create(raw_);
  }();
  ASSERT_FALSE(begun);
  EXPECT_NE(begun.error().message.find("cannot write"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(std::filesystem::path(raw_).parent_path()));
  EXPECT_TRUE(RawLog::create(raw_));
}

TEST_F(RawLogTest, OutlastsAnEndBetweenBytesAndTime) {
  write_three();
  ASSERT_TRUE(write_file(raw_, "abcdefgh"));  // bytes whose time never came, and the half of a time
  set_times(times() + "1234567");
  EXPECT_EQ(played(), "[100]abc [200]de [300|]f [?]gh");
  EXPECT_EQ(remarks_,
            "found 7 bytes of an unfinished time at the end of run.raw.times, left them out; when 2 of the 8 bytes of "
            "the recording arrived is not known");
  { ASSERT_TRUE(RawLog::resume(raw_)->append("i", 400)); }
  EXPECT_EQ(played(), "[100]abc [200]de [300|]f [?]gh [400]i");
}

TEST_F(RawLogTest, LeavesOutTimesBeyondTheBytesAndGoesOnBehindThem) {
  write_three();
  ASSERT_TRUE(write_file(raw_, "abcd"));
  EXPECT_EQ(played(), "[100]abc [?]d");
  EXPECT_EQ(remarks_,
            "found 3 of 4 times in run.raw.times beyond the 4 bytes of the recording, left them out; when 1 of the 4 "
            "bytes of the recording arrived is not known");
  { ASSERT_TRUE(RawLog::resume(raw_)->append("XYZ", 400)); }
  EXPECT_EQ(played(), "[100]abc [?]d [400]XYZ");
  ASSERT_TRUE(write_file(raw_, ""));
  EXPECT_EQ(played(), "");
}

TEST_F(RawLogTest, PlaysTheBytesWithoutTheirTimes) {
  write_three();
  const std::string sound = times();
  set_times("");
  EXPECT_EQ(played(), "[?]abcdef");
  EXPECT_NE(remarks_, "");
  set_times("something else entirely, and quite long at that");
  EXPECT_EQ(played(), "[?]abcdef");
  EXPECT_NE(remarks_, "");
  set_times(sound.substr(16));  // its beginning is gone
  EXPECT_EQ(played(), "[100]abc [200]de [300|]f");
  EXPECT_EQ(remarks_, "found run.raw.times without its beginning AXIOMETRYTIMES2, read 4 records of it that are sound");
  std::filesystem::remove(times_name(raw_));
  EXPECT_EQ(played(), "[?]abcdef");
  EXPECT_EQ(remarks_, "found no run.raw.times beside the recording: when its 6 bytes arrived is not known");
  { ASSERT_TRUE(RawLog::resume(raw_)->append("g", 400)); }
  EXPECT_EQ(played(), "[?]abcdef [400]g");
}

TEST_F(RawLogTest, EachFlippedByteCostsOneTimeAtMostAndIsTold) {
  write_three();
  const std::string sound = times();
  for (std::size_t at = 0; at < sound.size(); ++at)
    for (const char flip : {'\x01', '\x80', '\xff'}) {
      std::string harmed = sound;
      harmed[at] = static_cast<char>(harmed[at] ^ flip);
      set_times(harmed);
      const std::string text = played();
      EXPECT_NE(remarks_, "") << at;
      const std::string expected = at < 16   ? "[?]abc [200]de [300|]f"
                                   : at < 32 ? "[?]abcde [300|]f"
                                   : at < 48 ? "[100]abc [?]de [300|]f"
                                             : "[100]abc [200]de [?|]f";  // the connection is told twice
      EXPECT_EQ(text, expected) << at;
    }
}

TEST_F(RawLogTest, KeepsHarmedTimesBesideThoseWrittenAnew) {
  write_three();
  std::string harmed = times();
  harmed[20] = 'x';
  set_times(harmed);
  { ASSERT_TRUE(RawLog::resume(raw_)->append("g", 400)); }
  EXPECT_EQ(bytes_of(times_name(raw_) + ".old"), harmed);
  EXPECT_EQ(played(), "[?]abcde [300|]f [400]g");
  std::string again = times();
  again[20] = static_cast<char>(again[20] ^ 1);
  set_times(again);
  { ASSERT_TRUE(RawLog::resume(raw_)->append("h", 500)); }
  EXPECT_EQ(bytes_of(times_name(raw_) + ".old"), harmed);
  EXPECT_EQ(bytes_of(times_name(raw_) + ".old2"), again);
}

TEST_F(RawLogTest, KeepsADamagedEndToo) {
  write_three();
  std::string harmed = times();
  harmed[76] = static_cast<char>(harmed[76] ^ 1);
  set_times(harmed);
  { ASSERT_TRUE(RawLog::resume(raw_)->append("g", 400)); }
  EXPECT_EQ(bytes_of(times_name(raw_) + ".old"), harmed);
  EXPECT_EQ(played(), "[100]abc [200]de [?|]f [400]g");
  EXPECT_EQ(remarks_, "when 1 of the 7 bytes of the recording arrived is not known");
}

TEST_F(RawLogTest, IsRemovedWithAllThatLiesBesideIt) {
  write_three();
  for (int turn = 0; turn < 3; ++turn) {
    std::string harmed = times();
    harmed[60] = static_cast<char>(harmed[60] ^ 1);
    set_times(harmed);
    ASSERT_TRUE(RawLog::resume(raw_));
  }
  ASSERT_TRUE(std::filesystem::exists(times_name(raw_) + ".old3"));
  std::filesystem::remove(times_name(raw_) + ".old2");
  ASSERT_TRUE(write_file(times_name(raw_) + ".new", "what a crash has left"));
  remove_raw(raw_);
  const std::filesystem::path folder = std::filesystem::path(raw_).parent_path();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

/// A record of the first version: where the piece begins.
std::string old_record(std::uint64_t begin, std::int64_t arrival) {
  std::string record(16, '\0');
  std::memcpy(record.data(), &begin, 8);
  std::memcpy(record.data() + 8, &arrival, 8);
  return record;
}

TEST_F(RawLogTest, ReadsTimesOfTheFirstVersion) {
  ASSERT_TRUE(write_file(raw_, "abcdef"));
  const std::string head = "AXIOMETRYTIMES1\n";
  const std::string sound =
      old_record(0, 100) + old_record(3, 200) + old_record(std::uint64_t{5} | std::uint64_t{1} << 63, 300);
  set_times(head + sound);
  EXPECT_EQ(played(), "[100]abc [200]de [300|]f");
  EXPECT_EQ(remarks_, "");
  set_times(head + old_record(0, 100) + old_record(9, 200) + old_record(5, 300));
  EXPECT_EQ(played(), "[?]abcde [300]f");
  set_times(head + old_record(0, 100) + old_record(3, 20) + old_record(5, 300));
  EXPECT_EQ(played(), "[?]abc [20]de [300]f");  // of two that contradict each other the later one
  const std::int64_t last = std::numeric_limits<std::int64_t>::max();  // 2262; times of before 1970 are none
  set_times(head + old_record(0, std::numeric_limits<std::int64_t>::min()) + old_record(3, 200) + old_record(5, last));
  EXPECT_EQ(played(), fmt::format("[?]abc [200]de [{}]f", last));
  set_times(head + sound);
  { ASSERT_TRUE(RawLog::resume(raw_)->append("g", 400)); }
  EXPECT_EQ(played(), "[100]abc [200]de [300|]f [400]g");
  EXPECT_EQ(remarks_, "");
}

}  // namespace
}  // namespace axiometry::app
