// SPDX-License-Identifier: Apache-2.0
// What must not hurt an archive: two who write at once, one who holds on too long, another program's hands on its
// tables.
#include <gmock/gmock.h>

#include <signal.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::Contains;
using testing::HasSubstr;

class StoreTroubleTest : public BothStores {};
AXIOMETRY_ON_BOTH_STORES(StoreTroubleTest);

TEST_P(StoreTroubleTest, DatabaseItselfRefusesToChangeWhatWasKept) {
  const std::string address = filled();
  const auto connection = raw(address);
  for (const char* table : {"content", "machine", "machine_version", "axis", "axis_version", "instrument",
                            "instrument_version", "plan", "plan_version", "test", "test_version", "test_instrument",
                            "evaluation", "figure", "document", "audit", "migration"}) {
    const auto cleared = connection->run(fmt::format("DELETE FROM {}", table));
    EXPECT_THAT(why(cleared), HasSubstr("taken away")) << table;
    const auto replaced = connection->run(sqlite() ? fmt::format("INSERT OR REPLACE INTO {0} SELECT * FROM {0}", table)
                                                   : fmt::format("TRUNCATE {} CASCADE", table));
    EXPECT_THAT(why(replaced), testing::AnyOf(HasSubstr("there already"), HasSubstr("taken away"))) << table;
  }
  for (const char* change : {"content SET bytes = bytes", "content SET file_name = 'x'", "test SET content = 'x'",
                             "test SET at = 'x'", "test_version SET title = 'x'", "evaluation SET result = '{}'",
                             "figure SET value = 0", "document SET name = 'x'", "audit SET actor = 'x'",
                             "machine_version SET name = 'x'", "test SET latest = latest + 2",
                             "test SET latest = latest - 1", "axis SET latest = 0", "migration SET sha256 = 'x'"})
    EXPECT_THAT(why(connection->run(fmt::format("UPDATE {}", change))), HasSubstr("found ")) << change;
  EXPECT_TRUE(problems(address).empty());
}

TEST_P(StoreTroubleTest, VerifyFindsWhatWasChangedAllTheSame) {
  struct Case {
    const char* table;
    const char* sql;
    const char* said;
  };
  const std::string bytes = sqlite() ? "x'00'" : "'\\x00'";
  const std::string change_content = "UPDATE content SET bytes = " + bytes;
  for (const Case& c : {
           Case{"content", change_content.c_str(), "content 1: found 1 bytes"},
           Case{"content", "DELETE FROM content WHERE id = 1", "content 1: found none"},
           Case{"test_version", "UPDATE test_version SET title = 'x' WHERE test = 1",
                "test 1: found version 1 changed"},
           Case{"evaluation", "UPDATE evaluation SET result = '{\"A\":1}' WHERE version = 2",
                "test 1: found version 2 changed"},
           Case{"figure", "UPDATE figure SET value = 0.5 WHERE test = 2", "test 2: found version 1 changed"},
           Case{"test", "UPDATE test SET withdrawn = 0", "test 2: found it not withdrawn"},
           Case{"test", "UPDATE test SET latest = 1", "test 1: found 2 versions"},
           Case{"test", "UPDATE test SET actor = 'x' WHERE id = 2", "test 2: found another file, receipt"},
           Case{"test", "UPDATE test SET name_in_file = 'x' WHERE id = 1", "test 1: found another file, receipt"},
           Case{"content", "UPDATE content SET reason = 'x'", "content 1: found another time, name or reason"},
           Case{"test_list", "UPDATE test_list SET value_a = 0 WHERE test = 1", "test 1: found another line"},
           Case{"test_search", "DELETE FROM test_search", "test 1: found another line"},
           Case{"machine_version", "UPDATE machine_version SET name = 'x'", "machine 1: found version 1 changed"},
           Case{"document", "UPDATE document SET name = 'x'", "document 1: found it changed"},
           Case{"audit", "UPDATE audit SET actor = 'x' WHERE id = 2", "found entry 2 with the hash"},
           Case{"audit", "DELETE FROM audit WHERE id = 3", "found entry 4 after 2"},
           Case{"audit", "DELETE FROM audit WHERE id > 3", "the audit trail"},
       }) {
    const std::string address = filled();
    ASSERT_TRUE(problems(address).empty());
    tamper(address, c.table, c.sql);
    EXPECT_THAT(problems(address), Contains(HasSubstr(c.said))) << c.sql;
  }
}

TEST_P(StoreTroubleTest, VerifyFindsATestThatWasGivenTheBytesOfAnother) {
  const std::string address = filled();
  must(must(Store::open(address))->receive(content_of("def"), std::vector{new_test("c")}, by_anna));
  ASSERT_TRUE(problems(address).empty());
  tamper(address, "test", fmt::format("UPDATE test SET content = '{}' WHERE id = 1", sha256("def")));
  tamper(address, "test_list", fmt::format("UPDATE test_list SET content = '{}' WHERE test = 1", sha256("def")));
  EXPECT_THAT(problems(address), testing::ElementsAre(HasSubstr("test 1: found another file, receipt")));
}

TEST_P(StoreTroubleTest, GivesNoBytesThatWereChanged) {
  const std::string address = filled();
  tamper(address, "content", sqlite() ? "UPDATE content SET bytes = x'00'" : "UPDATE content SET bytes = '\\x00'");
  EXPECT_EQ(must(Store::open(address))->content(sha256("abc")).error().kind, ErrorKind::damaged);
}

TEST_P(StoreTroubleTest, RefusesAStoreOfANewerProgram) {
  const std::string address = filled();
  must(raw(address)->run("INSERT INTO migration (number, name, sha256, at) VALUES (7, 'x', 'x', 'x')"));
  for (const bool read_only : {false, true}) {
    const auto refused = Store::open(address, {.read_only = read_only});
    EXPECT_THAT(why(refused), HasSubstr("found schema 7, expected at most 4: written by a newer Axiometry"));
  }
}

TEST_P(StoreTroubleTest, RefusesAStoreWhoseMigrationWasAnother) {
  const std::string address = filled();
  tamper(address, "migration", "UPDATE migration SET sha256 = 'abc'");
  EXPECT_THAT(why(Store::open(address)), HasSubstr("found migration 1 with the SHA-256 abc"));
}

TEST_P(StoreTroubleTest, LetsManyThreadsAndTwoProgramsWriteAtOnce) {
  const std::string address = new_address();
  const std::unique_ptr<Store> stores[2] = {must(Store::open(address)), must(Store::open(address))};
  constexpr int each = 5;  // who waits for another program is not let in by its turn, and gives up after ten seconds
  std::vector<std::thread> threads;
  for (int writer = 0; writer < 6; ++writer)
    threads.emplace_back([&, writer] {
      for (int k = 0; k < each; ++k) {
        const auto ids = stores[writer % 2]->receive(content_of(fmt::format("{} {}", writer, k)),
                                                     std::vector{new_test("t")}, by_anna);
        EXPECT_TRUE(ids) << why(ids);
      }
    });
  for (int reader = 0; reader < 6; ++reader)
    threads.emplace_back([&, reader] {
      for (int k = 0; k < each; ++k) {
        const auto page = stores[reader % 2]->tests({});
        EXPECT_TRUE(page) << why(page);
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(must(stores[0]->counts()).tests, 6 * each);
  EXPECT_EQ(must(stores[0]->counts()).machines, 1);
  EXPECT_TRUE(problems(address).empty());
}

TEST_P(StoreTroubleTest, LetsOneOfManyWhoEditTheSameVersionWin) {
  const std::string address = filled();
  const std::unique_ptr<Store> stores[2] = {must(Store::open(address)), must(Store::open(address))};
  std::atomic<int> won = 0;
  std::atomic<int> told = 0;
  std::vector<std::thread> threads;
  for (int k = 0; k < 8; ++k)
    threads.emplace_back([&, k] {
      const auto revised = stores[k % 2]->revise(1, 2, new_test("mine").state, by_anna);
      if (revised) ++won;
      if (!revised && revised.error().kind == ErrorKind::conflict) ++told;
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(won, 1);
  EXPECT_EQ(told, 7);
}

/// Again and again: what one sees of another's half-made store is a matter of microseconds.
TEST_P(StoreTroubleTest, ManyMayMakeTheSameStoreAtOnce) {
  for (int round = 0; round < (sqlite() ? 60 : 5); ++round) {
    const std::string address = new_address();
    std::vector<std::thread> threads;
    for (int k = 0; k < 6; ++k)
      threads.emplace_back([&] {
        const auto store = Store::open(address);
        EXPECT_TRUE(store) << why(store);
      });
    for (std::thread& thread : threads) thread.join();
    if (HasFailure()) return;
  }
}

TEST_P(StoreTroubleTest, ReadsWhileAnotherHoldsOnAndGivesUpWritingAfterTenSeconds) {
  const std::string address = filled();
  const auto store = must(Store::open(address));
  const auto other = raw(address);
  must(other->begin_write());
  must(other->run("DELETE FROM test_search WHERE test = 1"));
  EXPECT_EQ(must(store->tests({})).total, 1);
  const auto begun = std::chrono::steady_clock::now();
  const auto late = store->receive(content_of("new"), std::vector{new_test("t")}, by_anna);
  EXPECT_GT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(9));
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().kind, ErrorKind::unavailable);
  EXPECT_THAT(late.error().message, HasSubstr("locked by another program for ten seconds"));
  other->rollback();
  EXPECT_TRUE(store->receive(content_of("new"), std::vector{new_test("t")}, by_anna));
  EXPECT_TRUE(problems(address).empty());
}

TEST_P(StoreTroubleTest, WritesNothingThroughAReadOnlyOpening) {
  const std::string address = filled();
  const auto store = must(Store::open(address, {.read_only = true}));
  EXPECT_FALSE(store->info().writable);
  EXPECT_EQ(must(store->tests({})).total, 1);
  EXPECT_TRUE(must(store->verify()).problems.empty());
  const auto refused = store->receive(content_of("x"), std::vector{new_test("t")}, by_anna);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::read_only);
  EXPECT_EQ(store->withdraw(1, true, by_anna).error().kind, ErrorKind::read_only);
  EXPECT_EQ(Store::open(new_address(), {.read_only = true}).error().kind, ErrorKind::not_found);
}

TEST_P(StoreTroubleTest, SaysSoWhenACellIsNotWhatWasWritten) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL keeps types itself";
  const std::string address = filled();
  tamper(address, "test", "UPDATE test SET latest = 'x' WHERE id = 1");
  const auto store = must(Store::open(address));
  EXPECT_EQ(store->test(1).error().kind, ErrorKind::damaged);
  EXPECT_FALSE(must(store->verify()).problems.empty());
}

class PostgresqlTroubleTest : public BothStores {};
INSTANTIATE_TEST_SUITE_P(One, PostgresqlTroubleTest, testing::Values("postgresql"),
                         [](const auto& each) { return each.param; });

TEST_P(PostgresqlTroubleTest, LetsOneWriteAtATimeHoweverThePathToTheTablesIsSpelt) {
  const std::string address = new_address();
  const std::unique_ptr<Store> stores[2] = {must(Store::open(address)), must(Store::open(address + ",public"))};
  std::vector<std::thread> threads;
  for (int writer = 0; writer < 4; ++writer)
    threads.emplace_back([&, writer] {
      for (int k = 0; k < 10; ++k) {
        const auto ids = stores[writer % 2]->receive(content_of(fmt::format("{} {}", writer, k)),
                                                     std::vector{new_test("t")}, by_anna);
        EXPECT_TRUE(ids) << why(ids);
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(must(stores[0]->counts()).tests, 40);
}

TEST_P(PostgresqlTroubleTest, NeverShowsThePassword) {
  for (const char* address :
       {"postgresql://anna:hidden@127.0.0.1:1/axiometry", "postgresql://anna:hidden@[::1/x",
        "postgresql://anna:hidden@127.0.0.1:1/axiometry?nonsense=1", "postgresql://%zzhidden@x/"}) {
    const auto refused = Store::open(address);
    ASSERT_FALSE(refused);
    EXPECT_THAT(why(refused), testing::Not(HasSubstr("hidden")));
  }
  std::string address = new_address();
  address.insert(address.find('@'), ":hidden");
  EXPECT_THAT(must(Store::open(address))->info().location, testing::Not(HasSubstr("hidden")));
}

TEST_P(PostgresqlTroubleTest, FindsItsServerAgainAfterTheConnectionWasLost) {
  const std::string address = new_address();
  const auto store = must(Store::open(address));
  must(store->receive(content_of("a"), std::vector{new_test("a")}, by_anna));
  const auto lose = [&] {
    must(
        raw(address)->query("SELECT count(pg_terminate_backend(pid)) FROM pg_stat_activity WHERE pid <> "
                            "pg_backend_pid() AND application_name = 'axiometry'"));
  };
  lose();
  EXPECT_EQ(must(store->tests({})).total, 1);
  lose();
  EXPECT_TRUE(store->receive(content_of("b"), std::vector{new_test("b")}, by_anna));
  EXPECT_EQ(must(store->counts()).tests, 2);
}

/// Processes that are stopped for as long as this: they keep what they hold and answer nothing.
class Stopped {
 public:
  explicit Stopped(std::vector<int> processes) : processes_(std::move(processes)) { tell(SIGSTOP); }
  ~Stopped() { tell(SIGCONT); }
  Stopped(const Stopped&) = delete;
  Stopped& operator=(const Stopped&) = delete;

 private:
  void tell(int number) const {
    for (const int process : processes_) ::kill(process, number);
  }
  std::vector<int> processes_;
};

/// The server first, so that it begins no more.
std::vector<int> processes_of_server() {
  const char* told = std::getenv("AXIOMETRY_TEST_POSTGRESQL_PID");
  if (told == nullptr) return {};
  std::vector<int> processes = {std::atoi(told)};
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", processes[0]));
  for (int child = 0; children >> child;) processes.push_back(child);
  return processes;
}

template <typename T>
Error error_of(const Result<T>& result) {
  return result ? Error{"found none, expected an error", {}, {}} : result.error();
}

/// Two seconds are promised; a machine that is busy with other work may take longer.
constexpr std::chrono::seconds long_beyond_the_promise{8};

TEST_P(PostgresqlTroubleTest, SaysThatItsServerIsSilentInsteadOfWaitingForIt) {
  const std::vector<int> server = processes_of_server();
  if (server.empty()) GTEST_SKIP() << "no AXIOMETRY_TEST_POSTGRESQL_PID";
  const std::string address = new_address();
  const auto store = must(Store::open(address));
  must(store->receive(content_of("a"), std::vector{new_test("a")}, by_anna));
  {
    const Stopped stopped(processes_of_server());  // those of the store among them
    const auto begun = std::chrono::steady_clock::now();
    std::vector<std::thread> askers;
    for (int k = 0; k < 12; ++k)
      askers.emplace_back([&, k] {
        const Error error = k % 3 == 0 ? error_of(store->withdraw(1, true, by_anna)) : error_of(store->test(1));
        EXPECT_EQ(error.kind, ErrorKind::unavailable);
        EXPECT_THAT(error.message, HasSubstr("silent"));
      });
    for (std::thread& asker : askers) asker.join();
    EXPECT_EQ(error_of(store->counts()).kind, ErrorKind::unavailable);
    EXPECT_LT(std::chrono::steady_clock::now() - begun, long_beyond_the_promise);
  }
  EXPECT_EQ(must(store->tests({})).total, 1);
  must(store->withdraw(1, true, by_anna));
  EXPECT_TRUE(must(store->verify()).problems.empty());
}

TEST_P(PostgresqlTroubleTest, GoesOnOverANewSessionWhereOnlyItsOwnWereStopped) {
  const std::string address = new_address();
  const auto store = must(Store::open(address));
  must(store->receive(content_of("a"), std::vector{new_test("a")}, by_anna));
  std::vector<int> sessions;
  for (const Row& row : must(raw(address)->query("SELECT pid FROM pg_stat_activity WHERE pid <> pg_backend_pid() AND "
                                                 "application_name = 'axiometry'")))
    sessions.push_back(row.number(0));
  ASSERT_FALSE(sessions.empty());
  const Stopped stopped(sessions);
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(must(store->tests({})).total, 1);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, long_beyond_the_promise);
}

TEST_P(PostgresqlTroubleTest, WaitsForAStatementThatTakesLongerThanItIsSilent) {
  const auto connection = raw(new_address());
  EXPECT_EQ(must(connection->query("SELECT 7 FROM (SELECT pg_sleep(1.5)) AS waited"))[0].integer(0), 7);
}

TEST_P(PostgresqlTroubleTest, SaysThatTheServerAcceptsNoChanges) {
  const std::string address = new_address();
  must(Store::open(address));
  const std::string reading = address + "%20-cdefault_transaction_read_only%3Don";
  const auto store = must(Store::open(reading));
  EXPECT_FALSE(store->info().writable);
  EXPECT_EQ(store->receive(content_of("b"), std::vector{new_test("b")}, by_anna).error().kind, ErrorKind::read_only);
}

}  // namespace
}  // namespace axiometry::store
