// SPDX-License-Identifier: Apache-2.0
// The volumetric calibration as the page asks for it: plan, program, sheet, errors, field, difference, line, table.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/formats/volumetric/volumetric_plan_json.h"
#include "axiometry/volumetric/plan/calibration_plan.h"
#include "axiometry/volumetric/simulate/simulated_lengths.h"
#include "server/routes/route_test_support.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* machine_json = R"({"name": "Mill", "chain": "XFYZ",
  "travel_mm": {"X": [0, 800], "Y": [0, 500], "Z": [-500, 0]},
  "tools_mm": {"T1": [0, 0, -120], "T2": [60, 0, -120], "T3": [0, 60, -240]},
  "stations_mm": {"S1": [-100, -50, -700], "S2": [900, -50, -800], "S3": [900, 600, -700], "S4": [-100, 600, -850]},
  "repeatability_um": 0.5})";

class VolumetricRoutes : public RouteTest {
 protected:
  VolumetricRoutes() : RouteTest("/api/volumetric/") { add_volumetric_routes(router); }

  Response send(std::string_view path, std::string body, Pairs query = {}, std::string type = json_type,
                language::Language language = language::Language::english) const {
    return ask("POST", path, std::move(body), std::move(query), std::move(type), language);
  }

  static std::string wish(const std::string& machine, const std::string& more) {
    return fmt::format(R"({{"machine": {}, "limits": {{"incidence_most_deg": 85}}{}}})", machine, more);
  }
  Value draft(int points = 40) const {
    return value_of(send("plan", wish(machine_json, fmt::format(R"(, "points": {}, "date": "2026-11-25")", points))));
  }

  /// What the instrument would measure at a machine whose errors are drawn by the seed.
  static std::string lengths_of(const Value& draft, std::uint64_t seed) {
    const auto plan = formats::volumetric_plan_from(*draft.find("plan"));
    const volumetric::Draw draw{seed, 0};
    const auto errors = volumetric::drawn_errors(plan->machine.travel, {}, draw);
    const auto simulated = volumetric::simulate_lengths(plan->machine, errors, volumetric::visits_of(*plan), {}, draw);
    return formats::write_volumetric_lengths(simulated->lengths);
  }

  Response send_form(std::string_view path, const Pairs& files, const std::string& options = "") const {
    return send(path, form_of(files, options.empty() ? Pairs() : Pairs{{"options", options}}), {}, form_type);
  }
  Value result(std::uint64_t seed) const {
    return value_of(send_form("identification", {{"lengths", lengths_of(draft(), seed)}, {"machine", machine_json}}));
  }
  static std::string of_model(const Value& result, const std::string& more = "") {
    return fmt::format(R"({{"model": {}{}}})", json::dump(*result.find("model")), more);
  }
};

TEST_F(VolumetricRoutes, plan_what_is_asked_for_and_say_what_it_will_tell) {
  const Value planned = draft();
  EXPECT_EQ(planned.find("plan")->find("runs")->items().size(), 12u);
  const Value& expected = *planned.find("expected");
  EXPECT_TRUE(expected.find("unseen")->items().empty());
  EXPECT_GT(expected.find("volume")->find("u_rms_um")->number(), 0.0);
  EXPECT_THAT(planned.find("csv")->text(), StartsWith("station,tool,segment,x_mm,y_mm,z_mm,length_mm\nS1,T1,1,"));
  EXPECT_EQ(json::dump(*draft().find("plan")), json::dump(*planned.find("plan"))) << "the same request, the same plan";
}

TEST_F(VolumetricRoutes, end_when_nobody_waits_any_more) {
  const Pairs files = {{"lengths", lengths_of(draft(), 3)}, {"machine", machine_json}};
  std::stop_source gone;
  gone.request_stop();
  stop = gone.get_token();
  for (const char* const more : {R"(, "points": 40)", R"(, "propose_stations": true, "points": 40)"})
    EXPECT_THAT(refusal(send("plan", wish(machine_json, more)), 503), HasSubstr("stopped before it was done"));
  for (const char* const path : {"identification", "identification/report.pdf", "identification/residuals"})
    EXPECT_THAT(refusal(send_form(path, files), 503), HasSubstr("stopped before it was done")) << path;
}

TEST_F(VolumetricRoutes, propose_stations_where_the_machine_has_none) {
  const std::string bare = R"({"chain": "FXYZ", "travel_mm": {"X": [0, 800], "Y": [0, 500], "Z": [-500, 0]},
    "tools_mm": {"T1": [0, 0, -120]}})";
  const Value planned = value_of(
      send("plan", wish(bare, R"(, "stations": 3, "points": 12)"), {}, "application/json", language::Language::german));
  EXPECT_EQ(planned.find("expected")->find("stations")->members().size(), 3u);
  EXPECT_FALSE(planned.find("expected")->find("unseen")->items().empty()) << "one tool does not tell rotations";
  EXPECT_THAT(planned.find("expected")->find("reasons")->items().front().text(), HasSubstr("Werkzeugpunkt"));
  for (const Value& finding : planned.find("expected")->find("findings")->items())
    EXPECT_THAT(finding.find("message")->text(), testing::Not(HasSubstr(" the "))) << "in German";
}

TEST_F(VolumetricRoutes, bound_what_a_plan_may_cost_before_anything_is_planned) {
  EXPECT_THAT(refusal(send("plan", wish(machine_json, R"(, "points": 501)"))), HasSubstr("from 1 to 500"));
  EXPECT_THAT(refusal(send("plan", wish(machine_json, R"(, "propose_stations": true, "stations": 9)"))),
              HasSubstr("from 1 to 8"));
  std::string many = machine_json;
  std::string tools;
  for (int k = 0; k < 7; ++k) tools += fmt::format("{}\"T{}\": [{}, 0, -120]", k > 0 ? ", " : "", k, 10 * k);
  const std::size_t at = many.find("\"tools_mm\": {") + 13;
  many.replace(at, many.find('}', at) - at, tools);
  EXPECT_THAT(refusal(send("plan", wish(many, ""))), HasSubstr("found 7 tools, expected at most 6"));
  EXPECT_THAT(refusal(send("plan", wish(machine_json, R"(, "date": "2026-13-45")"))),
              HasSubstr("found the date of the plan \"2026-13-45\", expected a day"));
  EXPECT_THAT(refusal(send("plan", wish(machine_json, R"(, "pionts": 5)"))), HasSubstr("pionts"));
  EXPECT_THAT(refusal(send("plan", R"({"machine": {"chain": "XXFZ"}})")), HasSubstr("XXFZ"));
  EXPECT_THAT(refusal(send("plan", "{}")), HasSubstr("machine"));
}

TEST_F(VolumetricRoutes, write_the_program_of_each_run_and_the_sheet) {
  const std::string plan = json::dump(*draft().find("plan"));
  for (const int part : {1, 12}) {
    const Response program = send(
        "plan/program", fmt::format(R"({{"plan": {}, "dialect": "linuxcnc", "options": {{"part": {}}}}})", plan, part));
    ASSERT_EQ(program.status, 200) << program.body;
    EXPECT_THAT(program.body, HasSubstr(fmt::format("RUN {} OF 12", part)));
  }
  const std::string beyond = fmt::format(R"({{"plan": {}, "dialect": "linuxcnc", "options": {{"part": 13}}}})", plan);
  EXPECT_THAT(refusal(send("plan/program", beyond)), HasSubstr("expected 1 to 12"));
  const Response sheet = send("plan/sheet.html", "{\"plan\": " + plan + "}", {{"language", "de"}}, "application/json",
                              language::Language::german);
  ASSERT_EQ(sheet.status, 200);
  EXPECT_THAT(sheet.body, HasSubstr("21 von 21 Abweichungen werden durch"));
  EXPECT_THAT(sheet.body, HasSubstr("Strahl verloren"));
  EXPECT_THAT(send("plan/sheet.pdf", "{\"plan\": " + plan + "}").body, StartsWith("%PDF-"));
}

TEST_F(VolumetricRoutes, find_the_errors_from_lengths_with_report_and_residuals) {
  const Pairs files = {{"lengths", lengths_of(draft(), 7)}, {"machine", machine_json}};
  const Value found = value_of(send_form("identification", files));
  EXPECT_TRUE(found.find("unseen")->items().empty());
  EXPECT_EQ(found.find("stations")->items().size(), 12u);
  EXPECT_EQ(found.find("gauge")->find("range_mm")->members().size(), 3u);
  EXPECT_THAT(send_form("identification/residuals", files).body, StartsWith("station,tool,segment,x_mm"));
  const Response kept = send_form("identification/report.json", files);
  EXPECT_EQ(json::dump(*json::parse(kept.body)->find("model")), json::dump(*found.find("model")));
  EXPECT_THAT(send_form("identification/report.pdf", files).body, StartsWith("%PDF-"));
  EXPECT_EQ(value_of(send_form("identification", files, R"({"reversal": "none"})")).find("readings")->number(), 480.0);
  EXPECT_THAT(refusal(send_form("identification", files, R"({"reversal": "some"})")), HasSubstr("some"));
  EXPECT_THAT(refusal(send_form("identification", {{"lengths", "x"}})),
              HasSubstr("neither a file machine nor a file plan"));
  EXPECT_THAT(refusal(send_form("identification", {{"lengths", "a,b\n1,2\n"}, {"machine", machine_json}})),
              HasSubstr("column"));
}

TEST_F(VolumetricRoutes, refuse_lengths_of_more_stations_or_segments_than_a_person_measures) {
  std::string many = "station,tool,x_mm,y_mm,z_mm,length_mm\n",
              broken = "station,tool,segment,x_mm,y_mm,z_mm,length_mm\n";
  for (int k = 0; k < 201; ++k) many += fmt::format("S{},T1,1,2,-3,500\n", k);
  for (int k = 0; k < 1001; ++k) broken += fmt::format("S1,T1,{},1,2,-3,500\n", k);
  EXPECT_THAT(refusal(send_form("identification", {{"lengths", many}, {"machine", machine_json}})),
              HasSubstr("found 201 stations with a tool, expected at most 200"));
  EXPECT_THAT(refusal(send_form("identification", {{"lengths", broken}, {"machine", machine_json}})),
              HasSubstr("found 1001 segments, expected at most 1000"));
}

TEST_F(VolumetricRoutes, tell_the_field_on_a_grid_with_every_tool) {
  const Value field = value_of(send("field", of_model(result(7), R"(, "nodes": 5)")));
  ASSERT_EQ(field.find("tools")->items().size(), 3u);
  double largest = 0.0;
  for (const Value& error : field.find("tools")->items()[0].find("error_um")->items()) {
    const auto& e = error.items();
    largest = std::max(largest, norm(Vector3{e[0].number(), e[1].number(), e[2].number()}));
  }
  EXPECT_EQ(field.find("tools")->items()[0].find("error_um")->items().size(), 125u);
  EXPECT_NEAR(largest, field.find("tools")->items()[0].find("as_found")->find("largest_um")->number(), 1e-3);
  EXPECT_THAT(refusal(send("field", of_model(result(7), R"(, "nodes": 22)"))), HasSubstr("from 2 to 21"));
  EXPECT_THAT(refusal(send("field", R"({"model": {"machine": 3}})")), HasSubstr("machine"));
}

TEST_F(VolumetricRoutes, tell_what_speaks_against_the_result_in_everything_made_of_it) {
  const Value found = result(7);
  const std::string given =
      R"([{"id": "volumetric-few-places", "severity": "serious", "message": "the stations are not told"},
          {"id": "volumetric-unseen-errors", "severity": "serious", "message": "of errors"},
          {"id": "volumetric-copies", "severity": "note", "message": "of rows"}])";
  const auto told = [&](const Value* findings) {
    std::vector<std::string> of_result;
    for (const Value& finding : findings->items())
      if (finding.find("message")->text().starts_with("The result from which") ||
          finding.find("message")->text().starts_with("the result from which"))
        of_result.push_back(finding.find("id")->text() + " " + finding.find("severity")->text());
    return of_result;
  };
  const std::vector<std::string> expected = {"volumetric-few-places serious"};
  const std::string with = R"(, "findings": )" + given;
  EXPECT_EQ(told(value_of(send("field", of_model(found, with + R"(, "nodes": 3)"))).find("findings")), expected);
  const std::string line = R"(, "axis": "X", "at_mm": [0, 250, -250], "tool": "T1")";
  EXPECT_EQ(told(value_of(send("prediction", of_model(found, with + line))).find("findings")), expected);
  const std::string table = R"(, "along": "X", "tool": "T1", "options": {"control": "linuxcnc"})";
  EXPECT_EQ(told(value_of(send("compensation", of_model(found, with + table))).find("result")->find("findings")),
            expected);
  const std::string model = json::dump(*found.find("model"));
  const Value difference =
      value_of(send("difference", fmt::format(R"({{"before": {}, "after": {}, "findings_after": {}, "nodes": 3}})",
                                              model, model, given)));
  EXPECT_EQ(told(difference.find("after")->find("findings")), expected);
  EXPECT_TRUE(told(difference.find("before")->find("findings")).empty());
  EXPECT_THAT(refusal(send("field", of_model(found, R"(, "findings": [{"id": "x"}])"))), HasSubstr("severity"));
  EXPECT_THAT(send("table", of_model(found, with + R"(, "table": "axis-csv", "tool": "T1")")).body,
              StartsWith("# DO NOT USE AS IT IS: serious findings speak against the result this was made from: "
                         "volumetric-few-places\n"));
}

TEST_F(VolumetricRoutes, keep_a_finding_that_is_in_the_readers_language_already) {
  const Value field = value_of(send("field", of_model(result(7), R"(, "nodes": 3, "findings":
    [{"id": "volumetric-few-places", "severity": "serious", "message": "Z wurde nur an 3,5 Orten gelesen: Kurven"}])"),
                                    {}, json_type, language::Language::german));
  EXPECT_EQ(
      field.find("findings")->items().front().find("message")->text(),
      "das Ergebnis, aus dem dies gemacht ist, sollte nicht so verwendet werden: Z wurde nur an 3,5 Orten gelesen: "
      "Kurven");
}

TEST_F(VolumetricRoutes, tell_what_has_changed_between_two_results) {
  const Value before = result(7), after = result(8);
  const auto ask = [&](const Value& a, const Value& b) {
    return send("difference", fmt::format(R"({{"before": {}, "after": {}, "nodes": 5}})", json::dump(*a.find("model")),
                                          json::dump(*b.find("model"))));
  };
  const Value none = value_of(ask(before, before));
  EXPECT_EQ(none.find("tools")->items()[0].find("as_found")->find("largest_um")->number(), 0.0);
  const Value some = value_of(ask(before, after));
  const Value& sizes = *some.find("tools")->items()[0].find("as_found");
  EXPECT_GT(sizes.find("largest_um")->number(), 5.0 * sizes.find("largest_u_um")->number());
  EXPECT_EQ(json::dump(*some.find("before")->find("observed_mm")),
            json::dump(*some.find("after")->find("observed_mm")));
}

TEST_F(VolumetricRoutes, predict_lines_and_write_tables) {
  const Value found = result(7);
  const Value axis =
      value_of(send("prediction", of_model(found, R"(, "axis": "X", "at_mm": [0, 250, -250], "tool": "T1")")));
  EXPECT_EQ(axis.find("prediction")->find("targets")->items().size(), 11u);
  EXPECT_GT(axis.find("prediction")->find("systematic_u_um")->number(), 0.0);
  value_of(send("prediction", of_model(found, R"(, "diagonal": "PPP-NNN", "tool": "T2")")));
  EXPECT_THAT(refusal(send("prediction", of_model(found, R"(, "diagonal": "up", "tool": "T2")"))),
              HasSubstr("PPP-NNN"));
  EXPECT_THAT(refusal(send("prediction", of_model(found, R"(, "axis": "X", "at_mm": [0, 900, 0], "tool": "T1")"))),
              HasSubstr("900"));
  const Response table = send("table", of_model(found, R"(, "table": "axis-csv", "tool": "T1", "nodes": 11)"));
  ASSERT_EQ(table.status, 200);
  EXPECT_THAT(table.body, HasSubstr("with these tables, predicted"));
  EXPECT_THAT(refusal(send("table", of_model(found, R"(, "table": "none")"))), HasSubstr("axis-csv"));
  EXPECT_THAT(refusal(send("table", of_model(found, R"(, "table": "axis-csv", "tool": "T1", "nodes": 402)"))),
              HasSubstr("from 2 to 401"));
}

TEST_F(VolumetricRoutes, show_a_result_file_in_the_readers_language_and_refuse_others) {
  const Value found = result(7);
  const Value shown = value_of(
      send("result", "{\"result\": " + json::dump(found) + "}", {}, "application/json", language::Language::german));
  EXPECT_EQ(json::dump(*shown.find("model")), json::dump(*found.find("model")));
  for (const Value& finding : shown.find("findings")->items())
    EXPECT_THAT(finding.find("message")->text(), testing::Not(HasSubstr(" the ")));
  EXPECT_THAT(refusal(send("result", R"({"result": {"errors": {}}})")), HasSubstr("EXX"));
  EXPECT_THAT(refusal(send("result", R"({"result": 3})")), HasSubstr("errors"));
}

TEST_F(VolumetricRoutes, make_the_table_of_an_axis_and_what_remains) {
  const Value found = result(7);
  const auto asked = [&](const std::string& more, language::Language language = language::Language::english) {
    return send("compensation", of_model(found, more), {}, "application/json", language);
  };
  const Value made = value_of(asked(R"(, "along": "X", "tool": "T1", "options": {"control": "linuxcnc"})"));
  EXPECT_EQ(made.find("file_name")->text(), "X-linuxcnc.comp");
  const Value& told = *made.find("result");
  EXPECT_LT(told.find("line_range")->find("after")->number(), 0.5 * told.find("line_range")->find("before")->number());
  EXPECT_EQ(told.find("errors")->text(), "EXX");
  const auto read = (*nc::axis_table_named("linuxcnc"))->read(made.find("table")->text(), {});
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(json::dump(app::nodes_to_json(*read)), json::dump(*told.find("table"))) << "the file is what is told of it";

  const std::string cross = R"(, "along": "Y", "component": "X", "tool": "T1", "output_axis": "AX1",
    "options": {"control": "siemens-cec", "axis": "AX2", "number": 4})";
  const Value moved = value_of(asked(cross, language::Language::german));
  EXPECT_EQ(moved.find("file_name")->text(), "AX1-by-AX2-siemens-cec.ini");
  EXPECT_EQ(moved.find("result")->find("errors")->text(), "EXY, C0Y");
  EXPECT_EQ(moved.find("result")->find("output_axis")->text(), "AX1");
  EXPECT_THAT(moved.find("result")->find("sign")->text(), testing::Not(HasSubstr("positive number")));
}

TEST_F(VolumetricRoutes, refuse_tables_that_nobody_may_load) {
  const Value found = result(7);
  const auto refused = [&](const std::string& more) { return refusal(send("compensation", of_model(found, more))); };
  const std::string linuxcnc = R"("options": {"control": "linuxcnc"})";
  EXPECT_THAT(refused(R"(, "along": "Y", "component": "X", "tool": "T1", )" + linuxcnc), HasSubstr("takes no other"));
  EXPECT_THAT(refused(R"(, "along": "A", "tool": "T1", )" + linuxcnc), HasSubstr("expected one of X, Y, Z"));
  EXPECT_THAT(refused(R"(, "tool": "T1", )" + linuxcnc), HasSubstr("along"));
  EXPECT_THAT(refused(R"(, "along": "X", "tool": "T1")"), HasSubstr("options"));
  EXPECT_THAT(refused(R"(, "along": "X", )" + linuxcnc), HasSubstr("found no tool, expected one of T1, T2, T3"));
  EXPECT_THAT(refused(R"(, "along": "X", "tool": "T1", "way": 1, )" + linuxcnc), HasSubstr("way"));
  EXPECT_THAT(refused(R"(, "along": "X", "tool": "T1", "output_axis": "Y", )" + linuxcnc), HasSubstr("no use for it"));
  EXPECT_THAT(refused(R"(, "along": "X", "tool": "T1", "options": {"control": "marlin", "inch": true})"),
              HasSubstr("no use for it"));
  EXPECT_THAT(refused(R"(, "along": "X", "tool": "T1", "options": {"control": "linuxcnc", "start": -50, "end": 400,
                      "step": 10})"),
              HasSubstr("found"));
}

}  // namespace
}  // namespace axiometry::server
