// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/simulate_text.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/app/files/amount_text.h"
#include "axiometry/app/simulate/simulate.h"

namespace axiometry::app {
namespace {

SimulationRequest request_of(AxisKind kind = AxisKind::linear) {
  SimulationRequest request;
  request.simulate.plan.axis.kind = kind;
  return request;
}

Result<void> apply(SimulationRequest& request, std::string_view name, std::vector<std::string> texts) {
  const auto options = simulation_options();
  const auto option = std::ranges::find(options, name, &SimulationOption::name);
  if (option == options.end()) return fail("no such option");
  return option->apply(texts, request);
}

std::string refused(std::string_view name, const std::string& text, AxisKind kind = AxisKind::linear) {
  SimulationRequest request = request_of(kind);
  const auto applied = apply(request, name, {text});
  return applied ? "" : applied.error().message;
}

TEST(AmountText, ReadsNumbersWithTheirUnits) {
  EXPECT_EQ(parse_deviation("3um", AxisKind::linear)->in_native(), 3.0);
  EXPECT_EQ(parse_deviation("0.003 mm", AxisKind::linear)->in_native(), 3.0);
  EXPECT_EQ(parse_deviation("-1.5e1nm", AxisKind::linear)->in_native(), -0.015);
  EXPECT_EQ(parse_deviation("2arcsec", AxisKind::rotary)->in_native(), 2.0);
  EXPECT_EQ(parse_position("10mm", AxisKind::linear)->in_native(), 10.0);
  EXPECT_EQ(parse_position("90deg", AxisKind::rotary)->in_native(), 90.0);
  EXPECT_EQ(parse_duration("2h")->in_s(), 7200.0);
  EXPECT_EQ(parse_duration("250ms")->in_s(), 0.25);
  EXPECT_EQ(parse_period("20Hz")->in_s(), 0.05);
  EXPECT_EQ(parse_slope("-5um/m", AxisKind::linear)->in_um_per_m(), -5.0);
  EXPECT_NEAR(parse_slope("3.6arcsec/deg", AxisKind::rotary)->in_um_per_m(), 1000.0, 1e-12);
  EXPECT_EQ(*parse_probability("2%"), 0.02);
  EXPECT_EQ(*parse_probability("0.5"), 0.5);
  EXPECT_EQ(parse_phase("90deg")->in_deg(), 90.0);
  EXPECT_EQ(parse_temperature("25C")->in_celsius(), 25.0);
  EXPECT_EQ(parse_expansion("11.5")->in_um_per_m_K(), 11.5);
  EXPECT_EQ(parse_expansion("11.5um/m/K")->in_um_per_m_K(), 11.5);
}

TEST(AmountText, SaysWhatWasExpectedOfOthers) {
  EXPECT_EQ(parse_deviation("3", AxisKind::linear).error().message,
            "found \"3\", expected a length in um, mm, nm, m, in, uin");
  for (const char* text :
       {"", "um", "3 furlong", "three um", "nan um", "infum", "3um 4um", "0x10um", "3,5um", "3arcsec"})
    EXPECT_FALSE(parse_deviation(text, AxisKind::linear)) << text;
  EXPECT_FALSE(parse_deviation("3um", AxisKind::rotary));
  EXPECT_FALSE(parse_period("0Hz"));
  EXPECT_FALSE(parse_period("-1Hz"));
  EXPECT_FALSE(parse_probability("101%"));
  EXPECT_FALSE(parse_probability("-0.1"));
  EXPECT_FALSE(parse_slope("5um", AxisKind::linear));
  EXPECT_FALSE(parse_duration("5"));
}

TEST(SimulateText, EveryOptionTakesItsExample) {
  const std::pair<std::string_view, std::string> examples[] = {
      {"--pitch", "5um/m"},
      {"--polynomial", "3um:-2um"},
      {"--pitch-walk", "1um:50mm"},
      {"--cyclic", "10mm:1.5um:90deg"},
      {"--backlash", "2um:5um:200mm:60mm"},
      {"--lost-motion", "4um:30mm"},
      {"--stick-slip", "1um:2um"},
      {"--thermal", "12um:3600s"},
      {"--servo", "20Hz:0.3"},
      {"--hunting", "1um:8Hz"},
      {"--axis-resolution", "1um"},
      {"--acceleration", "1000"},
      {"--noise", "0.1um"},
      {"--drift", "1um"},
      {"--resolution", "10nm"},
      {"--outliers", "2%:20um"},
      {"--slips", "5%:3um"},
      {"--vibration", "0.3um:50Hz"},
      {"--air", "1um/m:15min:0.3um/m:30s:200mm"},
      {"--expansion", "25C:11.5:8"},
      {"--missed", "3:up:2"},
      {"--doubled", "3:down:2"},
      {"--reversed-run", "2"},
      {"--rate", "1000"},
      {"--gap", "120s:5s"},
      {"--drop-out", "0.1%"},
      {"--wavelength", "632.991nm"},
  };
  ASSERT_EQ(std::size(examples), simulation_options().size());
  for (const auto& [name, text] : examples) EXPECT_EQ(refused(name, text), "") << name;
}

TEST(SimulateText, PutsPartsWhereTheyBelong) {
  SimulationRequest r = request_of();
  ASSERT_TRUE(apply(r, "--backlash", {"2um:5um:200mm:60mm"}));
  EXPECT_EQ(r.simulate.axis.backlash.size.in_native(), 2.0);
  EXPECT_EQ(r.simulate.axis.backlash.wear.in_native(), 5.0);
  EXPECT_EQ(r.simulate.axis.backlash.wear_at.in_native(), 200.0);
  EXPECT_EQ(r.simulate.axis.backlash.wear_width.in_native(), 60.0);
  ASSERT_TRUE(apply(r, "--cyclic", {"10mm:1.5um", "5mm:0.5um:90deg"}));
  ASSERT_EQ(r.simulate.axis.cyclic.size(), 2u);
  EXPECT_EQ(r.simulate.axis.cyclic[1].phase.in_deg(), 90.0);
  ASSERT_TRUE(apply(r, "--thermal", {"12um:1h:250mm"}));
  EXPECT_EQ(r.simulate.axis.thermal.fixed_point->in_native(), 250.0);
  ASSERT_TRUE(apply(r, "--thermal", {"12um:1h:everywhere"}));
  EXPECT_TRUE(r.simulate.axis.thermal.everywhere);
  EXPECT_FALSE(r.simulate.axis.thermal.fixed_point);
  ASSERT_TRUE(apply(r, "--stick-slip", {"1um"}));
  EXPECT_EQ(r.simulate.axis.stick_slip.down.in_native(), 1.0);
  ASSERT_TRUE(apply(r, "--servo", {"20Hz:0.3"}));
  EXPECT_EQ(r.simulate.axis.servo->period.in_s(), 0.05);
  EXPECT_EQ(r.simulate.axis.servo->damping, 0.3);
  ASSERT_TRUE(apply(r, "--missed", {"3:up:2", "1:down:1"}));
  EXPECT_EQ(r.simulate.departures.missed, (std::vector<Approach>{{2, Direction::up, 1}, {0, Direction::down, 0}}));
  ASSERT_TRUE(apply(r, "--gap", {"2min:5s"}));
  EXPECT_EQ(r.recording.gaps[0].begin.in_s(), 120.0);
}

TEST(SimulateText, RefusesOtherForms) {
  EXPECT_EQ(refused("--cyclic", "10mm"), "found \"10mm\" of 1 parts, expected 2 to 3, separated by colons");
  EXPECT_NE(refused("--backlash", "2um:5um"), "");
  EXPECT_NE(refused("--backlash", "2um:5um:200mm:60mm:1"), "");
  EXPECT_NE(refused("--missed", "0:up:1"), "");
  EXPECT_NE(refused("--missed", "1:sideways:1"), "");
  EXPECT_NE(refused("--missed", "1:up"), "");
  EXPECT_NE(refused("--reversed-run", "0"), "");
  EXPECT_NE(refused("--wavelength", "1nm"), "");
  EXPECT_NE(refused("--noise", "0.1um", AxisKind::rotary), "");
}

TEST(SimulateText, ReadsATableOfPitchErrors) {
  const auto nodes = parse_pitch_table("# mm, um\n0, 0\n100;1.5\r\n\n200 -2\n");
  ASSERT_TRUE(nodes);
  ASSERT_EQ(nodes->size(), 3u);
  EXPECT_EQ((*nodes)[2].at.in_native(), 200.0);
  EXPECT_EQ((*nodes)[2].deviation.in_native(), -2.0);
  EXPECT_EQ(parse_pitch_table("0,0\n1,x\n").error().at.line, 2u);
  EXPECT_FALSE(parse_pitch_table("# nothing\n"));
}

}  // namespace
}  // namespace axiometry::app
