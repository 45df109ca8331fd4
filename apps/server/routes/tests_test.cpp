// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "axiometry/app/workbench/examples/example_table2.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/model/simulated.h"
#include "server/routes/described_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/archive.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::HasSubstr;

class Routes : public testing::Test {
 protected:
  Routes() {
    // These routes have nothing to do with captures.
    auto& captures = *reinterpret_cast<app::CaptureService*>(&workbench);
    const Context context{archive.store(), workbench, captures};
    add_test_routes(router, context);
    add_equipment_routes(router, context);
    add_audit_routes(router, context);
    add_compensation_routes(router, context);
  }

  Response send(std::string method, std::string path, std::string body = {}, Pairs query = {}, Pairs headers = {}) {
    Request request;
    request.method = std::move(method);
    request.path = std::move(path);
    request.query = std::move(query);
    request.headers = std::move(headers);
    request.body = std::move(body);
    request.actor = "A. Tester";
    return router.answer(request);
  }

  Value answer(const Response& response, int status) {
    EXPECT_EQ(response.status, status) << response.body;
    auto value = json::parse(response.body);
    EXPECT_TRUE(value) << response.body;
    return value ? *value : Value::object();
  }

  Value upload(std::string bytes = std::string(app::example_table2), std::string name = "t%C3%A4st.json") {
    return answer(send("POST", "/api/tests", std::move(bytes), {}, {{"x-file-name", std::move(name)}}), 201);
  }

  static double number(const Value& object, std::string_view name) { return object.find(name)->number(); }
  static std::string text(const Value& object, std::string_view name) { return object.find(name)->text(); }
  static std::string message(const Response& response) {
    return json::parse(response.body)->find("error")->find("message")->text();
  }

  testing_support::Archive archive;
  app::Workbench workbench{archive.store()};
  DescribedRouter router;
};

TEST_F(Routes, TakeAllProcessorsByTheValueAndNotByTheBytes) {
  upload();
  const auto load = [&](const std::string& path, const std::string& body, Pairs query = {}) {
    auto request = std::make_shared<Request>();
    request->method = "POST";
    request->path = path;
    request->body = body;
    request->query = std::move(query);
    EXPECT_EQ(router.queue_of(*request), Load::light);
    return router.read(request).load;
  };
  const std::string escaped = R"({"options": {"methods": ["monte\u002dcarlo"]}})";
  EXPECT_EQ(load("/api/tests/1/evaluate", escaped), Load::lone);
  EXPECT_EQ(load("/api/tests/1/evaluate", "{}"), Load::heavy);
  EXPECT_EQ(load("/api/evaluations", "", {{"draft", escaped}}), Load::lone);
  EXPECT_EQ(load("/api/evaluations", "\"monte-carlo\""), Load::heavy);
  EXPECT_EQ(load("/api/tests/1/versions", R"({"base_version": 1, "title": "\"monte-carlo\""})"), Load::edit);
  EXPECT_EQ(load("/api/tests/1/versions", R"({"base_version": 1, "options": {"methods": ["monte\u002dcarlo"]}})"),
            Load::lone);
}

TEST_F(Routes, SayWhichOfThemMayKeepSomething) {
  const auto keeps = [&](const std::string& path) {
    Request request{};
    request.method = "POST";
    request.path = path;
    return router.keeps(request);
  };
  for (const std::string path : {"/api/tests", "/api/tests/1/versions", "/api/tests/1/reports",
                                 "/api/tests/1/attachments", "/api/tests/1/withdraw", "/api/machines", "/api/examples"})
    EXPECT_TRUE(keeps(path)) << path;
  for (const std::string path : {"/api/preview", "/api/evaluations", "/api/tests/1/evaluate"})
    EXPECT_FALSE(keeps(path)) << path;
}

TEST_F(Routes, WaitForNoTrialsWhereAReportIsOnlyReadFromTheArchive) {
  upload();
  answer(send("POST", "/api/tests/1/versions",
              R"({"base_version": 1, "options": {"methods": ["monte-carlo"], "trials": 10000}})"),
         201);
  const auto load = [&](const std::string& path) {
    auto request = std::make_shared<Request>();
    request->method = "GET";
    request->path = path;
    return router.read(request).load;
  };
  EXPECT_EQ(load("/api/tests/1/report.csv"), Load::lone);
  EXPECT_EQ(load("/api/tests/1/report.json"), Load::heavy);
}

TEST_F(Routes, SearchForNoMoreThanAPersonTypes) {
  upload();
  std::string words = "table";
  for (int k = 1; k < 30; ++k) words += " table";
  answer(send("GET", "/api/tests", {}, {{"text", words}}), 200);
  EXPECT_THAT(message(send("GET", "/api/tests", {}, {{"text", words + " x"}})),
              HasSubstr("found 31 words to search for, expected at most 30"));
  EXPECT_EQ(send("GET", "/api/tests", {}, {{"text", std::string(501, 'a')}}).status, 422);
}

TEST_F(Routes, HaveOneKeyForOneReportUntilSomethingChanges) {
  upload();
  const auto key = [&](const std::string& path, Pairs query = {}) {
    auto request = std::make_shared<Request>();
    request->method = "GET";
    request->path = path;
    request->query = std::move(query);
    return router.read(request).key;
  };
  const std::string report = key("/api/tests/1/report.html");
  EXPECT_FALSE(report.empty());
  EXPECT_EQ(key("/api/tests/1/report.html"), report);
  EXPECT_NE(key("/api/tests/1/report.pdf"), report);
  EXPECT_NE(key("/api/tests/1/report.html", {{"unit", "mm"}}), report);
  answer(send("POST", "/api/tests/1/withdraw"), 200);
  EXPECT_NE(key("/api/tests/1/report.html"), report);
}

TEST_F(Routes, SayWhereAnImportProfileIsWrong) {
  const std::string rows = "0 1 2\n1 1 2\n2 1 2\n3 1 2\n4 1 2\n";
  const auto refusal = [&](const std::string& profile, const std::string& more = {}) {
    const std::string body = "--x\r\nContent-Disposition: form-data; name=\"profile\"\r\n\r\n" + profile +
                             "\r\n--x\r\nContent-Disposition: form-data; name=\"file\"; filename=\"rows.dat\"\r\n\r\n" +
                             rows + more + "\r\n--x--\r\n";
    const Response response =
        send("POST", "/api/preview", body, {}, {{"content-type", "multipart/form-data; boundary=x"}});
    EXPECT_EQ(response.status, 422) << response.body;
    return *json::parse(response.body)->find("error");
  };
  const Value unknown = refusal("{\"format\": \"axiometry-import-profile/1\",\n \"colums\": []}");
  EXPECT_THAT(text(unknown, "message"), HasSubstr("perhaps \"columns\""));
  EXPECT_EQ(text(unknown, "file"), "profile");
  EXPECT_EQ(number(unknown, "line"), 2.0);
  EXPECT_GT(number(unknown, "column"), 1.0);
  EXPECT_THAT(text(refusal(std::string(70'000, ' ')), "message"), HasSubstr("70000 bytes, expected at most 65536"));
  EXPECT_THAT(text(refusal("{}", "\r\n--x\r\nContent-Disposition: form-data; name=\"profile\"\r\n\r\n{}"), "message"),
              HasSubstr("found the part \"profile\" twice"));
}

TEST_F(Routes, TakeAFileAndGiveItBack) {
  const Value received = upload();
  EXPECT_EQ(number(received, "id"), 1);
  EXPECT_EQ(text(received.find("readings")->find("up")->is(json::Kind::array) ? *received.find("result") : received,
                 "standard"),
            "ISO 230-2:2014");
  EXPECT_EQ(text(received.find("shown")->items().front(), "value"), "9.6");
  const Response raw = send("GET", "/api/tests/1/raw");
  EXPECT_EQ(raw.body, app::example_table2);
  EXPECT_THAT(raw.headers.front().second, HasSubstr("filename*=UTF-8''t%C3%A4st.json"));
  const Value test = answer(send("GET", "/api/tests/1"), 200);
  EXPECT_EQ(text(*test.find("file"), "name"), "täst.json");
  EXPECT_EQ(text(*test.find("received"), "actor"), "A. Tester");
}

TEST_F(Routes, LoadTheExamplesIntoAnEmptyArchiveOnly) {
  const Value loaded = answer(send("POST", "/api/examples"), 201);
  EXPECT_EQ(number(loaded, "tests"), number(answer(send("GET", "/api/tests"), 200), "total"));
  EXPECT_GT(number(loaded, "tests"), 3);
  const Response again = send("POST", "/api/examples");
  EXPECT_EQ(again.status, 409);
  EXPECT_EQ(message(again), "found an archive that holds something, expected an empty one for the examples");
  EXPECT_EQ(number(answer(send("GET", "/api/tests"), 200), "total"), number(loaded, "tests"));
}

TEST_F(Routes, LoadTheExamplesOnceWhenManyAskAtOnce) {
  std::vector<int> statuses(4);
  {
    std::vector<std::jthread> askers;
    for (int& status : statuses) askers.emplace_back([&] { status = send("POST", "/api/examples").status; });
  }
  EXPECT_THAT(statuses, testing::UnorderedElementsAre(201, 409, 409, 409));
  EXPECT_EQ(number(answer(send("GET", "/api/tests"), 200), "total"), 14);
}

TEST_F(Routes, TakeAFormOfSeveralFiles) {
  const std::string head = "Content-Disposition: form-data; name=\"file\"; filename=\"";
  const std::string bytes(app::example_table2);
  const std::string body = "--b\r\n" + head + "../one.json\"\r\n\r\n" + bytes + "\r\n--b\r\n" + head +
                           "two.json\"\r\n\r\n" + bytes + "\r\n--b--\r\n";
  const Value received =
      answer(send("POST", "/api/tests", body, {}, {{"content-type", "multipart/form-data; boundary=b"}}), 201);
  EXPECT_EQ(received.find("tests")->items().size(), 2u);
  EXPECT_EQ(text(received.find("tests")->items()[0], "title"), "one");
}

TEST_F(Routes, TakeFilesOfFormsUnderAnyNameAndRefuseOtherParts) {
  const auto part = [](const std::string& head, std::string_view bytes) {
    return "--b\r\nContent-Disposition: form-data; " + head + "\r\n\r\n" + std::string(bytes) + "\r\n";
  };
  const std::string file = part(R"(name="measured"; filename="one.json")", app::example_table2);
  const auto receive = [&](const std::string& more) {
    return send("POST", "/api/tests", file + more + "--b--\r\n", {},
                {{"content-type", "multipart/form-data; boundary=b"}});
  };
  const std::string options = part(R"(name="options")", "{}");
  for (const std::string& more : {options + options, options, part(R"(name="nonsense")", "1")}) {
    const Response refused = receive(more);
    EXPECT_EQ(refused.status, 422);
    EXPECT_THAT(message(refused), HasSubstr("in the form, expected files and profile"));
  }
  EXPECT_EQ(message(receive(part(R"(name="profile"; filename="p.json")", "{}"))),
            "found the part \"profile\" as a file, expected a text");
  EXPECT_EQ(message(receive(part(R"(name="file"; filename="two.csv")", ""))),
            "found the file \"two.csv\" empty, expected one with content");
  EXPECT_EQ(number(answer(send("GET", "/api/tests"), 200), "total"), 0);
  answer(receive(""), 201);
}

TEST_F(Routes, RefuseAFileWithLineAndColumnAndKeepNothing) {
  const Response refused =
      send("POST", "/api/tests", "target_mm,direction,run,deviation_um\n0,+,1,x\n", {}, {{"x-file-name", "<b>.csv"}});
  EXPECT_EQ(refused.status, 422);
  const auto error = *json::parse(refused.body)->find("error");
  EXPECT_EQ(number(error, "line"), 2);
  EXPECT_EQ(text(error, "file"), "<b>.csv");
  std::string endless(app::example_table2);
  endless.insert(endless.find("Ball screw"), 50'000, 'x');
  EXPECT_THAT(send("POST", "/api/tests", endless, {}, {{"x-file-name", "a.json"}}).body, HasSubstr("50029 bytes"));
  EXPECT_EQ(send("POST", "/api/tests").status, 422);
  EXPECT_EQ(send("POST", "/api/tests", "x", {}, {{"x-file-name", "%zz"}}).status, 422);
  EXPECT_EQ(number(answer(send("GET", "/api/tests"), 200), "total"), 0);
}

TEST_F(Routes, TryAndReviseAndAnswerConflicts) {
  upload();
  const std::string changes = R"({"changes": {"tolerance.A": "5"}, "options": {"methods": ["gum"]}})";
  const Value draft = answer(send("POST", "/api/tests/1/evaluate", changes), 200);
  EXPECT_EQ(text(draft, "verdict"), "does not conform");
  const std::string revision =
      R"({"base_version": 1, "title": "<i>T</i>", "reason": "limit", "changes": {"tolerance.A": "50"}})";
  const Value second = answer(send("POST", "/api/tests/1/versions", revision), 201);
  EXPECT_EQ(number(second, "version"), 2);
  EXPECT_EQ(text(second, "title"), "<i>T</i>");
  EXPECT_EQ(text(second, "verdict"), "conforms");
  EXPECT_EQ(send("POST", "/api/tests/1/versions", revision).status, 409);
  EXPECT_EQ(send("POST", "/api/tests/1/versions", R"({"base_version": 4294967298})").status, 422);  // 2 in 32 bits
  EXPECT_TRUE(answer(send("GET", "/api/tests/1", "", {{"version", "1"}}), 200).find("verdict")->is(json::Kind::null));
  EXPECT_EQ(send("GET", "/api/tests/1", "", {{"version", "7"}}).status, 404);
  EXPECT_EQ(send("POST", "/api/tests/1/evaluate", R"({"changes": {"tolerance.A": "-5"}})").status, 422);
  EXPECT_EQ(send("POST", "/api/tests/1/evaluate", R"({"chances": {}})").status, 422);
  const Response wrong = send("POST", "/api/tests/1/versions", "{\n  \"base_version\": \"one\"}");
  EXPECT_EQ(wrong.status, 422);
  EXPECT_EQ(number(*json::parse(wrong.body)->find("error"), "line"), 2);
}

TEST_F(Routes, ShutWhatCouldRunIntoASandbox) {
  upload();
  const auto policy = [&](const std::string& path) {
    const Response response = send("GET", path);
    EXPECT_EQ(response.status, 200) << path;
    for (const auto& [name, value] : response.headers)
      if (name == "Content-Security-Policy") return value;
    return std::string();
  };
  EXPECT_THAT(policy("/api/tests/1/report.html"), HasSubstr("sandbox"));
  EXPECT_THAT(policy("/api/tests/1/report.svg"), HasSubstr("sandbox"));
  EXPECT_THAT(policy("/api/tests/1/figures/1.svg"), HasSubstr("sandbox"));
  EXPECT_EQ(send("GET", "/api/tests/1/report.html", "", {{"download", "1"}}).headers.front().first,
            "Content-Disposition");
  EXPECT_EQ(send("GET", "/api/tests/1/report.exe").status, 404);
  EXPECT_EQ(send("GET", "/api/tests/1/report.html", "", {{"unit", "inch"}}).status, 422);
  EXPECT_EQ(send("GET", "/api/tests/99/report.html").status, 404);
  EXPECT_EQ(send("GET", "/api/tests/0x1/report.html").status, 404);
}

TEST_F(Routes, KeepReportsAndAttachments) {
  upload();
  const Value issued = answer(send("POST", "/api/tests/1/reports", R"({"extension": "csv", "decimal": "comma"})"), 201);
  EXPECT_EQ(text(issued, "kind"), "report");
  EXPECT_THAT(send("GET", "/api/documents/1").body, HasSubstr(";"));
  const Value attached = answer(send("POST", "/api/tests/1/attachments", "<script>", {},
                                     {{"x-file-name", "x.html"}, {"content-type", "text/html"}}),
                                201);
  EXPECT_EQ(text(attached, "media_type"), "text/html");
  const Response back = send("GET", "/api/documents/2");
  EXPECT_EQ(back.content_type, "application/octet-stream");
  EXPECT_THAT(back.headers.front().second, HasSubstr("attachment"));
  EXPECT_EQ(answer(send("GET", "/api/tests/1"), 200).find("documents")->items().size(), 2u);
}

TEST_F(Routes, NameTheSensorsOfALogThatTellsNoRole) {
  upload();
  const std::string log = "time;Oil [C];KSS [C]\n2026-03-02 09:00;20;21\n2026-03-02 09:10;20;21\n";
  answer(send("POST", "/api/tests/1/attachments", log, {}, {{"x-file-name", "oil.csv"}}), 201);
  const Value named = answer(send("GET", "/api/documents/1/temperature-sensors"), 200);
  ASSERT_EQ(named.find("sensors")->items().size(), 2u);
  EXPECT_EQ(named.find("sensors")->items()[0].text(), "Oil");
  answer(send("POST", "/api/tests/1/attachments", "words\n", {}, {{"x-file-name", "words.txt"}}), 201);
  const Response none = send("GET", "/api/documents/2/temperature-sensors");
  EXPECT_EQ(none.status, 422);
  EXPECT_THAT(none.body, HasSubstr("expected a temperature log"));
  EXPECT_EQ(send("GET", "/api/documents/3/temperature-sensors").status, 404);
}

TEST_F(Routes, FilterAndRefuseFiltersThatAreNone) {
  upload();
  const auto total = [&](Pairs query) { return number(answer(send("GET", "/api/tests", "", query), 200), "total"); };
  EXPECT_EQ(total({{"text", "täst"}}), 1);
  EXPECT_EQ(total({{"text", "other"}}), 0);
  EXPECT_EQ(total({{"from", "2014-05-15"}, {"to", "2014-05-15"}}), 1);
  EXPECT_EQ(total({{"from", ""}, {"to", ""}}), 1);
  for (const char* name : {"from", "to"})
    for (const char* none :
         {"yesterday", "2014", "2014-5-15", "2014-02-30", "15.05.2014", "2014-05-15T09:30", " 2014-05-15"}) {
      const Response refused = send("GET", "/api/tests", "", {{name, none}});
      EXPECT_EQ(refused.status, 422) << none;
      EXPECT_THAT(refused.body, HasSubstr("expected a date such as 2026-01-31")) << none;
    }
  EXPECT_EQ(total({{"machine", "1"}, {"order", "A"}, {"descending", "0"}}), 1);
  EXPECT_EQ(total({{"machine", "2"}}), 0);
  EXPECT_EQ(send("GET", "/api/tests", "", {{"order", "colour"}}).status, 422);
  EXPECT_EQ(send("GET", "/api/tests", "", {{"limit", "5000"}}).status, 422);
  EXPECT_EQ(send("GET", "/api/tests", "", {{"offset", "-1"}}).status, 422);
  answer(send("POST", "/api/tests/1/withdraw", R"({"reason": "wrong axis"})"), 200);
  EXPECT_EQ(total({}), 0);
  EXPECT_EQ(total({{"withdrawn", "1"}}), 1);
  answer(send("POST", "/api/tests/1/reinstate"), 200);
  EXPECT_EQ(total({}), 1);
}

TEST_F(Routes, TellMachinesAxesAndTrends) {
  upload();
  const Value machines = answer(send("GET", "/api/machines"), 200);
  const Value& machine = machines.find("machines")->items().front();
  EXPECT_EQ(number(machine, "tests"), 1);
  EXPECT_EQ(number(*machine.find("latest_test"), "id"), 1);
  const Value& of_axis = machine.find("latest_of_axes")->items().front();
  EXPECT_EQ(number(of_axis, "axis"), 1);
  EXPECT_EQ(number(of_axis, "id"), 1);
  EXPECT_EQ(text(machine.find("axes")->items().front(), "name"), "X");
  std::string axis = R"({"base_version": 1, "machine": 1, "name": "X", "kind": "linear",
                         "limits": [{"parameter": "A", "value": 12}], "notes": "", "reason": "agreed"})";
  EXPECT_EQ(number(answer(send("PUT", "/api/axes/1", axis), 200), "version"), 2);
  EXPECT_EQ(send("PUT", "/api/axes/1", axis).status, 409);
  EXPECT_EQ(answer(send("GET", "/api/axes/1/versions"), 200).find("versions")->items().size(), 2u);
  const Value trend = answer(send("GET", "/api/axes/1/trend", "", {{"parameters", "A,B"}}), 200);
  EXPECT_EQ(trend.find("points")->items().front().find("figures")->items().size(), 2u);
  upload();
  const Value twice = answer(send("GET", "/api/axes/1/trend"), 200);
  ASSERT_EQ(twice.find("points")->items().size(), 1u) << "the same bytes are one measurement";
  EXPECT_EQ(twice.find("points")->items().front().find("same_bytes")->items().front().number(), 2);
  EXPECT_EQ(send("GET", "/api/axes/1/trend", "", {{"parameters", "A,Q"}}).status, 422);
  EXPECT_EQ(send("GET", "/api/axes/9/trend").status, 404);
  EXPECT_FALSE(answer(send("GET", "/api/audit"), 200).find("entries")->items().empty());
  EXPECT_FALSE(answer(send("GET", "/api/audit", "", {{"subject", "axis 1"}}), 200).find("entries")->items().empty());
}

TEST_F(Routes, RefuseWhatNoTestOrSubjectCanHaveInPlaceOfAnEmptyList) {
  struct Case {
    const char *path, *name, *value, *expected;
  };
  const Case cases[] = {
      {"/api/tests", "sha256", "zz", "found sha256=\"zz\", expected 64 hexadecimal digits"},
      {"/api/tests", "machine", "0", "found machine=\"0\", expected a whole number from 1 to"},
      {"/api/compensations", "test", "0", "found test=\"0\", expected a whole number from 1 to"},
      {"/api/audit", "subject", "tests 1", "found subject=\"tests 1\", expected one of test, machine"},
      {"/api/audit", "subject", "test", "found subject=\"test\", expected one of test, machine"},
      {"/api/audit", "subject", "test x", "with its number, as in \"test 12\""}};
  for (const auto& [path, name, value, expected] : cases) {
    const Value refused = answer(send("GET", path, "", {{name, value}}), 422);
    EXPECT_THAT(text(*refused.find("error"), "message"), testing::HasSubstr(expected)) << value;
  }
  const Value turned = answer(send("GET", "/api/tests", "", {{"from", "2026-02-01"}, {"to", "2026-01-31"}}), 422);
  EXPECT_THAT(text(*turned.find("error"), "message"), testing::HasSubstr("after to="));
  answer(
      send("GET", "/api/tests", "", {{"from", "2026-02-01"}, {"to", "2026-02-01"}, {"sha256", std::string(64, 'A')}}),
      200);
}

TEST_F(Routes, TellOfTestsInOneDirectionAllThatTheyHaveWhereNoParametersAreAskedFor) {
  std::string one_way = "# machine: M\n# axis: X\n# date: 2026-01-20\ntarget_mm,direction,run,deviation_um\n";
  for (int run = 1; run <= 5; ++run)
    for (int k = 0; k < 5; ++k)
      one_way += fmt::format("{},+,{},{}\n", 100 * k + k * k, run, 0.1 * ((7 * k + 3 * run) % 11));
  upload(one_way, "one-way.csv");
  std::vector<std::string> keys;
  const Value trend = answer(send("GET", "/api/axes/1/trend"), 200);
  ASSERT_EQ(trend.find("points")->items().size(), 1u);
  for (const Value& figure : trend.find("points")->items().front().find("figures")->items())
    keys.push_back(text(figure, "parameter"));
  EXPECT_THAT(keys, testing::UnorderedElementsAre("A_up", "E_up", "R_up"));
}

TEST_F(Routes, SayOfASimulatedTestThatItHasNoDate) {
  const auto undated = [&](std::string_view date) {
    std::string bytes = fmt::format("# date: {}\ntarget_mm,direction,run,deviation_um\n", date);
    bytes += "0,+,1,1\n0,-,1,2\n100,+,1,2\n100,-,1,2\n";
    const double id = number(upload(std::move(bytes), "date.csv"), "id");
    return answer(send("GET", fmt::format("/api/tests/{}", id)), 200).find("simulated_undated")->boolean();
  };
  EXPECT_TRUE(undated(simulated_date));
  EXPECT_FALSE(undated("2026-01-20"));
  EXPECT_FALSE(undated("None: lost"));
}

TEST_F(Routes, AddInstrumentsAndSayWhichInputIsWrong) {
  const Value added = answer(
      send("POST", "/api/instruments", R"({"manufacturer": "M", "inputs": {"uncertainty.misalignment_mm": "1"}})"),
      201);
  EXPECT_EQ(number(added, "id"), 1);
  const Response wrong = send("POST", "/api/instruments",
                              "{\"manufacturer\": \"M\",\n \"inputs\": {\"uncertainty.misalignment_mm\": \"x\"}}");
  EXPECT_EQ(wrong.status, 422);
  EXPECT_THAT(message(wrong), HasSubstr("uncertainty.misalignment_mm"));
  EXPECT_EQ(number(*json::parse(wrong.body)->find("error"), "line"), 2);
  EXPECT_EQ(send("POST", "/api/instruments", "{}").status, 422);
  EXPECT_EQ(send("POST", "/api/machines", R"({"name": "a\u0007"})").status, 422);
  EXPECT_EQ(send("PUT", "/api/instruments/1", R"({"manufacturer": "N"})").status, 422);
}

TEST_F(Routes, SayWhatTheyKeptSoThatAReceiptCanNameIt) {
  const auto kept = [&](std::string method, std::string path, std::string body) {
    const Response response = send(std::move(method), std::move(path), std::move(body));
    EXPECT_EQ(response.status / 100, 2) << response.body;
    return std::pair(response.kept.id, response.kept.version);
  };
  const auto version = [](store::Id id, int number) { return std::pair(std::optional(id), std::optional(number)); };
  const auto without_version = [](store::Id id) { return std::pair(std::optional(id), std::optional<int>()); };
  EXPECT_EQ(kept("POST", "/api/tests", std::string(app::example_table2)), version(1, 1));
  EXPECT_EQ(kept("POST", "/api/machines", R"({"name": "Mill"})"), version(2, 1));
  EXPECT_EQ(kept("PUT", "/api/machines/2", R"({"name": "Lathe", "base_version": 1})"), version(2, 2));
  EXPECT_EQ(kept("POST", "/api/axes", R"({"machine": 2, "name": "Y", "kind": "linear"})"), version(2, 1));
  EXPECT_EQ(kept("POST", "/api/instruments", R"({"manufacturer": "M"})"), version(3, 1));
  EXPECT_EQ(kept("POST", "/api/tests/1/attachments", "a note"), without_version(1));
  EXPECT_EQ(kept("POST", "/api/tests/1/reports", R"({"extension": "json"})"), without_version(2));
  EXPECT_EQ(kept("POST", "/api/tests/1/withdraw", R"({"reason": "r"})"), version(1, 1));
  EXPECT_EQ(kept("GET", "/api/machines/2", ""), std::pair(std::optional<store::Id>(), std::optional<int>()));
}

TEST_F(Routes, EvaluateWithoutKeeping) {
  const Value evaluated = answer(
      send("POST", "/api/evaluations", std::string(app::example_table2), {{"draft", R"({"changes": {}})"}}), 200);
  EXPECT_NEAR(number(*evaluated.find("result")->find("parameters"), "A"), 9.586, 5e-4);
  const Value preview = answer(send("POST", "/api/preview", "no test", {}, {{"x-file-name", "a.txt"}}), 200);
  EXPECT_FALSE(preview.find("refused")->is(json::Kind::null));
  EXPECT_EQ(number(answer(send("GET", "/api/tests"), 200), "total"), 0);
}

}  // namespace
}  // namespace axiometry::server
