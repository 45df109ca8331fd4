// SPDX-License-Identifier: Apache-2.0
#include "server/access/security.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace axiometry::server {
namespace {

std::vector<std::string> values(const Response& response, const std::string& name) {
  std::vector<std::string> found;
  for (const auto& [header, value] : response.headers)
    if (header == name) found.push_back(value);
  return found;
}

Response finished(Pairs headers, bool tls = false) {
  Response response{.headers = std::move(headers)};
  add_security_headers(response, tls);
  return response;
}

TEST(SecurityHeaders, are_on_every_response_once) {
  const Response response = finished({{"X-Frame-Options", "ALLOWALL"}});
  for (const char* name : {"Content-Security-Policy", "X-Content-Type-Options", "Referrer-Policy",
                           "Cross-Origin-Opener-Policy", "Cross-Origin-Resource-Policy", "Permissions-Policy"})
    EXPECT_EQ(values(response, name).size(), 1) << name;
  EXPECT_THAT(values(response, "X-Frame-Options"), ::testing::ElementsAre("SAMEORIGIN"));
  EXPECT_THAT(values(response, "Cache-Control"), ::testing::ElementsAre("no-store"));
  EXPECT_THAT(values(finished({{"Cache-Control", "no-cache"}}), "Cache-Control"), ::testing::ElementsAre("no-cache"));
}

TEST(SecurityHeaders, let_the_page_run_nothing_but_its_own_program) {
  const std::string policy = values(finished({}), "Content-Security-Policy").front();
  EXPECT_THAT(policy, ::testing::HasSubstr("default-src 'none'"));
  EXPECT_THAT(policy, ::testing::HasSubstr("script-src 'self'"));
  EXPECT_THAT(policy, ::testing::Not(::testing::HasSubstr("unsafe")));
}

TEST(SecurityHeaders, give_way_only_to_the_policy_of_a_document_that_runs_nothing) {
  const Response document = finished({{"Content-Security-Policy", std::string(document_policy)}});
  EXPECT_THAT(values(document, "Content-Security-Policy"), ::testing::ElementsAre(std::string(document_policy)));
  for (const std::string loose :
       {"default-src *", "sandbox allow-scripts; default-src 'none'; frame-ancestors 'self'",
        "sandbox; default-src 'none'; script-src *; frame-ancestors 'self'", "sandbox; default-src 'none'"})
    EXPECT_EQ(values(finished({{"Content-Security-Policy", loose}}), "Content-Security-Policy").size(), 2) << loose;
}

TEST(SecurityHeaders, come_with_the_letters_of_XML) {
  Response picture{.content_type = "image/svg+xml"};
  add_security_headers(picture, false);
  EXPECT_EQ(picture.content_type, "image/svg+xml; charset=utf-8");
}

TEST(SecurityHeaders, ask_browsers_to_stay_with_TLS_only_over_TLS) {
  EXPECT_TRUE(values(finished({}), "Strict-Transport-Security").empty());
  EXPECT_EQ(values(finished({}, true), "Strict-Transport-Security").size(), 1);
}

}  // namespace
}  // namespace axiometry::server
