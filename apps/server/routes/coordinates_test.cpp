// SPDX-License-Identifier: Apache-2.0
// Points from lengths, and from lengths with angles, as the page asks for them: what the command line finds.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/tracking/multilaterate.h"
#include "axiometry/app/tracking/polar.h"
#include "server/routes/route_test_support.h"
#include "server/routes/routes.h"
#include "tests/support/repository_file.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string lee_file(const std::string& name) {
  return testing_support::repository_file("tests/transcripts/tracking-" + name);
}
std::string lee_ranges() { return lee_file("multilaterate.files/ranges.csv"); }
std::string lee_nominal() { return lee_file("multilaterate.files/nominal.csv"); }
std::string lee_tracker() { return lee_file("polar.files/tracker.csv"); }

class CoordinatesRoutes : public RouteTest {
 protected:
  CoordinatesRoutes() : RouteTest("/api/tracking/") { add_coordinates_routes(router); }

  Response send(std::string_view path, const Pairs& files, const std::string& options = "", Pairs query = {},
                language::Language language = language::Language::english) const {
    return ask("POST", path, form_of(files, options.empty() ? Pairs() : Pairs{{"options", options}}), std::move(query),
               form_type, language);
  }
  std::string refused(std::string_view path, const Pairs& files, const std::string& options = "") const {
    return refusal(send(path, files, options));
  }
};

/// Without what the name of a file makes different.
std::string without_sources(const Value& result) {
  Value rest = Value::object();
  for (const auto& [name, member] : result.members())
    if (!name.contains("source")) rest.add(name, member);
  return json::dump(rest);
}

TEST_F(CoordinatesRoutes, speak_of_no_flag_of_the_command_line) {
  EXPECT_THAT(refused("multilateration", {{"ranges", lee_ranges()}}),
              AllOf(HasSubstr("in a file of their own"), Not(HasSubstr("--"))));
  EXPECT_THAT(refused("polar", {{"readings", lee_tracker()}}, R"({"ranging": "leica-at901"})"),
              AllOf(HasSubstr("found an instrument"), Not(HasSubstr("--"))));
}

TEST_F(CoordinatesRoutes, end_when_nobody_waits_any_more) {
  std::stop_source gone;
  gone.request_stop();
  stop = gone.get_token();
  EXPECT_THAT(refusal(send("multilateration", {{"ranges", lee_ranges()}, {"points", lee_nominal()}}), 503),
              HasSubstr("stopped before it was done"));
  EXPECT_THAT(
      refusal(send("polar", {{"readings", lee_tracker()}}, R"({"ranging": "20um+1um/m", "angles": "4arcsec"})"), 503),
      HasSubstr("stopped before it was done"));
}

TEST_F(CoordinatesRoutes, multilaterate_as_the_command_line_does) {
  const Value found = value_of(send("multilateration", {{"ranges", lee_ranges()}, {"points", lee_nominal()}}));
  const testing_support::TemporaryFolder folder;
  app::MultilaterateRequest request;
  request.ranges = folder.written("ranges.csv", lee_ranges());
  request.points = folder.written("points.csv", lee_nominal());
  const auto made = app::multilaterate_files(request);
  ASSERT_TRUE(made) << made.error().message;
  const std::string file = folder.path() + "/out.json";
  ASSERT_TRUE(app::write_outputs(**made, app::compose(**made, {}), {.outputs = {.json = file}}, {}));
  const auto written = json::parse(*app::whole_file(file));
  ASSERT_TRUE(written);
  EXPECT_EQ(without_sources(found), without_sources(*written)) << "the numbers, and the order of the members";
  EXPECT_EQ(found.find("points")->items().size(), 24u);
  EXPECT_EQ(found.find("source")->find("file")->text(), "ranges.x");
  const Response points = send("multilateration/points", {{"ranges", lee_ranges()}, {"points", lee_nominal()}});
  EXPECT_THAT(points.body, StartsWith("point,x_mm,y_mm,z_mm,dx_um,dy_um,dz_um,ux_um,uy_um,uz_um\nP1,49.99"));
  const Response residuals = send("multilateration/residuals", {{"ranges", lee_ranges()}, {"points", lee_nominal()}});
  EXPECT_THAT(residuals.body, StartsWith("point,station,segment,length_mm,residual_um,normalised\nP1,A,1,"));
}

TEST_F(CoordinatesRoutes, write_reports_and_the_result_as_files) {
  const Pairs lengths = {{"ranges", lee_ranges()}, {"points", lee_nominal()}};
  EXPECT_THAT(send("multilateration/report.pdf", lengths).body, StartsWith("%PDF-"));
  const Response html = send("multilateration/report.html", lengths, "", {}, language::Language::german);
  EXPECT_THAT(html.body, HasSubstr("Punkte"));
  EXPECT_EQ(value_of(send("multilateration/report.json", lengths)).find("result")->text(), "multilateration");
  const Pairs angles = {{"readings", lee_tracker()}};
  const std::string options = R"({"instruments": ["leica-at901"]})";
  EXPECT_THAT(send("polar/report.pdf", angles, options).body, StartsWith("%PDF-"));
  EXPECT_EQ(value_of(send("polar/report.json", angles, options)).find("result")->text(), "polar");
  EXPECT_THAT(send("polar/points", angles, options).body, StartsWith("point,x_mm,y_mm,z_mm,ux_um,"));
}

TEST_F(CoordinatesRoutes, adjust_angles_as_the_command_line_does) {
  const std::string options = R"({"instruments": ["leica-at901", "TR=etalon-lasertracer"], "in_station": true})";
  const std::string tracer = lee_file("polar.files/tracer.csv"), nominal = lee_file("polar.files/nominal.csv");
  const Value found =
      value_of(send("polar", {{"readings", lee_tracker()}, {"readings", tracer}, {"points", nominal}}, options));
  const testing_support::TemporaryFolder folder;
  app::PolarRequest request;
  request.files = {folder.written("readings.x", lee_tracker()), folder.written("tracer.x", tracer)};
  request.points = folder.written("points.csv", nominal);
  request.instruments = {{"", "leica-at901"}, {"TR", "etalon-lasertracer"}};
  request.in_station = true;
  const auto made = app::adjust_polar_files(request);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(without_sources(found), without_sources(app::present(**made, {}).json));
  EXPECT_EQ(found.find("coordinates")->text(), "station");
}

TEST_F(CoordinatesRoutes, speak_the_language_of_the_reader) {
  std::string misread = lee_ranges();
  const std::size_t at = misread.find("669.79");
  ASSERT_NE(at, std::string::npos);
  misread.replace(at, 6, "669.49");
  const Value found = value_of(
      send("multilateration", {{"ranges", misread}, {"points", lee_nominal()}}, "", {}, language::Language::german));
  ASSERT_FALSE(found.find("findings")->items().empty());
  for (const Value& finding : found.find("findings")->items())
    EXPECT_THAT(finding.find("message")->text(), Not(HasSubstr(" the ")));
  const Value polar = value_of(send("polar", {{"readings", lee_tracker()}}, R"({"instruments": ["leica-at901"]})", {},
                                    language::Language::german));
  ASSERT_EQ(polar.find("remarks")->items().size(), 1u) << "the column T_C";
  EXPECT_THAT(polar.find("remarks")->items().front().text(), Not(HasSubstr("passed over")));
}

TEST_F(CoordinatesRoutes, refuse_what_is_missing_or_said_twice) {
  EXPECT_THAT(refusal(ask("POST", "multilateration", "{}")), HasSubstr("found no form"));
  EXPECT_THAT(refused("multilateration", {{"points", lee_nominal()}}), HasSubstr("found no file ranges"));
  EXPECT_THAT(refused("multilateration", {{"ranges", lee_ranges()}, {"ranges", lee_ranges()}}), HasSubstr("two files"));
  EXPECT_THAT(refused("multilateration", {{"readings", lee_ranges()}}), HasSubstr("found the part \"readings\""));
  EXPECT_THAT(refused("multilateration", {{"ranges", lee_ranges()}}), HasSubstr("found no columns x_mm, y_mm, z_mm"));
  EXPECT_THAT(refused("polar", {{"readings", lee_tracker()}, {"points", "a"}, {"points", "b"}}),
              HasSubstr("two files points"));
  EXPECT_THAT(refused("polar", {{"readings", lee_tracker()}, {"readings", lee_tracker()}}), HasSubstr("second file"));
  EXPECT_THAT(refused("polar", {{"readings", lee_tracker()}}), HasSubstr("whose uncertainty nobody states"));
  EXPECT_THAT(refused("polar", {{"readings", lee_ranges()}}, R"({"instruments": ["leica-at901"]})"),
              HasSubstr("found no angles"));
  Pairs many;
  for (int k = 0; k < 51; ++k) many.emplace_back("readings", lee_tracker());
  EXPECT_THAT(refused("polar", many), HasSubstr("found 51 files of readings, expected at most 50"));
}

TEST_F(CoordinatesRoutes, refuse_options_with_their_place) {
  const auto lengths = [&](const std::string& options) {
    return refused("multilateration", {{"ranges", lee_ranges()}, {"points", lee_nominal()}}, options);
  };
  EXPECT_THAT(lengths(R"({"scale": "wide"})"), HasSubstr("scale: found \"wide\", expected fixed, common or free"));
  EXPECT_THAT(lengths(R"({"scale_prior_ppm": 0.1})"), HasSubstr("found it with a fixed scale"));
  EXPECT_THAT(lengths(R"({"scale": "common", "scale_prior_ppm": -1})"), HasSubstr("expected a number above 0"));
  EXPECT_THAT(lengths(R"({"ranging": "0um"})"), HasSubstr("found an uncertainty of 0"));
  EXPECT_THAT(lengths(R"({"repeatability": "wide"})"), HasSubstr("repeatability: "));
  EXPECT_THAT(lengths(R"({"file": "/etc/passwd"})"), HasSubstr("file"));
  EXPECT_THAT(lengths("{"), HasSubstr("found"));
  const auto angles = [&](const std::string& options) {
    return refused("polar", {{"readings", lee_tracker()}}, options);
  };
  EXPECT_THAT(angles(R"({"in_station": true})"), HasSubstr("without nominal points"));
  EXPECT_THAT(angles(R"({"instruments": ["leica-at9"]})"), HasSubstr("leica-at9"));
  EXPECT_THAT(angles(R"({"instruments": ["=leica-at901"]})"), HasSubstr("found no station before ="));
  EXPECT_THAT(angles(R"({"ranging": "leica-at901"})"), HasSubstr("found an instrument"));
  EXPECT_THAT(angles(R"({"angles": "wide"})"), HasSubstr("angles: found \"wide\""));
}

/// The work grows with the cube of their number.
TEST_F(CoordinatesRoutes, bound_how_many_stations_there_are) {
  std::string ranges = "point,station,length_mm,x_mm,y_mm,z_mm\n";
  for (int station = 0; station < 101; ++station) ranges += fmt::format("P,S{},1,0,0,0\n", station);
  EXPECT_THAT(refused("multilateration", {{"ranges", ranges}}), HasSubstr("found 101 stations, expected at most 100"));
}

}  // namespace
}  // namespace axiometry::server
