// SPDX-License-Identifier: Apache-2.0
#include "server/access/guard.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace axiometry::server {
namespace {

const Site site = make_site({.tls = false, .listen = "127.0.0.1", .port = 8230, .names = {"bench.example"}});

Request request(std::string method, Pairs headers, std::string path = "/api/tests") {
  headers.emplace_back("host", "127.0.0.1:8230");
  return {.method = std::move(method),
          .path = std::move(path),
          .query = {},
          .headers = std::move(headers),
          .body = {},
          .actor = {},
          .captured = {}};
}

int status(const Request& asked) {
  const auto refused = refused_by_guard(asked, site);
  return refused ? refused->status : 0;
}

TEST(Guard, knows_this_machine_by_its_names_and_the_port) {
  EXPECT_THAT(site.hosts,
              ::testing::IsSupersetOf({"127.0.0.1:8230", "localhost:8230", "[::1]:8230", "bench.example:8230"}));
  EXPECT_THAT(make_site({.tls = true, .listen = "192.168.1.20", .port = 443}).hosts,
              ::testing::IsSupersetOf({"192.168.1.20", "192.168.1.20:443", "localhost"}));
  EXPECT_THAT(make_site({.listen = "0.0.0.0", .port = 1}).hosts, ::testing::Not(::testing::Contains("0.0.0.0:1")));
  EXPECT_THAT(make_site({.listen = "fe80::1", .port = 1}).hosts, ::testing::Contains("[fe80::1]:1"));
  EXPECT_THAT(make_site({.listen = "::1", .port = 1, .names = {"Door.example:443"}}).hosts,
              ::testing::Contains("door.example:443"));
}

TEST(Guard, refuses_every_other_host) {
  for (const std::string host : {"evil.example", "evil.example:8230", "127.0.0.1", "127.0.0.1:80", "localhost",
                                 "127.0.0.1:8230.evil.example", "bench.example", ""}) {
    Request asked = request("GET", {{"host", host}});
    EXPECT_EQ(status(asked), 421) << host;
  }
  EXPECT_EQ(status(request("GET", {{"host", "LocalHost:8230"}})), 0);
  Request none = request("GET", {});
  none.headers.clear();
  EXPECT_EQ(status(none), 400);
}

TEST(Guard, lets_only_its_own_page_change_anything) {
  for (const std::string method : {"POST", "PUT", "DELETE"}) {
    EXPECT_EQ(status(request(method, {})), 0);
    EXPECT_EQ(status(request(method, {{"origin", "http://127.0.0.1:8230"}, {"sec-fetch-site", "same-origin"}})), 0);
    for (const std::string origin : {"null", "http://evil.example", "https://127.0.0.1:8230", "http://127.0.0.1",
                                     "http://localhost:8230", "http://127.0.0.1:8230/", ""})
      EXPECT_EQ(status(request(method, {{"origin", origin}})), 403) << origin;
    for (const std::string fetch_site : {"cross-site", "same-site", "", "anything"})
      EXPECT_EQ(status(request(method, {{"sec-fetch-site", fetch_site}})), 403) << fetch_site;
  }
}

Site behind_proxy() {
  return make_site({.tls = false,
                    .listen = "127.0.0.1",
                    .port = 8230,
                    .public_addresses = {*parse_public_address("https://Calibration.example"),
                                         *parse_public_address("https://door.example:8443/")}});
}

TEST(Guard, knows_a_public_address_by_its_origin_and_host) {
  const Site proxied = behind_proxy();
  const auto status_of = [&](const std::string& host, const std::string& origin) {
    Request asked = request("POST", {{"host", host}, {"origin", origin}, {"sec-fetch-site", "same-origin"}});
    const auto refused = refused_by_guard(asked, proxied);
    return refused ? refused->status : 0;
  };
  for (const std::string host : {"calibration.example", "calibration.example:443", "127.0.0.1:8230"})
    EXPECT_EQ(status_of(host, "https://calibration.example"), 0) << host;
  EXPECT_EQ(status_of("door.example:8443", "https://door.example:8443"), 0);
  EXPECT_EQ(status_of("127.0.0.1:8230", "http://127.0.0.1:8230"), 0);
  for (const std::string host : {"evil.example", "calibration.example:8230", "calibration.example:80", "door.example",
                                 "door.example:443", "calibration.example.evil.example", "x.calibration.example"})
    EXPECT_EQ(status_of(host, "https://calibration.example"), 421) << host;
  for (const std::string host : {"calibration.example", "127.0.0.1:8230"})
    for (const std::string origin :
         {"http://calibration.example", "https://calibration.example:8443", "https://evil.example", "null",
          "https://calibration.example.evil.example", "https://calibration.example/", "https://127.0.0.1:8230", ""})
      EXPECT_EQ(status_of(host, origin), 403) << host << " " << origin;
}

TEST(Guard, trusts_nothing_that_a_proxy_says) {
  for (const std::string header : {"forwarded", "x-forwarded-host", "x-forwarded-proto", "x-forwarded-for",
                                   "x-original-host", "x-forwarded-scheme"}) {
    Request asked = request("POST", {{"host", "evil.example"}, {header, "calibration.example"}});
    EXPECT_EQ(refused_by_guard(asked, behind_proxy())->status, 421) << header;
    asked = request("POST", {{"origin", "https://127.0.0.1:8230"}, {header, "https"}});
    EXPECT_EQ(refused_by_guard(asked, behind_proxy())->status, 403) << header;
  }
}

TEST(PublicAddress, is_a_scheme_and_a_host_and_no_more) {
  for (const std::string text :
       {"", "calibration.example", "https://", "https:///", "https://calibration.example/axes",
        "https://user@calibration.example", "https://*.example", "https://*", "null", "https://calibration.example:0",
        "https://calibration.example:65536", "https://calibration.example:", "https://a b", "ftp://calibration.example",
        "http://calibration.example", "https://calibration.example//", "https://a?b"})
    EXPECT_FALSE(parse_public_address(text).has_value()) << text;
  EXPECT_EQ(parse_public_address("HTTPS://Calibration.Example:443/")->origin, "https://calibration.example");
  EXPECT_EQ(parse_public_address("https://[2001:db8::1]:8443")->origin, "https://[2001:db8::1]:8443");
  EXPECT_TRUE(parse_public_address("http://localhost:9000")->is_local);
  EXPECT_FALSE(parse_public_address("https://calibration.example")->is_local);
}

TEST(Guard, lets_others_lead_here_but_embed_nothing_of_the_API) {
  EXPECT_EQ(status(request("GET", {{"sec-fetch-site", "cross-site"}, {"sec-fetch-mode", "navigate"}})), 0);
  EXPECT_EQ(status(request("GET", {{"sec-fetch-site", "cross-site"}, {"sec-fetch-mode", "no-cors"}})), 403);
  EXPECT_EQ(status(request("GET", {{"sec-fetch-site", "same-site"}})), 403);
  EXPECT_EQ(status(request("GET", {{"sec-fetch-site", "cross-site"}}, "/app.js")), 0);
}

TEST(Guard, knows_five_methods) {
  for (const std::string method : {"TRACE", "CONNECT", "OPTIONS", "PATCH", "get", ""}) {
    const auto refused = refused_by_guard(request(method, {}), site);
    ASSERT_TRUE(refused.has_value()) << method;
    EXPECT_EQ(refused->status, 405);
    EXPECT_THAT(refused->headers, ::testing::Contains(::testing::Pair("Allow", "GET, HEAD, POST, PUT, DELETE")));
  }
}

}  // namespace
}  // namespace axiometry::server
