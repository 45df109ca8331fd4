// SPDX-License-Identifier: Apache-2.0
#include "server/http/request_head.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace axiometry::server {
namespace {

namespace http = boost::beast::http;

std::expected<RequestHead, Response> head_with(const std::vector<std::pair<std::string, std::string>>& fields) {
  http::request_header<> header;
  header.method(http::verb::post);
  header.target("/api/tests");
  header.version(11);
  for (const auto& [name, value] : fields) header.insert(name, value);
  return read_head(header, "192.0.2.1");
}

int status_with(const std::string& name, const std::string& value) {
  const auto head = head_with({{name, value}});
  return head ? 0 : head.error().status;
}

TEST(RequestHead, refuses_a_body_in_a_coding_that_nobody_undoes) {
  EXPECT_EQ(status_with("Content-Encoding", "gzip"), 415);
  EXPECT_EQ(status_with("Content-Encoding", "br, gzip"), 415);
  EXPECT_EQ(status_with("Content-Encoding", ""), 415);
  EXPECT_EQ(status_with("Content-Encoding", "Identity"), 0);
  const auto twice = head_with({{"Content-Encoding", "identity"}, {"Content-Encoding", "gzip"}});
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().status, 400);
  const auto refused = head_with({{"Content-Encoding", "gzip"}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().headers.back(), (std::pair<std::string, std::string>("Accept-Encoding", "identity")));
}

TEST(RequestHead, takes_a_name_as_any_other_text) {
  const auto named = head_with({{"X-Actor", "J%C3%BCrgen"}});
  ASSERT_TRUE(named);
  EXPECT_EQ(named->request.actor, "Jürgen");
  const auto unnamed = head_with({});
  ASSERT_TRUE(unnamed);
  EXPECT_EQ(unnamed->request.actor, "workbench");
  for (const std::string bad : {"a%0Ab", "a%7Fb", "%FF", "a%E2%80%AEb", "%C2%85"})
    EXPECT_EQ(status_with("X-Actor", bad), 400) << bad;
  EXPECT_EQ(status_with("X-Actor", std::string(201, 'a')), 400);
}

TEST(RequestHead, gives_nobody_a_name_by_which_the_program_calls_itself) {
  for (const std::string name : {"restore", "Examples", "%20restore%20", "workbench"})
    EXPECT_EQ(status_with("X-Actor", name), 400) << name;
  EXPECT_EQ(status_with("X-Actor", "restorer"), 0);
}

}  // namespace
}  // namespace axiometry::server
