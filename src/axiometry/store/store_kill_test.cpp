// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <random>
#include <set>
#include <thread>

#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

// Processes that write are killed without warning, again and again, two at a time. What was acknowledged must be there.
namespace axiometry::store {
namespace {

constexpr int rounds = 15;

/// Writes tests, revisions and documents for ever; says the number of each test once it is kept.
[[noreturn]] void write_for_ever(const std::string& address, int writer, int pipe) {
  const auto store = Store::open(address);
  if (!store) ::_exit(1);
  for (int k = 0;; ++k) {
    const std::string bytes = fmt::format("{} {} {}", ::getpid(), writer, k) + std::string(20'000, 'x');
    const auto ids = (*store)->receive(content_of(bytes), std::vector{new_test("t"), new_test("u")}, {"writer", ""});
    if (!ids) ::_exit(2);
    for (const Id id : *ids)
      if (::write(pipe, &id, sizeof id) != sizeof id) ::_exit(3);
    if (!(*store)->revise((*ids)[0], 1, new_test("revised").state, {"writer", ""})) ::_exit(4);
  }
}

class StoreKillTest : public BothStores {};
AXIOMETRY_ON_BOTH_STORES(StoreKillTest);

TEST_P(StoreKillTest, LosesNothingThatWasAcknowledged) {
  const std::string address = new_address();
  must(Store::open(address));
  int pipe[2];
  ASSERT_EQ(::pipe(pipe), 0);
  std::mt19937 random(20261122);
  std::multiset<Id> acknowledged;
  for (int round = 0; round < rounds; ++round) {
    pid_t writers[2];
    for (int k = 0; k < 2; ++k)
      if ((writers[k] = ::fork()) == 0) write_for_ever(address, k, pipe[1]);
    // However busy the machine is, the first round ends after something was acknowledged.
    pollfd said{pipe[0], POLLIN, 0};
    EXPECT_EQ(::poll(&said, 1, 60'000), 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(50 + random() % 300));
    for (const pid_t writer : writers) {
      ::kill(writer, SIGKILL);
      int status = 0;
      ::waitpid(writer, &status, 0);
      EXPECT_TRUE(WIFSIGNALED(status)) << "a writer gave up by itself with " << WEXITSTATUS(status);
      std::this_thread::sleep_for(std::chrono::milliseconds(random() % 50));
    }
  }
  ::close(pipe[1]);
  Id id = 0;
  while (::read(pipe[0], &id, sizeof id) == sizeof id) acknowledged.insert(id);
  ::close(pipe[0]);
  ASSERT_FALSE(acknowledged.empty());
  const auto store = must(Store::open(address));
  const Verification found = must(store->verify());
  EXPECT_THAT(found.problems, testing::IsEmpty());
  EXPECT_EQ(std::set<Id>(acknowledged.begin(), acknowledged.end()).size(), acknowledged.size()) << "a number twice";
  EXPECT_LE(*acknowledged.rbegin(), found.tests);
  for (const Id each : acknowledged) EXPECT_TRUE(store->test(each)) << each;
  EXPECT_EQ(found.tests % 2, 0) << "half a file was kept";
}

}  // namespace
}  // namespace axiometry::store
