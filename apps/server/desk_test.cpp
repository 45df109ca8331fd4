// SPDX-License-Identifier: Apache-2.0
#include "server/desk.h"

#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <latch>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace axiometry::server {
namespace {

using namespace std::chrono_literals;

constexpr WorkerPool::Options single_worker{.threads = 1, .waiting_max = 10};
constexpr WorkerPool::Options two_of_them{.threads = 2, .waiting_max = 10};

/// A desk whose requests say by their path what they are: a name of `jobs`.
struct Office {
  Service service;
  Limits limits;
  std::map<std::string, Job> jobs;
  boost::asio::io_context io{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> open{io.get_executor()};
  std::unique_ptr<Desk> desk;
  std::unique_ptr<Lines> lines;
  std::vector<std::string> replies;

  explicit Office(WorkerPool::Options light = single_worker, WorkerPool::Options heavy = two_of_them) {
    service.line_of = [](const Request&) { return Load::light; };
    service.read = [this](const std::shared_ptr<Request>& request) { return jobs.at(request->path); };
    service.finish = [](Response&) {};
    lines = std::make_unique<Lines>(Lines::Options{.light = light, .edits = single_worker, .heavy = heavy});
    desk = std::make_unique<Desk>(io, service, limits, *lines);
  }

  Desk::Ticket ask(const std::string& path, const std::string& who = "a") {
    auto request = std::make_shared<Request>();
    request->path = path;
    return desk->ask(std::move(request), who, [this](const std::shared_ptr<const Response>& response) {
      replies.push_back(std::to_string(response->status) + " " + response->body);
    });
  }

  template <typename Condition>
  void run_until(const Condition& holds) {
    while (!holds()) io.run_one_for(1ms);
  }
  void run_until_replies(std::size_t count) {
    run_until([&] { return replies.size() >= count; });
  }
};

Job job(Load load, std::function<std::string(const std::stop_token&)> make, std::string key = {}) {
  return {.load = load, .key = std::move(key), .answer = [make = std::move(make)](const std::stop_token& stop) {
            return Response{.body = make(stop)};
          }};
}

std::string wait_for(const std::stop_token& stop) {
  std::latch told(1);
  const std::stop_callback on_stop(stop, [&] { told.count_down(); });
  told.wait();
  return "stopped";
}

TEST(Desk, answers_what_is_asked) {
  Office office;
  office.jobs["/light"] = job(Load::light, [](const auto&) { return "quick"; });
  office.jobs["/report"] = job(Load::heavy, [](const auto&) { return "long"; });
  office.ask("/light");
  office.run_until_replies(1);
  office.ask("/report");
  office.run_until_replies(2);
  EXPECT_EQ(office.replies, (std::vector<std::string>{"200 quick", "200 long"}));
}

TEST(Desk, makes_once_what_several_ask_for_at_once) {
  std::latch go_on(1);
  std::atomic<int> made = 0;
  Office office;
  office.jobs["/report"] = job(
      Load::heavy,
      [&](const auto&) {
        go_on.wait();
        return std::to_string(++made);
      },
      "report of test 1");
  for (const std::string who : {"a", "b", "c"}) office.ask("/report", who);
  office.run_until([&] { return office.desk->waiting_for("report of test 1") == 3; });
  go_on.count_down();
  office.run_until_replies(3);
  EXPECT_EQ(office.replies, (std::vector<std::string>(3, "200 1")));
  EXPECT_EQ(office.desk->waiting_for("report of test 1"), 0U);
  office.ask("/report");
  office.run_until_replies(4);
  EXPECT_EQ(office.replies.back(), "200 2") << "nothing is kept for who asks later";
}

TEST(Desk, stops_what_nobody_waits_for_and_goes_on_for_who_stays) {
  std::latch begun(1);
  std::latch ended(1);
  Office office;
  office.jobs["/trials"] = job(
      Load::lone,
      [&](const std::stop_token& stop) {
        begun.count_down();
        std::string text = wait_for(stop);
        ended.count_down();
        return text;
      },
      "trials");
  const auto first = office.ask("/trials", "a");
  const auto second = office.ask("/trials", "b");
  office.run_until([&] { return office.desk->waiting_for("trials") == 2; });
  begun.wait();
  EXPECT_TRUE(office.desk->leave(first));
  EXPECT_EQ(office.desk->waiting_for("trials"), 1U);
  EXPECT_TRUE(office.desk->leave(second));
  EXPECT_FALSE(office.desk->is_idle()) << "is told to stop, and has not ended yet";
  ended.wait();
  office.run_until([&] { return office.desk->is_idle(); });
  EXPECT_EQ(office.desk->waiting_for("trials"), 0U);
  EXPECT_TRUE(office.replies.empty());
  EXPECT_FALSE(office.desk->leave(second));
}

TEST(Desk, does_an_edit_though_its_client_has_left) {
  std::latch begun(1);
  std::latch go_on(1);
  std::latch kept(1);
  Office office;
  office.jobs["/edit"] = job(Load::edit, [&](const std::stop_token& stop) {
    begun.count_down();
    go_on.wait();
    if (!stop.stop_requested()) kept.count_down();
    return "kept";
  });
  const auto ticket = office.ask("/edit");
  office.run_until([&] { return begun.try_wait(); });
  EXPECT_FALSE(office.desk->leave(ticket));
  go_on.count_down();
  office.run_until_replies(1);
  EXPECT_TRUE(kept.try_wait());
}

TEST(Desk, lets_nobody_wait_beyond_the_deadline_and_stops_the_work) {
  Office office;
  office.limits.lone_deadline = 1ms;
  office.jobs["/trials"] = job(Load::lone, wait_for, "trials");
  office.ask("/trials");
  office.run_until_replies(1);
  EXPECT_TRUE(office.replies.front().starts_with("503 ")) << office.replies.front();
  EXPECT_NE(office.replies.front().find("took longer than 0.001 s"), std::string::npos) << office.replies.front();
  EXPECT_EQ(office.desk->waiting_for("trials"), 0U);
}

TEST(Desk, says_that_a_line_is_full) {
  std::latch begun(1);
  std::latch go_on(1);
  Office office(single_worker, {.threads = 1, .waiting_max = 1});
  office.jobs["/busy"] = job(Load::heavy, [&](const auto&) {
    begun.count_down();
    go_on.wait();
    return "done";
  });
  office.jobs["/more"] = job(Load::heavy, [](const auto&) { return "more"; });
  office.ask("/busy");
  office.run_until([&] { return begun.try_wait(); });
  office.ask("/more");
  office.ask("/more");
  office.run_until_replies(1);
  EXPECT_TRUE(office.replies.front().starts_with("503 ")) << office.replies.front();
  go_on.count_down();
  office.run_until_replies(3);
}

TEST(Desk, ends_a_request_that_fails_and_no_other) {
  Office office;
  office.jobs["/fault"] = job(Load::heavy, [](const auto&) -> std::string { throw std::bad_alloc(); });
  office.jobs["/light"] = job(Load::light, [](const auto&) { return "quick"; });
  office.ask("/fault");
  office.ask("/unknown");  // reading it throws
  office.ask("/light");
  office.run_until_replies(3);
  std::ranges::sort(office.replies);
  EXPECT_EQ(office.replies[0], "200 quick");
  EXPECT_TRUE(office.replies[1].starts_with("500 ")) << office.replies[1];
  EXPECT_TRUE(office.replies[2].starts_with("500 ")) << office.replies[2];
}

}  // namespace
}  // namespace axiometry::server
