// SPDX-License-Identifier: Apache-2.0
#include "server/http/turnstile.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace axiometry::server {
namespace {

Turnstile::Post posting_to(boost::asio::io_context& io) {
  return [&io](Turnstile::Step step) { boost::asio::post(io, std::move(step)); };
}

TEST(Turnstile, lets_in_one_of_each_peer_in_turn) {
  boost::asio::io_context io{1};
  Turnstile turnstile(posting_to(io));
  std::string came;
  for (const char* who : {"a1", "a2", "a3", "b1", "c1", "b2"})
    turnstile.enter(std::string(1, who[0]), [&came, who] { came += std::string(who) + " "; });
  EXPECT_EQ(came, "");
  io.run();
  EXPECT_EQ(came, "a1 b1 c1 a2 b2 a3 ");
  turnstile.enter("a", [&] { came += "again"; });
  io.restart();
  io.run();
  EXPECT_TRUE(came.ends_with("again"));
}

TEST(Turnstile, lets_others_pass_between_two) {
  boost::asio::io_context io{1};
  Turnstile turnstile(posting_to(io));
  std::string done;
  for (int k = 0; k < 3; ++k)
    turnstile.enter("a", [&] {
      done += "a";
      boost::asio::post(io, [&] { done += "b"; });
    });
  io.run();
  EXPECT_EQ(done, "ababab");
}

TEST(Turnstile, lets_in_the_others_though_a_step_fails) {
  boost::asio::io_context io{1};
  Turnstile turnstile(posting_to(io));
  std::string came;
  turnstile.enter("a", [&] { came += "a"; });
  turnstile.enter("b", [] { throw std::runtime_error("a fault"); });
  for (const char* who : {"a", "b", "c"}) turnstile.enter(who, [&came, who] { came += who; });
  EXPECT_NO_THROW(io.run());
  EXPECT_EQ(came, "acab");
}

TEST(Turnstile, goes_on_after_there_was_no_memory_for_a_turn) {
  boost::asio::io_context io{1};
  bool has_memory = false;
  Turnstile turnstile([&, post = posting_to(io)](Turnstile::Step step) {
    if (!has_memory) throw std::bad_alloc();
    post(std::move(step));
  });
  std::string came;
  EXPECT_THROW(turnstile.enter("lost", [&] { came += "lost"; }), std::bad_alloc);
  has_memory = true;
  turnstile.enter("a", [&] {
    came += "a";
    has_memory = false;
  });
  for (const char* who : {"b", "c"}) turnstile.enter(who, [&came, who] { came += who; });
  io.run();
  EXPECT_EQ(came, "abc");
  has_memory = true;
  turnstile.enter("d", [&] { came += "d"; });
  io.restart();
  io.run();
  EXPECT_EQ(came, "abcd");
}

}  // namespace
}  // namespace axiometry::server
