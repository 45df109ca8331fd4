// SPDX-License-Identifier: Apache-2.0
#include "server/routing/router.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "axiometry/base/broken_contract.h"

namespace axiometry::server {
namespace {

Router some_router() {
  Router router;
  router.add("GET", "/api/tests", [](const Request&) -> Result<Response> { return Response{.body = "list"}; });
  router.add("POST", "/api/tests", [](const Request&) -> Result<Response> { return Response{.status = 201}; });
  router.add("GET", "/api/tests/{id}", [](const Request& request) -> Result<Response> {
    return Response{.body = "test " + std::string(request.segment("id"))};
  });
  router.add("GET", "/api/tests/{id}/report.{extension}", [](const Request& request) -> Result<Response> {
    return Response{.body = std::string(request.segment("id")) + " as " + std::string(request.segment("extension"))};
  });
  router.add("GET", "/api/fault", [](const Request&) -> Result<Response> { throw std::runtime_error("fault"); });
  router.add("GET", "/api/memory", [](const Request&) -> Result<Response> { throw std::bad_alloc(); });
  router.add("GET", "/api/contract", [](const Request& request) -> Result<Response> {
    return Response{.body = std::string(request.segment("no such segment"))};
  });
  router.add("POST", "/api/fault", [](const Request&) -> Result<Response> { throw std::bad_alloc(); });
  router.add("GET", "/api/conflict", [](const Request&) -> Result<Response> {
    return fail(ErrorKind::conflict, "found version 1, expected version 2");
  });
  return router;
}

Response answer(std::string method, std::string path) {
  return some_router().answer({.method = std::move(method),
                               .path = std::move(path),
                               .query = {},
                               .headers = {},
                               .body = {},
                               .actor = {},
                               .captured = {}});
}

TEST(Router, finds_the_handler_and_what_stands_in_braces) {
  EXPECT_EQ(answer("GET", "/api/tests").body, "list");
  EXPECT_EQ(answer("POST", "/api/tests").status, 201);
  EXPECT_EQ(answer("GET", "/api/tests/12").body, "test 12");
  EXPECT_EQ(answer("GET", "/api/tests/12/report.pdf").body, "12 as pdf");
  EXPECT_EQ(answer("HEAD", "/api/tests/12").body, "test 12");
}

TEST(Router, finds_nothing_where_a_segment_is_missing_empty_or_too_many) {
  for (const std::string path : {"/", "/api", "/api/tests/", "/api/tests/12/", "/api/tests/12/report.", "/api/x",
                                 "/api/tests/12/report.pdf/x", "/API/tests"})
    EXPECT_EQ(answer("GET", path).status, 404) << path;
}

TEST(Router, tells_what_computes_for_long) {
  Router router;
  const Handler none = [](const Request&) -> Result<Response> { return Response{}; };
  router.add("GET", "/api/tests", none);
  router.add("POST", "/api/tests", none, Weight::by_size);
  router.add("POST", "/api/withdraw", none, Weight::edit);
  router.add_read("POST", "/api/evaluations", [&](const Request& request) -> Result<ReadRequest> {
    AXIOMETRY_TRY(const json::Value body, json_body(request));
    return ReadRequest{.load = body.find("lone") ? Load::lone : Load::edit, .answer = none};
  });
  router.add("GET", "/api/tests/{id}/report.{extension}", none, Weight::heavy);
  const auto load = [&](std::string method, std::string path, std::string body = "") {
    Request request{};
    request.method = std::move(method);
    request.path = std::move(path);
    request.body = std::move(body);
    return std::pair(router.queue_of(request), router.read(std::make_shared<Request>(request)).load);
  };
  const auto both = [](Load load) { return std::pair(load, load); };
  EXPECT_EQ(load("GET", "/api/tests"), both(Load::light));
  EXPECT_EQ(load("POST", "/api/tests", std::string(1000, 'x')), both(Load::light));
  EXPECT_EQ(load("POST", "/api/tests", std::string(1'000'000, 'x')), both(Load::heavy));
  EXPECT_EQ(load("GET", "/api/tests/1/report.pdf"), both(Load::heavy));
  EXPECT_EQ(load("HEAD", "/api/tests/1/report.pdf"), both(Load::heavy));
  EXPECT_EQ(load("POST", "/api/withdraw"), both(Load::edit));
  EXPECT_EQ(load("POST", "/api/withdraw", std::string(1'000'000, ' ')).first, Load::heavy) << "takes long to be read";
  EXPECT_EQ(load("POST", "/api/evaluations", "{}"), std::pair(Load::light, Load::edit));
  EXPECT_EQ(load("POST", "/api/evaluations", R"({"l\u006fne": true})"), std::pair(Load::light, Load::lone));
  EXPECT_EQ(load("POST", "/api/evaluations", "no JSON"), both(Load::light));
  EXPECT_EQ(load("POST", "/api/tests/1/report.pdf"), both(Load::light));
  EXPECT_EQ(load("GET", "/nothing"), both(Load::light));
}

TEST(Router, tells_with_the_head_what_may_keep_something_and_how_large_its_body_may_be) {
  Router router = some_router();
  const Handler none = [](const Request&) -> Result<Response> { return Response{}; };
  router.add("POST", "/api/preview", none, Weight::light, {.only_looks = true});
  router.add("POST", "/api/login", none, Weight::light, {.body_max = 100});
  const auto asked = [](std::string method, std::string path) {
    Request request{};
    request.method = std::move(method);
    request.path = std::move(path);
    return request;
  };
  EXPECT_TRUE(router.keeps(asked("POST", "/api/tests")));
  EXPECT_FALSE(router.keeps(asked("GET", "/api/tests")));
  EXPECT_FALSE(router.keeps(asked("HEAD", "/api/tests")));
  EXPECT_FALSE(router.keeps(asked("POST", "/api/preview")));
  EXPECT_FALSE(router.keeps(asked("PUT", "/api/tests")));
  EXPECT_EQ(router.body_max(asked("POST", "/api/login")), 100U);
  EXPECT_GT(router.body_max(asked("POST", "/api/tests")), std::size_t{1} << 32U);
  EXPECT_GT(router.body_max(asked("POST", "/api/nothing")), std::size_t{1} << 32U);
}

TEST(Router, refuses_bodies_of_another_type_than_the_route_takes) {
  Router router;
  const Handler none = [](const Request&) -> Result<Response> { return Response{}; };
  router.add("POST", "/api/plans", none);
  router.add("POST", "/api/tests", none, Weight::light, {.sent = Sent::files});
  const auto status = [&](std::string path, Pairs headers) {
    Request head{};
    head.method = "POST";
    head.path = std::move(path);
    head.headers = std::move(headers);
    const auto refused = router.refused(head);
    return refused ? refused->status : 0;
  };
  const std::pair<std::string, std::string> length = {"content-length", "5"};
  for (const std::string type :
       {"application/json", "Application/JSON; charset=utf-8", "application/json;charset=\"UTF-8\""})
    EXPECT_EQ(status("/api/plans", {length, {"content-type", type}}), 0) << type;
  for (const std::string type : {"text/plain", "", "application/json; charset=latin1", "application/jsonx", "text/json",
                                 "multipart/form-data; boundary=x", "application/x-www-form-urlencoded"})
    EXPECT_EQ(status("/api/plans", {length, {"content-type", type}}), 415) << type;
  EXPECT_EQ(status("/api/plans", {length}), 415);
  EXPECT_EQ(status("/api/plans", {{"transfer-encoding", "chunked"}}), 415);
  EXPECT_EQ(status("/api/plans", {{"content-length", "0"}}), 0);
  EXPECT_EQ(status("/api/plans", {}), 0);
  EXPECT_EQ(status("/api/tests", {length, {"content-type", "text/csv"}}), 0);
  EXPECT_EQ(status("/api/tests", {length}), 0);
}

TEST(Router, says_which_methods_a_path_has) {
  const Response response = answer("DELETE", "/api/tests");
  EXPECT_EQ(response.status, 405);
  EXPECT_THAT(response.headers, ::testing::Contains(::testing::Pair("Allow", "GET, POST")));
}

TEST(Router, answers_faults_and_errors_as_JSON) {
  EXPECT_EQ(answer("GET", "/api/fault").status, 500);
  EXPECT_EQ(answer("GET", "/api/memory").status, 500);
  const ContractsThrow in_its_request;
  EXPECT_EQ(answer("GET", "/api/contract").status, 500);
  EXPECT_THAT(answer("GET", "/api/fault").body, ::testing::Not(::testing::HasSubstr("fault\"")));
  EXPECT_THAT(answer("GET", "/api/fault").body, ::testing::HasSubstr("nothing was kept"));
  EXPECT_THAT(answer("POST", "/api/fault").body, ::testing::HasSubstr("whether anything was kept is not known"));
  EXPECT_EQ(answer("GET", "/api/conflict").status, 409);
  EXPECT_THAT(answer("GET", "/api/conflict").body, ::testing::HasSubstr("\"conflict\""));
}

TEST(Downloads, have_names_that_are_safe_everywhere) {
  const Response response = download("x", "text/csv", "Prüfung \"1\"\r\n/../<x>.csv");
  EXPECT_THAT(response.headers,
              ::testing::Contains(::testing::Pair("Content-Disposition",
                                                  "attachment; filename=\"Pr__fung _1____..__x_.csv\"; "
                                                  "filename*=UTF-8''Pr%C3%BCfung%20_1____..__x_.csv")));
}

}  // namespace
}  // namespace axiometry::server
