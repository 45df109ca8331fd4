// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/identification.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/volumetric/field/curve_nodes.h"
#include "axiometry/volumetric/identify/identification_test_support.h"
#include "axiometry/volumetric/identify/noise_trials.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::volumetric {
namespace {

using test::four_stations;
using test::measured;
using test::TrueMachine;
using testing::HasSubstr;

IdentifyOptions with_spans(std::size_t spans) {
  IdentifyOptions options;
  options.sizes = {spans, spans, spans};
  return options;
}

/// The mean over the travel is 0, of straightness also the slope: the truth as the gauge has it.
std::vector<double> in_gauge(const std::vector<CurveNode>& nodes, ErrorMotion error, const TrueMachine& machine) {
  constexpr int steps = 4000;
  const double lower = machine.model.travel.lowest_mm[error.axis], upper = machine.model.travel.highest_mm[error.axis];
  double mean = 0.0, slope = 0.0;
  for (int k = 0; k < steps; ++k) {
    const double x = 2.0 * (k + 0.5) / steps - 1.0;
    const double value = machine.value(error, 0.5 * (lower + upper) + 0.5 * x * (upper - lower));
    mean += value / steps;
    slope += 3.0 * value * x / steps;
  }
  std::vector<double> truth;
  for (const CurveNode& node : nodes) {
    const double x = (2.0 * node.position_mm - lower - upper) / (upper - lower);
    truth.push_back(machine.value(error, node.position_mm) - mean - (error.is_straightness() ? slope * x : 0.0));
  }
  return truth;
}

const VolumetricFinding* finding(const Identification& result, std::string_view id) {
  const auto at = std::ranges::find(result.findings, id, &VolumetricFinding::id);
  return at == result.findings.end() ? nullptr : &*at;
}

std::vector<std::string> unseen_names(const Identification& result) {
  std::vector<std::string> names;
  for (const std::size_t e : result.model.unseen_errors()) names.push_back(error_names()[e]);
  return names;
}

TEST(Identify, FindsTheErrorsOfEveryChainFromExactLengths) {
  for (const char* chain : {"FXYZ", "XFYZ", "YXFZ", "XYZF", "ZFXY", "FZYX"}) {
    TrueMachine machine(chain, 3);
    const VolumetricLengths lengths = measured(machine, four_stations(), {.noise = false});
    const auto result = identify(machine.model, lengths, with_spans(14));
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->rank.null_directions, 0u);
    EXPECT_EQ(result->rank.errors, 285u);  // 18 · 17 − 18 − 6 + 3
    double worst = 0.0;
    for (std::size_t a = 0; a < axis_count; ++a)
      for (std::size_t m = 0; m < motion_count; ++m) {
        const auto nodes = curve_nodes(result->model, {a, m});
        const auto truth = in_gauge(nodes, {a, m}, machine);
        for (std::size_t k = 0; k < nodes.size(); ++k)
          worst = std::max(worst, std::abs(nodes[k].mean.value - truth[k]));
      }
    // What fourteen spans leave of two waves, and products of errors.
    EXPECT_LT(worst, 0.02) << chain;
  }
}

/// Share of values within 1.96 u, over many machines: 95 %, less a little for spans that cannot follow.
TEST(Identify, StatesUncertaintiesThatHoldTheTruth) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  std::size_t held = 0, all = 0;
  double ratio = 0.0;
  constexpr unsigned machines = 30;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    TrueMachine machine("XFYZ", seed);
    machine.model.repeatability = Length::um(0.5);
    const auto result = identify(machine.model, measured(machine, four_stations(), {.points = 40}), with_spans(6));
    ASSERT_TRUE(result) << result.error().message;
    ratio += result->chi_squared_per_dof() / machines;
    for (std::size_t a = 0; a < axis_count; ++a)
      for (std::size_t m = 0; m < motion_count; ++m) {
        const auto nodes = curve_nodes(result->model, {a, m}, 7);
        const auto truth = in_gauge(nodes, {a, m}, machine);
        for (std::size_t k = 0; k < nodes.size(); ++k) {
          held += std::abs(nodes[k].mean.value - truth[k]) < 1.96 * nodes[k].mean.u;
          ++all;
        }
      }
  }
  // 3780 values, of which neighbours hang together: as if some 1000 were independent, 0.7 % each way.
  const double share = static_cast<double>(held) / static_cast<double>(all);
  EXPECT_GT(share, 0.93);
  EXPECT_LT(share, 0.97);
  EXPECT_NEAR(ratio, 1.0, 0.03);
}

TEST(Identify, GivesNoNumberForWhatOneToolCannotTell) {
  TrueMachine machine("FXYZ", 5);
  machine.model.tools.resize(1);
  const auto result = identify(machine.model, measured(machine, four_stations(), {.points = 150}), with_spans(5));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_THAT(unseen_names(*result), testing::ElementsAre("ECY", "EXZ", "EYZ", "EAZ", "EBZ", "ECZ", "B0Z", "A0Z"));
  EXPECT_FALSE(result->model.motion(*error_motion_named("EAZ"), -200.0));
  EXPECT_FALSE(result->model.squareness(Squareness::A0Z));
  EXPECT_TRUE(result->model.squareness(Squareness::C0Y));
  EXPECT_TRUE(curve_nodes(result->model, *error_motion_named("EYZ")).empty());
  // With this very tool the field is known all the same, with another it is not.
  EXPECT_TRUE(result->model.at({300.0, 200.0, -100.0}, machine.model.tools[0].offset_mm).is_whole());
  EXPECT_FALSE(result->model.at({300.0, 200.0, -100.0}, {0.0, 0.0, -300.0}).is_whole());
  const VolumetricFinding* unseen = finding(*result, "volumetric-unseen-errors");
  ASSERT_NE(unseen, nullptr);
  EXPECT_TRUE(unseen->serious);
  EXPECT_THAT(unseen->message, HasSubstr("the same tool point"));
}

/// As a setter measures tools on the spindle's axis: what hundredths of a millimetre tell of a rotation is milliradians
/// of nothing.
TEST(Identify, GivesNoNumberForRotationsThatToolsAllButOnOneLineTell) {
  TrueMachine machine("XFYZ", 5);
  machine.model.tools = {{"short", {0.0, 0.0, -150.0}}, {"long", {0.0, 0.0, -300.0}}, {"third", {0.03, 0.0, -220.0}}};
  const auto result = identify(machine.model, measured(machine, four_stations(), {.points = 80}), with_spans(5));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_THAT(unseen_names(*result), testing::ElementsAre("ECY", "ECZ"));
  EXPECT_FALSE(result->model.motion(*error_motion_named("ECY"), 200.0));
  const VolumetricFinding* unseen = finding(*result, "volumetric-unseen-errors");
  ASSERT_NE(unseen, nullptr);
  EXPECT_TRUE(unseen->serious);
  EXPECT_THAT(unseen->message, HasSubstr("within 0.03 mm of one line, and were taken to lie on it"));
  EXPECT_EQ(finding(*result, "volumetric-tool-offset"), nullptr);
  for (const Tool& tool : result->model.machine().tools)
    EXPECT_TRUE(result->model.at({300.0, 200.0, -100.0}, tool.offset_mm).is_whole()) << tool.name;
}

TEST(Identify, TellsThatAShortLeverMakesRotations) {
  TrueMachine machine("XFYZ", 5);
  machine.model.tools[2].offset_mm = {3.0, 0.0, -180.0};
  const auto result = identify(machine.model, measured(machine, four_stations(), {.points = 80}), with_spans(5));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_THAT(unseen_names(*result), testing::IsEmpty());
  const VolumetricFinding* lever = finding(*result, "volumetric-short-lever");
  ASSERT_NE(lever, nullptr);
  EXPECT_TRUE(lever->serious);
  EXPECT_GT(result->model.motion(*error_motion_named("ECY"), 0.0)->u, 5.0);
}

/// More points from there never help.
TEST(Identify, SaysThatStationsOnOneLineAreTheReason) {
  TrueMachine machine("XFYZ", 5);
  const std::vector<NamedStation> stations = {
      {"A", {-150.0, -120.0, -640.0}}, {"B", {300.0, -120.0, -640.0}}, {"C", {900.0, -120.0, -640.0}}};
  const auto result = identify(machine.model, measured(machine, stations, {.points = 100}), with_spans(3));
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_NE(finding(*result, "volumetric-unseen-errors"), nullptr);
  EXPECT_THAT(finding(*result, "volumetric-unseen-errors")->message, HasSubstr("within 10 mm of one line"));
}

/// An axis comes to its ends from one side alone: fine curves of both directions ask for what no length says there.
TEST(Identify, ChoosesNoCurvesSoFineThatLengthsTellLess) {
  for (const unsigned seed : {1u, 2u}) {
    TrueMachine machine("XYFZ", seed);
    machine.model.repeatability = Length::um(0.05);
    const VolumetricLengths lengths = measured(machine, four_stations(), {.points = 140});
    IdentifyOptions fine = with_spans(12);
    fine.reversal = Reversal::curves;
    const auto asked = identify(machine.model, lengths, fine);
    ASSERT_TRUE(asked) << asked.error().message;
    EXPECT_FALSE(unseen_names(*asked).empty()) << seed;  // as it was asked for
    const auto chosen = identify(machine.model, lengths, {.reversal = Reversal::curves});
    ASSERT_TRUE(chosen) << chosen.error().message;
    EXPECT_THAT(unseen_names(*chosen), testing::IsEmpty()) << seed;
    IdentifyOptions smooth{.reversal = Reversal::curves};
    smooth.smoothness.kind = Smoothness::Kind::automatic;  // which takes twice as many spans where they tell as much
    const auto bent = identify(machine.model, lengths, smooth);
    ASSERT_TRUE(bent) << bent.error().message;
    EXPECT_THAT(unseen_names(*bent), testing::IsEmpty()) << seed;
  }
}

/// Straight lines between nodes, and polynomials of a low degree, cannot bend as that what one tool cannot tell.
TEST(Identify, TakesTheShapeOfItsCurvesForNothingThatWasMeasured) {
  TrueMachine machine("FXYZ", 5);
  machine.model.tools.resize(1);
  const VolumetricLengths lengths = measured(machine, four_stations(), {.points = 150});
  for (const auto& [curves, size] : {std::pair(CurveKind::nodes, 5), {CurveKind::legendre, 2}}) {
    IdentifyOptions options = with_spans(static_cast<std::size_t>(size));
    options.curves = curves;
    const auto result = identify(machine.model, lengths, options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_THAT(unseen_names(*result), testing::ElementsAre("ECY", "EXZ", "EYZ", "EAZ", "EBZ", "ECZ", "B0Z", "A0Z"))
        << curve_kind_name(curves);
    EXPECT_FALSE(result->model.motion(*error_motion_named("EAZ"), -200.0));
    EXPECT_TRUE(result->model.motion(*error_motion_named("EXX"), 200.0));
    EXPECT_FALSE(result->model.at({300.0, 200.0, -100.0}, {0.0, 0.0, -300.0}).is_whole());
    EXPECT_NE(finding(*result, "volumetric-unseen-errors"), nullptr);
  }
}

TEST(Identify, GivesAllNumbersOfCoarseCurvesWhereThreeToolsTellThem) {
  TrueMachine machine("XFYZ", 5);
  const VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  for (const auto& [curves, size] : {std::pair(CurveKind::nodes, 6), {CurveKind::legendre, 2}}) {
    IdentifyOptions options = with_spans(static_cast<std::size_t>(size));
    options.curves = curves;
    const auto result = identify(machine.model, lengths, options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_THAT(unseen_names(*result), testing::IsEmpty());
    EXPECT_EQ(result->rank.null_directions, 0u);
  }
}

TEST(Identify, SaysWhereNumbersAreInOtherUnits) {
  TrueMachine machine("XFYZ", 5);
  const VolumetricLengths lengths = measured(machine, four_stations());
  VolumetricLengths in_inches = lengths;
  for (VolumetricReading& reading : in_inches.readings) reading.length_mm /= 25.4;
  const auto refused = identify(machine.model, in_inches, with_spans(4));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("fit when the lengths are read as inches"));

  for (const auto& [factor, unit] : {std::pair(1e-3, "m,"), {1e3, "µm,"}}) {
    VolumetricLengths other = lengths;
    for (VolumetricReading& reading : other.readings) reading.length_mm *= factor;
    const auto mistaken = identify(machine.model, other, with_spans(4));
    ASSERT_FALSE(mistaken) << unit;
    EXPECT_THAT(mistaken.error().message, HasSubstr("fit when the lengths are read as " + std::string(unit)));
  }

  MachineModel small = machine.model;
  small.travel = {1.0 / 25.4 * small.travel.lowest_mm, 1.0 / 25.4 * small.travel.highest_mm};
  for (Tool& tool : small.tools) tool.offset_mm = 1.0 / 25.4 * tool.offset_mm;
  VolumetricLengths positions = lengths;
  for (VolumetricReading& reading : positions.readings) reading.axes_mm = 1.0 / 25.4 * reading.axes_mm;
  const auto mixed = identify(small, positions, with_spans(4));
  ASSERT_FALSE(mixed);
  EXPECT_THAT(mixed.error().message, HasSubstr("fit when the positions and tools are read as inches"));

  for (VolumetricReading& reading : positions.readings) reading.length_mm /= 25.4;
  const auto all = identify(small, positions, with_spans(4));
  ASSERT_TRUE(all) << all.error().message;
  ASSERT_NE(finding(*all, "volumetric-small-machine"), nullptr);
  EXPECT_THAT(finding(*all, "volumetric-small-machine")->message, HasSubstr("39.4, 23.6 and 19.7 mm"));
}

TEST(Identify, SaysThatTwoStationsAreTooFew) {
  TrueMachine machine("FXYZ", 5);
  auto stations = four_stations();
  stations.resize(2);
  const auto result = identify(machine.model, measured(machine, stations, {.points = 100}), with_spans(5));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_GT(result->rank.null_directions, 0u);
  ASSERT_NE(finding(*result, "volumetric-unseen-errors"), nullptr);
  EXPECT_THAT(finding(*result, "volumetric-unseen-errors")->message, HasSubstr("three stations are the least"));
}

/// What two stations tell as weakly as this takes some ninety steps.
TEST(Identify, FollowsWhatIsToldWeaklyToItsEnd) {
  TrueMachine machine("FXYZ", 7);
  machine.model.repeatability = Length::um(0.3);
  const std::vector<NamedStation> two = {{"A", {-200.0, -150.0, -800.0}}, {"B", {1200.0, -130.0, -750.0}}};
  const auto result = identify(machine.model, measured(machine, two, {.points = 150}), with_spans(5));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_NE(finding(*result, "volumetric-unseen-errors"), nullptr);
  EXPECT_NEAR(result->chi_squared_per_dof(), 1.0, 0.15);
}

TEST(Identify, FindsABreakOfTheBeamThatNobodyTold) {
  TrueMachine machine("XFYZ", 6);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  for (std::size_t i = 0; i < lengths.readings.size(); ++i) {
    const bool is_behind = lengths.readings[i].station == 1 && lengths.readings[i].tool == 2 && i % 80 >= 30;
    if (is_behind) lengths.readings[i].length_mm += 0.012;
  }
  const auto result = identify(machine.model, lengths, {});
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->breaks.size(), 1u);
  EXPECT_EQ(lengths.readings[result->breaks[0].before_reading].station, 1u);
  EXPECT_EQ(result->breaks[0].before_reading % 80, 30u);
  EXPECT_NEAR(result->breaks[0].jump_um, 12.0, 0.5);
  EXPECT_TRUE(result->set_aside.empty());
  EXPECT_NEAR(result->chi_squared_per_dof(), 1.0, 0.15);
}

TEST(Identify, SetsAsideWhatNoErrorExplainsAndNothingElse) {
  TrueMachine machine("XFYZ", 8);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  const std::vector<std::size_t> wrong = {17, 230, 231, 555, 902};
  for (const std::size_t i : wrong) lengths.readings[i].length_mm += i % 2 == 0 ? 0.05 : -1.5;
  const auto result = identify(machine.model, lengths, {});
  ASSERT_TRUE(result) << result.error().message;
  std::vector<std::size_t> aside;
  for (const SetAside& s : result->set_aside) aside.push_back(s.reading);
  EXPECT_EQ(aside, wrong);
  EXPECT_TRUE(result->breaks.empty());
  EXPECT_NEAR(result->chi_squared_per_dof(), 1.0, 0.15);
}

TEST(Identify, TakesOutADriftOfTheDeadPathsWhereResidualsShowIt) {
  TrueMachine machine("XFYZ", 9);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  const auto still = identify(machine.model, lengths, {});
  ASSERT_TRUE(still);
  EXPECT_FALSE(still->drift);
  for (std::size_t i = 0; i < lengths.readings.size(); ++i)
    lengths.readings[i].length_mm += 0.004 * static_cast<double>(i % 80) / 79.0;
  const auto result = identify(machine.model, lengths, {});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->drift);
  EXPECT_TRUE(result->breaks.empty());
  // A length that grows is a dead path that shrinks; drifts are added to the length.
  for (const IdentifiedStretch& s : result->stretches) EXPECT_NEAR(*s.drift_um, 4.0, 1.0);
}

TEST(Identify, NoticesAToolOffsetThatIsWrongByCentimetres) {
  TrueMachine machine("XFYZ", 10);
  const VolumetricLengths lengths = measured(machine, four_stations());
  machine.model.tools[1].offset_mm += Vector3{10.0, 0.0, -20.0};
  const auto result = identify(machine.model, lengths, {});
  ASSERT_TRUE(result) << result.error().message;
  const VolumetricFinding* found = finding(*result, "volumetric-tool-offset");
  ASSERT_NE(found, nullptr);
  EXPECT_TRUE(found->serious);
  const Vector3 stated = machine.model.tools[1].offset_mm - machine.model.tools[0].offset_mm;
  const auto text = [](Vector3 v) {
    return fmt::format("({}; {}; {}) mm", format_fixed(v.x, 2), format_fixed(v.y, 2), format_fixed(v.z, 2));
  };
  EXPECT_THAT(found->message,
              HasSubstr("is " + text(stated - Vector3{10.0, 0.0, -20.0}) + ", not " + text(stated) + " as stated"));
  EXPECT_THAT(found->message, HasSubstr("4 stations"));
}

TEST(Identify, NoticesAnAxisThatRanTheOtherWayAndAxesThatWereExchanged) {
  TrueMachine machine("XFYZ", 11);
  VolumetricLengths lengths = measured(machine, four_stations());
  VolumetricLengths mirrored = lengths;
  for (VolumetricReading& r : mirrored.readings) r.axes_mm.x = 1000.0 - r.axes_mm.x;
  const auto other_way = identify(machine.model, mirrored, {});
  ASSERT_TRUE(other_way) << other_way.error().message;
  ASSERT_NE(finding(*other_way, "volumetric-tool-offset"), nullptr);
  EXPECT_THAT(finding(*other_way, "volumetric-tool-offset")->message, HasSubstr("as if X ran the other way"));

  for (VolumetricReading& r : lengths.readings) std::swap(r.axes_mm.x, r.axes_mm.y);
  MachineModel swapped = machine.model;
  swapped.travel = {{0.0, 0.0, -500.0}, {600.0, 1000.0, 0.0}};
  const auto exchanged = identify(swapped, lengths, {});
  ASSERT_TRUE(exchanged) << exchanged.error().message;
  ASSERT_NE(finding(*exchanged, "volumetric-tool-offset"), nullptr);
  EXPECT_THAT(finding(*exchanged, "volumetric-tool-offset")->message, HasSubstr("as if X and Y were exchanged"));
  EXPECT_FALSE(identify(machine.model, lengths, {}));  // beyond the travel of Y
}

TEST(Identify, NoticesStationsInAnotherFrame) {
  TrueMachine machine("XFYZ", 12);
  const VolumetricLengths lengths = measured(machine, four_stations());
  machine.model.stations = four_stations();
  const auto right = identify(machine.model, lengths, {});
  ASSERT_TRUE(right) << right.error().message;
  EXPECT_EQ(finding(*right, "volumetric-station-frame"), nullptr);
  for (NamedStation& s : machine.model.stations) s.at_mm += Vector3{300.0, 0.0, 0.0};
  const auto result = identify(machine.model, lengths, {});
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_NE(finding(*result, "volumetric-station-frame"), nullptr);
  EXPECT_THAT(finding(*result, "volumetric-station-frame")->message, HasSubstr("(−300; 0; 0) mm"));
}

TEST(Identify, TellsStationsThatAreStatedUnderOtherNames) {
  TrueMachine machine("XFYZ", 12);
  const VolumetricLengths lengths = measured(machine, four_stations());
  const auto told = [&](std::vector<NamedStation> stations) -> std::string {
    machine.model.stations = std::move(stations);
    const auto result = identify(machine.model, lengths, {});
    if (!result) return result.error().message;
    const VolumetricFinding* found = finding(*result, "volumetric-station-names");
    return found == nullptr ? "none" : found->message;
  };
  EXPECT_EQ(told({}), "none") << "nobody need say where they stand";
  EXPECT_EQ(told(four_stations()), "none");
  std::vector<NamedStation> others = four_stations();
  others.pop_back();
  EXPECT_THAT(told(others), HasSubstr(text::quoted(four_stations().back().name) + " stand, which have lengths: "));
  others = four_stations();
  for (NamedStation& station : others) station.name = "P" + station.name;
  EXPECT_THAT(told(others), HasSubstr("whose places are stated, there are none"));
}

TEST(Identify, NoticesThatLengthsOfTwoSetupsAreMixed) {
  TrueMachine machine("XFYZ", 13);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 80});
  lengths.segments = {"1", "2"};
  for (std::size_t i = 0; i < 80; ++i) {
    VolumetricReading& r = lengths.readings[i];
    if (i % 80 < 40) continue;
    r.segment = 1;
    const Vector3 p = r.axes_mm + machine.model.tools[0].offset_mm, s = four_stations()[0].at_mm;
    r.length_mm += distance(p, s + Vector3{0.02, 0.01, 0.0}) - distance(p, s);
  }
  const auto result = identify(machine.model, lengths, {});
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_NE(finding(*result, "volumetric-station-moved"), nullptr);
  EXPECT_THAT(finding(*result, "volumetric-station-moved")->message, HasSubstr("two set-ups or days"));
}

TEST(Identify, MultipliesUncertaintiesWhereResidualsAreLargerThanStated) {
  TrueMachine machine("XFYZ", 14);
  machine.model.repeatability = Length::um(1.0);
  const VolumetricLengths lengths = measured(machine, four_stations());
  const auto stated = identify(machine.model, lengths, with_spans(6));
  machine.model.repeatability = {};
  const auto understated = identify(machine.model, lengths, with_spans(6));
  ASSERT_TRUE(stated && understated);
  EXPECT_NE(finding(*understated, "volumetric-scatter"), nullptr);
  const double u = stated->model.squareness(Squareness::B0Z)->u;
  EXPECT_NEAR(understated->model.squareness(Squareness::B0Z)->u, u, 0.15 * u);
}

TEST(Identify, AddsWhatAllLengthsHaveInCommonToTheSlopesOfPositioning) {
  TrueMachine machine("XFYZ", 15);
  const VolumetricLengths lengths = measured(machine, four_stations());
  machine.model.scale_uncertainty = RelativeLength::um_per_m(0.0);
  const auto without = identify(machine.model, lengths, with_spans(6));
  machine.model.scale_uncertainty = RelativeLength::um_per_m(1.0);
  const auto with = identify(machine.model, lengths, with_spans(6));
  ASSERT_TRUE(without && with);
  EXPECT_EQ(finding(*with, "volumetric-scale-uncertainty"), nullptr);
  const ErrorMotion exx{0, 0};
  const double u = with->model.motion(exx, 1000.0)->u, u_without = without->model.motion(exx, 1000.0)->u;
  // Half a metre from the middle of the travel, where the mean is 0: 0.5 µm.
  EXPECT_NEAR(u * u - u_without * u_without, 0.25, 0.02);
}

TEST(Identify, DoesNotDependOnTheNumberOfThreads) {
  TrueMachine machine("XFYZ", 16);
  const VolumetricLengths lengths = measured(machine, four_stations(), {.points = 1500});
  IdentifyOptions options = with_spans(6);
  options.threads = 1;
  const auto one = identify(machine.model, lengths, options);
  options.threads = 3;
  const auto three = identify(machine.model, lengths, options);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->model.parts().values, three->model.parts().values);
}

TEST(Identify, TellsTheDirectionsApart) {
  TrueMachine machine("XFYZ", 17);
  VolumetricLengths lengths = measured(machine, four_stations(), {.points = 100});
  Vector3 before;
  for (std::size_t i = 0; i < lengths.readings.size(); ++i) {
    VolumetricReading& r = lengths.readings[i];
    const Vector3 u = unit(r.axes_mm + machine.model.tools[r.tool].offset_mm - four_stations()[r.station].at_mm);
    if (i % 100 != 0) r.length_mm += (r.axes_mm.x > before.x ? 0.5 : -0.5) * 0.006 * u.x;
    before = r.axes_mm;
  }
  IdentifyOptions options = with_spans(6);
  options.reversal = Reversal::constant;
  const auto result = identify(machine.model, lengths, options);
  ASSERT_TRUE(result) << result.error().message;
  const double up = result->model.motion({0, 0}, 400.0, 1.0)->value;
  const double down = result->model.motion({0, 0}, 400.0, -1.0)->value;
  EXPECT_NEAR(up - down, 6.0, 0.3);
  EXPECT_NEAR(result->chi_squared_per_dof(), 1.0, 0.15);
}

/// Two ways to the same uncertainties: the inverse of the normal matrix, and noise drawn anew.
TEST(NoiseTrials, ScatterAsTheCovarianceSays) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  TrueMachine machine("XFYZ", 19);
  const VolumetricLengths lengths = measured(machine, four_stations());
  IdentifyOptions options = with_spans(6);
  options.drift = DriftModel::none;
  options.find_part_scales = false;
  const auto found = identify(machine.model, lengths, options);
  const auto trials = noise_trials(machine.model, lengths, options, 2000, 1);
  ASSERT_TRUE(found && trials);
  const std::size_t n = trials->sd.size();
  double squares = 0.0, count = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double variance = found->model.parts().covariance[k * n + k] / found->variance_factor();
    if (variance < 1e-18) continue;
    const double ratio = trials->sd[k] / std::sqrt(variance);
    EXPECT_NEAR(ratio, 1.0, 0.08) << k;  // 2000 trials: 1.6 % each
    squares += ratio * ratio;
    count += 1.0;
  }
  EXPECT_NEAR(squares / count, 1.0, 0.03);  // 3.2 % of each variance, as if ten were independent
}

TEST(Identify, RefusesWhatCannotBeMeant) {
  TrueMachine machine("XFYZ", 18);
  const VolumetricLengths lengths = measured(machine, four_stations(), {.points = 40});
  VolumetricLengths other = lengths;
  other.tools[0] = "T9";
  EXPECT_THAT(identify(machine.model, other, {}).error().message, HasSubstr("expected a tool of the machine"));
  other = lengths;
  other.readings[7].axes_mm.y = 601.0;
  EXPECT_THAT(identify(machine.model, other, {}).error().message, HasSubstr("found Y at 601 mm"));
  other = lengths;
  for (VolumetricReading& r : other.readings) r.axes_mm.z = -100.0;
  EXPECT_THAT(identify(machine.model, other, {}).error().message, HasSubstr("one place of Z"));
  other = lengths;
  other.readings.resize(20);
  EXPECT_FALSE(identify(machine.model, other, {}));
  other.readings.clear();
  EXPECT_FALSE(identify(machine.model, other, {}));
}

/// A grid of so few places that half as many functions cannot follow the errors: what they leave is no break of the
/// beam, no drift and no station that moved.
TEST(Identify, TakesForNothingElseWhatTheErrorsOfAGridBend) {
  TrueMachine machine("XFYZ", 181);
  machine.model.tools.erase(machine.model.tools.begin() + 1);
  const VolumetricLengths lengths = measured(machine, four_stations(), {.grid = {11, 9, 8}});
  const auto found = identify(machine.model, lengths, {});
  ASSERT_TRUE(found);
  EXPECT_LT(found->chi_squared_per_dof(), 1.2);
  EXPECT_TRUE(found->breaks.empty()) << found->breaks.size();
  EXPECT_FALSE(found->drift);
  std::string told;
  for (const VolumetricFinding& f : found->findings) told += f.id + " ";
  EXPECT_EQ(told.find("station-moved"), std::string::npos) << told;
  EXPECT_NE(told.find("few-places"), std::string::npos) << told;
}

}  // namespace
}  // namespace axiometry::volumetric
