// SPDX-License-Identifier: Apache-2.0
#include "server/routing/query_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using testing::Contains;
using testing::Field;
using testing::Not;

QueryNames described_names() { return QueryNames(openapi_files().front().bytes); }

Response asked(const Router& router, std::string method, Pairs query,
               language::Language language = language::Language::english) {
  Request request;
  request.method = std::move(method);
  request.path = "/api/tests";
  request.query = std::move(query);
  request.language = language;
  return router.answer(request);
}

TEST(QueryNames, are_those_of_the_description) {
  const QueryNames names = described_names();
  ASSERT_NE(names.of("GET", "/api/tests"), nullptr);
  const auto called = [](const char* name) { return Field(&QueryName::name, name); };
  EXPECT_THAT(*names.of("GET", "/api/tests"), Contains(called("verdict")));
  EXPECT_THAT(*names.of("GET", "/api/tests"), Contains(called("decimal"))) << "of a reference";
  EXPECT_THAT(*names.of("GET", "/api/tests/{id}"), Not(Contains(called("id")))) << "it is in the path";
  EXPECT_TRUE(names.of("GET", "/api/machines")->empty());
  EXPECT_EQ(names.of("GET", "/api/nothing"), nullptr);
  EXPECT_EQ(names.of("PUT", "/api/tests"), nullptr);
}

TEST(Router, refuses_what_a_query_may_not_have) {
  Router router;
  const Handler taken = [](const Request&) -> Result<Response> { return Response{.body = "taken"}; };
  router.add("GET", "/api/tests", taken);
  EXPECT_EQ(asked(router, "GET", {{"verdickt", "fail"}}).status, 200) << "nobody has said what it may have";
  router.expect(described_names());
  EXPECT_EQ(asked(router, "GET", {{"verdict", "undecided"}, {"language", "de"}}).body, "taken");
  const Response refused = asked(router, "GET", {{"verdict", "undecided"}, {"verdickt", "fail"}});
  EXPECT_EQ(refused.status, 422);
  EXPECT_THAT(refused.body,
              testing::HasSubstr(R"(found the query parameter \"verdickt\", expected one of text, machine)"));
  EXPECT_THAT(refused.body, testing::HasSubstr(R"("kind":"bad_input")")) << "as all that is to be mended";
  EXPECT_EQ(asked(router, "HEAD", {{"oder", "name"}}).status, 422);
  EXPECT_THAT(asked(router, "GET", {{"limit", "0"}, {"limit", "5"}}).body,
              testing::HasSubstr("more than once, expected it once"));
  EXPECT_THAT(asked(router, "GET", {{"oder", "name"}}, language::Language::german).body,
              testing::HasSubstr(R"(Abfrageparameter \"oder\"; erwartet: einer von text, machine)"));
}

TEST(Router, refuses_a_word_that_is_none_of_those_enumerated) {
  Router router;
  const Handler taken = [](const Request&) -> Result<Response> { return Response{.body = "taken"}; };
  router.add("GET", "/api/tests", taken);
  router.expect(described_names());
  const Response refused = asked(router, "GET", {{"verdict", "nonsense"}});
  EXPECT_EQ(refused.status, 422);
  EXPECT_THAT(
      refused.body,
      testing::HasSubstr(R"(found verdict=\"nonsense\", expected one of conforms, does not conform, undecided)"));
  EXPECT_THAT(asked(router, "GET", {{"decimal", "dot"}}).body, testing::HasSubstr("expected one of point, comma"))
      << "of a reference";
  EXPECT_EQ(asked(router, "GET", {{"verdict", ""}, {"text", "nonsense"}}).body, "taken");
  EXPECT_THAT(asked(router, "GET", {{"verdict", "nonsense"}}, language::Language::german).body,
              testing::HasSubstr(R"(verdict=\"nonsense\"; erwartet: )"));
}

TEST(Router, takes_the_language_of_its_refusals_everywhere) {
  Router router;
  router.add("GET", "/api/machines", [](const Request&) -> Result<Response> { return Response{}; });
  router.expect(described_names());
  Request request;
  request.method = "GET";
  request.path = "/api/machines";
  request.query = {{"language", "de"}};
  EXPECT_EQ(router.answer(request).status, 200);
  request.query = {{"language", "xx"}};
  EXPECT_THAT(router.answer(request).body, testing::HasSubstr("expected one of en, de, fr"));
  request.query = {{"limit", "3"}};
  EXPECT_THAT(router.answer(request).body, testing::HasSubstr(R"(found the query parameter \"limit\", expected none)"));
}

TEST(Router, takes_the_name_of_a_file_in_the_query) {
  Router router;
  const Handler taken = [](const Request&) -> Result<Response> { return Response{.body = "taken"}; };
  router.add("POST", "/api/preview", taken, Weight::light, {.sent = Sent::files, .only_looks = true});
  router.add("POST", "/api/tests/{id}/evaluate", taken);
  router.expect(described_names());
  Request request;
  request.method = "POST";
  request.path = "/api/preview";
  for (const char* name : {"name", "filename"}) {
    request.query = {{name, "a.csv"}};
    EXPECT_EQ(router.answer(request).body, "taken") << name;
  }
  request.path = "/api/tests/1/evaluate";
  EXPECT_EQ(router.answer(request).status, 422) << "no file is sent";
}

}  // namespace
}  // namespace axiometry::server
