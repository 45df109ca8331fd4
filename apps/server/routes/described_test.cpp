// SPDX-License-Identifier: Apache-2.0
// What holds answers against the description must see what is wrong with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/routes/described_test_support.h"

namespace axiometry::server {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Request asked(std::string method, std::string path, std::string body = {}, Pairs query = {}) {
  Request request;
  request.method = std::move(method);
  request.path = std::move(path);
  request.body = std::move(body);
  request.query = std::move(query);
  return request;
}

Described::Faults of_examples(const std::string& body) {
  return Described::faults(asked("POST", "/api/examples"), {.status = 201, .body = body});
}

TEST(Described, sees_a_member_more_and_a_member_less) {
  EXPECT_THAT(of_examples(R"({"tests": 3})"), IsEmpty());
  EXPECT_THAT(of_examples(R"({"tests": 3, "colour": "red"})"), ElementsAre(HasSubstr("/colour")));
  EXPECT_THAT(of_examples(R"({})"), ElementsAre(HasSubstr("no tests")));
  EXPECT_THAT(of_examples(R"({"tests": 3.5})"), ElementsAre(HasSubstr("/tests: found 3.5")));
  EXPECT_THAT(of_examples("nothing"), ElementsAre(HasSubstr("expected")));
}

TEST(Described, sees_members_that_are_beside_those_of_a_shape_in_common) {
  const std::string axis = R"("id": 1, "version": 1, "change": {"at": "", "actor": "", "reason": ""}, "machine": 1,
    "name": "X", "kind": "linear", "limits": [{"parameter": "A", "value": 10}], "notes": "")";
  const auto of_axis = [](const std::string& members) {
    return Described::faults(asked("GET", "/api/axes/1"), {.body = "{" + members + "}"});
  };
  EXPECT_THAT(of_axis(axis), IsEmpty());
  EXPECT_THAT(of_axis(axis + R"(, "colour": "red")"), ElementsAre(HasSubstr("/colour")));
  EXPECT_THAT(of_axis(R"("id": 0, )" + axis.substr(9)), ElementsAre(HasSubstr("/id: found 0")));
  EXPECT_THAT(of_axis(axis.substr(0, axis.find("\"limits\"")) + R"("limits": [{"parameter": "Q", "value": 1}],
    "notes": "")"),
              ElementsAre(HasSubstr("/limits/0/parameter: found \"Q\"")));
}

TEST(Described, sees_paths_methods_statuses_and_types_that_are_not_described) {
  const std::string failure =
      R"({"error": {"kind": "not_found", "message": "", "file": null, "line": null, "column": null}})";
  const auto of = [&](const std::string& method, const std::string& path, int status, const std::string& type) {
    return Described::faults(asked(method, path), {.status = status, .content_type = type, .body = failure});
  };
  const std::string json = "application/json";
  EXPECT_THAT(of("GET", "/api/nothing", 404, json), IsEmpty());
  EXPECT_THAT(of("GET", "/api/nothing", 409, json), ElementsAre("this is not described"));
  EXPECT_THAT(of("GET", "/api/nothing", 503, json), IsEmpty());
  EXPECT_THAT(of("PUT", "/api/tests", 405, json), IsEmpty());
  EXPECT_THAT(of("PUT", "/api/tests", 404, json), ElementsAre("this is not described"));
  EXPECT_THAT(of("GET", "/api/tests/1", 404, json), IsEmpty());
  EXPECT_THAT(of("GET", "/api/tests/1", 409, json), ElementsAre("a status that is not described"));
  EXPECT_THAT(of("GET", "/api/tests/1", 404, "text/plain"), ElementsAre(HasSubstr("text/plain")));
  EXPECT_THAT(of("POST", "/api/logout", 204, json), ElementsAre("a body, expected none"));
}

TEST(Described, sees_what_was_asked_and_is_not_described) {
  const Response done{.status = 201, .body = R"({"tests": 3})"};
  EXPECT_THAT(Described::faults(asked("GET", "/api/machines", "{}"), {.body = R"({"machines": []})"}),
              ElementsAre("a request with a body, expected none"));
  EXPECT_THAT(Described::faults(asked("POST", "/api/examples", "", {{"colour", "red"}}), done),
              ElementsAre("the query colour is not described"));
  const Response signed_in{.status = 204};
  EXPECT_THAT(Described::faults(asked("POST", "/api/login", R"({"token": "x"})"), signed_in), IsEmpty());
  EXPECT_THAT(Described::faults(asked("POST", "/api/login", R"({"token": 1})"), signed_in),
              ElementsAre(HasSubstr("/token")));
  EXPECT_THAT(Described::faults(asked("POST", "/api/login"), signed_in),
              ElementsAre("a request without a body, expected one"));
}

}  // namespace
}  // namespace axiometry::server
