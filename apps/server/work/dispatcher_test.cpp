// SPDX-License-Identifier: Apache-2.0
#include "server/work/dispatcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <latch>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace axiometry::server {
namespace {

using namespace std::chrono_literals;

constexpr WorkerPool::Options single_worker{.threads = 1, .waiting_max = 10};
constexpr WorkerPool::Options two_of_them{.threads = 2, .waiting_max = 10};

/// A dispatcher whose requests say by their path what they are: a name of `jobs`.
struct Office {
  Service service;
  Limits limits;
  std::map<std::string, Job> jobs;
  boost::asio::io_context io{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> open{io.get_executor()};
  std::unique_ptr<Dispatcher> dispatcher;
  std::unique_ptr<RequestQueues> queues;
  std::vector<std::string> replies;

  explicit Office(WorkerPool::Options light = single_worker, WorkerPool::Options heavy = two_of_them) {
    service.queue_of = [](const Request&) { return Load::light; };
    service.read = [this](const std::shared_ptr<Request>& request) { return jobs.at(request->path); };
    service.finish = [](Response&) {};
    queues =
        std::make_unique<RequestQueues>(RequestQueues::Options{.light = light, .edits = single_worker, .heavy = heavy});
    dispatcher = std::make_unique<Dispatcher>(io, service, limits, *queues);
  }

  Dispatcher::Ticket ask(const std::string& path, const std::string& who = "a") {
    return ask(path, who, [this](const std::shared_ptr<const Response>& response) {
      replies.push_back(std::to_string(response->status) + " " + response->body);
    });
  }
  Dispatcher::Ticket ask(const std::string& path, const std::string& who, Dispatcher::Reply reply) {
    auto request = std::make_shared<Request>();
    request->path = path;
    return dispatcher->ask(std::move(request), who, std::move(reply));
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

TEST(Dispatcher, answers_what_is_asked) {
  Office office;
  office.jobs["/light"] = job(Load::light, [](const auto&) { return "quick"; });
  office.jobs["/report"] = job(Load::heavy, [](const auto&) { return "long"; });
  office.ask("/light");
  office.run_until_replies(1);
  office.ask("/report");
  office.run_until_replies(2);
  EXPECT_EQ(office.replies, (std::vector<std::string>{"200 quick", "200 long"}));
}

TEST(Dispatcher, makes_once_what_several_ask_for_at_once) {
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
  office.run_until([&] { return office.dispatcher->waiting_for("report of test 1") == 3; });
  go_on.count_down();
  office.run_until_replies(3);
  EXPECT_EQ(office.replies, (std::vector<std::string>(3, "200 1")));
  EXPECT_EQ(office.dispatcher->waiting_for("report of test 1"), 0U);
  office.ask("/report");
  office.run_until_replies(4);
  EXPECT_EQ(office.replies.back(), "200 2") << "nothing is kept for who asks later";
}

TEST(Dispatcher, stops_what_nobody_waits_for_and_goes_on_for_who_stays) {
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
  office.run_until([&] { return office.dispatcher->waiting_for("trials") == 2; });
  begun.wait();
  EXPECT_TRUE(office.dispatcher->leave(first));
  EXPECT_EQ(office.dispatcher->waiting_for("trials"), 1U);
  EXPECT_TRUE(office.dispatcher->leave(second));
  EXPECT_FALSE(office.dispatcher->is_idle()) << "is told to stop, and has not ended yet";
  ended.wait();
  office.run_until([&] { return office.dispatcher->is_idle(); });
  EXPECT_EQ(office.dispatcher->waiting_for("trials"), 0U);
  EXPECT_TRUE(office.replies.empty());
  EXPECT_FALSE(office.dispatcher->leave(second));
}

TEST(Dispatcher, does_an_edit_though_its_client_has_left) {
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
  EXPECT_FALSE(office.dispatcher->leave(ticket));
  go_on.count_down();
  office.run_until_replies(1);
  EXPECT_TRUE(kept.try_wait());
}

TEST(Dispatcher, does_to_the_end_whatever_may_keep_something_though_its_client_has_left) {
  std::latch begun(1);
  Office office;
  office.service.keeps = [](const Request& request) { return request.path != "/trials"; };
  office.jobs["/trials"] = job(Load::lone, [&](const std::stop_token& stop) {
    begun.count_down();
    return wait_for(stop);
  });
  office.jobs["/edit with trials"] = job(
      Load::lone, [](const std::stop_token& stop) { return std::string(stop.stop_requested() ? "stopped" : "kept"); },
      "edit");
  const auto trials = office.ask("/trials");
  office.run_until([&] { return begun.try_wait(); });
  const auto in_line = office.ask("/edit with trials");
  office.run_until(
      [&] { return office.dispatcher->waiting_for("edit") == 1; });  // behind the trials, among what is heavy
  const bool is_forgotten = office.dispatcher->leave(in_line);
  EXPECT_TRUE(office.dispatcher->leave(trials));
  ASSERT_FALSE(is_forgotten);
  office.run_until_replies(1);
  EXPECT_EQ(office.replies.front(), "200 kept");
}

TEST(Dispatcher, waits_for_the_true_answer_of_what_may_have_been_kept_at_the_deadline) {
  Office office;
  office.limits.light_deadline = 1ms;
  office.service.keeps = [](const Request&) { return true; };
  office.jobs["/edit"] = job(Load::light, [](const std::stop_token& stop) {
    wait_for(stop);
    return "kept";
  });
  office.ask("/edit");
  office.run_until_replies(1);
  EXPECT_EQ(office.replies, std::vector<std::string>{"200 kept"});
}

std::optional<std::string> retry_after(const Response& response) {
  for (const auto& [name, value] : response.headers)
    if (name == "Retry-After") return value;
  return {};
}

TEST(Dispatcher, tells_who_was_stopped_before_anything_was_kept_why_and_when_to_come_again) {
  Office office;
  office.limits.light_deadline = 1ms;
  office.service.keeps = [](const Request&) { return true; };
  office.jobs["/edit"] = {
      .load = Load::light, .answer = [](const std::stop_token& stop) {
        wait_for(stop);
        const Error error{"stopped before it was done; nothing was kept", {}, {}, ErrorKind::unavailable};
        return error_response(error, language::Language::english);
      }};
  std::shared_ptr<const Response> told;
  office.ask("/edit", "a", [&](const auto& response) { told = response; });
  office.run_until([&] { return told != nullptr; });
  EXPECT_EQ(told->status, 503);
  EXPECT_EQ(retry_after(*told), "10");
  EXPECT_NE(told->body.find("took longer than 0.001 s"), std::string::npos) << told->body;
  EXPECT_NE(told->body.find("nothing was kept"), std::string::npos) << told->body;
}

TEST(Dispatcher, begins_nothing_that_may_keep_something_where_the_deadline_has_passed_while_it_was_read) {
  std::latch reading(1);
  std::latch go_on(1);
  std::atomic<bool> begun = false;
  Office office;
  office.limits.light_deadline = 1ms;
  office.service.keeps = [](const Request&) { return true; };
  office.service.read = [&](const auto&) {
    reading.count_down();
    go_on.wait();
    return job(Load::heavy, [&](const auto&) {
      begun = true;
      return "kept";
    });
  };
  std::shared_ptr<const Response> told;
  office.ask("/edit", "a", [&](const auto& response) { told = response; });
  reading.wait();
  bool has_passed = false;  // a timer that is set later and for longer
  boost::asio::steady_timer later(office.io);
  boost::asio::post(office.io, [&] {
    later.expires_after(2ms);
    later.async_wait([&](const auto&) { has_passed = true; });
  });
  office.run_until([&] { return has_passed; });
  go_on.count_down();
  office.run_until([&] { return told != nullptr; });
  EXPECT_EQ(told->status, 503);
  EXPECT_EQ(retry_after(*told), "10");
  EXPECT_FALSE(begun);
}

TEST(Dispatcher, says_that_nobody_knows_what_was_kept_where_the_work_does_not_end) {
  std::latch go_on(1);
  Office office;
  office.limits.light_deadline = 1ms;
  office.limits.outcome_deadline = 1ms;
  office.service.keeps = [](const Request&) { return true; };
  office.jobs["/edit"] = job(Load::light, [&](const auto&) {
    go_on.wait();
    return "kept";
  });
  office.ask("/edit");
  office.run_until_replies(1);
  go_on.count_down();
  EXPECT_TRUE(office.replies.front().starts_with("504 ")) << office.replies.front();
  EXPECT_NE(office.replies.front().find("whether anything was kept is not known"), std::string::npos);
  EXPECT_FALSE(office.dispatcher->is_idle());
  office.run_until([&] { return office.dispatcher->is_idle(); });
  EXPECT_EQ(office.replies.size(), 1U);
}

TEST(Dispatcher, marks_the_answer_of_what_may_keep_something_as_one_to_give_in_any_case) {
  Office office;
  office.service.keeps = [](const Request& request) { return request.path == "/edit"; };
  std::map<std::string, bool> receipts;
  for (const std::string path : {"/edit", "/list"}) {
    office.jobs[path] = job(Load::light, [](const auto&) { return "done"; });
    office.ask(path, "a", [&receipts, path](const auto& response) { receipts[path] = response->is_receipt; });
  }
  office.run_until([&] { return receipts.size() == 2; });
  EXPECT_EQ(receipts, (std::map<std::string, bool>{{"/edit", true}, {"/list", false}}));
}

TEST(Dispatcher, answers_the_others_though_one_cannot_be_given_the_answer) {
  std::latch go_on(1);
  Office office;
  office.jobs["/report"] = job(
      Load::heavy,
      [&](const auto&) {
        go_on.wait();
        return "done";
      },
      "report");
  int hung_up = 0;
  office.ask("/report", "a", [&](const std::shared_ptr<const Response>& response) {
    if (response) throw std::bad_alloc();
    ++hung_up;
  });
  office.ask("/report", "b");
  office.run_until([&] { return office.dispatcher->waiting_for("report") == 2; });
  go_on.count_down();
  office.run_until_replies(1);
  EXPECT_EQ(office.replies, std::vector<std::string>{"200 done"});
  EXPECT_EQ(hung_up, 1);
}

TEST(Dispatcher, hangs_up_on_all_where_there_is_no_memory_for_an_answer) {
  Office office;
  office.service.finish = [](Response&) { throw std::bad_alloc(); };
  office.jobs["/light"] = job(Load::light, [](const auto&) { return "quick"; });
  bool hung_up = false;
  office.ask("/light", "a", [&](const auto& response) { hung_up = response == nullptr; });
  office.run_until([&] { return hung_up; });
  EXPECT_TRUE(office.dispatcher->is_idle());
}

TEST(Dispatcher, lets_nobody_wait_beyond_the_deadline_and_stops_the_work) {
  Office office;
  office.limits.lone_deadline = 1ms;
  office.jobs["/trials"] = job(Load::lone, wait_for, "trials");
  office.ask("/trials");
  office.run_until_replies(1);
  EXPECT_TRUE(office.replies.front().starts_with("503 ")) << office.replies.front();
  EXPECT_NE(office.replies.front().find("took longer than 0.001 s"), std::string::npos) << office.replies.front();
  EXPECT_EQ(office.dispatcher->waiting_for("trials"), 0U);
}

TEST(Dispatcher, says_that_a_line_is_full) {
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
  auto event = SecurityEvent::none;
  office.ask("/more", "a", [&](const std::shared_ptr<const Response>& response) {
    event = response->event;
    office.replies.push_back(std::to_string(response->status) + " ");
  });
  office.run_until_replies(1);
  EXPECT_EQ(event, SecurityEvent::quota_refused);
  EXPECT_TRUE(office.replies.front().starts_with("503 ")) << office.replies.front();
  go_on.count_down();
  office.run_until_replies(3);
}

TEST(Dispatcher, ends_a_request_that_fails_and_no_other) {
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

TEST(Dispatcher, does_not_say_that_nothing_was_kept_where_what_failed_may_have_kept_something) {
  Office office;
  office.service.keeps = [](const Request&) { return true; };
  office.jobs["/light edit"] = job(Load::light, [](const auto&) -> std::string { throw std::bad_alloc(); });
  office.jobs["/heavy edit"] = job(Load::heavy, [](const auto&) -> std::string { throw std::bad_alloc(); });
  for (const std::string path : {"/light edit", "/heavy edit", "/unknown"}) {  // reading the last throws
    office.ask(path);
    office.run_until([&] { return !office.replies.empty(); });
    const std::string reply = std::exchange(office.replies, {}).front();
    EXPECT_TRUE(reply.starts_with("500 ")) << reply;
    const bool says_nothing_was_kept = reply.contains("nothing was kept");
    EXPECT_EQ(says_nothing_was_kept, path == "/unknown") << path << ": " << reply;
    EXPECT_NE(reply.contains("whether anything was kept is not known"), says_nothing_was_kept) << path << ": " << reply;
  }
}

}  // namespace
}  // namespace axiometry::server
