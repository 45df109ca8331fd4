// SPDX-License-Identifier: Apache-2.0
// Calibrations that are kept, over what the transcripts of the command line measure.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "axiometry/app/workbench/workbench.h"
#include "axiometry/formats/plan/plan_json.h"
#include "server/routes/route_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/archive.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string transcript_file(const std::string& name) {
  std::ifstream stream(std::string(AXIOMETRY_SOURCE_DIR) + "/tests/transcripts/" + name, std::ios::binary);
  EXPECT_TRUE(stream) << name;
  return {std::istreambuf_iterator<char>(stream), {}};
}

class CalibrationRoutes : public RouteTest {
 protected:
  CalibrationRoutes() : RouteTest("/api/calibrations") {
    auto& captures = *reinterpret_cast<app::CaptureService*>(&workbench);  // these have nothing to do with captures
    add_motion_routes(router);
    add_calibration_routes(router, {archive.store(), workbench, captures});
  }

  Response send(std::string method, std::string_view path, std::string body = {}, Pairs query = {}) const {
    return ask(std::move(method), path, std::move(body), std::move(query));
  }

  Response keep(const Pairs& files, const Pairs& texts) const {
    return ask("POST", "", form_of(files, texts), {}, form_type);
  }

  Response keep_lines(const std::string& about = "{}", const std::string& options = "{}") {
    return keep({{"lengths", transcript_file("tracking-evaluate.files/lengths.csv")},
                 {"plan", transcript_file("tracking-evaluate.files/seven.json")}},
                {{"kind", "lines"}, {"about", about}, {"options", options}});
  }

  Response keep_volume(const std::string& options = R"({"spans": 4})") {
    return keep({{"lengths", transcript_file("volumetric.files/lengths.csv")},
                 {"machine", transcript_file("volumetric.files/machine.json")}},
                {{"kind", "volumetric"}, {"options", options}});
  }

  std::vector<double> listed(Pairs query = {}) {
    const Value page = value_of(send("GET", "", {}, std::move(query)));
    std::vector<double> ids;
    for (const Value& row : page.find("calibrations")->items()) ids.push_back(row.find("id")->number());
    EXPECT_EQ(page.find("total")->number(), static_cast<double>(ids.size()));
    return ids;
  }

  testing_support::Archive archive;
  app::Workbench workbench{archive.store()};
};

std::optional<double> figure_of(const Value& calibration, std::string_view parameter, std::string_view of) {
  for (const Value& figure : calibration.find("figures")->items())
    if (figure.find("parameter")->text() == parameter && figure.find("of")->text() == of)
      return figure.find("value")->number();
  return std::nullopt;
}

TEST_F(CalibrationRoutes, keep_nothing_when_nobody_waits_any_more) {
  std::stop_source gone;
  gone.request_stop();
  stop = gone.get_token();
  EXPECT_THAT(refusal(keep_volume(), 503), HasSubstr("stopped before it was done"));
  EXPECT_THAT(listed(), IsEmpty());
}

TEST_F(CalibrationRoutes, keep_lines_with_their_files_and_figures) {
  store::MachineRecord mill;
  mill.name = "Mill 5";
  ASSERT_TRUE(archive.store().add(mill, {"Anna", ""}));
  const Value kept = value_of(keep_lines(R"({"title": "seven lines", "notes": "warm"})"), 201);
  EXPECT_EQ(kept.find("title")->text(), "seven lines");
  EXPECT_EQ(kept.find("notes")->text(), "warm");
  EXPECT_EQ(kept.find("machine")->find("name")->text(), "Mill 5") << "the plan names it";
  EXPECT_NEAR(*figure_of(kept, "A", "x"), 10.2, 0.05);
  EXPECT_NEAR(*figure_of(kept, "E", "xyz"), 9.4, 0.05);
  EXPECT_EQ(kept.find("result")->find("result")->text(), "tracking-evaluation");
  ASSERT_EQ(kept.find("files")->items().size(), 2u);
  EXPECT_EQ(send("GET", "/1/files/lengths").body, transcript_file("tracking-evaluate.files/lengths.csv"));
  EXPECT_THAT(refusal(send("GET", "/1/files/machine"), 404), HasSubstr("machine"));
}

TEST_F(CalibrationRoutes, keep_the_21_errors) {
  const Value kept = value_of(keep_volume(), 201);
  EXPECT_EQ(kept.find("title")->text(), "lengths");
  EXPECT_TRUE(kept.find("machine")->is(json::Kind::null)) << "no machine is added";
  EXPECT_NEAR(*figure_of(kept, "chi2_per_dof", ""), 1.122, 0.001);
  EXPECT_EQ(*figure_of(kept, "unseen_errors", ""), 0.0);
  EXPECT_EQ(*figure_of(kept, "readings", ""), 360.0);
  EXPECT_GT(*figure_of(kept, "volume_largest", "long"), *figure_of(kept, "volume_mean", "long"));
  EXPECT_TRUE(kept.find("result")->find("errors")->find("EXX"));
}

TEST_F(CalibrationRoutes, evaluate_again_into_a_version_and_keep_the_one_before) {
  value_of(keep_volume(), 201);
  const Value again =
      value_of(send("POST", "/1/versions",
                    R"({"base_version": 1, "reason": "finer", "title": "volume", "options": {"spans": 3}})"),
               201);
  EXPECT_EQ(again.find("version")->number(), 2);
  EXPECT_EQ(again.find("change")->find("reason")->text(), "finer");
  EXPECT_EQ(again.find("options")->find("spans")->number(), 3);
  EXPECT_NE(again.find("versions")->items()[0].find("result_sha256")->text(),
            again.find("versions")->items()[1].find("result_sha256")->text());
  const Value first = value_of(send("GET", "/1", {}, {{"version", "1"}}));
  EXPECT_NEAR(*figure_of(first, "chi2_per_dof", ""), 1.122, 0.001);
  EXPECT_THAT(refusal(send("POST", "/1/versions", R"({"base_version": 1, "title": "x"})"), 409),
              HasSubstr("found version 2"));
  EXPECT_THAT(refusal(send("POST", "/1/versions", R"({"base_version": 2, "options": {"spans": 0}})")),
              HasSubstr("spans"));
}

TEST_F(CalibrationRoutes, edit_what_people_say) {
  store::MachineRecord mill;
  mill.name = "Other";
  ASSERT_TRUE(archive.store().add(mill, {"Anna", ""}));
  value_of(keep_lines(), 201);
  const Value edited = value_of(
      send("POST", "/1/versions", R"({"base_version": 1, "machine": 1, "measured_on": "2026-11-25", "notes": "cold"})"),
      201);
  EXPECT_EQ(edited.find("machine")->find("name")->text(), "Other");
  EXPECT_EQ(edited.find("measured_on")->text(), "2026-11-25");
  EXPECT_THAT(listed({{"machine", "1"}}), ElementsAre(1));
  const Value without = value_of(send("POST", "/1/versions", R"({"base_version": 2, "machine": null})"), 201);
  EXPECT_TRUE(without.find("machine")->is(json::Kind::null));
  EXPECT_EQ(without.find("notes")->text(), "cold");
  EXPECT_THAT(refusal(send("POST", "/1/versions", R"({"base_version": 3, "machine": 7})"), 404),
              HasSubstr("found no machine 7"));
  EXPECT_THAT(refusal(send("POST", "/1/versions", R"({"base_version": 3, "measured_on": "yesterday"})")),
              HasSubstr("2026-01-31"));
}

TEST_F(CalibrationRoutes, are_listed_by_kind_words_and_date_and_withdrawn) {
  value_of(keep_lines(R"({"title": "before", "measured_on": "2026-01-02"})"), 201);
  value_of(keep_volume(), 201);
  EXPECT_THAT(listed(), ElementsAre(2, 1));
  EXPECT_THAT(listed({{"kind", "lines"}}), ElementsAre(1));
  EXPECT_THAT(listed({{"text", "BEFORE"}}), ElementsAre(1));
  EXPECT_THAT(listed({{"from", "2026-01-01"}, {"to", "2026-01-02"}}), ElementsAre(1));
  EXPECT_THAT(refusal(send("GET", "", {}, {{"kind", "other"}})),
              HasSubstr("lines, volumetric, straightness, angles or squareness"));
  EXPECT_THAT(refusal(send("GET", "", {}, {{"order", "size"}})), HasSubstr("received, measured or title"));
  const Value gone = value_of(send("POST", "/1/withdraw", R"({"reason": "wrong plan"})"));
  EXPECT_TRUE(gone.find("withdrawn")->boolean());
  EXPECT_EQ(gone.find("change")->find("reason")->text(), "wrong plan");
  EXPECT_THAT(listed(), ElementsAre(2));
  EXPECT_THAT(listed({{"withdrawn", "1"}}), ElementsAre(2, 1));
  EXPECT_THAT(refusal(send("POST", "/1/withdraw"), 409), HasSubstr("withdrawn already"));
  EXPECT_THAT(refusal(send("POST", "/1/versions", R"({"base_version": 2, "title": "x"})"), 409),
              HasSubstr("found calibration 1 withdrawn, expected one that is not: reinstate it first"));
  value_of(send("POST", "/1/reinstate"));
  EXPECT_THAT(listed(), ElementsAre(2, 1));
}

TEST_F(CalibrationRoutes, say_when_the_same_files_are_kept_again) {
  const auto same_as = [](const Value& kept) { return json::dump(*kept.find("same_files"), 0); };
  EXPECT_EQ(same_as(value_of(keep_volume(), 201)), "[]");
  EXPECT_EQ(same_as(value_of(keep_lines(), 201)), "[]") << "other files";
  EXPECT_EQ(same_as(value_of(keep_volume(R"({"spans": 3})"), 201)), "[1]") << "with other options";
  value_of(send("POST", "/1/withdraw"));
  EXPECT_EQ(same_as(value_of(keep_volume(), 201)), "[1,3]") << "a withdrawn one too";
  EXPECT_EQ(value_of(send("GET", "/3")).find("same_files"), nullptr);
}

TEST_F(CalibrationRoutes, are_reported_from_the_archive) {
  value_of(keep_lines(), 201);
  value_of(keep_volume(), 201);
  EXPECT_THAT(send("GET", "/1/report.html").body, HasSubstr("xyz"));
  EXPECT_THAT(send("GET", "/2/report.html").body, HasSubstr("XFYZ"));
  EXPECT_THAT(send("GET", "/2/report.pdf").body, testing::StartsWith("%PDF"));
  const Value kept = value_of(send("GET", "/2/report.json"));
  EXPECT_NE(kept.find("model"), nullptr);
  EXPECT_THAT(refusal(send("GET", "/2/report.docx"), 422), HasSubstr("docx"));
  EXPECT_EQ(kept.find("withdrawn"), nullptr);
  value_of(send("POST", "/2/withdraw"));
  EXPECT_TRUE(value_of(send("GET", "/2/report.json")).find("withdrawn")->boolean());
}

TEST_F(CalibrationRoutes, are_compared_before_and_after) {
  value_of(keep_volume(), 201);
  value_of(keep_volume(R"({"spans": 3})"), 201);
  const Value compared = value_of(send("GET", "/1/comparison", {}, {{"with", "2"}}));
  std::map<std::string, const Value*> rows;
  for (const Value& row : compared.find("rows")->items())
    rows[row.find("parameter")->text() + row.find("of")->text()] = &row;
  for (const char* name : {"EXX", "EAX", "C0Y", "volume_largestlong"}) ASSERT_TRUE(rows.contains(name)) << name;
  const Value& exx = *rows["EXX"];
  EXPECT_EQ(exx.find("unit")->text(), "um");
  EXPECT_EQ(rows["EAX"]->find("unit")->text(), "urad");
  EXPECT_DOUBLE_EQ(exx.find("difference")->number(), exx.find("after")->number() - exx.find("before")->number());
  value_of(keep_lines(), 201);
  EXPECT_THAT(refusal(send("GET", "/1/comparison", {}, {{"with", "3"}})), HasSubstr("two of the same"));
}

TEST_F(CalibrationRoutes, keep_the_limits_of_a_table_with_the_lines) {
  const Pairs files = {{"lengths", transcript_file("tracking-evaluate.files/lengths.csv")},
                       {"plan", transcript_file("tracking-evaluate.files/seven.json")},
                       {"tolerances", "name,kind,travel_up_to,unit,A\nMill,linear,,um,1\nOld,linear,,um,500\n"}};
  const auto verdict_with = [&](const std::string& options) {
    return value_of(keep(files, {{"kind", "lines"}, {"options", options}}), 201).find("verdict")->text();
  };
  EXPECT_EQ(verdict_with(R"({"tolerance_table": "Mill"})"), "does not conform");
  EXPECT_EQ(verdict_with(R"({"tolerance_table": "Old"})"), "conforms");
  EXPECT_EQ(send("GET", "/1/files/tolerances").status, 200);
  EXPECT_EQ(send("GET", "/1/report.pdf").status, 200) << "made again from what was kept";
  EXPECT_THAT(refusal(keep_lines("{}", R"({"tolerance_table": "Mill"})")), HasSubstr("no file tolerances"));
}

TEST_F(CalibrationRoutes, keep_how_uncertain_the_lines_are) {
  const Value plain = value_of(keep_lines(), 201), gum = value_of(keep_lines("{}", R"({"methods": ["gum"]})"), 201);
  EXPECT_NE(json::dump(*plain.find("result")), json::dump(*gum.find("result")));
  EXPECT_EQ(send("GET", "/2/report.pdf").status, 200);
  EXPECT_THAT(refusal(keep_lines("{}", R"({"methods": ["monte-carlo"], "trials": 9000000})")),
              HasSubstr("10000000 in all"));
}

TEST_F(CalibrationRoutes, take_several_files_of_lengths_of_the_21_errors_alone) {
  const std::string lengths = transcript_file("volumetric.files/lengths.csv");
  const std::string machine = transcript_file("volumetric.files/machine.json");
  EXPECT_THAT(
      refusal(keep({{"lengths", lengths}, {"lengths-3", lengths}, {"machine", machine}}, {{"kind", "volumetric"}})),
      HasSubstr("one after another"));
  EXPECT_THAT(
      refusal(keep({{"lengths", lengths}, {"lengths-2", lengths}, {"machine", machine}}, {{"kind", "volumetric"}})),
      HasSubstr("each station with each tool in one file"))
      << "both are read";
  for (const char* role : {"lengths-02", "lengths-1", "lengths-501", "lengths-", "lengths-2x"})
    EXPECT_THAT(refusal(keep({{"lengths", lengths}, {role, lengths}, {"machine", machine}}, {{"kind", "volumetric"}})),
                HasSubstr("expected lengths, machine, plan"))
        << role;
  EXPECT_THAT(refusal(keep({{"lengths", transcript_file("tracking-evaluate.files/lengths.csv")},
                            {"lengths-2", "x"},
                            {"plan", transcript_file("tracking-evaluate.files/seven.json")}},
                           {{"kind", "lines"}})),
              HasSubstr("expected lengths, plan, station, tolerances"));
  EXPECT_THAT(refusal(keep({{"lengths", lengths}}, {{"kind", "volumetric"}})), HasSubstr("machine"));
  EXPECT_THAT(refusal(keep_volume(R"({"reversed": true})")), HasSubstr("continuous recording"));
}

/// Readings of an error over 0 to 200 mm in both directions, with a slope in 1e-3.
std::string readings(const std::string& head, double slope) {
  std::string text = head + "\n";
  for (const int run : {1, 2})
    for (const char* direction : {"up", "down"})
      for (const double at : {0.0, 100.0, 200.0})
        text += fmt::format("{},{},{},{}\n", at, run, direction,
                            slope * at + (at == 100.0 ? 0.5 : 0.0) + 0.01 * run + (*direction == 'u' ? 0.1 : 0.0));
  return text;
}
const std::string eyx_head = "# machine.name: Mill 5\nposition_mm,run,direction,EYX_um";
const std::string exy_head = "position_mm,run,direction,EXY_um";

TEST_F(CalibrationRoutes, keep_straightness_angles_and_squareness_apart_from_tests) {
  store::MachineRecord mill;
  mill.name = "Mill 5";
  ASSERT_TRUE(archive.store().add(mill, {"Anna", ""}));
  const std::string eyx = readings(eyx_head, 0.02), exy = readings(exy_head, 0.01);
  const Value one = value_of(keep({{"readings", eyx}}, {{"kind", "straightness"}}), 201);
  EXPECT_EQ(one.find("title")->text(), "EYX");
  EXPECT_EQ(one.find("machine")->find("name")->text(), "Mill 5");
  EXPECT_NEAR(*figure_of(one, "straightness", "EYX"), 0.5, 1e-9);
  EXPECT_NEAR(*figure_of(one, "motion_reversal", "EYX"), 0.1, 1e-9);
  EXPECT_FALSE(figure_of(one, "E", "EYX"));
  EXPECT_FALSE(figure_of(one, "E", ""));
  const Value square = value_of(keep({{"readings", eyx}, {"readings-2", exy}},
                                     {{"kind", "squareness"}, {"options", R"({"positive": ["+Y", "-X"]})"}}),
                                201);
  // X turns about Z by +20 µrad; the sensor of Y counts towards −X, so Y turns by +10 µrad.
  EXPECT_NEAR(*figure_of(square, "C0Y", ""), 10.0 - 20.0, 1e-6);
  const Value angles = value_of(keep({{"readings", readings("position_mm,run,direction,EAX_urad", 0.0)}},
                                     {{"kind", "angles"}, {"about", R"({"title": "roll"})"}}),
                                201);
  EXPECT_NEAR(*figure_of(angles, "angle_range", "EAX"), 0.5, 1e-9);
  EXPECT_THAT(listed(), ElementsAre(3, 2, 1));
  EXPECT_THAT(listed({{"kind", "squareness"}}), ElementsAre(2));
  EXPECT_EQ(archive.store().counts()->tests, 0);
  EXPECT_EQ(send("GET", "/2/files/readings-2").body, exy);
  const Response report = send("GET", "/2/report.html");
  EXPECT_EQ(report.status, 200);
  EXPECT_THAT(report.body, HasSubstr("Location error C0Y"));
  // Evaluated again with a square that is 2″ too large.
  const Value again = value_of(send("POST", "/2/versions",
                                    R"({"base_version": 1, "reason": "the certificate of the square",
                                        "options": {"positive": ["+Y", "-X"], "square_error_arcsec": 2}})"),
                               201);
  EXPECT_NEAR(*figure_of(again, "C0Y", ""), -10.0 + 2 * 4.84813681, 1e-6);
}

Plan one_run_along(const char* axis) {
  Plan plan;
  plan.axis.name = axis;
  plan.targets = {Position::native(0.0), Position::native(100.0), Position::native(200.0)};
  plan.cycle = TestCycle::unidirectional;
  plan.runs = 1;
  plan.overrun = Position::native(5.0);
  plan.feed = 1000.0;
  return plan;
}

TEST_F(CalibrationRoutes, keep_readings_alone_with_the_plan_that_they_were_taken_after) {
  Plan plan = one_run_along("X");
  const Value kept = value_of(
      keep({{"readings", "EYX_um\n0\n0.6\n0\n"}, {"plan", formats::write_plan(plan)}}, {{"kind", "straightness"}}),
      201);
  EXPECT_NEAR(*figure_of(kept, "straightness", "EYX"), 0.6, 1e-9);
  EXPECT_EQ(send("GET", "/1/report.html").status, 200);  // found again from what is kept
  EXPECT_THAT(
      refusal(keep({{"readings", "EYX_um\n0\n"}, {"plan", formats::write_plan(plan)}}, {{"kind", "straightness"}})),
      HasSubstr("found 1 reading, expected 3"));
  plan.errors = {{'Z', 'X'}};
  EXPECT_THAT(refusal(keep({{"readings", "EYX_um\n0\n0.6\n0\n"}, {"plan", formats::write_plan(plan)}},
                           {{"kind", "straightness"}})),
              HasSubstr("found readings of EYX with a plan made for EZX"));
}

TEST_F(CalibrationRoutes, keep_a_squareness_of_readings_alone_with_a_plan_for_each_line) {
  const Plan x = one_run_along("X"), y = one_run_along("Y");
  const std::string of_x = formats::write_plan(x), of_y = formats::write_plan(y);
  const std::string eyx = "EYX_um\n0\n1\n2\n", exy = "EXY_um\n0\n2\n4\n";
  const Value kept = value_of(keep({{"readings", eyx}, {"readings-2", exy}, {"plan", of_x}, {"plan-2", of_y}},
                                   {{"kind", "squareness"}, {"options", R"({"positive": ["+Y", "+X"]})"}}),
                              201);
  EXPECT_NEAR(*figure_of(kept, "C0Y", ""), -30.0, 1e-6);  // −(20 µm/m) − (10 µm/m)
  EXPECT_EQ(send("GET", "/1/report.html").status, 200);   // found again from what is kept
  const auto refused = [&](const Pairs& plans) {
    Pairs files = {{"readings", eyx}, {"readings-2", exy}};
    for (const auto& plan : plans) files.push_back(plan);
    return refusal(keep(files, {{"kind", "squareness"}}));
  };
  EXPECT_THAT(refused({{"plan", of_x}}), HasSubstr("plans for squareness: found 1, expected 2"));
  EXPECT_THAT(refused({{"plan", of_x}, {"plan-2", of_x}}), HasSubstr("found two plans of the axis \"X\""));
  EXPECT_THAT(refused({{"plan", of_y}, {"plan-2", of_x}}), HasSubstr("found readings of EYX with a plan of the axis"));
  EXPECT_THAT(refusal(keep({{"readings", eyx}, {"plan", of_x}, {"plan-2", of_y}}, {{"kind", "straightness"}})),
              HasSubstr("found 2 plans, expected one"));
  // A line that only its sense names is held against its plan all the same.
  EXPECT_THAT(refusal(keep({{"readings", "# positive: +X\nstraightness_um\n0\n1\n2\n"},
                            {"readings-2", "# positive: +Y\nstraightness_um\n0\n1\n2\n"},
                            {"plan", of_x},
                            {"plan-2", of_y}},
                           {{"kind", "squareness"}})),
              HasSubstr("found readings of EXY with a plan of the axis \"X\""));
}

TEST_F(CalibrationRoutes, compare_figures_of_one_unit_alone) {
  keep({{"readings", readings("position_mm,run,direction,EAX_urad", 0.0)}}, {{"kind", "angles"}});
  keep({{"readings", readings("position_mm,run,direction,EAX_arcsec", 0.0)}}, {{"kind", "angles"}});
  const Value comparison = value_of(send("GET", "/1/comparison", {}, {{"with", "2"}}));
  for (const Value& row : comparison.find("rows")->items())
    EXPECT_TRUE(row.find("difference")->is(json::Kind::null)) << json::dump(row);
}

TEST_F(CalibrationRoutes, refuse_motions_that_are_none) {
  const std::string eyx = readings(eyx_head, 0.02), exy = readings(exy_head, 0.01);
  const auto refused = [&](const Pairs& files, const std::string& kind, const std::string& options = "{}") {
    return refusal(keep(files, {{"kind", kind}, {"options", options}}));
  };
  EXPECT_THAT(refused({{"readings", eyx}}, "squareness"), HasSubstr("found 1 file of readings for squareness"));
  EXPECT_THAT(refused({{"readings", eyx}, {"readings-2", exy}}, "straightness"), HasSubstr("expected 1"));
  EXPECT_THAT(refused({{"lengths", eyx}}, "straightness"), HasSubstr("found no file readings"));
  EXPECT_THAT(refused({{"readings", eyx}, {"readings-3", exy}}, "squareness"), HasSubstr("found no file readings-2"));
  EXPECT_THAT(refused({{"readings", eyx}}, "angles"), HasSubstr("found readings of a length, expected an angle"));
  EXPECT_THAT(refused({{"readings", eyx}}, "straightness", R"({"offset_mm": [0, 0, 1]})"), HasSubstr("no use for"));
  EXPECT_THAT(refused({{"readings", eyx}}, "angles", R"({"offset_mm": [0, 1e9, 1]})"),
              HasSubstr("offset_mm: found 1000000000 mm in the offset, expected 100000 mm at most"));
  EXPECT_THAT(refused({{"readings", eyx}}, "straightness", R"({"square_error_arcsec": 1})"), HasSubstr("no use for"));
  EXPECT_THAT(refused({{"readings", eyx}}, "straightness", R"({"reference": "none"})"), HasSubstr("no use for"));
  EXPECT_THAT(refused({{"readings", eyx}}, "straightness", R"({"instrument": [-1]})"), HasSubstr("from 0 to"));
  EXPECT_THAT(refused({{"readings", eyx}}, "straightness", R"({"instrument": []})"), HasSubstr("found 0 numbers"));
  EXPECT_THAT(refused({{"readings", eyx}}, "straightness", R"({"positive": ["Y"]})"), HasSubstr("found \"Y\""));
  EXPECT_THAT(refused({{"readings", eyx}}, "straightness", R"({"positive": ["+Y", "+Y"]})"),
              HasSubstr("found 2 senses"));
  EXPECT_THAT(refused({{"readings", eyx}}, "straightness", R"({"spans": 3})"), HasSubstr("spans"));
  EXPECT_THAT(listed({{"withdrawn", "1"}}), IsEmpty());
}

class MotionRoutes : public RouteTest {
 protected:
  MotionRoutes() : RouteTest("/api/motions") {
    auto& captures = *reinterpret_cast<app::CaptureService*>(&workbench);  // these have nothing to do with captures
    add_motion_routes(router);
    add_calibration_routes(router, {archive.store(), workbench, captures});
  }
  Response look(const Pairs& files, const Pairs& texts = {}, std::string_view path = "") const {
    return ask("POST", path, form_of(files, texts), {}, form_type);
  }
  testing_support::Archive archive;
  app::Workbench workbench{archive.store()};
};

TEST_F(MotionRoutes, tell_what_readings_are_and_keep_nothing) {
  const std::string eyx = readings(eyx_head, 0.02), exy = readings(exy_head, 0.01);
  EXPECT_EQ(value_of(look({{"readings", eyx}})).find("result")->text(), "straightness");
  EXPECT_EQ(value_of(look({{"readings", eyx}, {"readings-2", exy}})).find("result")->text(), "squareness");
  EXPECT_THAT(refusal(look({{"readings", eyx}, {"readings-2", exy}, {"plan", "{}"}, {"plan-2", "{}"}})),
              HasSubstr("found no member \"axis\" in the plan"));
  EXPECT_EQ(value_of(look({{"readings", readings("position_mm,run,direction,EAX_urad", 0.0)}})).find("result")->text(),
            "angles");
  EXPECT_THAT(refusal(look({{"readings", "no table"}})), HasSubstr("found no column position_mm"));
  EXPECT_THAT(refusal(look({{"readings", eyx}}, {{"kind", "lines"}})), HasSubstr("straightness, angles or squareness"));
  EXPECT_THAT(refusal(look({{"readings", eyx}}, {{"about", R"({"title": "x"})"}})), HasSubstr("found the part about"));
  EXPECT_THAT(refusal(look({{"readings", eyx}}, {{"about", "[]"}})), HasSubstr("found the part about"));
  const Response report = look({{"readings", eyx}}, {}, "/report.html");
  EXPECT_EQ(report.status, 200);
  EXPECT_THAT(report.body, HasSubstr("Straightness EYX"));
  EXPECT_EQ(archive.store().counts()->content_bytes, 0);
}

TEST_F(CalibrationRoutes, refuse_what_cannot_be_evaluated_and_keep_nothing) {
  EXPECT_THAT(refusal(keep({{"lengths", "x"}}, {{"kind", "lines"}})), HasSubstr("found no file plan"));
  EXPECT_THAT(refusal(keep({{"lengths", "x"}}, {{"kind", "other"}})),
              HasSubstr("lines, volumetric, straightness, angles or squareness"));
  EXPECT_THAT(refusal(keep({{"photo", "x"}}, {{"kind", "lines"}})), HasSubstr("lengths, plan, station"));
  EXPECT_THAT(refusal(keep({}, {{"kind", "lines"}, {"kind", "angles"}})), HasSubstr("the part \"kind\" twice"));
  EXPECT_THAT(refusal(keep({}, {{"about", "{}"}, {"about", "{}"}})), HasSubstr("the part \"about\" twice"));
  EXPECT_THAT(refusal(keep_lines(R"({"name": "x"})")), HasSubstr("name"));
  EXPECT_THAT(refusal(keep_lines("{}", R"({"tolerances": ["Q=1um"]})")), HasSubstr("Q"));
  EXPECT_THAT(refusal(keep_volume(R"({"curves": "wavelets"})")), HasSubstr("b-spline"));
  EXPECT_THAT(listed({{"withdrawn", "1"}}), IsEmpty());
  EXPECT_EQ(archive.store().counts()->content_bytes, 0);
}

}  // namespace
}  // namespace axiometry::server
