// SPDX-License-Identifier: Apache-2.0
// Plans and captures as the page asks for them, through the router, over an archive.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "axiometry/app/live/lengths/length_plans_test_support.h"
#include "axiometry/app/live/service/capture_keeping.h"
#include "axiometry/app/live/service/piece_server_test_support.h"
#include "axiometry/app/workbench/calibrations/calibration_evaluation.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "server/routes/described_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/archive.h"
#include "tests/support/made_up_motion.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::HasSubstr;
using namespace std::chrono_literals;

constexpr const char* short_request = R"({"axis": "X", "kind": "linear", "from": 0, "to": 60, "targets": 3,
  "cycle": "standard", "runs": 2, "feed": 6000, "dwell_s": 1, "seed": 3,
  "further": {"machine": "Mill", "warm-up": "0"}})";

class CaptureRoutes : public testing::Test {
 protected:
  explicit CaptureRoutes(std::vector<app::CaptureSource> sources = {}) {
    captures = *app::CaptureService::open({.folder = captures_folder(), .sources = std::move(sources)},
                                          app::keeping_in(workbench));
    const Context context{archive.store(), workbench, *captures};
    add_test_routes(router, context);
    add_equipment_routes(router, context);
    add_plan_routes(router, context);
    add_capture_routes(router, context);
  }

  std::string captures_folder() const { return archive.folder() + "/captures"; }

  Response send(std::string method, std::string path, std::string body = {}, Pairs query = {},
                language::Language language = language::Language::english) {
    Request request;
    request.method = std::move(method);
    request.path = std::move(path);
    request.query = std::move(query);
    request.body = std::move(body);
    request.actor = "A. Tester";
    request.language = language;
    return router.answer(request);
  }

  static Value value_of(const Response& response, int status) {
    EXPECT_EQ(response.status, status) << response.body;
    auto value = json::parse(response.body);
    EXPECT_TRUE(value) << response.body;
    return value ? *value : Value::object();
  }

  static double number(const Value& object, std::string_view name) { return object.find(name)->number(); }
  static std::string text(const Value& object, std::string_view name) { return object.find(name)->text(); }
  static std::string message(const Response& response) {
    return json::parse(response.body)->find("error")->find("message")->text();
  }

  Value keep_plan(const std::string& more = "") {
    return value_of(send("POST", "/api/plans", std::string("{\"request\": ") + short_request + more + "}"), 201);
  }

  Value wait_for_end(int id) {
    for (int k = 0; k < 2000; ++k) {
      const Value state = value_of(send("GET", "/api/captures/" + std::to_string(id)), 200);
      if (text(state, "state") != "waiting" && text(state, "state") != "running") return state;
      std::this_thread::sleep_for(10ms);
    }
    ADD_FAILURE() << "the capture has not ended";
    return Value::object();
  }

  testing_support::Archive archive;
  app::Workbench workbench{archive.store()};
  std::unique_ptr<app::CaptureService> captures;
  DescribedRouter router;
};

TEST_F(CaptureRoutes, DraftAPlanWithoutKeepingIt) {
  const Value draft = value_of(send("POST", "/api/plans/draft", short_request), 200);
  EXPECT_EQ(draft.find("targets")->items().size(), 3u);
  EXPECT_THAT(text(draft, "figure_svg"), HasSubstr("<svg"));
  EXPECT_EQ(number(*draft.find("request"), "seed"), 3);
  const Value dark = value_of(send("POST", "/api/plans/draft", short_request, {{"theme", "dark"}}), 200);
  EXPECT_NE(text(dark, "figure_svg"), text(draft, "figure_svg"));
  EXPECT_TRUE(value_of(send("GET", "/api/plans"), 200).find("plans")->items().empty());
  const Response bad = send("POST", "/api/plans/draft", "{\"axis\": \"X\",\n \"kind\": 3}");
  EXPECT_EQ(bad.status, 422);
  EXPECT_EQ(json::parse(bad.body)->find("error")->find("line")->number(), 2);
}

TEST_F(CaptureRoutes, KeepPlansInVersions) {
  const Value plan = keep_plan(", \"title\": \"X of the <b>mill</b>\"");
  EXPECT_EQ(number(plan, "id"), 1);
  EXPECT_EQ(text(plan, "title"), "X of the <b>mill</b>");
  const std::string edit =
      std::string(R"({"base_version": 1, "title": "Again", "reason": "longer", "request": )") + short_request + "}";
  const Response edited = send("PUT", "/api/plans/1", edit);
  EXPECT_EQ(number(value_of(edited, 200), "version"), 2);
  EXPECT_EQ(edited.kept.id, 1) << "for a receipt";
  EXPECT_EQ(edited.kept.version, 2);
  const Response late = send("PUT", "/api/plans/1", edit);
  EXPECT_EQ(late.status, 409);
  EXPECT_EQ(text(value_of(send("GET", "/api/plans/1", "", {{"version", "1"}}), 200), "title"), "X of the <b>mill</b>");
  EXPECT_EQ(value_of(send("GET", "/api/plans/1/versions"), 200).find("versions")->items().size(), 2u);
  EXPECT_EQ(send("GET", "/api/plans/2").status, 404);
  EXPECT_EQ(send("GET", "/api/plans/..").status, 404);
}

TEST_F(CaptureRoutes, ImportAPlansFileAndGiveItBack) {
  const Value plan = keep_plan();
  const Response file = send("GET", "/api/plans/1/plan.json");
  EXPECT_THAT(file.body, HasSubstr("axiometry-plan/1"));
  Value body = Value::object();
  body.add("plan", file.body);
  const Value imported = value_of(send("POST", "/api/plans", json::dump(body)), 201);
  EXPECT_TRUE(imported.find("request")->is(json::Kind::null));
  EXPECT_EQ(json::dump(*imported.find("targets")), json::dump(*plan.find("targets")));
}

TEST_F(CaptureRoutes, WriteSheetsAndProgramsOfPlansAndDrafts) {
  keep_plan();
  const Response sheet = send("GET", "/api/plans/1/sheet.html");
  EXPECT_THAT(sheet.body, HasSubstr("<html"));
  EXPECT_THAT(sheet.headers, testing::Contains(testing::Pair("Content-Security-Policy", document_policy)));
  EXPECT_TRUE(send("GET", "/api/plans/1/sheet.pdf").body.starts_with("%PDF"));
  EXPECT_EQ(send("GET", "/api/plans/1/sheet.exe").status, 422);
  const Response program = send("GET", "/api/plans/1/program", "", {{"dialect", "linuxcnc"}, {"unrolled", "1"}});
  EXPECT_EQ(program.status, 200);
  const std::string body = std::string("{\"request\": ") + short_request +
                           ", \"dialect\": \"linuxcnc\", \"options\": {\"unrolled\": true, \"decimals\": 4}}";
  EXPECT_EQ(send("POST", "/api/plans/draft/program", body).body, program.body);
  EXPECT_EQ(send("GET", "/api/plans/1/program", "", {{"dialect", "linuxcnc"}, {"part", "2"}}).status, 422);
  EXPECT_THAT(message(send("GET", "/api/plans/1/program", "", {{"dialect", "fanic"}})), HasSubstr("perhaps fanuc"));
  EXPECT_THAT(message(send("GET", "/api/plans/1/program", "", {{"dialect", "fanuc"}, {"file", "/etc/x"}})),
              HasSubstr("file: found no such option"));
}

TEST_F(CaptureRoutes, CaptureFromTheSimulatorToAKeptTest) {
  keep_plan();
  const Value sources = value_of(send("GET", "/api/sources"), 200);
  EXPECT_EQ(text(sources.find("sources")->items().at(0), "kind"), "simulator");
  const Value capture = value_of(
      send("POST", "/api/captures",
           R"({"plan": 1, "source": "simulator", "layout": "", "options": {"speed": 60, "preset": "backlash"}})"),
      201);
  const int id = static_cast<int>(number(capture, "id"));
  EXPECT_EQ(number(capture, "approaches"), 12);
  const Value end = wait_for_end(id);
  EXPECT_EQ(text(end, "state"), "complete") << json::dump(end);
  EXPECT_EQ(end.find("readings")->items().size(), 12u);
  EXPECT_TRUE(end.find("so_far")->is(json::Kind::object));
  ASSERT_TRUE(end.find("test")->is(json::Kind::number)) << json::dump(end);
  const Value test = value_of(send("GET", "/api/tests/1"), 200);
  EXPECT_EQ(number(test, "plan"), 1);
  EXPECT_EQ(text(*test.find("machine"), "name"), "Mill (simulated)");
  ASSERT_EQ(test.find("documents")->items().size(), 2u);
  const Response raw = send("GET", "/api/documents/1");
  EXPECT_TRUE(raw.body.starts_with("# Simulated, not measured\ntime_s,position_mm\n"));
  EXPECT_THAT(send("GET", "/api/tests/1/raw").body, HasSubstr("Simulated, not measured"));
}

TEST_F(CaptureRoutes, AFailingRequestBeginsNothing) {
  keep_plan();
  struct Bad {
    const char* body;
    int status;
    const char* message;
  };
  const Bad table[] = {
      {R"({"source": "simulator"})", 422, "found no plan"},
      {R"({"plan": 9, "source": "simulator"})", 404, ""},
      {R"({"plan": 1, "source": "tcp://127.0.0.1:22"})", 404, "found no source"},
      {R"({"plan": 1, "source": "simulator", "host": "x"})", 422, "unknown member \"host\""},
      {R"({"plan": 1, "source": "simulator", "layout": "/dev/sda"})", 422, "unknown stream"},
      {R"({"plan": 1, "source": "simulator", "options": {"speed": 7}})", 422, "speed: found \"7\""},
      {R"({"plan": 1, "source": "simulator", "options": []})", 422, "options: found array"},
      {R"({"resume": 1})", 404, ""},
      {R"({"resume": 1, "plan": 1})", 422, "expected it alone"},
      {"{", 422, ""},
  };
  for (const Bad& bad : table) {
    const Response response = send("POST", "/api/captures", bad.body);
    EXPECT_EQ(response.status, bad.status) << bad.body << response.body;
    EXPECT_THAT(message(response), HasSubstr(bad.message));
  }
  EXPECT_TRUE(value_of(send("GET", "/api/captures"), 200).find("captures")->items().empty());
  EXPECT_EQ(send("GET", "/api/captures/1").status, 404);
  EXPECT_EQ(send("POST", "/api/captures/1/stop").status, 404);
  EXPECT_FALSE(std::filesystem::exists(captures_folder()));
}

std::string length_wish(std::size_t part, const std::string& more = "") {
  Value lengths = Value::object();
  lengths.add("kind", "volume");
  lengths.add("plan", *testing_support::volume_body().find("plan"));
  lengths.add("part", part);
  return "{\"lengths\": " + json::dump(lengths) + R"(, "source": "simulator", "options": {"speed": 60})" + more + "}";
}

TEST_F(CaptureRoutes, CaptureTheLengthsOfAPlanPartByPartToOneTable) {
  const Value first = value_of(send("POST", "/api/captures", length_wish(1)), 201);
  EXPECT_TRUE(first.find("plan")->is(json::Kind::null));
  EXPECT_EQ(number(*first.find("lengths"), "due"), 1);
  EXPECT_EQ(text(*first.find("lengths"), "title"), "part 1 (station A, tool T1)");
  const Value second = value_of(send("POST", "/api/captures", length_wish(2)), 201);
  const Value end = wait_for_end(static_cast<int>(number(first, "id")));
  EXPECT_EQ(text(end, "state"), "complete") << json::dump(end);
  EXPECT_EQ(end.find("lengths")->find("caught")->items().size(), testing_support::volume_points);
  EXPECT_EQ(
      wait_for_end(static_cast<int>(number(second, "id"))).find("lengths")->find("end")->find("files")->items().size(),
      3u);

  const Value plan = value_of(send("GET", "/api/captures/1/plan"), 200);
  ASSERT_EQ(plan.find("stops")->items().size(), testing_support::volume_points);
  EXPECT_EQ(text(plan.find("stops")->items()[0], "name"), "point 1");
  const std::string plan_text = json::dump(*plan.find("plan"));
  const Value parts =
      value_of(send("POST", "/api/captures/parts", R"({"kind": "volume", "part": 1, "plan": )" + plan_text + "}"), 200);
  EXPECT_EQ(parts.find("parts")->items().size(), 2u);
  EXPECT_EQ(parts.find("captures")->items().size(), 2u);
  EXPECT_EQ(text(parts, "plan_id"), text(plan, "plan_id"));

  const Response table = send("POST", "/api/captures/lengths", R"({"captures": [1, 2]})");
  EXPECT_EQ(table.status, 200);
  const auto read = formats::read_volumetric_lengths(table.body);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->readings.size(), 2 * testing_support::volume_points);
  const Response raw = send("GET", "/api/captures/1/files/raw");
  EXPECT_THAT(raw.body, testing::StartsWith("# Simulated, not measured\ntime_s,length_mm\n"));
  EXPECT_THAT(raw.headers, testing::Contains(testing::Pair("Content-Disposition", HasSubstr("capture-1.raw"))));
  EXPECT_EQ(send("GET", "/api/captures/1/files/order").status, 404);

  EXPECT_EQ(send("POST", "/api/captures/1/discard").status, 200);
  EXPECT_EQ(send("POST", "/api/captures/1/discard").status, 404);
  EXPECT_EQ(send("POST", "/api/captures/lengths", R"({"captures": [1, 2]})").status, 404);
}

TEST_F(CaptureRoutes, CapturesOfLengthsAreToldInGerman) {
  value_of(send("POST", "/api/captures", length_wish(1, R"(, "layout": "")")), 201);
  wait_for_end(1);
  const Value state = value_of(send("GET", "/api/captures/1", "", {}, language::Language::german), 200);
  EXPECT_EQ(text(*state.find("lengths"), "title"), "Teil 1 (Station A, Werkzeug T1)");
  for (const Value& note : state.find("lengths")->find("end")->find("notes")->items())
    EXPECT_THAT(note.text(), HasSubstr("Aufzeichnung"));
  const Value plan = value_of(send("GET", "/api/captures/1/plan", "", {}, language::Language::german), 200);
  EXPECT_EQ(text(plan.find("stops")->items()[0], "name"), "Punkt 1");
  EXPECT_EQ(text(plan.find("stops")->items()[0], "group"), "Teil 1");
}

TEST_F(CaptureRoutes, AFailingRequestForLengthsBeginsNothing) {
  keep_plan();
  const std::string plan = json::dump(*testing_support::volume_body().find("plan"));
  const auto lengths = [&](const std::string& more) {
    return R"({"source": "simulator", "lengths": {"plan": )" + plan + more + "}}";
  };
  struct Bad {
    std::string body;
    int status;
    const char* message;
  };
  const Bad table[] = {
      {lengths(""), 422, "found the kind"},
      {lengths(R"(, "kind": "house")"), 422, "expected lines or volume"},
      {lengths(R"(, "kind": "lines")"), 422, ""},
      {lengths(R"(, "kind": "volume")"), 422, "found part 0 asked for"},
      {lengths(R"(, "kind": "volume", "part": 3)"), 422, "expected 1 to 2"},
      {lengths(R"(, "kind": "volume", "part": 1.5)"), 422, "part"},
      {lengths(R"(, "kind": "volume", "part": 1, "file": "/etc/passwd")"), 422, "unknown member \"file\""},
      {R"({"source": "simulator", "lengths": 5})", 422, "lengths: found number"},
      {R"({"source": "simulator", "plan": 1, "lengths": {}})", 422, "found a plan beside lengths"},
      {length_wish(1, R"(, "options": {"zero": "first-target"})"), 422, ""},
  };
  for (const Bad& bad : table) {
    const Response response = send("POST", "/api/captures", bad.body);
    EXPECT_EQ(response.status, bad.status) << bad.body << response.body;
    EXPECT_THAT(message(response), HasSubstr(bad.message));
  }
  EXPECT_TRUE(value_of(send("GET", "/api/captures"), 200).find("captures")->items().empty());
  for (const char* body : {"{}", R"({"captures": []})", R"({"captures": "1"})", R"({"captures": [0]})"})
    EXPECT_EQ(send("POST", "/api/captures/lengths", body).status, 422) << body;
  EXPECT_EQ(send("POST", "/api/captures/lengths", R"({"captures": [7]})").status, 404);
  EXPECT_EQ(send("GET", "/api/captures/1/plan").status, 404);
  EXPECT_FALSE(std::filesystem::exists(captures_folder()));
}

TEST_F(CaptureRoutes, ACaptureOfATestIsNoneOfLengths) {
  keep_plan();
  value_of(send("POST", "/api/captures", R"({"plan": 1, "source": "simulator", "options": {"speed": 60}})"), 201);
  EXPECT_EQ(send("GET", "/api/captures/1/plan").status, 404);
  EXPECT_EQ(send("GET", "/api/captures/1/files/raw").status, 404);
  EXPECT_EQ(send("POST", "/api/captures/1/discard").status, 409);
  EXPECT_EQ(send("POST", "/api/captures/lengths", R"({"captures": [1]})").status, 404);
  EXPECT_EQ(text(wait_for_end(1), "state"), "complete");
}

/// A stream of a straightness, all of it at once to the one who connects.
struct DrivenStream {
  static std::string bytes() {
    std::string text = "time_s,straightness_um,trigger\n";
    for (const auto& s : testing_support::DrivenAxis(testing_support::straightness_plan()).samples())
      text += fmt::format("{:.2f},{:.4f},{}\n", s.time_s, s.value_um, s.trigger ? 1 : 0);
    return text;
  }
  testing_support::PieceServer server{{bytes()}};
};

class MotionCaptureRoutes : private DrivenStream, public CaptureRoutes {
 protected:
  MotionCaptureRoutes() : CaptureRoutes({server.source()}) {
    Value body = Value::object();
    body.add("plan", formats::write_plan(testing_support::straightness_plan()));
    value_of(send("POST", "/api/plans", json::dump(body)), 201);
  }
  static std::string wish(const std::string& options) {
    return R"({"plan": 1, "source": "laser", "layout": "", "options": {)" + options + "}}";
  }
};

TEST_F(MotionCaptureRoutes, CaptureAStraightnessToReadingsThatAreEvaluated) {
  const Value begun = value_of(
      send("POST", "/api/captures",
           wish(R"("stops": "trigger", "stop-column": 2, "stream-axis": 1, "give-up": 0, "positive": "+Y")")),
      201);
  EXPECT_EQ(text(*begun.find("motion"), "error"), "EYX");
  EXPECT_EQ(text(*begun.find("motion"), "stops"), "trigger");
  EXPECT_EQ(number(*begun.find("due"), "target"), 1);
  EXPECT_TRUE(begun.find("anew")->boolean());
  const Value end = wait_for_end(1);
  EXPECT_EQ(text(end, "state"), "complete") << json::dump(end);
  EXPECT_TRUE(end.find("test")->is(json::Kind::null));
  EXPECT_EQ(text(end, "unit"), "um");
  ASSERT_EQ(end.find("readings")->items().size(), 12u);
  EXPECT_NEAR(number(end.find("readings")->items()[1], "deviation"), 3.0, 0.1);
  EXPECT_EQ(number(*end.find("motion")->find("end"), "found"), 12);
  EXPECT_EQ(end.find("motion")->find("end")->find("files")->items().size(), 3u) << "raw, times, readings";

  const Response table = send("GET", "/api/captures/1/files/readings");
  EXPECT_THAT(table.body, HasSubstr("# positive: +Y\n"));
  EXPECT_THAT(table.headers, testing::Contains(testing::Pair("Content-Disposition", HasSubstr("capture-1.csv"))));
  EXPECT_THAT(send("GET", "/api/captures/1/files/raw").body, testing::StartsWith("time_s,straightness_um,trigger\n"));
  const app::CalibrationSource readings{"readings", "eyx.csv", table.body};
  EXPECT_TRUE(app::evaluate_calibration("straightness", {&readings, 1}, Value::object()));

  const Value german = value_of(send("GET", "/api/captures/1", "", {}, language::Language::german), 200);
  EXPECT_EQ(text(*german.find("motion"), "error"), "EYX");
  EXPECT_EQ(send("POST", "/api/captures/1/keys", R"({"key": "take"})").status, 409) << "it has ended";
  EXPECT_EQ(send("GET", "/api/captures/1/plan").status, 404);
  EXPECT_EQ(send("POST", "/api/captures/1/discard").status, 200);
  EXPECT_TRUE(value_of(send("GET", "/api/captures"), 200).find("captures")->items().empty());
}

TEST_F(MotionCaptureRoutes, CaptureAStraightnessFromTheSimulatorThatSaysSo) {
  const Value offered = value_of(send("GET", "/api/sources"), 200);
  const Value& presets = *offered.find("sources")->items().at(0).find("motion_presets");
  EXPECT_EQ(text(presets.items().at(0), "id"), "good");
  value_of(send("POST", "/api/captures",
                R"({"plan": 1, "source": "simulator", "options": {"stops": "readings", "speed": 60, "seed": 3}})"),
           201);
  const Value end = wait_for_end(1);
  EXPECT_EQ(text(end, "state"), "complete") << json::dump(end);
  EXPECT_EQ(text(*end.find("source"), "kind"), "simulator");
  EXPECT_EQ(number(*end.find("motion")->find("end"), "found"), 12);
  const std::string table = send("GET", "/api/captures/1/files/readings").body;
  EXPECT_THAT(table, HasSubstr("# test.purpose: simulation\n"));
  EXPECT_THAT(table, HasSubstr("# test.comment: Simulated, not measured: fault good, size 5 um; seed 3\n"));
}

TEST_F(MotionCaptureRoutes, WhatIsSaidAtAStopIsTakeSkipOrUndo) {
  value_of(send("POST", "/api/captures", wish(R"("stops": "keys", "stream-axis": 1)")), 201);
  const Value said = value_of(send("POST", "/api/captures/1/keys", R"({"key": "skip"})"), 200);
  EXPECT_EQ(text(*said.find("motion"), "stops"), "keys");
  for (const char* body : {"{}", R"({"key": "enter"})", R"({"key": 1})", R"({"key": "take", "time_s": 3})"})
    EXPECT_EQ(send("POST", "/api/captures/1/keys", body).status, 422) << body;
  EXPECT_EQ(send("POST", "/api/captures/9/keys", R"({"key": "take"})").status, 404);
  EXPECT_EQ(send("POST", "/api/captures/1/stop").status, 200);
}

TEST_F(MotionCaptureRoutes, AFailingRequestForAMotionBeginsNothing) {
  const std::pair<std::string, const char*> table[] = {
      {wish(""), "found a plan made for EYX"},
      {wish(R"("unit": "um")"), "found what is said of stops without stops"},
      {wish(R"("stops": "bells")"), "expected keys, trigger, readings or position"},
      {wish(R"("stops": "trigger")"), "found no column of the trigger"},
      {R"({"plan": 1, "source": "simulator", "options": {"stops": "keys", "size": 0}})", "size: found \"0\""},
      {R"({"plan": 1, "source": "simulator", "layout": "umd", "options": {"stops": "keys"}})", "layout: found umd"},
      {wish(R"("stops": "keys", "size": 5)"), "expected it with the simulator only"},
  };
  for (const auto& [body, told] : table) {
    const Response response = send("POST", "/api/captures", body);
    EXPECT_EQ(response.status, 422) << body << response.body;
    EXPECT_THAT(message(response), HasSubstr(told));
  }
  EXPECT_TRUE(value_of(send("GET", "/api/captures"), 200).find("captures")->items().empty());
}

}  // namespace
}  // namespace axiometry::server
