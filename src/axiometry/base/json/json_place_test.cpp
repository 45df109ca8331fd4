// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/json/json_place.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

namespace axiometry::json {
namespace {

/// Any of everything, of a random number generator that is in the same state whoever asks.
void put_anything(Place place, std::mt19937& engine, int depth) {
  const auto any = [&](unsigned below) { return static_cast<unsigned>(engine() % below); };
  const std::vector<std::string> texts = {"", "ä – 𝄞", "a \"quoted\" \\ line\n", std::string(40, 'x'), "\xE2\x80 cut"};
  switch (any(depth > 0 ? 9 : 7)) {
    case 0: return place.put(std::nullopt);
    case 1: return place.put(any(2) == 0);
    case 2: return place.put(static_cast<double>(engine()) / 7.0 - 1e8);
    case 3: return place.put(static_cast<int>(any(100)) - 50);
    case 4: return place.put(texts[any(5)]);
    case 5: return place.put(any(2) == 0 ? std::optional<double>(-0.0) : std::nullopt);
    case 6: return place.put(Value::array({1.5, "in a tree", Value::object(), Value()}));
    case 7: {
      Object object(place);
      for (unsigned k = any(12); k > 0; --k)
        put_anything(object.at("member " + std::to_string(k) + "\t"), engine, depth - 1);
      return;
    }
    default: {
      List list(place);
      for (unsigned k = any(12); k > 0; --k) put_anything(list.next(), engine, depth - 1);
      return;
    }
  }
}

TEST(JsonPlace, BecomesTheSameAsATextAndAsATree) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 of_text(seed), of_tree(seed);
    const std::string text = text_of([&](Place place) { put_anything(place, of_text, 4); });
    const Value tree = tree_of([&](Place place) { put_anything(place, of_tree, 4); });
    ASSERT_EQ(text, dump(tree, 0)) << seed;
    ASSERT_TRUE(parse(text)) << seed;
  }
}

TEST(JsonPlace, ClosesWhatWasOpened) {
  const auto write = [](Place place) {
    Object object(place);
    object.add("absent", std::optional<double>());
    object.add("there", std::optional<std::string_view>("as text"));
    {
      List list = object.list("list");
      list.push(std::size_t{3});
      list.object().add("inside", true);
    }
    Object last = object.object("empty");
  };
  EXPECT_EQ(text_of(write), R"({"absent":null,"there":"as text","list":[3,{"inside":true}],"empty":{}})");
}

TEST(JsonPlaceDeathTest, RefusesAMemberBesideAnOpenOne) {
  const auto beside = [](Place place) {
    Object object(place);
    const List list = object.list("open");
    object.add("beside", 1.0);
  };
  EXPECT_DEATH(text_of(beside), "contract broken");
}

TEST(JsonPlaceDeathTest, RefusesWhatIsNotANumber) {
  const auto not_a_number = [](Place place) { place.put(std::numeric_limits<double>::quiet_NaN()); };
  EXPECT_DEATH(text_of(not_a_number), "contract broken");
}

}  // namespace
}  // namespace axiometry::json
