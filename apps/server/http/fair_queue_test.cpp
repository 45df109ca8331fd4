// SPDX-License-Identifier: Apache-2.0
#include "server/http/fair_queue.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace axiometry::server {
namespace {

FairQueue::Post posting_to(boost::asio::io_context& io) {
  return [&io](FairQueue::Step step) { boost::asio::post(io, std::move(step)); };
}

TEST(FairQueue, lets_in_one_of_each_peer_in_turn) {
  boost::asio::io_context io{1};
  FairQueue fair_queue(posting_to(io));
  std::string came;
  for (const char* who : {"a1", "a2", "a3", "b1", "c1", "b2"})
    fair_queue.enter(std::string(1, who[0]), [&came, who] { came += std::string(who) + " "; });
  EXPECT_EQ(came, "");
  io.run();
  EXPECT_EQ(came, "a1 b1 c1 a2 b2 a3 ");
  fair_queue.enter("a", [&] { came += "again"; });
  io.restart();
  io.run();
  EXPECT_TRUE(came.ends_with("again"));
}

TEST(FairQueue, lets_others_pass_between_two) {
  boost::asio::io_context io{1};
  FairQueue fair_queue(posting_to(io));
  std::string done;
  for (int k = 0; k < 3; ++k)
    fair_queue.enter("a", [&] {
      done += "a";
      boost::asio::post(io, [&] { done += "b"; });
    });
  io.run();
  EXPECT_EQ(done, "ababab");
}

TEST(FairQueue, lets_in_the_others_though_a_step_fails) {
  boost::asio::io_context io{1};
  FairQueue fair_queue(posting_to(io));
  std::string came;
  fair_queue.enter("a", [&] { came += "a"; });
  fair_queue.enter("b", [] { throw std::runtime_error("a fault"); });
  for (const char* who : {"a", "b", "c"}) fair_queue.enter(who, [&came, who] { came += who; });
  EXPECT_NO_THROW(io.run());
  EXPECT_EQ(came, "acab");
}

TEST(FairQueue, goes_on_after_there_was_no_memory_for_a_turn) {
  boost::asio::io_context io{1};
  bool has_memory = false;
  FairQueue fair_queue([&, post = posting_to(io)](FairQueue::Step step) {
    if (!has_memory) throw std::bad_alloc();
    post(std::move(step));
  });
  std::string came;
  EXPECT_THROW(fair_queue.enter("lost", [&] { came += "lost"; }), std::bad_alloc);
  has_memory = true;
  fair_queue.enter("a", [&] {
    came += "a";
    has_memory = false;
  });
  for (const char* who : {"b", "c"}) fair_queue.enter(who, [&came, who] { came += who; });
  io.run();
  EXPECT_EQ(came, "abc");
  has_memory = true;
  fair_queue.enter("d", [&] { came += "d"; });
  io.restart();
  io.run();
  EXPECT_EQ(came, "abcd");
}

}  // namespace
}  // namespace axiometry::server
