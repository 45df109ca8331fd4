// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axiometry/app/workbench/examples/example_table2.h"
#include "axiometry/app/workbench/workbench.h"
#include "server/routes/described_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/archive.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class RuleRoutes : public testing::Test {
 protected:
  RuleRoutes() {
    // These routes have nothing to do with captures.
    auto& captures = *reinterpret_cast<app::CaptureService*>(&workbench);
    const Context context{archive.store(), workbench, captures};
    add_test_routes(router, context);
    add_rule_routes(router, context);
    keep(std::string(app::example_table2));
  }

  void keep(std::string bytes) {
    Request request;
    request.method = "POST";
    request.path = "/api/tests";
    request.headers = {{"x-file-name", "test.json"}};
    request.body = std::move(bytes);
    request.actor = "A. Tester";
    ASSERT_EQ(router.answer(request).status, 201);
  }

  Response get(std::string path, Pairs query = {}, language::Language language = language::Language::english) {
    Request request;
    request.method = "GET";
    request.path = std::move(path);
    request.query = std::move(query);
    request.language = language;
    return router.answer(request);
  }

  static Value value_of(const Response& response) {
    EXPECT_EQ(response.status, 200) << response.body;
    auto value = json::parse(response.body);
    return value ? *value : Value::object();
  }

  static std::vector<std::string> ids(const Value& compared) {
    std::vector<std::string> all;
    for (const Value& rule : compared.find("rules")->items()) all.push_back(rule.find("id")->text());
    return all;
  }

  static const Value& figure(const Value& compared, std::string_view key) {
    for (const Value& rule : compared.find("rules")->items())
      for (const Value& each : rule.find("figures")->items())
        if (each.find("key")->text() == key) return each;
    throw std::logic_error("no such figure");
  }

  testing_support::Archive archive;
  app::Workbench workbench{archive.store()};
  DescribedRouter router;
};

TEST_F(RuleRoutes, TellAKeptTestByEveryRuleOrByThoseThatAreNamed) {
  EXPECT_EQ(ids(value_of(get("/api/tests/1/rules"))).size(), 9u);
  const Value two = value_of(get("/api/tests/1/rules", {{"standards", "vdi-dgq-3441,jis-b-0182-1993"}}));
  EXPECT_THAT(ids(two), ElementsAre("vdi-dgq-3441", "jis-b-0182-1993"));
  EXPECT_NEAR(figure(two, "P").find("value")->number(), 10.626681494529517, 1e-9);
  EXPECT_EQ(figure(two, "P").find("shown")->find("value")->text(), "10.6");
  EXPECT_EQ(figure(two, "P").find("shown")->find("relative_difference")->text(), "+11\u00a0%");
}

TEST_F(RuleRoutes, ClaimNothingOfWhatIsSecondHand) {
  const Value compared = value_of(get("/api/tests/1/rules"));
  for (const Value& rule : compared.find("rules")->items())
    for (const Value& each : rule.find("figures")->items())
      EXPECT_NE(each.find("checked_against_text")->boolean(),
                each.find("evidence_text")->text().contains("not checked against the text of the rule"))
          << each.find("key")->text();
  EXPECT_TRUE(compared.find("uncertainty")->is(json::Kind::null));
  EXPECT_THAT(compared.find("remarks")->items().front().text(), HasSubstr("no conformity with any rule but"));
}

TEST_F(RuleRoutes, SpeakTheLanguageOfTheReader) {
  const Value german = value_of(get("/api/tests/1/rules", {{"standards", "vdi-dgq-3441"}}, language::Language::german));
  EXPECT_EQ(figure(german, "P").find("title")->text(), "Positionsunsicherheit");
  EXPECT_EQ(figure(german, "P").find("shown")->find("value")->text(), "10,6");
  EXPECT_THAT(german.find("warnings")->items().front().find("message")->text(),
              HasSubstr("ist P nach VDI/DGQ 3441 gleich 10,6 µm"));
}

TEST_F(RuleRoutes, RefuseUnknownRulesAndThoseNamedTwice) {
  EXPECT_EQ(get("/api/tests/1/rules", {{"standards", "nmtba"}}).status, 422);
  EXPECT_EQ(get("/api/tests/1/rules", {{"standards", "vdi-dgq-3441,"}}).status, 422);
  EXPECT_EQ(get("/api/tests/1/rules", {{"standards", "export-lists,export-lists"}}).status, 422);
  EXPECT_EQ(get("/api/tests/2/rules").status, 404);
}

TEST_F(RuleRoutes, GiveIntervalsWhereTrialsAreAskedFor) {
  const Value compared = value_of(
      get("/api/tests/1/rules", {{"standards", "vdi-dgq-3441"}, {"uncertainty", "monte-carlo"}, {"trials", "1000"}}));
  EXPECT_EQ(compared.find("uncertainty")->find("trials")->number(), 1000.0);
  const Value& P = figure(compared, "P");
  EXPECT_LE(P.find("interval")->find("low")->number(), P.find("value")->number());
  EXPECT_GT(P.find("interval")->find("high")->number(), P.find("interval")->find("low")->number());
  EXPECT_THAT(P.find("shown")->find("interval")->text(), testing::MatchesRegex("[0-9.]+ to [0-9.]+"));
  EXPECT_EQ(get("/api/tests/1/rules", {{"uncertainty", "gum"}}).status, 422);
  EXPECT_EQ(get("/api/tests/1/rules", {{"trials", "1000"}}).status, 422);
  EXPECT_EQ(get("/api/tests/1/rules", {{"uncertainty", "monte-carlo"}, {"trials", "1000001"}}).status, 422);
}

TEST_F(RuleRoutes, TakeSeedCoverageAndWayOfSamplingAsTheCommandLineDoes) {
  const auto asked = [&](const Pairs& more) {
    Pairs query{{"standards", "vdi-dgq-3441"}, {"uncertainty", "monte-carlo"}, {"trials", "1000"}};
    query.insert(query.end(), more.begin(), more.end());
    return get("/api/tests/1/rules", query);
  };
  const Value usual = value_of(asked({}));
  const Value other = value_of(asked({{"seed", "7"}, {"coverage", "0.5"}, {"type_a", "resampled"}}));
  EXPECT_EQ(usual.find("uncertainty")->find("seed")->number(), 1.0);
  EXPECT_EQ(other.find("uncertainty")->find("seed")->number(), 7.0);
  EXPECT_EQ(other.find("uncertainty")->find("coverage")->number(), 0.5);
  const auto width = [](const Value& compared) {
    const Value& interval = *figure(compared, "P").find("interval");
    return interval.find("high")->number() - interval.find("low")->number();
  };
  EXPECT_LT(width(other), width(usual));
  for (const auto& [name, wrong] : Pairs{{"seed", "-1"}, {"seed", "x"}, {"coverage", "1"}, {"type_a", "best"}}) {
    const Response refused = asked({{name, wrong}});
    EXPECT_EQ(refused.status, 422) << name;
    EXPECT_THAT(refused.body, HasSubstr("\"message\":\"" + name + ": found"));
  }
  for (const auto& [name, given] : Pairs{{"seed", "1"}, {"coverage", "0.95"}, {"type_a", "pooled"}})
    EXPECT_EQ(get("/api/tests/1/rules", {{name, given}}).status, 422) << name;
}

TEST_F(RuleRoutes, TakeAllProcessorsForTrialsAlone) {
  const auto load = [&](Pairs query) {
    auto request = std::make_shared<Request>();
    request->method = "GET";
    request->path = "/api/tests/1/rules";
    request->query = std::move(query);
    return router.read(request).load;
  };
  EXPECT_EQ(load({}), Load::heavy);
  EXPECT_EQ(load({{"uncertainty", "monte-carlo"}}), Load::lone);
}

TEST_F(RuleRoutes, SetTheComparisonAsADocumentButDrawNoEmptyPicture) {
  const Response html = get("/api/tests/1/rules/report.html", {{"standards", "vdi-dgq-3441"}});
  EXPECT_EQ(html.status, 200);
  EXPECT_THAT(html.body, HasSubstr("Positional scatter, largest"));
  EXPECT_THAT(html.body, HasSubstr("second-hand, not checked against the text of the rule"));
  EXPECT_THAT(html.body, Not(HasSubstr("JIS B 0182")));
  EXPECT_EQ(get("/api/tests/1/rules/report.svg").status, 404);
  EXPECT_EQ(get("/api/tests/1/rules/report.PNG").status, 404);
  EXPECT_THAT(get("/api/tests/1/rules/report.docx").body, HasSubstr("found a sheet as \\\"docx\\\", expected one of"));
  const Value file = value_of(get("/api/tests/1/rules/report.json"));
  EXPECT_EQ(ids(file).size(), 9u);
  EXPECT_NE(file.find("metadata"), nullptr);
}

}  // namespace
}  // namespace axiometry::server
