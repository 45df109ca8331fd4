// SPDX-License-Identifier: Apache-2.0
#include "server/work/worker_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace axiometry::server {
namespace {

TEST(WorkerPool, does_every_task_that_it_takes) {
  std::atomic<int> done = 0;
  std::latch all(100);
  WorkerPool pool({.threads = 4, .waiting_max = 100});
  for (int i = 0; i < 100; ++i)
    ASSERT_TRUE(pool.submit("a", [&] {
      ++done;
      all.count_down();
    }));
  all.wait();
  EXPECT_EQ(done, 100);
}

TEST(WorkerPool, takes_no_more_than_may_wait) {
  std::latch begun(1);
  std::latch go_on(1);
  WorkerPool pool({.threads = 1, .waiting_max = 2});
  ASSERT_TRUE(pool.submit("a", [&] {
    begun.count_down();
    go_on.wait();
  }));
  begun.wait();
  EXPECT_TRUE(pool.submit("a", [] {}));
  EXPECT_TRUE(pool.submit("a", [] {}));
  EXPECT_FALSE(pool.submit("a", [] {}));
  go_on.count_down();
}

TEST(WorkerPool, forgets_what_waits_when_it_ends) {
  std::atomic<int> done = 0;
  std::latch begun(1);
  std::latch go_on(1);
  std::thread release;
  {
    WorkerPool pool({.threads = 1, .waiting_max = 1'000'000});
    pool.submit("a", [&] {
      begun.count_down();
      go_on.wait();
    });
    begun.wait();
    for (int i = 0; i < 10; ++i) pool.submit("a", [&] { ++done; });
    release = std::thread([&] {  // the busy one, once the pool takes nothing more, and so has begun to end
      while (pool.submit("a", [&] { ++done; })) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      go_on.count_down();
    });
  }
  release.join();
  EXPECT_EQ(done, 0);
}

/// A pool of one thread that is busy until told, so that all others wait.
struct BusyPool {
  std::latch begun{1};
  std::latch go_on{1};
  std::vector<std::string> done;  // by the one thread alone
  std::latch all;
  WorkerPool pool;

  BusyPool(std::size_t waiting_max, std::size_t reserved, std::ptrdiff_t tasks)
      : all(tasks), pool({.threads = 1, .waiting_max = waiting_max, .reserved = reserved}) {
    pool.submit("busy", [this] {
      begun.count_down();
      go_on.wait();
    });
    begun.wait();
  }

  std::optional<WorkerPool::Ticket> submit(const std::string& who, const std::string& name) {
    return pool.submit(who, [this, name] {
      done.push_back(name);
      all.count_down();
    });
  }

  std::vector<std::string> finish() {
    go_on.count_down();
    all.wait();
    return done;
  }
};

TEST(WorkerPool, lets_those_who_ask_take_turns) {
  BusyPool busy(20, 0, 6);
  for (const std::string name : {"a1", "a2", "a3", "a4"}) busy.submit("a", name);
  busy.submit("b", "b1");
  busy.submit("c", "c1");
  EXPECT_THAT(busy.finish(), ::testing::ElementsAre("a1", "b1", "c1", "a2", "a3", "a4"));
}

TEST(WorkerPool, keeps_its_last_places_for_those_who_have_none) {
  BusyPool busy(8, 2, 8);
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(busy.submit("a", "a"));
  EXPECT_FALSE(busy.submit("a", "a"));
  EXPECT_TRUE(busy.submit("b", "b"));
  EXPECT_FALSE(busy.submit("b", "b"));
  EXPECT_TRUE(busy.submit("c", "c"));
  EXPECT_FALSE(busy.submit("d", "d"));
  busy.finish();
}

TEST(WorkerPool, gives_the_place_of_a_withdrawn_task_to_another) {
  BusyPool busy(2, 0, 2);
  const auto first = busy.submit("a", "a1");
  EXPECT_TRUE(busy.submit("b", "b1"));
  ASSERT_TRUE(first);
  EXPECT_FALSE(busy.submit("c", "c1"));
  EXPECT_TRUE(busy.pool.withdraw(*first));
  EXPECT_FALSE(busy.pool.withdraw(*first));
  EXPECT_TRUE(busy.submit("c", "c1"));
  EXPECT_THAT(busy.finish(), ::testing::ElementsAre("b1", "c1"));
}

TEST(WorkerPool, does_lone_tasks_one_after_another_and_others_beside_them) {
  std::latch begun(1);
  std::latch go_on(1);
  std::latch beside(1);
  std::latch all(3);
  std::atomic<int> running = 0;
  std::atomic<bool> together = false;
  WorkerPool pool({.threads = 4, .waiting_max = 10});
  const auto wait_and_end = [&] {
    if (++running > 1) together = true;
    go_on.wait();
    --running;
    all.count_down();
  };
  ASSERT_TRUE(pool.submit(
      "a",
      [&] {
        begun.count_down();
        wait_and_end();
      },
      true));
  begun.wait();
  ASSERT_TRUE(pool.submit("a", wait_and_end, true));
  const auto third = pool.submit("b", wait_and_end, true);
  ASSERT_TRUE(third);
  ASSERT_TRUE(pool.submit("a", [&] { beside.count_down(); }));
  beside.wait();
  const bool withdrawn = pool.withdraw(*third);
  EXPECT_TRUE(withdrawn) << "waits in the line, not on a thread";
  if (withdrawn) all.count_down();
  go_on.count_down();
  all.wait();
  EXPECT_FALSE(together);
}

TEST(WorkerPool, goes_on_after_a_task_that_throws) {
  std::latch done(1);
  WorkerPool pool({.threads = 1, .waiting_max = 2});
  ASSERT_TRUE(pool.submit("a", [] { throw std::runtime_error("on purpose"); }));
  ASSERT_TRUE(pool.submit(
      "a", [&] { done.count_down(); }, true));
  done.wait();
}

TEST(WorkerPool, does_what_has_begun) {
  std::latch begun(1);
  std::latch go_on(1);
  WorkerPool pool({.threads = 1, .waiting_max = 1});
  const auto ticket = pool.submit("a", [&] {
    begun.count_down();
    go_on.wait();
  });
  begun.wait();
  ASSERT_TRUE(ticket);
  EXPECT_FALSE(pool.withdraw(*ticket));
  go_on.count_down();
}

}  // namespace
}  // namespace axiometry::server
