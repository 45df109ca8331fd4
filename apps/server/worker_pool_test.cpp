// SPDX-License-Identifier: Apache-2.0
#include "server/worker_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <latch>
#include <thread>

namespace axiometry::server {
namespace {

TEST(WorkerPool, does_every_task_that_it_takes) {
  std::atomic<int> done = 0;
  std::latch all(100);
  WorkerPool pool(4, 100);
  for (int i = 0; i < 100; ++i)
    ASSERT_TRUE(pool.submit([&] {
      ++done;
      all.count_down();
    }));
  all.wait();
  EXPECT_EQ(done, 100);
}

TEST(WorkerPool, takes_no_more_than_may_wait) {
  std::latch begun(1);
  std::latch go_on(1);
  WorkerPool pool(1, 2);
  ASSERT_TRUE(pool.submit([&] {
    begun.count_down();
    go_on.wait();
  }));
  begun.wait();
  EXPECT_TRUE(pool.submit([] {}));
  EXPECT_TRUE(pool.submit([] {}));
  EXPECT_FALSE(pool.submit([] {}));
  go_on.count_down();
}

TEST(WorkerPool, forgets_what_waits_when_it_ends) {
  std::atomic<int> done = 0;
  std::latch begun(1);
  std::latch go_on(1);
  std::thread release;
  {
    WorkerPool pool(1, 10);
    pool.submit([&] {
      begun.count_down();
      go_on.wait();
    });
    begun.wait();
    for (int i = 0; i < 10; ++i) pool.submit([&] { ++done; });
    release = std::thread([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      go_on.count_down();
    });
  }
  release.join();
  EXPECT_EQ(done, 0);
}

}  // namespace
}  // namespace axiometry::server
