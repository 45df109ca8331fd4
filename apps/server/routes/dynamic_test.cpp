// SPDX-License-Identifier: Apache-2.0
// A recording without standstills as the page asks for its motion: result, curves, reports, tables.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "server/routes/route_test_support.h"
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

using json::Value;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// 10 mm/s, with 2 µm at 50 Hz on it.
std::string recorded(int samples, std::string_view unit = "mm") {
  constexpr double rate = 1000.0, velocity = 10.0, amplitude = 0.002, frequency = 50.0;
  std::string text = fmt::format("time_s,position_{}\n", unit);
  for (int k = 0; k < samples; ++k) {
    const double time = k / rate;
    text += fmt::format("{:.3f},{:.6f}\n", time,
                        velocity * time + amplitude * std::sin(2.0 * std::numbers::pi * frequency * time));
  }
  return text;
}

class DynamicRoutes : public RouteTest {
 protected:
  DynamicRoutes() : RouteTest("/api/dynamic") { add_dynamic_routes(router); }

  Response send(std::string body, const std::string& options = "", std::string_view path = "",
                language::Language language = language::Language::english, std::string name = "run.csv") const {
    Request request;
    request.method = "POST";
    request.path = "/api/dynamic" + std::string(path);
    if (!options.empty()) request.query = {{"options", options}};
    request.headers = {{"content-type", "application/octet-stream"}, {"x-file-name", std::move(name)}};
    request.body = std::move(body);
    request.language = language;
    return router.answer(request);
  }
};

TEST_F(DynamicRoutes, answer_what_the_command_line_writes_and_curves) {
  const std::string recording = recorded(2000);
  const auto measured = app::measure_dynamic(app::GivenFile{"run.csv", recording}, app::DynamicOptions{.feed = 600.0});
  ASSERT_TRUE(measured) << measured.error().to_string();
  const std::string written = json::dump(app::to_json(*measured));
  EXPECT_EQ(send(recording, R"({"feed_per_min": 600})", "/report.json").body, written + "\n");

  Value answered = value_of(send(recording, R"({"feed_per_min": 600})"));
  const Value* curves = answered.find("curves");
  ASSERT_NE(curves, nullptr);
  Value without = Value::object();
  for (const auto& [name, member] : answered.members())
    if (name != "curves") without.add(name, member);
  EXPECT_EQ(json::dump(without), written);
  const Value& peak = answered.find("spectrum")->find("peaks")->items().front();
  EXPECT_NEAR(peak.find("frequency_hz")->number(), 50.0, 0.05);
  EXPECT_NEAR(peak.find("amplitude")->number(), 2.0, 0.02);
}

TEST_F(DynamicRoutes, thin_curves_to_a_screen_and_keep_their_extremes) {
  std::string recording = recorded(20'000);
  const std::string told = "\n12.345,";
  const std::size_t at = recording.find(told) + told.size();
  recording.replace(at, recording.find('\n', at) - at, "999");
  const Value answered = value_of(send(recording));
  EXPECT_EQ(answered.find("samples")->number(), 20'000.0);
  const Value& position = *answered.find("curves")->find("position");
  const auto& times = position.find("time_s")->items();
  const auto& values = position.find("value")->items();
  ASSERT_EQ(times.size(), values.size());
  EXPECT_LT(values.size(), 2'100U);
  EXPECT_EQ(times.front().number(), 0.0);
  EXPECT_NEAR(times.back().number(), 19.999, 1e-9);
  double highest = 0.0;
  for (const Value& value : values) highest = std::max(highest, value.number());
  EXPECT_EQ(highest, 999.0);
}

TEST_F(DynamicRoutes, take_the_options_of_the_command_line) {
  const Value part =
      value_of(send(recorded(2000, "deg"), R"({"from_s": 0.5, "to_s": 1.0, "reverse": true, "window_s": 0.02,
    "even_percent": 50, "kind": "rotary"})"));
  EXPECT_EQ(part.find("samples")->number(), 501.0);
  EXPECT_EQ(part.find("unit")->text(), "°");
  EXPECT_LT(part.find("velocity_per_s")->find("highest")->find("value")->number(), 0.0);
  EXPECT_NEAR(part.find("uniform_share")->number(), 0.5, 1e-12);
  const std::string damaged = recorded(2000) + "lost\n";
  EXPECT_THAT(refusal(send(damaged)), HasSubstr("found \"lost\", expected 2 columns"));
  EXPECT_EQ(value_of(send(damaged, R"({"skip_damaged": true})")).find("samples")->number(), 2000.0);
}

TEST_F(DynamicRoutes, refuse_options_and_recordings_with_what_was_found) {
  const std::string recording = recorded(200);
  EXPECT_THAT(refusal(send(recording, "3")), HasSubstr("expected an object"));
  EXPECT_THAT(refusal(send(recording, R"({"feed": 3})")), AllOf(HasSubstr("feed"), HasSubstr("feed_per_min")));
  EXPECT_EQ(refusal(send(recording, R"({"feed_per_min": 0})")),
            "feed_per_min: found 0, expected a number above 0 and up to 1000000000");
  EXPECT_EQ(refusal(send(recording, R"({"even_percent": 51})")),
            "even_percent: found 51, expected a number above 0 and up to 50");
  EXPECT_THAT(refusal(send(recording, R"({"stream_axis": 0})")), StartsWith("stream_axis: found 0, expected"));
  EXPECT_THAT(refusal(send(recording, R"({"stream": "x"})")), HasSubstr("found the unknown stream \"x\""));
  EXPECT_THAT(refusal(send(recording, R"({"window_s": 1})")), HasSubstr("found a window of 1 s"));
  EXPECT_EQ(refusal(send("")), "found the file \"run.csv\" empty, expected one with content");
  EXPECT_EQ(refusal(send("", "", "", language::Language::german)),
            "Datei \"run.csv\" ist leer; erwartet: eine mit Inhalt");
  EXPECT_EQ(refusal(send(recorded(63))), "found 63 samples, expected 64 at least");
  EXPECT_THAT(refusal(send("no recording")), HasSubstr("expected one of"));
  EXPECT_THAT(refusal(send(recording, "", "/report.docx")), HasSubstr("docx"));
  EXPECT_EQ(refusal(send(recording, R"({"even_percent": 51})", "", language::Language::german)),
            "Abweichung gleichmäßiger Bewegung: 51; erwartet: eine Zahl über 0 und bis 50");
}

TEST_F(DynamicRoutes, tell_remarks_in_the_language_of_the_reader) {
  const Value german = value_of(send(recorded(2000), "", "", language::Language::german));
  std::string all;
  for (const Value& remark : german.find("remarks")->items()) all += remark.text();
  EXPECT_THAT(all, HasSubstr("der verlangte Vorschub ist nicht angegeben: Wie"));
}

TEST_F(DynamicRoutes, write_reports_and_tables) {
  const std::string recording = recorded(2000);
  EXPECT_THAT(send(recording, "", "/report.pdf").body, StartsWith("%PDF-"));
  EXPECT_THAT(send(recording, "", "/report.html").body, HasSubstr("Motion of an axis, evaluated without standstills"));
  const Response samples = send(recording, "", "/series.csv");
  EXPECT_THAT(samples.content_type, HasSubstr("text/csv"));
  EXPECT_THAT(samples.body, StartsWith("time_s,position_mm,velocity_mm_per_s,acceleration_mm_per_s2\n0,0,"));
  EXPECT_EQ(std::ranges::count(samples.body, '\n'), 2001);
  EXPECT_THAT(send(recording, "", "/spectrum.csv").body, StartsWith("frequency_hz,amplitude_um\n0,"));
}

TEST_F(DynamicRoutes, look_for_no_file_of_the_name_and_skip_what_is_damaged_of_a_raw_one) {
  const std::string damaged = recorded(2000) + "lost\n";
  const auto named = [&](const char* name) { return send(damaged, "", "", language::Language::english, name); };
  EXPECT_EQ(named("run.raw").status, 200);
  EXPECT_EQ(named("run.txt").status, 422);
}

}  // namespace
}  // namespace axiometry::server
