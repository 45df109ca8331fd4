// SPDX-License-Identifier: Apache-2.0
// What a verification says of a log beside the file that is not as it was written.
#include <gmock/gmock.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "axiometry/store/proof/sqlite_log.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::Contains;
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

  static LogState state(const std::string& file) {
    std::ifstream log(file, std::ios::binary);
    return log_state(log);
  }
};
AXIOMETRY_ON_BOTH_STORES(StoreLogTest);

TEST_P(StoreLogTest, FindsABitOfAPageOrItsHeadThatSqlitePassesOver) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such log";
  EXPECT_THAT(verified(with_log()).problems, IsEmpty());
  EXPECT_THAT(verified(with_log()).notes, IsEmpty());
  constexpr std::pair<std::size_t, const char*> places[] = {{head_of_log + 24 + 100, "a page"},
                                                            {head_of_log + 2, "its number"},
                                                            {head_of_log + 9, "its salt"},
                                                            {head_of_log + 17, "its sum"}};
  for (const auto& [at, what] : places) {
    const std::string address = with_log();
    flip(address + "-wal", at);
    EXPECT_THAT(verified(address).problems, Contains(HasSubstr("found page 1 of the log"))) << what;
  }
  for (const std::size_t at : {std::size_t{3}, std::size_t{14}, std::size_t{18}, std::size_t{25}}) {
    const std::string address = with_log();
    flip(address + "-wal", at);
    EXPECT_THAT(verified(address).problems, Contains(HasSubstr("found the head of the log"))) << at;
  }
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
}

TEST_P(StoreLogTest, TakesPagesOfAnEarlierLogAndOfAChangeThatWasTakenBackForNone) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such log";
  const std::string address = with_log();
  const std::int64_t pages = state(address + "-wal").pages;
  EXPECT_EQ(head_of_log + static_cast<std::size_t>(pages) * page_of_log, std::filesystem::file_size(address + "-wal"));
  std::array<char, page_of_log> left{};
  left.fill('x');
  std::ofstream(address + "-wal", std::ios::app | std::ios::binary).write(left.data(), left.size());
  EXPECT_EQ(state(address + "-wal"), LogState{.pages = pages});
  EXPECT_THAT(verified(address).problems, IsEmpty());
}

}  // namespace
}  // namespace axiometry::store
