// SPDX-License-Identifier: Apache-2.0
// What a verification says of a log beside the file that is not as it was written.
#include <gmock/gmock.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/store/database/sqlite_log.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr std::size_t head_of_log = 32, page_of_log = 24 + 4096;

class StoreLogTest : public BothStores {
 protected:
  /// An archive as a program leaves it that is killed: three changes stand in the log alone, each in one page or more.
  std::string with_log() {
    const std::string address = filled(), copy = new_address();
    const auto reader = raw(address);  // for whom the log stays
    must(reader->begin_read());
    must(reader->query("SELECT count(*) FROM audit"));
    const auto store = must(Store::open(address));
    for (const char* title : {"one", "two", "three"}) must(store->add(PlanRecord{title, 1, sha256("abc")}, by_anna));
    for (const char* end : {"", "-wal"}) std::filesystem::copy_file(address + end, copy + end);
    return copy;
  }

  static void flip(const std::string& file, std::size_t at) {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekg(static_cast<std::streamoff>(at));
    const char changed = static_cast<char>(bytes.get() ^ 1);
    bytes.seekp(static_cast<std::streamoff>(at));
    bytes.put(changed);
  }

  static void zero(const std::string& file, std::size_t from, std::size_t size) {
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(static_cast<std::streamoff>(from));
    bytes << std::string(size, '\0');
  }

  static LogState state(const std::string& file) {
    std::ifstream log(file, std::ios::binary);
    return log_state(log);
  }
};
AXIOMETRY_ON_BOTH_STORES(StoreLogTest);

/// Bytes of a page of the log, counted from 0.
constexpr std::size_t at_page(std::int64_t page, std::size_t byte) {
  return head_of_log + static_cast<std::size_t>(page) * page_of_log + byte;
}

TEST_P(StoreLogTest, FindsABitOfAPageOrItsHeadThatSqlitePassesOver) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such log";
  EXPECT_THAT(verified(with_log()).problems, IsEmpty());
  EXPECT_THAT(verified(with_log()).notes, IsEmpty());
  constexpr std::pair<std::size_t, const char*> places[] = {
      {24 + 100, "a page"}, {2, "its number"}, {9, "its salt"}, {17, "its sum"}};
  for (const auto& [byte, what] : places) {
    const std::string address = with_log();
    flip(address + "-wal", at_page(0, byte));
    EXPECT_THAT(verified(address).problems,
                Contains(AllOf(HasSubstr("found page 1 of the log"),
                               HasSubstr("the change that begins with page 1 is passed over, and 2 finished changes "
                                         "behind it"))))
        << what;
  }
  for (const std::size_t at : {std::size_t{3}, std::size_t{14}, std::size_t{18}, std::size_t{25}}) {
    const std::string address = with_log();
    flip(address + "-wal", at);
    EXPECT_THAT(verified(address).problems, Contains(HasSubstr("found the head of the log"))) << at;
  }
}

/// The change of which the altered page is the last counts among none behind it; where it begins is said.
TEST_P(StoreLogTest, CountsTheChangesBehindTheAlteredOne) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such log";
  const std::string address = with_log();
  std::vector<std::int64_t> ends;  // numbers of pages that end a change, from 1
  {
    std::ifstream log(address + "-wal", std::ios::binary);
    std::array<char, page_of_log> page{};
    log.seekg(head_of_log);
    for (std::int64_t number = 1; log.read(page.data(), page.size()); ++number)
      if (page[4] != 0 || page[5] != 0 || page[6] != 0 || page[7] != 0) ends.push_back(number);
  }
  ASSERT_EQ(ends.size(), 3u);
  const auto said = [&](std::int64_t page, std::size_t byte) {
    const std::string copy = new_address();
    for (const char* end : {"", "-wal"}) std::filesystem::copy_file(address + end, copy + end);
    flip(copy + "-wal", at_page(page - 1, byte));
    return verified(copy).problems;
  };
  const std::string begins = fmt::format("the change that begins with page {} is passed over", ends[0] + 1);
  EXPECT_THAT(said(ends[1], 24), Contains(HasSubstr(begins + ", and 1 finished change behind it")));
  EXPECT_THAT(said(ends[1] - 1, 24), Contains(HasSubstr(begins + ", and 1 finished change behind it")));
  const auto without_size = [&](std::int64_t page) {
    const std::string copy = new_address();
    for (const char* end : {"", "-wal"}) std::filesystem::copy_file(address + end, copy + end);
    zero(copy + "-wal", at_page(page - 1, 4), 4);
    return verified(copy);
  };
  EXPECT_THAT(without_size(ends[1]).problems, Contains(AllOf(HasSubstr(fmt::format("found page {} of", ends[1])),
                                                             HasSubstr(begins + ", and 1 finished change behind it"))));
  EXPECT_THAT(without_size(ends[2]).notes, Contains(HasSubstr("is not whole and is passed over")));
  EXPECT_THAT(said(ends[2], 9),
              Contains(EndsWith(fmt::format("the change that begins with page {} is passed over", ends[1] + 1))));
}

TEST_P(StoreLogTest, FindsItsHeadOverwrittenWithZeros) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such log";
  const std::string address = with_log();
  zero(address + "-wal", 0, head_of_log);
  EXPECT_THAT(verified(address).problems, Contains(HasSubstr("found the head of the log")));
  zero(address + "-wal", head_of_log, page_of_log);
  EXPECT_THAT(verified(address).problems, Contains(HasSubstr("found the head of the log")));
  zero(address + "-wal", 0, std::filesystem::file_size(address + "-wal"));
  EXPECT_EQ(state(address + "-wal"), LogState{}) << "as a file system leaves it when power is lost";
}

/// Who may write would take what SQLite reads of it for all there is.
TEST_P(StoreLogTest, IsNotOpenedButToVerifyWhereItIsDamaged) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such log";
  const std::string address = with_log();
  flip(address + "-wal", at_page(0, 100));
  const auto bytes = std::filesystem::file_size(address + "-wal");
  for (const bool reading : {false, true}) {
    const auto store = Store::open(address, {.create = false, .read_only = reading});
    ASSERT_FALSE(store);
    EXPECT_EQ(store.error().kind, ErrorKind::damaged);
    EXPECT_THAT(store.error().message, HasSubstr("found page 1 of the log"));
    EXPECT_THAT(store.error().message, HasSubstr("would destroy what changed from page 1 on"));
    EXPECT_EQ(store.error().file, address);
  }
  EXPECT_THAT(verified(address).problems, Contains(HasSubstr("found page 1 of the log")));
  EXPECT_EQ(std::filesystem::file_size(address + "-wal"), bytes);
  flip(address + "-wal", 3);
  EXPECT_THAT(why(Store::open(address)), HasSubstr("found the head of the log"));
  std::filesystem::remove(address + "-wal");
  EXPECT_TRUE(Store::open(address)) << "as its error says";
}

/// Nobody can tell it from one that was altered.
TEST_P(StoreLogTest, NotesALastChangeThatIsNotWhole) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such log";
  const std::string address = with_log();
  const std::size_t size = std::filesystem::file_size(address + "-wal");
  flip(address + "-wal", size - 1);
  const Verification found = verified(address);
  EXPECT_THAT(found.problems, Not(Contains(HasSubstr("log"))));
  EXPECT_THAT(found.notes, Contains(HasSubstr("is not whole and is passed over")));
  EXPECT_TRUE(found.last_change_is_lost);
  const auto store = must(Store::open(address, {.create = false, .read_only = true}));
  EXPECT_THAT(must(store->backup(file("copy.db"))).notes, Contains(HasSubstr("is not whole and is passed over")));
  EXPECT_TRUE(Store::open(address)) << "a crash leaves as much";
}

TEST_P(StoreLogTest, TakesPagesOfAnEarlierLogAndOfAChangeThatWasTakenBackForNone) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such log";
  const std::string address = with_log();
  const std::int64_t pages = state(address + "-wal").pages;
  EXPECT_EQ(head_of_log + static_cast<std::size_t>(pages) * page_of_log, std::filesystem::file_size(address + "-wal"));
  std::array<char, page_of_log> left{};
  left.fill('x');
  std::ofstream(address + "-wal", std::ios::app | std::ios::binary).write(left.data(), left.size());
  EXPECT_EQ(state(address + "-wal"), (LogState{.pages = pages, .kept = pages}));
  EXPECT_THAT(verified(address).problems, IsEmpty());
}

}  // namespace
}  // namespace axiometry::store
