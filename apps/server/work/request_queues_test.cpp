// SPDX-License-Identifier: Apache-2.0
#include "server/work/request_queues.h"

#include <gtest/gtest.h>

#include <latch>

namespace axiometry::server {
namespace {

constexpr WorkerPool::Options one_worker{.threads = 1, .waiting_max = 10};

/// All workers for reports are busy until told, and more reports wait.
struct UnderReports {
  std::latch begun{1};
  std::latch go_on{1};
  RequestQueues queues{{.light = one_worker, .edits = one_worker, .heavy = one_worker}};

  UnderReports() {
    queues.submit(Load::heavy, "a", [this] {
      begun.count_down();
      go_on.wait();
    });
    begun.wait();
    for (int i = 0; i < 9; ++i) queues.submit(Load::heavy, "b", [] {});
  }
  ~UnderReports() { go_on.count_down(); }
};

TEST(RequestQueues, let_an_edit_pass_all_reports) {
  UnderReports reports;
  std::latch saved(1);
  ASSERT_TRUE(reports.queues.submit(Load::edit, "c", [&] { saved.count_down(); }));
  saved.wait();
}

TEST(RequestQueues, let_an_edit_pass_what_only_reads) {
  std::latch begun(1);
  std::latch go_on(1);
  std::latch saved(1);
  RequestQueues queues({.light = one_worker, .edits = one_worker, .heavy = one_worker});
  ASSERT_TRUE(queues.submit(Load::light, "a", [&] {
    begun.count_down();
    go_on.wait();
  }));
  begun.wait();
  ASSERT_TRUE(queues.submit(Load::edit, "a", [&] { saved.count_down(); }));
  saved.wait();
  go_on.count_down();
}

TEST(RequestQueues, put_lone_tasks_with_the_heavy_ones) {
  UnderReports reports;
  const auto place = reports.queues.submit(Load::lone, "c", [] {});
  ASSERT_TRUE(place);
  EXPECT_TRUE(reports.queues.withdraw(*place));
  EXPECT_FALSE(reports.queues.withdraw(*place));
}

}  // namespace
}  // namespace axiometry::server
