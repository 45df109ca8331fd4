// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "axiometry/app/live/service/capture_keeping.h"
#include "axiometry/app/live/service/capture_service.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/text/text.h"
#include "axiometry/language/language.h"
#include "axiometry/model/surroundings.h"
#include "server/routes/described_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/archive.h"
#include "tests/support/repository_file.h"

namespace axiometry::server {
namespace {

/// Of all, or of those that are described with this status.
std::set<std::string> described(std::string_view status = {}) {
  std::set<std::string> operations;
  for (const auto& [path, methods] : api_description().find("paths")->members())
    for (const auto& [method, operation] : methods.members())
      if (status.empty() || operation.find("responses")->find(status)) operations.insert(method + " " + path);
  return operations;
}

std::set<std::string> names_of(const std::vector<Router::Route>& routes) {
  std::set<std::string> operations;
  for (const Router::Route& route : routes)
    operations.insert(fmt::format("{} {}", text::to_lower(route.method), route.pattern));
  return operations;
}

std::vector<Router::Route> served() {
  testing_support::Archive archive;
  app::Workbench workbench(archive.store());
  TokenGate token({});
  const auto captures =
      app::CaptureService::open({.folder = archive.folder() + "/captures", .sources = {}}, app::keeping_in(workbench));
  if (!captures) throw std::runtime_error(captures.error().to_string());
  Router router;
  add_service_routes(router, {.store = archive.store(), .token = token});
  add_session_routes(router, token);
  const Context context{.store = archive.store(), .workbench = workbench, .captures = **captures};
  add_test_routes(router, context);
  add_rule_routes(router, context);
  add_periodic_routes(router, context);
  add_equipment_routes(router, context);
  add_audit_routes(router, context);
  add_plan_routes(router, context);
  add_capture_routes(router, context);
  add_tracking_routes(router);
  add_coordinates_routes(router);
  add_dynamic_routes(router);
  add_motion_routes(router);
  add_calibration_routes(router, context);
  add_compensation_routes(router, context);
  add_volumetric_routes(router);
  return router.routes();
}

TEST(OpenApi, lists_the_languages_of_the_program) {
  std::vector<std::string> described_tags;
  for (const auto& tag : api_description().find("components")->find("schemas")->find("Language")->find("enum")->items())
    described_tags.push_back(tag.text());
  std::vector<std::string> tags;
  for (const language::Language each : language::languages()) tags.emplace_back(language::tag(each));
  EXPECT_EQ(described_tags, tags);
}

TEST(OpenApi, describes_every_route_and_nothing_else) {
  EXPECT_THAT(names_of(served()), ::testing::UnorderedElementsAreArray(described()));
}

TEST(OpenApi, tells_of_the_line_in_which_heavy_requests_wait) {
  std::vector<Router::Route> waiting = served();
  std::erase_if(waiting, [](const Router::Route& route) { return route.weight == Weight::light; });
  EXPECT_THAT(names_of(waiting), ::testing::UnorderedElementsAreArray(described("503")));
}

/// "#/components/schemas/Test" and the like.
void collect_references(const json::Value& value, std::set<std::string>& found) {
  if (value.is(json::Kind::array))
    for (const json::Value& item : value.items()) collect_references(item, found);
  if (!value.is(json::Kind::object)) return;
  for (const auto& [name, member] : value.members()) {
    if (name == "$ref" && member.is(json::Kind::text)) found.insert(member.text());
    collect_references(member, found);
  }
}

/// A capture's setting is the owner; these say it in words.
TEST(OpenApi, says_as_page_and_guide_how_long_the_last_reading_can_be_taken_back) {
  ASSERT_EQ(app::CaptureSettings{}.for_undo.in_s(), 10.0);
  for (const char* file :
       {"apps/server/openapi.json", "web/src/pages/capture/motion_texts.ts", "docs/howto/capture.md"})
    EXPECT_THAT(testing_support::repository_file(file), ::testing::HasSubstr("ten seconds")) << file;
}

TEST(OpenApi, bounds_what_was_agreed_on_temperatures_as_the_program_does) {
  const json::Value* limits =
      api_description().find("components")->find("schemas")->find("KeptTemperatures")->find("properties");
  for (const auto& [name, least] : {std::pair{"lowest_C", coldest_hall_C}, std::pair{"highest_C", coldest_hall_C},
                                    std::pair{"rate_C_per_h", 0.0}, std::pair{"gradient_C", 0.0}}) {
    EXPECT_EQ(limits->find(name)->find("minimum")->number(), least) << name;
    EXPECT_EQ(limits->find(name)->find("maximum")->number(), hottest_hall_C) << name;
  }
}

TEST(OpenApi, refers_to_nothing_that_is_missing) {
  std::set<std::string> references;
  collect_references(api_description(), references);
  ASSERT_FALSE(references.empty());
  for (const std::string& reference : references) {
    const json::Value* at = &api_description();
    for (const std::string_view part : text::split(std::string_view(reference).substr(2), '/')) {
      at = at->find(part);
      ASSERT_NE(at, nullptr) << reference;
    }
  }
}

}  // namespace
}  // namespace axiometry::server
