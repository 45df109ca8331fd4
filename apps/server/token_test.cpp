// SPDX-License-Identifier: Apache-2.0
#include "server/token.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace axiometry::server {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string token = "correct horse battery";
const TokenGate::Clock::time_point noon{};

Request request(Pairs headers, std::string path = "/api/tests", std::string body = "") {
  return {.method = "POST",
          .path = std::move(path),
          .query = {},
          .headers = std::move(headers),
          .body = std::move(body),
          .actor = {},
          .captured = {},
          .peer = "192.0.2.1"};
}

Request bearing(const std::string& what) { return request({{"authorization", "Bearer " + what}}); }

Request signing_in(const std::string& what) { return request({}, "/api/login", "{\"token\": \"" + what + "\"}"); }

std::string cookie_of(const Response& response) {
  for (const auto& [name, value] : response.headers)
    if (name == "Set-Cookie") return value;
  return "";
}

TEST(Token, is_asked_of_the_API_alone) {
  TokenGate gate({.token = token});
  EXPECT_EQ(gate.refused(request({}), noon)->status, 401);
  EXPECT_EQ(gate.refused(request({}), noon)->delay, 0ms);
  for (const std::string path : {"/", "/app.js", "/machines/3", "/api/health", "/api/login"})
    EXPECT_FALSE(gate.refused(request({}, path), noon).has_value()) << path;
  EXPECT_FALSE(TokenGate({}).refused(request({}), noon).has_value());
}

TEST(Token, opens_as_bearer_and_as_the_cookie_it_is_changed_for) {
  TokenGate gate({.token = token, .tls = false, .port = 8230});
  EXPECT_FALSE(gate.refused(bearing(token), noon).has_value());
  const auto signed_in = gate.login(signing_in(token), noon);
  ASSERT_TRUE(signed_in.has_value());
  EXPECT_EQ(signed_in->status, 204);
  const std::string cookie = cookie_of(*signed_in);
  EXPECT_THAT(cookie, testing::AllOf(HasSubstr("axiometry-8230="), HasSubstr("HttpOnly"), HasSubstr("SameSite=Strict"),
                                     Not(HasSubstr(token)), Not(HasSubstr("Secure"))));
  const std::string pair = cookie.substr(0, cookie.find(';'));
  EXPECT_TRUE(gate.knows(request({{"cookie", "a=b; " + pair + "; c=d"}})));
  EXPECT_FALSE(gate.knows(request({{"cookie", "x" + pair}})));
  EXPECT_FALSE(gate.knows(request({{"cookie", pair + "0"}})));
  EXPECT_FALSE(gate.knows(request({{"cookie", "axiometry-8230=" + token}})));
  EXPECT_FALSE(TokenGate({.token = token, .port = 8230}).knows(request({{"cookie", pair}})))
      << "what another has given out is no session here";
}

TEST(Token, begins_a_session_of_its_own_each_time_which_ends_alone) {
  TokenGate gate({.token = token, .port = 8230});
  const auto sign_in = [&] {
    const std::string cookie = cookie_of(*gate.login(signing_in(token), noon));
    return request({{"cookie", cookie.substr(0, cookie.find(';'))}});
  };
  const Request one = sign_in();
  const Request other = sign_in();
  EXPECT_NE(one.header("cookie"), other.header("cookie"));
  EXPECT_THAT(cookie_of(gate.logout(one)), HasSubstr("Max-Age=0"));
  EXPECT_EQ(gate.refused(one, noon)->status, 401);
  EXPECT_FALSE(gate.refused(other, noon).has_value());
  EXPECT_EQ(gate.refused(other, noon + Sessions::longest)->status, 401);
}

TEST(Token, gives_each_session_a_share_of_its_own) {
  TokenGate gate({.token = token, .port = 8230});
  const auto sign_in = [&] {
    const std::string cookie = cookie_of(*gate.login(signing_in(token), noon));
    return gate.peer_of(request({{"cookie", cookie.substr(0, cookie.find(';'))}}), noon);
  };
  const std::string one = sign_in();
  EXPECT_NE(sign_in(), one);
  EXPECT_NE(one, "192.0.2.1");
  EXPECT_NE(gate.peer_of(bearing(token), noon), "192.0.2.1");
  for (const Request& stranger : {request({}), bearing("wrong"), request({{"cookie", "axiometry-8230=" + one}})})
    EXPECT_EQ(gate.peer_of(stranger, noon), "192.0.2.1");
  EXPECT_EQ(TokenGate({}).peer_of(bearing(token), noon), "192.0.2.1");
}

TEST(Token, that_is_right_passes_the_wrong_ones_of_others_behind_the_same_address) {
  TokenGate gate({.token = token});
  const auto now = noon + 1h;
  EXPECT_FALSE(gate.refused(bearing(token), now).has_value());
  int late = 0;
  for (int i = 0; i < 100; ++i) late += gate.refused(bearing("wrong"), now)->status == 429 ? 1 : 0;
  EXPECT_GT(late, 90);
  EXPECT_FALSE(gate.refused(bearing(token), now).has_value());
  EXPECT_EQ(gate.login(signing_in(token), now)->status, 204);
}

TEST(Token, has_a_cookie_for_TLS_alone_where_there_is_TLS) {
  TokenGate gate({.token = token, .tls = true, .port = 443});
  EXPECT_THAT(cookie_of(*gate.login(signing_in(token), noon)),
              testing::AllOf(testing::StartsWith("__Host-axiometry-443="), HasSubstr("; Secure")));
  EXPECT_THAT(cookie_of(gate.logout(request({}))), HasSubstr("Max-Age=0"));
}

TEST(Token, that_is_wrong_is_answered_later_each_time) {
  TokenGate gate({.token = token});
  auto now = noon + 1h;
  for (const auto expected : {500ms, 1000ms, 2000ms, 4000ms, 8000ms, 8000ms}) {
    const auto refused = gate.refused(bearing("wrong"), now);
    EXPECT_EQ(refused->status, 401);
    EXPECT_EQ(refused->delay, expected);
    now += refused->delay;
  }
  EXPECT_EQ(gate.refused(bearing("wrong"), now + 10min)->delay, 500ms);
}

TEST(Token, is_not_looked_at_while_many_wrong_ones_of_that_address_wait) {
  TokenGate gate({.token = token});
  const auto now = noon + 1h;
  int looked_at = 0;
  for (int i = 0; i < 1000; ++i)
    if (gate.refused(bearing("wrong"), now)->status == 401) ++looked_at;
  EXPECT_LT(looked_at, 10);
  EXPECT_EQ(gate.refused(bearing(token), now)->status, 429);
  EXPECT_EQ(gate.login(signing_in(token), now)->status, 429);
  Request elsewhere = bearing(token);
  elsewhere.peer = "192.0.2.2";
  EXPECT_FALSE(gate.refused(elsewhere, now).has_value());
  EXPECT_FALSE(gate.refused(bearing(token), now + 1min).has_value());
}

TEST(Token, is_a_text_in_the_body) {
  TokenGate gate({.token = token});
  for (const std::string body : {"", "{}", "{\"token\": 1}", "[]"})
    EXPECT_FALSE(gate.login(request({}, "/api/login", body), noon).has_value()) << body;
}

TEST(Token, gives_a_page_that_came_over_TLS_from_a_proxy_a_cookie_for_TLS_alone) {
  TokenGate gate({.token = token, .tls = false, .port = 8230});
  Request asked = signing_in(token);
  EXPECT_THAT(cookie_of(*gate.login(asked, noon)), Not(HasSubstr("Secure")));
  asked.headers = {{"origin", "https://calibration.example"}};
  EXPECT_THAT(cookie_of(*gate.login(asked, noon)), HasSubstr("; Secure"));
}

}  // namespace
}  // namespace axiometry::server
