// SPDX-License-Identifier: Apache-2.0
// Requests at a dispatcher while memory runs out: each allocation in turn fails once, wherever it is made. A program of
// its own, since it replaces what allocates.
#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <memory>
#include <new>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "server/work/dispatcher.h"

namespace {

constexpr long never = -1;
std::atomic<long> succeed = never;  // so many allocations, before one fails

bool fails_now() {
  long left = succeed.load();
  while (left >= 0 && !succeed.compare_exchange_weak(left, left - 1)) {
  }
  return left == 0;
}

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return fails_now() ? nullptr : std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  void* memory = operator new(size, std::nothrow);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace axiometry::server {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto patience = 5s;
constexpr auto long_for_a_deadline = 30ms;

/// What is tried: how the only request is read, and what the server is like.
struct Trial {
  std::function<Job()> job;
  bool keeps = false;
  std::size_t light_waiting = 10;
  std::size_t heavy_waiting = 10;
  Limits limits{};
};

struct Outcome {
  bool was_refused = false;  // asking threw
  int replies = 0;
  bool is_idle = false;
  bool any_failed = false;
};

/// What a step throws is told and forgotten, as the transport does.
template <typename Condition>
void run_until(boost::asio::io_context& io, const Condition& holds) {
  const auto end = Clock::now() + patience;
  while (!holds() && Clock::now() < end) {
    try {
      io.run_one_for(1ms);
    } catch (const std::bad_alloc&) {
      continue;
    }
  }
}

Outcome tried(const Trial& trial, long allocations) {
  Service service;
  service.queue_of = [](const Request&) { return Load::light; };
  service.keeps = [&](const Request&) { return trial.keeps; };
  service.read = [&](const auto&) { return trial.job(); };
  service.finish = [](Response&) {};
  boost::asio::io_context io{1};
  const auto open = boost::asio::make_work_guard(io);
  Outcome outcome;
  RequestQueues::Options options;
  options.light = {.threads = 1, .waiting_max = trial.light_waiting};
  options.heavy = {.threads = 1, .waiting_max = trial.heavy_waiting};
  std::unique_ptr<RequestQueues> queues;
  Dispatcher dispatcher(io, service, trial.limits, *(queues = std::make_unique<RequestQueues>(options)));
  auto request = std::make_shared<Request>();
  succeed = allocations;
  try {
    dispatcher.ask(std::move(request), "a", [&](const auto&) { ++outcome.replies; });
  } catch (const std::bad_alloc&) {
    outcome.was_refused = true;
  }
  run_until(io, [&] { return outcome.was_refused || outcome.replies > 0; });
  outcome.any_failed = succeed.exchange(never) < 0;
  run_until(io, [&] { return dispatcher.is_idle(); });
  outcome.is_idle = dispatcher.is_idle();
  queues.reset();  // before what its tasks answer to
  return outcome;
}

/// Without any failure at the last.
void every_allocation_may_fail(const Trial& trial) {
  for (long k = 0;; ++k) {
    const Outcome outcome = tried(trial, k);
    EXPECT_EQ(outcome.replies, outcome.was_refused ? 0 : 1) << "where allocation " << k << " fails";
    EXPECT_TRUE(outcome.is_idle) << "where allocation " << k << " fails";
    if (testing::Test::HasFailure()) return;
    if (outcome.any_failed) continue;
    EXPECT_GT(k, 3) << "some were tried";
    return;
  }
}

Job job(Load load, std::function<Response(const std::stop_token&)> answer, std::string key = {}) {
  return {.load = load, .key = std::move(key), .answer = std::move(answer)};
}

Response done(const std::stop_token&) { return {.body = "done"}; }

Response fault(const std::stop_token&) { throw std::bad_alloc(); }

/// A while beyond the deadline of a trial.
Response stopped(const std::stop_token& stop) {
  const auto end = Clock::now() + long_for_a_deadline;
  while (!stop.stop_requested() && Clock::now() < end) std::this_thread::sleep_for(1ms);
  return error_response({"stopped before it was done; nothing was kept", {}, {}, ErrorKind::unavailable}, {});
}

TEST(WithoutMemory, who_asks_for_something_light_is_answered_or_hung_up_on) {
  every_allocation_may_fail({.job = [] { return job(Load::light, done); }});
  every_allocation_may_fail({.job = [] { return job(Load::light, done); }, .light_waiting = 0});
}

TEST(WithoutMemory, who_asks_for_something_heavy_is_answered_or_hung_up_on) {
  const std::string key = "a report whose key is too long to be kept without memory";
  every_allocation_may_fail({.job = [&] { return job(Load::heavy, done, key); }});
  every_allocation_may_fail({.job = [&] { return job(Load::heavy, done, key); }, .heavy_waiting = 0});
}

TEST(WithoutMemory, who_asks_for_what_fails_is_answered_or_hung_up_on) {
  for (const Load load : {Load::light, Load::heavy})
    every_allocation_may_fail({.job = [&] { return job(load, fault); }, .keeps = true});
}

TEST(WithoutMemory, who_waits_beyond_the_deadline_is_answered_or_hung_up_on) {
  for (const bool keeps : {true, false}) {
    Trial trial{.job = [] { return job(Load::light, stopped); }, .keeps = keeps};
    trial.limits.light_deadline = 1ms;
    every_allocation_may_fail(trial);
  }
}

}  // namespace
}  // namespace axiometry::server
