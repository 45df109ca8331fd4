// SPDX-License-Identifier: Apache-2.0
// What must not hurt an archive in a file: what is no archive, what a killed program left, other files and other
// programs in its place, no room, no right to write.
#include <gmock/gmock.h>
#include <sched.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::HasSubstr;

class SqliteTroubleTest : public BothStores {};
INSTANTIATE_TEST_SUITE_P(One, SqliteTroubleTest, testing::Values("sqlite"),
                         [](const auto& each) { return each.param; });

std::string bytes_of(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_P(SqliteTroubleTest, RefusesWhatIsNoStoreAndLeavesItAlone) {
  std::ofstream(file("text.db")) << "just some text, long enough to be taken for something";
  sqlite3* foreign = nullptr;
  ASSERT_EQ(sqlite3_open(file("foreign.db").c_str(), &foreign), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(foreign, "CREATE TABLE t (x)", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(foreign);
  for (const char* name : {"text.db", "foreign.db"}) {
    const std::string before = bytes_of(file(name));
    for (const bool read_only : {false, true}) {
      const auto refused = Store::open(file(name), {.read_only = read_only});
      EXPECT_THAT(why(refused), HasSubstr("expected a store")) << name;
    }
    EXPECT_EQ(bytes_of(file(name)), before) << name;
    EXPECT_FALSE(std::filesystem::exists(file(name) + std::string("-wal"))) << name;
  }
  EXPECT_THAT(why(Store::open(file("."))), HasSubstr("found a folder"));
  EXPECT_THAT(why(Store::open("")), HasSubstr("found no name"));
  EXPECT_THAT(why(Store::open("mysql://root:secret@host/x")), HasSubstr("expected a file or postgresql://"));
}

TEST_P(SqliteTroubleTest, SaysOfACutOffStoreThatItIsDamaged) {
  const std::string address = file("cut.db");
  must(must(Store::open(address))->receive(content_of("x"), std::vector{new_test("t")}, by_anna));
  std::filesystem::resize_file(address, std::filesystem::file_size(address) / 2);
  const auto refused = Store::open(address);
  EXPECT_THAT(why(refused), HasSubstr("found a damaged SQLite database"));
  EXPECT_EQ(refused.error().kind, ErrorKind::damaged);
}

TEST_P(SqliteTroubleTest, KeepsNothingInAFileThatHasLostItsName) {
  const std::string address = file("moved.db");
  const auto store = must(Store::open(address));
  const auto keep = [&] { return store->receive(content_of("x"), std::vector{new_test("t")}, by_anna); };
  must(keep());
  std::filesystem::rename(address, file("away.db"));
  for (const bool replaced : {false, true}) {
    if (replaced) std::ofstream(address) << "another";
    const auto refused = keep();
    EXPECT_THAT(why(refused), HasSubstr("removed or replaced"));
    EXPECT_EQ(refused.error().kind, ErrorKind::unavailable);
    if (replaced)
      EXPECT_THAT(why(store->counts()), HasSubstr("removed or replaced"));
    else
      EXPECT_EQ(must(store->counts()).tests, 1) << "what is there can be read";
  }
  std::filesystem::rename(file("away.db"), address);
  must(keep());
  EXPECT_EQ(must(store->counts()).tests, 2);
}

TEST_P(SqliteTroubleTest, NeverTakesAnotherFileForItsOwn) {
  const std::string address = file("replaced.db");
  const std::string other = file("other.db");
  must(must(Store::open(other))->receive(content_of("other"), std::vector{new_test("other")}, by_anna));
  auto store = must(Store::open(address));
  must(store->receive(content_of("x"), std::vector{new_test("a"), new_test("b")}, by_anna));
  std::filesystem::rename(other, address);
  // Many at once, so that new connections are made.
  std::vector<std::thread> threads;
  for (int k = 0; k < 16; ++k)
    threads.emplace_back([&, k] {
      for (int round = 0; round < 20; ++round)
        if (const auto seen = store->counts()) EXPECT_EQ(seen->tests, 2);
      EXPECT_FALSE(store->receive(content_of(std::to_string(k)), std::vector{new_test("lost")}, by_anna));
    });
  for (std::thread& thread : threads) thread.join();
  store.reset();
  const auto there = must(Store::open(address, {.read_only = true}));
  EXPECT_EQ(must(there->counts()).tests, 1);
  EXPECT_EQ(must(there->test(1)).state.title, "other");
}

/// A program that is killed while it makes a store leaves a journal behind; every moment of it is tried.
TEST_P(SqliteTroubleTest, OpensAStoreWhoseMakingWasKilled) {
  int killed = 0;
  for (int round = 0; round < 40; ++round) {
    const std::string address = file(fmt::format("killed{}.db", round).c_str());
    const pid_t child = ::fork();
    if (child == 0) {
      static_cast<void>(Store::open(address));
      ::_exit(0);
    }
    while (!std::filesystem::exists(address) && ::waitpid(child, nullptr, WNOHANG) == 0) ::usleep(50);
    ::usleep(static_cast<useconds_t>(round) * 250);
    ::kill(child, SIGKILL);
    int status = 0;
    if (::waitpid(child, &status, 0) == child && WIFSIGNALED(status)) ++killed;
    const auto store = Store::open(address);
    ASSERT_TRUE(store) << "killed after " << round * 250 << " µs: " << why(store);
    must((*store)->receive(content_of("x"), std::vector{new_test("t")}, by_anna));
  }
  EXPECT_GT(killed, 0);
}

struct Begun {
  std::string by;    ///< the file that it is begun in
  std::string left;  ///< where a killed program would leave it
};

/// SQLite's journal of a change that was begun, as a killed program leaves it: the database has the change, the journal
/// what was there before.
void leave(const Begun& begun) {
  sqlite3* raw = nullptr;
  ASSERT_EQ(sqlite3_open(begun.by.c_str(), &raw), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(raw, "PRAGMA application_id = 1098410351; PRAGMA user_version = 1", nullptr, nullptr, nullptr),
            SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(raw,
                         "PRAGMA cache_size = 1; BEGIN IMMEDIATE; PRAGMA user_version = 7; CREATE TABLE t (x); "
                         "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 200) "
                         "INSERT INTO t SELECT randomblob(4000) FROM n",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  for (const char* rest : {"", "-journal"}) std::filesystem::copy_file(begun.by + rest, begun.left + rest);
  sqlite3_close(raw);
  ASSERT_GT(std::filesystem::file_size(begun.left + "-journal"), 0u);
}

TEST_P(SqliteTroubleTest, SaysOfAChangeThatWasBegunThatWhoOnlyReadsCannotTakeItBack) {
  leave({.by = file("begun.db"), .left = file("left.db")});
  const std::string before = bytes_of(file("left.db"));
  const auto refused = Store::open(file("left.db"), {.read_only = true});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::unavailable);
  EXPECT_THAT(why(refused), HasSubstr("(-journal)"));
  EXPECT_EQ(bytes_of(file("left.db")), before);
  EXPECT_TRUE(Store::open(file("left.db")));
  EXPECT_TRUE(Store::open(file("left.db"), {.read_only = true}));
}

TEST_P(SqliteTroubleTest, TakesBackWhatAKilledProgramHadBegun) {
  leave({.by = file("begun.db"), .left = file("left.db")});
  const auto store = Store::open(file("left.db"));
  ASSERT_TRUE(store) << why(store);
  must((*store)->receive(content_of("x"), std::vector{new_test("t")}, by_anna));
  EXPECT_TRUE(must((*store)->verify()).problems.empty());
}

TEST_P(SqliteTroubleTest, SaysThatAnotherProgramHoldsTheStoreAlsoWhenItOnlyReads) {
  const std::string address = file("held.db");
  must(must(Store::open(address))->receive(content_of("x"), std::vector{new_test("t")}, by_anna));
  sqlite3* holder = nullptr;
  ASSERT_EQ(sqlite3_open(address.c_str(), &holder), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(holder, "PRAGMA locking_mode = EXCLUSIVE; BEGIN IMMEDIATE; COMMIT", nullptr, nullptr, nullptr),
            SQLITE_OK);
  const auto refused = Store::open(address, {.read_only = true});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::unavailable);
  EXPECT_THAT(why(refused), HasSubstr("locked by another program"));
  sqlite3_close(holder);
  EXPECT_TRUE(Store::open(address, {.read_only = true}));
}

TEST_P(SqliteTroubleTest, MakesItsFileForItsOwnerOnlyAndTheFolderWithIt) {
  const std::string address = file("a/b/store ? # %41.db");
  must(must(Store::open(address))->receive(content_of("x"), std::vector{new_test("t")}, by_anna));
  struct stat status {};
  ASSERT_EQ(::stat(address.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  EXPECT_TRUE(Store::open(address, {.read_only = true}));
}

/// What a child process found wrong among mounts of its own, "" if nothing; no value where it may not mount.
template <typename Scenario>
std::optional<std::string> among_own_mounts(Scenario scenario) {
  int ends[2];
  if (::pipe(ends) != 0) return "no pipe";
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string user = fmt::format("0 {} 1", ::geteuid());
    const std::string group = fmt::format("0 {} 1", ::getegid());
    const bool may = ::unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0;
    // Without these files of its own have no owner.
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << user;
    std::ofstream("/proc/self/gid_map") << group;
    const std::string said = may ? scenario() : "not allowed";
    ::_exit(::write(ends[1], said.data(), said.size()) < 0 ? 1 : 0);
  }
  ::close(ends[1]);
  std::string said(4096, '\0');
  const ssize_t size = ::read(ends[0], said.data(), said.size());
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (status != 0) return fmt::format("ended with {}", status);
  said.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return said == "not allowed" ? std::nullopt : std::optional(said);
}

TEST_P(SqliteTroubleTest, KeepsNothingOfWhatFindsNoRoomAndGoesOnAfterwards) {
  const std::string address = file("full.db");
  const std::string folder = file("");
  const auto wrong = among_own_mounts([&]() -> std::string {
    if (::mount("none", folder.c_str(), "tmpfs", 0, "size=2m") != 0) return "not allowed";
    const auto store = must(Store::open(address));
    must(store->receive(content_of("first"), std::vector{new_test("first")}, by_anna));
    const auto big = store->receive(content_of(std::string(2'000'000, 'x')), std::vector{new_test("big")}, by_anna);
    if (big || big.error().kind != ErrorKind::full) return "found " + why(big);
    if (must(store->counts()).tests != 1) return "kept half of it";
    // To the last byte, by small ones.
    int kept = 1;
    while (store->receive(content_of(std::string(20'000, 'x') + std::to_string(kept)), std::vector{new_test("small")},
                          by_anna))
      ++kept;
    const auto found = must(store->verify());
    if (!found.problems.empty()) return found.problems[0];
    if (found.tests != kept) return fmt::format("found {} tests, expected {}", found.tests, kept);
    if (::mount("none", folder.c_str(), "tmpfs", MS_REMOUNT, "size=20m") != 0) return "cannot make room";
    const auto again = store->receive(content_of("again"), std::vector{new_test("again")}, by_anna);
    return again ? "" : why(again);
  });
  if (!wrong) GTEST_SKIP() << "may not mount";
  EXPECT_EQ(*wrong, "");
}

TEST_P(SqliteTroubleTest, ReadsWhatLiesOnAFileSystemThatCannotBeWritten) {
  const std::string address = file("readable.db");
  const std::string folder = file("");
  must(must(Store::open(address))->receive(content_of("first"), std::vector{new_test("first")}, by_anna));
  const auto wrong = among_own_mounts([&]() -> std::string {
    if (::mount(folder.c_str(), folder.c_str(), nullptr, MS_BIND, nullptr) != 0) return "not allowed";
    if (::mount(nullptr, folder.c_str(), nullptr, MS_BIND | MS_REMOUNT | MS_RDONLY, nullptr) != 0) return "not allowed";
    const auto store = Store::open(address);
    if (!store) return why(store);
    if ((*store)->info().writable || (*store)->info().why_not != "its file system is mounted read-only")
      return (*store)->info().why_not;
    if (must((*store)->tests({})).total != 1 || !must((*store)->verify()).problems.empty()) return "cannot be read";
    const auto refused = (*store)->receive(content_of("x"), std::vector{new_test("x")}, by_anna);
    if (refused || refused.error().kind != ErrorKind::read_only) return "found " + why(refused);
    const auto none = Store::open(folder + "none.db");
    if (none || none.error().kind != ErrorKind::read_only) return "found " + why(none);
    const auto backup = (*store)->backup(folder + "backup.db");
    return backup || backup.error().kind != ErrorKind::read_only ? "found " + why(backup) : "";
  });
  if (!wrong) GTEST_SKIP() << "may not mount";
  EXPECT_EQ(*wrong, "");
}

TEST_P(SqliteTroubleTest, SeesWhatIsWrittenElsewhereIntoWhatItCannotWrite) {
  const std::string folder = file("");
  const std::string readable = file("readable/");
  const std::string address = file("store/archive.db");
  must(must(Store::open(address))->receive(content_of("first"), std::vector{new_test("first")}, by_anna));
  std::filesystem::create_directory(readable);
  const auto wrong = among_own_mounts([&]() -> std::string {
    if (::mount((folder + "store").c_str(), readable.c_str(), nullptr, MS_BIND, nullptr) != 0) return "not allowed";
    if (::mount(nullptr, readable.c_str(), nullptr, MS_BIND | MS_REMOUNT | MS_RDONLY, nullptr) != 0)
      return "not allowed";
    const auto reader = must(Store::open(readable + "archive.db"));
    if (must(reader->counts()).tests != 1) return "not what was there";
    {
      const auto owner = must(Store::open(address));
      must(owner->receive(content_of("second"), std::vector{new_test("second")}, by_anna));
      const auto beside = reader->counts();
      if (!beside || beside->tests != 2) return "not what is written: " + (beside ? "the old content" : why(beside));
    }
    const auto after = reader->counts();
    if (!after || after->tests != 2) return "not what was written: " + (after ? "the old content" : why(after));
    must(must(Store::open(address))->receive(content_of("third"), std::vector{new_test("third")}, by_anna));
    const auto last = reader->counts();
    return last && last->tests == 3 ? "" : "not what was written last: " + (last ? "the old content" : why(last));
  });
  if (!wrong) GTEST_SKIP() << "may not mount";
  EXPECT_EQ(*wrong, "");
}

}  // namespace
}  // namespace axiometry::store
