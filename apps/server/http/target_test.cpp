// SPDX-License-Identifier: Apache-2.0
#include "server/http/target.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace axiometry::server {
namespace {

TEST(Target, is_decoded_once) {
  const auto target = parse_target("/api/tests%20of/12?text=%C3%A4+b%2Bc&empty=&flag&&x=1=2");
  ASSERT_TRUE(target.has_value());
  EXPECT_EQ(target->path, "/api/tests of/12");
  EXPECT_EQ(target->query, (Pairs{{"text", "ä b+c"}, {"empty", ""}, {"flag", ""}, {"x", "1=2"}}));
  EXPECT_EQ(parse_target("/%2541")->path, "/%41");
}

TEST(Target, may_end_in_a_slash_but_has_no_empty_name_before) {
  EXPECT_EQ(parse_target("/")->path, "/");
  EXPECT_EQ(parse_target("/machines/")->path, "/machines/");
  EXPECT_FALSE(parse_target("//etc").has_value());
  EXPECT_FALSE(parse_target("/a//b").has_value());
}

TEST(Target, refuses_every_way_out_of_the_tree) {
  for (const std::string_view raw : {"/..",       "/../etc/passwd",
                                     "/a/../b",   "/.",
                                     "/%2e%2e/x", "/%2E%2e/x",
                                     "/..%2fetc", "/a%2Fb",
                                     "/a%5cb",    "/a\\b",
                                     "/%00",      "/a%00.html",
                                     "/%0a",      "/%7f",
                                     "/%c0%ae",   "/%ff",
                                     "*",         "",
                                     "etc",       "http://localhost/",
                                     "/a#b",      "/a b",
                                     "/\xC3\xA4"})
    EXPECT_FALSE(parse_target(raw).has_value()) << raw;
}

TEST(Target, refuses_malformed_percent_encoding) {
  for (const std::string_view raw : {"/%", "/%4", "/%zz", "/%4g", "/?a=%", "/?%=a", "/?a=%4", "/?a=%00"})
    EXPECT_FALSE(parse_target(raw).has_value()) << raw;
  EXPECT_EQ(parse_target("/%zz").error().message, "found \"%zz\", expected two hexadecimal digits after %");
}

}  // namespace
}  // namespace axiometry::server
