// SPDX-License-Identifier: Apache-2.0
#include "server/access/token.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

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

TEST(Token, says_what_the_log_tells_of_it) {
  TokenGate gate({.token = token, .tls = false, .port = 8230});
  const auto refused = [&](const Request& asked) { return gate.refused(asked, noon)->event; };
  EXPECT_EQ(refused(request({})), SecurityEvent::token_missing);
  EXPECT_EQ(refused(bearing("wrong")), SecurityEvent::token_refused);
  EXPECT_EQ(refused(request({{"cookie", "axiometry-8230=none"}})), SecurityEvent::session_refused);
  EXPECT_EQ(gate.login(signing_in("wrong"), noon)->event, SecurityEvent::sign_in_refused);
  const auto signed_in = gate.login(signing_in(token), noon);
  EXPECT_EQ(signed_in->event, SecurityEvent::signed_in);
  const std::string cookie = cookie_of(*signed_in);
  const Request leaving = request({{"cookie", cookie.substr(0, cookie.find(';'))}}, "/api/logout");
  EXPECT_EQ(gate.logout(leaving).event, SecurityEvent::signed_out);
  EXPECT_EQ(gate.logout(leaving).event, SecurityEvent::none) << "nobody was signed in any more";
  for (std::size_t k = 0; k < Sessions::most; ++k)
    ASSERT_EQ(gate.login(signing_in(token), noon)->event, SecurityEvent::signed_in) << k;
  EXPECT_EQ(gate.login(signing_in(token), noon)->event, SecurityEvent::signed_in_ending_another);
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

TEST(Token, that_is_wrong_is_answered_late_though_the_right_one_came_from_there) {
  TokenGate gate({.token = token});
  const auto now = noon + 1h;
  EXPECT_FALSE(gate.refused(bearing(token), now).has_value());
  for (int i = 0; i < 100; ++i) {
    EXPECT_GE(gate.refused(bearing("wrong"), now)->delay, 500ms);
    EXPECT_GE(gate.login(signing_in("wrong"), now)->delay, 500ms);
  }
}

TEST(Token, that_is_wrong_is_answered_late_from_however_many_addresses) {
  TokenGate gate({.token = token});
  const auto now = noon + 1h;
  Request asked = bearing("wrong");
  for (int i = 0; i < 5000; ++i) {
    asked.peer = std::to_string(i);
    const auto refused = gate.refused(asked, now);
    EXPECT_GE(refused->delay, 500ms) << i;
    EXPECT_EQ(refused->status, 401) << "the first of this address: " << i;
  }
  asked = bearing(token);
  asked.peer = "one more";
  EXPECT_FALSE(gate.refused(asked, now).has_value());
}

TEST(Token, that_is_wrong_is_refused_wherever_it_opens_more) {
  TokenGate gate({.token = token});
  const auto at = [](std::string path, const std::string& shown) {
    return request({{"authorization", "Bearer " + shown}}, std::move(path));
  };
  EXPECT_EQ(gate.refused(at("/api/health", "wrong"), noon)->status, 401);
  EXPECT_GE(gate.refused(at("/api/health", "wrong"), noon)->delay, 500ms);
  EXPECT_FALSE(gate.refused(at("/api/health", token), noon).has_value());
  EXPECT_FALSE(gate.refused(request({{"authorization", "Basic YTpi"}}, "/api/health"), noon).has_value())
      << "is a proxy's affair";
  for (const std::string path : {"/", "/api/login"})
    EXPECT_EQ(gate.peer_of(at(path, token), noon), "192.0.2.1") << path;
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
  const std::string cookie = cookie_of(*gate.login(asked, noon));
  EXPECT_THAT(cookie, HasSubstr("; Secure"));
  EXPECT_THAT(cookie, testing::StartsWith("__Host-axiometry-8230="));
  Request known = request({{"cookie", cookie.substr(0, cookie.find(';'))}, {"origin", "https://calibration.example"}});
  EXPECT_FALSE(gate.refused(known, noon).has_value());
  EXPECT_THAT(cookie_of(gate.logout(known)), testing::StartsWith("__Host-axiometry-8230=; "));
  EXPECT_EQ(gate.refused(known, noon)->status, 401);
}

TEST(Token, opens_by_the_cookie_that_is_valid_of_the_two_that_a_browser_may_show) {
  TokenGate before({.token = token, .port = 8230});
  TokenGate gate({.token = token, .port = 8230});
  Request by_proxy = signing_in(token);
  by_proxy.headers = {{"origin", "https://calibration.example"}};
  const auto pair_of = [](const std::string& cookie) { return cookie.substr(0, cookie.find(';')); };
  const std::string stale = pair_of(cookie_of(*before.login(by_proxy, noon)));
  const std::string valid = pair_of(cookie_of(*gate.login(signing_in(token), noon)));
  ASSERT_TRUE(stale.starts_with("__Host-"));
  const Request both = request({{"cookie", stale + "; " + valid}});
  EXPECT_FALSE(gate.refused(both, noon).has_value());
  EXPECT_NE(gate.peer_of(both, noon), both.peer);
  const Response left = gate.logout(both);
  EXPECT_EQ(gate.refused(both, noon)->status, 401);
  std::vector<std::string> taken_away;
  for (const auto& [name, value] : left.headers)
    if (name == "Set-Cookie" && value.contains("Max-Age=0")) taken_away.push_back(value.substr(0, value.find(';')));
  EXPECT_THAT(taken_away, testing::UnorderedElementsAre("__Host-axiometry-8230=", "axiometry-8230="));
}

TEST(Token, opens_over_TLS_by_no_cookie_that_might_have_gone_without) {
  TokenGate gate({.token = token, .tls = true, .port = 443});
  const std::string cookie = cookie_of(*gate.login(signing_in(token), noon));
  const std::string pair = cookie.substr(0, cookie.find(';'));
  EXPECT_TRUE(gate.knows(request({{"cookie", pair}}), noon));
  EXPECT_FALSE(gate.knows(request({{"cookie", pair.substr(std::string("__Host-").size())}}), noon));
}

}  // namespace
}  // namespace axiometry::server
