// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "axiometry/app/workbench/workbench.h"
#include "server/routes/described_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/archive.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// An amplitude of 2 µm every 10 mm, read upwards in five runs at unequal steps, without noise but rounding.
std::string screw() {
  std::string text = "# axis.name: X\nposition_mm,run,direction,deviation_um\n";
  for (int run = 1; run <= 5; ++run)
    for (int k = 0; k < 40; ++k) {
      const double x = 1.7 * k + 0.4 * (k % 3);
      text += fmt::format("{:.3f},{},up,{:.4f}\n", x, run, 2.0 * std::sin(2.0 * std::numbers::pi * x / 10.0));
    }
  return text;
}

class PeriodicRoutes : public testing::Test {
 protected:
  PeriodicRoutes() {
    // These routes have nothing to do with captures.
    auto& captures = *reinterpret_cast<app::CaptureService*>(&workbench);
    const Context context{archive.store(), workbench, captures};
    add_test_routes(router, context);
    add_periodic_routes(router, context);
    add_rule_routes(router, context);
    EXPECT_EQ(send("POST", "/api/tests", screw()).status, 201);
  }

  Response send(std::string method, std::string path, std::string body, Pairs query = {},
                language::Language language = language::Language::english) {
    Request request;
    request.method = std::move(method);
    request.path = std::move(path);
    request.headers = {{"x-file-name", "screw.csv"}};
    request.body = std::move(body);
    request.query = std::move(query);
    request.actor = "A. Tester";
    request.language = language;
    return router.answer(request);
  }
  Response get(std::string path, Pairs query = {}, language::Language language = language::Language::english) {
    return send("GET", std::move(path), {}, std::move(query), language);
  }

  static Value value_of(const Response& response) {
    EXPECT_EQ(response.status, 200) << response.body;
    auto value = json::parse(response.body);
    return value ? *value : Value::object();
  }

  testing_support::Archive archive;
  app::Workbench workbench{archive.store()};
  DescribedRouter router;
};

TEST_F(PeriodicRoutes, FindThePeriodOfAKeptTest) {
  const Value found = value_of(get("/api/tests/1/periodic"));
  const Value& up = found.find("directions")->items().front();
  EXPECT_NEAR(up.find("period")->find("value")->number(), 10.0, 1e-3);
  EXPECT_NEAR(up.find("amplitude")->find("value")->number(), 2.0, 1e-3);
  EXPECT_TRUE(up.find("significant")->boolean());
  const Value given = value_of(get("/api/tests/1/periodic", {{"period", "10"}}));
  EXPECT_TRUE(given.find("directions")->items().front().find("period_known")->boolean());
}

TEST_F(PeriodicRoutes, TellItInTheWordsAndFiguresOfTheReport) {
  const Value shown = value_of(get("/api/tests/1/periodic", {{"theme", "dark"}}, language::Language::german));
  const std::string document = json::dump(*shown.find("document"));
  EXPECT_THAT(document, AllOf(HasSubstr("Periodische Positionsabweichung"), HasSubstr("\"svg\": \"<svg")));
  EXPECT_THAT(document, Not(HasSubstr("Periodic positioning error")));
  const std::string light = json::dump(*value_of(get("/api/tests/1/periodic")).find("document"));
  EXPECT_THAT(light, HasSubstr("peak to valley"));
}

TEST_F(PeriodicRoutes, WriteWhatTheCommandLineWrites) {
  const Response html = get("/api/tests/1/periodic/report.html", {{"period", "10"}});
  EXPECT_EQ(html.status, 200);
  EXPECT_THAT(html.body, HasSubstr("Periodic positioning error of axis X"));
  const Value file = value_of(get("/api/tests/1/periodic/report.json"));
  EXPECT_EQ(file.find("document"), nullptr);
  EXPECT_EQ(file.find("result")->text(), "periodic-error");
  EXPECT_EQ(get("/api/tests/1/periodic/report.docx").status, 422);
}

TEST_F(PeriodicRoutes, RefusePeriodsThatAreNoneAndSearchesThatWouldTakeLong) {
  for (const char* wrong : {"0", "-1", "x", "inf", "1e400"})
    for (const char* name : {"period", "min_period", "max_period"}) {
      const Response refused = get("/api/tests/1/periodic", {{name, wrong}});
      EXPECT_EQ(refused.status, 422) << name << wrong;
      EXPECT_THAT(refused.body, HasSubstr("found")) << name << wrong;
    }
  EXPECT_EQ(get("/api/tests/1/periodic", {{"period", "10"}, {"max_period", "20"}}).status, 422);
  const Response endless = get("/api/tests/1/periodic", {{"min_period", "0.0001"}});
  EXPECT_EQ(endless.status, 422);
  EXPECT_THAT(endless.body, HasSubstr("expected at most 300000"));
  EXPECT_EQ(get("/api/tests/2/periodic").status, 404);
}

TEST_F(PeriodicRoutes, AndThoseOfOtherRulesSayThatATestIsWithdrawn) {
  EXPECT_EQ(send("POST", "/api/tests/1/withdraw", R"({"reason": "wrong axis"})").status, 200);
  for (const char* route : {"/api/tests/1/periodic", "/api/tests/1/rules"}) {
    EXPECT_THAT(value_of(get(route)).find("label")->text(), HasSubstr("withdrawn, not to be used")) << route;
    EXPECT_THAT(get(std::string(route) + "/report.html").body, HasSubstr("withdrawn, not to be used")) << route;
  }
}

}  // namespace
}  // namespace axiometry::server
