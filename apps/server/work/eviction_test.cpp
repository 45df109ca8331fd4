// SPDX-License-Identifier: Apache-2.0
#include "server/work/eviction.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace axiometry::server {
namespace {

using Doing = ConnectionState::Doing;
using std::chrono::seconds;

constexpr ConnectionState::Clock::time_point now{std::chrono::hours(1)};

ConnectionState state_of(std::string_view peer, Doing doing, int seconds_ago, std::size_t bytes = 0) {
  return {peer, doing, now - seconds(seconds_ago), bytes};
}

TEST(Room, is_there_until_all_places_are_taken) {
  const std::vector all = {state_of("a", Doing::idle, 9), state_of("b", Doing::idle, 9)};
  EXPECT_FALSE(room_for(all, "a", 3, 3, now).is_full);
  EXPECT_TRUE(room_for(all, "a", 2, 3, now).is_full);
}

TEST(Room, is_made_by_the_peer_that_has_most) {
  const std::vector all = {state_of("honest", Doing::silent, 9), state_of("many", Doing::idle, 1),
                           state_of("many", Doing::idle, 2)};
  EXPECT_EQ(room_for(all, "newcomer", 3, 3, now).goes, 2);
}

TEST(Room, is_made_by_the_silent_before_the_idle_and_by_these_before_those_that_stand_still) {
  std::vector all = {state_of("a", Doing::sending, 20), state_of("a", Doing::idle, 10), state_of("a", Doing::silent, 1),
                     state_of("a", Doing::waiting, 30)};
  const auto goes = [&] { return room_for(all, "a", 1, 100, now).goes; };
  EXPECT_EQ(goes(), 2);
  all[2].doing = Doing::waiting;
  EXPECT_EQ(goes(), 1);
  all[1].doing = Doing::waiting;
  EXPECT_EQ(goes(), 0);
  all[0].since = now;
  EXPECT_EQ(goes(), std::nullopt) << "what moves and what computes stays";
}

TEST(Room, of_one_peer_is_its_share_though_others_have_none) {
  const std::vector all = {state_of("many", Doing::idle, 3), state_of("many", Doing::idle, 4),
                           state_of("one", Doing::idle, 9)};
  const Room room = room_for(all, "many", 100, 2, now);
  EXPECT_TRUE(room.is_full);
  EXPECT_EQ(room.goes, 1);
  EXPECT_FALSE(room_for(all, "one", 100, 2, now).is_full);
}

TEST(Room, is_made_by_the_next_peer_where_all_of_the_largest_wait_for_answers) {
  const std::vector all = {state_of("computes", Doing::waiting, 9), state_of("computes", Doing::waiting, 9),
                           state_of("silent", Doing::silent, 9)};
  EXPECT_EQ(room_for(all, "newcomer", 3, 3, now).goes, 2);
}

/// Who gives back what it holds so that `peer` can hold more of an answer, where nothing is free.
std::optional<std::size_t> gives_back(const std::vector<ConnectionState>& all, std::string_view peer) {
  std::size_t held = 0;
  for (const ConnectionState& one : all) held += one.bytes;
  const Room room = memory_for(all, {.peer = peer, .bytes = 1}, held, now);
  EXPECT_TRUE(room.is_full);
  return room.goes;
}

TEST(Memory, comes_back_from_the_peer_that_holds_most) {
  const std::vector all = {state_of("small", Doing::sending, 9, 10), state_of("large", Doing::sending, 1, 60),
                           state_of("large", Doing::receiving, 2, 60), state_of("large", Doing::waiting, 9, 60)};
  EXPECT_EQ(gives_back(all, "small"), 2);
}

TEST(Memory, of_ones_own_comes_back_only_where_nothing_moves) {
  std::vector all = {state_of("a", Doing::sending, 1, 60), state_of("a", Doing::sending, 5, 60)};
  EXPECT_EQ(gives_back(all, "a"), 1);
  all[1].since = now;
  EXPECT_EQ(gives_back(all, "a"), std::nullopt);
}

TEST(Memory, is_not_taken_from_those_who_hold_none) {
  const std::vector all = {state_of("a", Doing::idle, 100), state_of("b", Doing::waiting, 100, 60)};
  EXPECT_EQ(gives_back(all, "c"), std::nullopt);
}

TEST(Memory, comes_back_from_the_next_peer_where_all_of_the_largest_waits) {
  const std::vector all = {state_of("computes", Doing::waiting, 9, 60), state_of("reads", Doing::sending, 1, 10)};
  EXPECT_EQ(gives_back(all, "newcomer"), 1);
}

TEST(Memory, is_not_taken_by_who_holds_more_from_who_goes_on_with_less) {
  std::vector all = {state_of("large", Doing::waiting, 9, 60), state_of("small", Doing::sending, 1, 10)};
  EXPECT_EQ(gives_back(all, "large"), std::nullopt);
  all[1].since = now - seconds(5);
  EXPECT_EQ(gives_back(all, "large"), 1) << "but from who stands still";
}

TEST(Memory, of_bodies_leaves_a_quarter_for_answers) {
  const std::vector all = {state_of("a", Doing::waiting, 9, 40), state_of("b", Doing::waiting, 9, 30)};
  EXPECT_FALSE(memory_for(all, {.peer = "c", .bytes = 5, .of_body = true}, 100, now).is_full);
  EXPECT_TRUE(memory_for(all, {.peer = "c", .bytes = 6, .of_body = true}, 100, now).is_full);
  EXPECT_FALSE(memory_for(all, {.peer = "c", .bytes = 30}, 100, now).is_full);
  EXPECT_TRUE(memory_for(all, {.peer = "c", .bytes = 31}, 100, now).is_full);
}

TEST(Memory, of_one_peer_is_half_of_it_for_bodies_and_half_for_answers) {
  std::vector all = {state_of("a", Doing::waiting, 9, 45)};
  EXPECT_FALSE(memory_for(all, {.peer = "a", .bytes = 5, .of_body = true}, 100, now).is_full);
  EXPECT_TRUE(memory_for(all, {.peer = "a", .bytes = 6, .of_body = true}, 100, now).is_full);
  EXPECT_FALSE(memory_for(all, {.peer = "a", .bytes = 50}, 100, now).is_full);
  all[0].doing = Doing::sending;
  const Room room = memory_for(all, {.peer = "a", .bytes = 6}, 100, now);
  EXPECT_TRUE(room.is_full);
  EXPECT_EQ(room.goes, 0) << "which stands still";
  EXPECT_FALSE(memory_for({}, {.peer = "a", .bytes = 80}, 100, now).is_full) << "nothing else is on its way";
}

TEST(Memory, for_a_body_comes_back_from_bodies_alone_where_these_have_their_share) {
  const std::vector all = {state_of("a", Doing::waiting, 9, 40), state_of("b", Doing::receiving, 9, 35),
                           state_of("d", Doing::sending, 20, 20)};
  EXPECT_EQ(memory_for(all, {.peer = "c", .bytes = 1, .of_body = true}, 100, now).goes, 1);
}

constexpr std::size_t most = 80 * small_body;  // 10 of these for small bodies, 60 for all

std::vector<ConnectionState> waiting(std::string_view peer, std::size_t count, std::size_t bytes) {
  return std::vector<ConnectionState>(count, state_of(peer, Doing::waiting, 9, bytes));
}

TEST(Memory, has_a_share_for_small_bodies_which_large_ones_do_not_take) {
  std::vector all = {state_of("a", Doing::waiting, 9, 30 * small_body),
                     state_of("b", Doing::waiting, 9, 19 * small_body)};
  const auto fits = [&](const MemoryClaim& claim) { return !memory_for(all, claim, most, now).is_full; };
  EXPECT_TRUE(fits({.peer = "c", .bytes = small_body, .of_body = true, .held = small_body}));
  EXPECT_FALSE(fits({.peer = "c", .bytes = small_body + 1, .of_body = true, .held = small_body}));
  all.push_back(state_of("c", Doing::waiting, 9, small_body + 1));
  for (const std::string_view peer : {"d", "e"}) {
    for (int k = 0; k < 5; ++k) {
      EXPECT_TRUE(fits({.peer = peer, .bytes = small_body, .of_body = true})) << peer << k;
      all.push_back(state_of(peer, Doing::waiting, 9, small_body));
    }
    EXPECT_FALSE(fits({.peer = peer, .bytes = small_body, .of_body = true})) << "one has half of the share";
  }
  EXPECT_FALSE(fits({.peer = "f", .bytes = 1, .of_body = true}));
  EXPECT_TRUE(fits({.peer = "g", .bytes = 20 * small_body - 1})) << "and a quarter is left for answers";
}

TEST(Memory, for_small_bodies_is_that_of_the_large_where_there_are_more) {
  const auto fits = [](const std::vector<ConnectionState>& all) {
    return !memory_for(all, {.peer = "b", .bytes = small_body, .of_body = true}, most, now).is_full;
  };
  EXPECT_TRUE(fits(waiting("a", 59, small_body)));
  EXPECT_TRUE(fits(waiting("a", 39, small_body)));
  EXPECT_FALSE(fits(waiting("a", 60, small_body)));
}

TEST(Memory, of_answers_is_not_that_of_small_bodies) {
  const std::vector all = {state_of("a", Doing::sending, 0, 40 * small_body)};
  const auto fits = [&](std::size_t bytes) {
    return !memory_for(all, {.peer = "b", .bytes = bytes}, most, now).is_full;
  };
  EXPECT_TRUE(fits(30 * small_body));
  EXPECT_FALSE(fits(30 * small_body + 1));
}

}  // namespace
}  // namespace axiometry::server
