// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/from_archive/kept_temperatures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "axiometry/app/workbench/examples/example_table2.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/digest/sha256.h"
#include "tests/support/archive.h"

namespace axiometry::app {
namespace {

using testing::HasSubstr;

const store::By who_logs{"A. Tester", "a log"};
const std::string some_hash(64, 'a');

Result<KeptTemperatures> read_kept(const std::string& text) {
  auto value = json::parse(text);
  if (!value) return std::unexpected(std::move(value).error());
  return kept_temperatures_from(*value);
}

TEST(KeptTemperatures, AreReadAsTheyAreWritten) {
  KeptTemperatures kept{some_hash, "hall.csv", "2026-03-02T09:00", "2026-03-02T10:10", {{"T1", "air"}}, 19, 22, 0.5, 1};
  const auto again = kept_temperatures_from(to_json(kept));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(*again, kept);
  kept = {some_hash, "hall.csv"};
  EXPECT_EQ(*kept_temperatures_from(to_json(kept)), kept);
}

TEST(KeptTemperatures, RefuseWhatIsNone) {
  const std::string head = fmt::format(R"({{"sha256": "{}", "name": "hall.csv")", some_hash);
  for (const char* rest :
       {R"(, "lowest_C": -61})", R"(, "highest_C": 101})", R"(, "rate_C_per_h": -1})", R"(, "gradient_C": "1"})",
        R"(, "sensors": [{"name": "T1", "role": "hall"}]})", R"(, "beganat": "x"})", R"(, "began": "a\nb"})"})
    EXPECT_FALSE(read_kept(head + rest)) << rest;
  EXPECT_FALSE(read_kept(R"({"sha256": "12", "name": "hall.csv"})"));
  EXPECT_TRUE(read_kept(head + "}"));
}

TEST(KeptTemperatures, GoWithTheVersionsOfATest) {
  testing_support::Archive archive;
  Workbench workbench{archive.store()};
  const Upload upload{"table2.json", example_table2};
  const auto received = workbench.receive(std::span(&upload, 1), who_logs);
  ASSERT_TRUE(received) << received.error().to_string();
  const store::Id id = received->tests.front().id;
  std::string log = "time;Air\n";
  for (int hour = 0; hour < 14; ++hour)
    for (const char* minute : {"00", "20", "40"}) log += fmt::format("2026-03-02 {:02}:{};23,00\n", hour, minute);
  const auto document = workbench.attach(id, {"hall.csv", "text/csv", log}, who_logs);
  ASSERT_TRUE(document) << document.error().to_string();
  Revision revision;
  revision.base_version = 1;
  revision.draft.options.temperatures = KeptTemperatures{some_hash, "hall.csv"};
  const auto unknown = workbench.revise(id, revision, who_logs);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message, HasSubstr("attach it first"));
  const std::string recording(read_budget::file_bytes + 1, '7');
  const auto large = archive.store().keep({sha256(recording), "run.csv", "raw", recording}, {"Anna", ""});
  ASSERT_TRUE(large) << large.error().to_string();
  revision.draft.options.temperatures = KeptTemperatures{*large, "hall.csv"};
  const auto too_large = workbench.revise(id, revision, who_logs);
  ASSERT_FALSE(too_large);
  EXPECT_THAT(too_large.error().message, HasSubstr("found 65 MiB of temperatures, expected at most 64"));
  auto& kept = *revision.draft.options.temperatures;
  kept = {document->sha256, "hall.csv", "2026-03-02T12:00", "2026-03-02T13:00"};
  kept.highest_C = 22.0;
  const auto revised = workbench.revise(id, revision, who_logs);
  ASSERT_TRUE(revised) << revised.error().to_string();
  const auto again = workbench.test(id);
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(again->draft.options.temperatures, kept);
  const json::Value* environment = again->outcome.result.find("environment");
  ASSERT_NE(environment, nullptr);
  EXPECT_TRUE(environment->find("exceeded")->boolean());
  EXPECT_FALSE(again->outcome.result.find("conforming")->boolean());
  ReportRequest request;
  request.extension = "html";
  const auto report = workbench.report(id, 2, request);
  ASSERT_TRUE(report) << report.error().to_string();
  EXPECT_THAT(report->bytes, HasSubstr("Temperatures before and during the test"));
}

}  // namespace
}  // namespace axiometry::app
