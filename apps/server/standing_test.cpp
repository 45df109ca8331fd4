// SPDX-License-Identifier: Apache-2.0
#include "server/standing.h"

#include <gtest/gtest.h>

#include <vector>

namespace axiometry::server {
namespace {

using Doing = Standing::Doing;
using std::chrono::seconds;

constexpr Standing::Clock::time_point now{std::chrono::hours(1)};

Standing standing(std::string_view peer, Doing doing, int seconds_ago, std::size_t bytes = 0) {
  return {peer, doing, now - seconds(seconds_ago), bytes};
}

TEST(Room, is_there_until_all_places_are_taken) {
  const std::vector all = {standing("a", Doing::idle, 9), standing("b", Doing::idle, 9)};
  EXPECT_FALSE(room_for(all, "a", 3, 3, now).is_full);
  EXPECT_TRUE(room_for(all, "a", 2, 3, now).is_full);
}

TEST(Room, is_made_by_the_peer_that_has_most) {
  const std::vector all = {standing("honest", Doing::silent, 9), standing("many", Doing::idle, 1),
                           standing("many", Doing::idle, 2)};
  EXPECT_EQ(room_for(all, "newcomer", 3, 3, now).goes, 2);
}

TEST(Room, is_made_by_the_silent_before_the_idle_and_by_these_before_those_that_stand_still) {
  std::vector all = {standing("a", Doing::sending, 20), standing("a", Doing::idle, 10), standing("a", Doing::silent, 1),
                     standing("a", Doing::waiting, 30)};
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
  const std::vector all = {standing("many", Doing::idle, 3), standing("many", Doing::idle, 4),
                           standing("one", Doing::idle, 9)};
  const Room room = room_for(all, "many", 100, 2, now);
  EXPECT_TRUE(room.is_full);
  EXPECT_EQ(room.goes, 1);
  EXPECT_FALSE(room_for(all, "one", 100, 2, now).is_full);
}

TEST(Memory, comes_back_from_the_peer_that_holds_most) {
  const std::vector all = {standing("small", Doing::sending, 9, 10), standing("large", Doing::sending, 1, 60),
                           standing("large", Doing::receiving, 2, 60), standing("large", Doing::waiting, 9, 60)};
  EXPECT_EQ(gives_back(all, "small", now), 2);
}

TEST(Memory, of_ones_own_comes_back_only_where_nothing_moves) {
  std::vector all = {standing("a", Doing::sending, 1, 60), standing("a", Doing::sending, 5, 60)};
  EXPECT_EQ(gives_back(all, "a", now), 1);
  all[1].since = now;
  EXPECT_EQ(gives_back(all, "a", now), std::nullopt);
}

TEST(Memory, is_not_taken_from_those_who_hold_none) {
  const std::vector all = {standing("a", Doing::idle, 100), standing("b", Doing::waiting, 100, 60)};
  EXPECT_EQ(gives_back(all, "c", now), std::nullopt);
}

}  // namespace
}  // namespace axiometry::server
