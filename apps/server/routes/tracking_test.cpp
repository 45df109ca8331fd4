// SPDX-License-Identifier: Apache-2.0
// The tracking interferometer as the page asks for it: station, lines, program, sheet, evaluation.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/base/vector3.h"
#include "server/routes/route_test_support.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr Vector3 at = {100.0, 80.0, -600.0};  // the station of `request`
constexpr const char* request = R"({"setup": {"travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 600, 0]},
  "tool_offset_mm": [0, 0, -120], "station": {"position_mm": [100, 80, -600]}}, "turn_reflector": true, "runs": 2,
  "seed": 7, "machine": "Mill", "date": "2026-11-25"})";

class TrackingRoutes : public RouteTest {
 protected:
  TrackingRoutes() : RouteTest("/api/tracking/") { add_tracking_routes(router); }

  Response send(std::string_view path, std::string body, Pairs query = {}, std::string type = json_type,
                language::Language language = language::Language::english) const {
    return ask("POST", path, std::move(body), std::move(query), std::move(type), language);
  }

  Value draft(const std::string& of = request) const { return value_of(send("lines", "{\"request\": " + of + "}")); }

  /// A form with those files and options.
  static std::string form(const Pairs& files, const std::string& options = "") {
    return form_of(files, options.empty() ? Pairs() : Pairs{{"options", options}});
  }
  Response send_form(std::string_view path, const Pairs& files, const std::string& options = "",
                     Pairs query = {}) const {
    return send(path, form(files, options), std::move(query), form_type);
  }
};

Vector3 vector_of(const Value& value) {
  return {value.items()[0].number(), value.items()[1].number(), value.items()[2].number()};
}

std::vector<std::string> ids_of(const Value& lines) {
  std::vector<std::string> ids;
  for (const Value& line : lines.items()) ids.push_back(line.find("id")->text());
  std::ranges::sort(ids);
  return ids;
}

/// What a perfect instrument shows along the lines of a draft on a machine that is too long in Y by so much.
std::string lengths_of(const Value& draft, double scale_y) {
  std::string table = "line,target,direction,run,length_difference_mm\n";
  for (const Value& line : draft.find("lines")->items())
    for (int run = 1; run <= 2; ++run)
      for (const char* direction : {"up", "down"}) {
        int target = 0;
        for (const Value& place : line.find("targets")->items()) {
          Vector3 p = vector_of(place);
          p.y += scale_y * (p.y - at.y);
          table += fmt::format("{},{},{},{},{:.6f}\n", line.find("id")->text(), ++target, direction, run,
                               distance(p, at) - 100.0);
        }
      }
  return table;
}

std::string points_table(Vector3 station) {
  std::string table = "x_mm,y_mm,z_mm,length_difference_mm\n";
  const Vector3 places[] = {{0, 0, -620}, {800, 0, -620}, {800, 600, -620}, {0, 600, -120},
                            {0, 0, -120}, {800, 0, -120}, {400, 600, -300}, {300, 100, -150}};
  for (const Vector3 p : places)
    table += fmt::format("{},{},{},{:.5f}\n", p.x, p.y, p.z, distance(p, station) - distance(places[0], station));
  return table;
}

TEST_F(TrackingRoutes, plan_lines_with_what_a_picture_of_them_needs) {
  const Value planned = draft();
  EXPECT_THAT(ids_of(*planned.find("lines")), ElementsAre("x", "xy", "xyz", "xz", "y", "yz", "z"));
  EXPECT_EQ(vector_of(*planned.find("reach")->find("lowest_mm")), (Vector3{0, 0, -620}));
  EXPECT_GT(planned.find("duration_s")->number(), 60.0);
  EXPECT_FALSE(planned.find("way_mm")->items().empty());
  for (const Value& line : planned.find("lines")->items()) {
    const Vector3 first = vector_of(line.find("targets")->items().front());
    const Vector3 last = vector_of(line.find("targets")->items().back());
    EXPECT_NEAR(norm(cross(unit(first - at), unit(last - at))), 0.0, 1e-4) << "through the station";
    EXPECT_EQ(line.find("readings")->number(), 4.0 * static_cast<double>(line.find("targets")->items().size()));
  }
}

TEST_F(TrackingRoutes, give_a_request_that_makes_the_same_plan_again) {
  const std::string without_seed = R"({"setup": {"travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 600, 0]},
    "station": {"position_mm": [100, 80, -400]}}, "turn_reflector": true, "lines": ["x", "xy"]})";
  const Value first = draft(without_seed);
  const Value again = draft(json::dump(*first.find("request")));
  EXPECT_EQ(json::dump(*first.find("plan")), json::dump(*again.find("plan")));
  EXPECT_THAT(ids_of(*first.find("lines")), ElementsAre("x", "xy"));
}

constexpr const char* diagonals = R"({"setup": {"travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 600, 0]},
  "tool_offset_mm": [0, 0, -120]}, "lines": ["body", "face"], "runs": 2, "seed": 7, "date": "2026-11-25"})";

TEST_F(TrackingRoutes, plan_diagonals_of_the_travels_without_a_station) {
  const Value planned = draft(diagonals);
  EXPECT_EQ(planned.find("lines")->items().size(), 10u);
  EXPECT_EQ(planned.find("plan")->find("setup")->find("station"), nullptr);
  for (const Value& line : planned.find("lines")->items()) {
    EXPECT_THAT(line.find("standard")->text(), StartsWith("ISO 230-6"));
    EXPECT_TRUE(line.find("usable")->is(json::Kind::null));
    EXPECT_EQ(line.find("readings")->number(), 4.0 * static_cast<double>(line.find("targets")->items().size()))
        << "in both senses";
  }
  const std::string plan = json::dump(*planned.find("plan"));
  const std::string program = send("lines/program", "{\"plan\": " + plan + ", \"dialect\": \"linuxcnc\"}").body;
  std::size_t stops = 0;
  for (std::size_t at = program.find("M0\n"); at != std::string::npos; at = program.find("M0\n", at + 1)) ++stops;
  EXPECT_EQ(stops, 10u) << "the interferometer is aligned with each line first";
  const Response sheet = send("lines/sheet.html", "{\"plan\": " + plan + "}");
  EXPECT_THAT(sheet.body, HasSubstr("Diagonals by an aligned interferometer"));
  EXPECT_THAT(sheet.body, Not(HasSubstr("nan")));
}

TEST_F(TrackingRoutes, evaluate_diagonals_without_a_station_with_the_squareness_that_the_machine_has) {
  constexpr double out_of_square = 20e-6;  // Y leans towards −X
  const Value planned = draft(diagonals);
  std::string table = "line,target,direction,run,length_difference_mm\n";
  for (const Value& line : planned.find("lines")->items()) {
    const auto targets = line.find("targets")->items();
    const Vector3 first = vector_of(targets.front());
    for (int run = 1; run <= 2; ++run)
      for (const char* direction : {"up", "down"})
        for (std::size_t k = 0; k < targets.size(); ++k) {
          Vector3 way = vector_of(targets[k]) - first;
          way.x -= out_of_square * way.y;
          table += fmt::format("{},{},{},{},{:.6f}\n", line.find("id")->text(), k + 1, direction, run, norm(way));
        }
  }
  const Pairs files = {{"plan", json::dump(*planned.find("plan"))}, {"lengths", table}};
  const Value found = value_of(send_form("evaluation", files));
  const auto pairs = found.find("iso230_6")->find("face_pairs")->items();
  ASSERT_EQ(pairs.size(), 3u);
  for (const Value& pair : pairs) {
    const double expected = pair.find("face")->text() == "XY" ? 20.0 : 0.0;
    EXPECT_NEAR(std::abs(pair.find("um_per_m")->number()), expected, 0.1) << pair.find("face")->text();
  }
  EXPECT_THAT(send_form("evaluation/report.html", files).body, HasSubstr("by an aligned interferometer"));
}

TEST_F(TrackingRoutes, ask_for_a_station_where_lines_need_one) {
  const std::string seven = R"({"setup": {"travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 600, 0]}}})";
  EXPECT_THAT(refusal(send("lines", "{\"request\": " + seven + "}")), HasSubstr("found no station"));
  for (const char* path : {"points", "station/advice"})
    EXPECT_THAT(refusal(send(path, "{\"request\": " + std::string(diagonals) + "}")),
                HasSubstr("found no station, expected one"))
        << path;
  std::string limited = diagonals;
  limited.replace(limited.find("\"tool_offset_mm\""), 0, "\"limits\": {\"range_most_mm\": 900}, ");
  EXPECT_THAT(refusal(send("lines", "{\"request\": " + limited + "}")),
              HasSubstr("found limits of a tracking instrument without a station"));
}

TEST_F(TrackingRoutes, refuse_a_date_that_is_no_day) {
  std::string dated = diagonals;
  dated.replace(dated.find("2026-11-25"), 10, "2026-13-45");
  EXPECT_THAT(refusal(send("lines", "{\"request\": " + dated + "}")),
              HasSubstr("found the date of the plan \"2026-13-45\", expected a day"));
}

TEST_F(TrackingRoutes, tell_lost_lines_in_the_language_of_the_reader) {
  const std::string beside = R"({"setup": {"travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 600, 0]},
    "station": {"position_mm": [100, -12, -300]}}, "turn_reflector": true})";
  const std::string body = "{\"request\": " + beside + "}";
  const Value english = value_of(send("lines", body));
  const Value german = value_of(send("lines", body, {}, "application/json", language::Language::german));
  ASSERT_FALSE(english.find("lost")->items().empty());
  const auto reason = [](const Value& draft) { return draft.find("lost")->items()[0].find("reason")->text(); };
  EXPECT_THAT(reason(english), HasSubstr("outside the travel of Y"));
  EXPECT_NE(reason(english), reason(german));
}

TEST_F(TrackingRoutes, write_program_and_sheet_of_a_request_and_of_its_plan) {
  const Value planned = draft();
  const std::string plan = json::dump(*planned.find("plan"));
  const Response all = send("lines/program", "{\"plan\": " + plan + ", \"dialect\": \"linuxcnc\"}");
  const Response asked = send("lines/program", std::string("{\"request\": ") + request + R"(, "dialect": "linuxcnc"})");
  EXPECT_EQ(all.status, 200) << all.body;
  EXPECT_EQ(all.body, asked.body);
  const Response one = send("lines/program", "{\"plan\": " + plan + R"(, "dialect": "fanuc", "line": "xy",
    "options": {"stop_at_start": true}})",
                            {{"download", "1"}});
  ASSERT_EQ(one.status, 200) << one.body;
  EXPECT_LT(one.body.size(), all.body.size());
  EXPECT_THAT(one.headers, testing::Contains(testing::Pair("Content-Disposition", HasSubstr("line-xy."))));
  EXPECT_THAT(send("lines/sheet.pdf", "{\"plan\": " + plan + "}").body, StartsWith("%PDF-"));
  EXPECT_THAT(send("lines/sheet.html", std::string("{\"request\": ") + request + "}").body, HasSubstr("Mill"));
}

TEST_F(TrackingRoutes, say_what_is_wrong_with_a_request) {
  const auto with = [](const std::string& more) {
    return std::string(R"({"request": {"setup": {"travel": {"lowest_mm": [0, 0, 0], "highest_mm": [800, 600, 500]},
      "station": {"position_mm": [100, 80, 50]}})") +
           more + "}}";
  };
  EXPECT_THAT(refusal(send("lines", with(R"(, "colour": "red")"))), HasSubstr("colour"));
  EXPECT_THAT(refusal(send("lines", with(R"(, "runs": 1000000)"))),
              HasSubstr("runs: found 1000000, expected a whole number from 1 to 100"));
  EXPECT_THAT(refusal(send("lines", with(R"(, "turn_reflector": true, "targets": 9000, "runs": 2)"))),
              HasSubstr("readings in all lines"));
  EXPECT_THAT(refusal(send("lines", with(R"(, "rule": "diagonal")"))), HasSubstr("equal or corner"));
  EXPECT_THAT(refusal(send("lines", "{}")), HasSubstr("neither a request nor a plan"));
  EXPECT_THAT(refusal(send("lines", R"({"request": {"setup": {}}})")), HasSubstr("travel"));
  EXPECT_THAT(refusal(send("lines/program", with(R"(, "runs": 2)"))), HasSubstr("dialect"));
}

TEST_F(TrackingRoutes, take_no_text_of_a_request_for_the_name_of_a_file) {
  EXPECT_THAT(refusal(send("lines", R"({"request": {"setup": "/etc/passwd"}})")), HasSubstr("string"));
  EXPECT_THAT(refusal(send("lines", R"({"plan": "/etc/passwd"})")), HasSubstr("string"));
  EXPECT_THAT(refusal(send("lines", R"({"request": {"setup": {"travel": {"lowest_mm": [0, 0, 0],
    "highest_mm": [9, 9, 9]}, "station": "/etc/passwd"}}})")),
              HasSubstr("station"));
}

TEST_F(TrackingRoutes, advise_a_station_that_keeps_more_lines) {
  const std::string beside = R"({"request": {"setup": {"travel": {"lowest_mm": [0, 0, -500],
    "highest_mm": [800, 600, 0]}, "station": {"position_mm": [100, -12, -300]}}, "turn_reflector": true}})";
  const Value advice = value_of(send("station/advice", beside));
  EXPECT_EQ(advice.find("lines")->number(), 7.0);
  ASSERT_FALSE(advice.find("better")->items().empty());
  const Value& better = advice.find("better")->items().front();
  EXPECT_GT(better.find("lines")->number(), advice.find("now")->find("lines")->number());
  const Vector3 place = vector_of(*better.find("position_mm"));
  EXPECT_EQ(place.z, -300.0) << "on the table";
}

TEST_F(TrackingRoutes, plan_the_points_that_find_the_station) {
  const std::string body = std::string("{\"request\": ") + request + ", \"count\": 7}";
  const Value points = value_of(send("points", body));
  EXPECT_EQ(points.find("points")->items().size(), 7U);
  EXPECT_THAT(points.find("csv")->text(), HasSubstr("length_difference_mm"));
  EXPECT_THAT(send("points/sheet.pdf", body).body, StartsWith("%PDF-"));
  EXPECT_THAT(refusal(send("points", std::string("{\"request\": ") + request + ", \"count\": 5000}")), HasSubstr("51"));
}

TEST_F(TrackingRoutes, find_the_station_from_points_and_give_it_as_a_file) {
  const Vector3 truth = {120.0, 90.0, -610.0};
  const Pairs query = {{"options", R"({"machine_sigma_um": 2})"}};
  const std::string table = points_table(truth);
  const Value found = value_of(send("station", table, query, "text/csv"));
  EXPECT_LT(distance(vector_of(*found.find("refined")->find("station")), truth), 1e-3);
  const Response file = send("station/report.json", table, query, "text/csv");
  EXPECT_EQ(json::dump(*found.find("refined")), json::dump(*value_of(file).find("refined")));
  EXPECT_THAT(send("station/report.pdf", table, query, "text/csv").body, StartsWith("%PDF-"));
  EXPECT_THAT(refusal(send("station", "x_mm,y_mm\n1,2\n", {}, "text/csv")), HasSubstr("z"));
  EXPECT_THAT(refusal(send("station", table, {{"options", R"({"sigma": 2})"}}, "text/csv")), HasSubstr("sigma"));
}

TEST_F(TrackingRoutes, evaluate_lengths_with_the_error_that_the_machine_has) {
  const Value planned = draft();
  const std::string plan = json::dump(*planned.find("plan"));
  const std::string station =
      R"({"station": [100, 80, -600], "covariance": [[1e-8, 0, 0], [0, 1e-8, 0], [0, 0, 1e-8]]})";
  const Pairs files = {{"plan", plan}, {"lengths", lengths_of(planned, 100e-6)}, {"station", station}};
  const Value found = value_of(send_form("evaluation", files, R"({"tolerances": ["E=20um"]})"));
  ASSERT_EQ(found.find("lines")->items().size(), 7U);
  for (const Value& line : found.find("lines")->items()) {
    const std::string& id = line.find("id")->text();
    const double slope = line.find("slope")->find("um_per_m")->number();
    if (id == "y") EXPECT_NEAR(std::abs(slope), 100.0, 0.1);
    if (id == "x" || id == "z" || id == "xz") EXPECT_NEAR(slope, 0.0, 0.1) << id;
    const std::string& verdict = line.find("test")->find("verdict")->text();
    if (id == "y") EXPECT_EQ(verdict, "does not conform");
    if (id == "x") EXPECT_EQ(verdict, "conforms");
  }
  EXPECT_THAT(send_form("evaluation/report.pdf", files).body, StartsWith("%PDF-"));
  EXPECT_THAT(value_of(send_form("evaluation/report.json", files)).find("source")->find("file")->text(), "lengths.x");
}

TEST_F(TrackingRoutes, take_a_located_station_in_place_of_the_plan_s) {
  const Value planned = draft();
  const std::string located = send("station/report.json", points_table(at), {}, "text/csv").body;
  const Pairs files = {
      {"plan", json::dump(*planned.find("plan"))}, {"lengths", lengths_of(planned, 0.0)}, {"station", located}};
  const Value found = value_of(send_form("evaluation", files));
  EXPECT_EQ(found.find("source")->find("station")->find("file")->text(), "station.x");
  EXPECT_TRUE(found.find("lines")->items().front().find("length_difference")->is(json::Kind::object));
}

TEST_F(TrackingRoutes, say_what_is_wrong_with_a_form) {
  const std::string plan = json::dump(*draft().find("plan"));
  EXPECT_THAT(refusal(send("evaluation", "x", {}, "text/csv")), HasSubstr("found no form"));
  EXPECT_THAT(refusal(send_form("evaluation", {{"plan", plan}})), HasSubstr("without lengths"));
  EXPECT_THAT(refusal(send_form("evaluation", {{"lengths", "length_difference_mm\n1\n"}})),
              HasSubstr("without a plan"));
  EXPECT_THAT(refusal(send_form("evaluation", {{"plan", plan}, {"plan", plan}})), HasSubstr("two files plan"));
  EXPECT_THAT(refusal(send_form("evaluation", {{"plan", plan}, {"colour", "red"}})), HasSubstr("colour"));
  EXPECT_EQ(refusal(send("evaluation", form_of({{"options", "{}"}}, {{"plan", plan}}), {}, form_type)),
            "found the part \"options\" as a file, expected a text");
  EXPECT_EQ(refusal(send("evaluation", form_of({}, {{"plan", plan}}), {}, form_type)),
            "found the part \"plan\" as a text, expected a file");
  for (const char* blank : {"", " \n"})
    EXPECT_THAT(refusal(send_form("evaluation", {{"plan", blank}, {"lengths", "length_difference_mm\n1\n"}})),
                HasSubstr("empty, expected one with content"));
  EXPECT_THAT(refusal(send_form("evaluation", {{"plan", "{}"}, {"lengths", "length_difference_mm\n1\n"}})),
              HasSubstr("format"));
  EXPECT_THAT(refusal(send_form("evaluation", {{"plan", plan}, {"lengths", "x\n"}}, R"({"tolerances": ["Q=1um"]})")),
              HasSubstr("Q"));
}

TEST_F(TrackingRoutes, evaluate_no_plan_of_more_readings_than_are_shown) {
  std::string plan = json::dump(*draft().find("plan"));
  for (std::size_t at = plan.find("\"runs\": 2"); at != std::string::npos; at = plan.find("\"runs\": 2", at))
    plan.replace(at, 9, "\"runs\": 5000");
  const std::string lengths = "length_difference_mm\n1\n";
  EXPECT_THAT(refusal(send_form("evaluation", {{"plan", plan}, {"lengths", lengths}})),
              HasSubstr("readings in all lines, expected at most 100000"));
}

}  // namespace
}  // namespace axiometry::server
