// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/smoothing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "axiometry/volumetric/field/curve_nodes.h"
#include "axiometry/volumetric/identify/identification_test_support.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::volumetric {
namespace {

using detail::CurvaturePenalty;
using detail::curve_count;
using ::testing::HasSubstr;

/// Errors whose slopes are random walks: what smoothness takes curves for.
class WanderingMachine {
 public:
  WanderingMachine(double displacement_um, double rotation_urad, unsigned seed) : random_(seed) {
    model.travel = {{0.0, 0.0, -500.0}, {1000.0, 600.0, 0.0}};
    model.tools = {{"short", {0.0, 0.0, -150.0}}, {"long", {0.0, 0.0, -300.0}}, {"side", {120.0, 60.0, -180.0}}};
    model.repeatability = Length::um(1.0);
    for (std::size_t e = 0; e < curve_count; ++e) {
      const double bend = detail::bend_of(e) == 0 ? displacement_um : rotation_urad;
      double value = 0.0, slope = 8.0 * normal();
      for (double& at : curves_[e]) {
        at = value;
        value += slope / steps;
        slope += bend * normal() / std::sqrt(static_cast<double>(steps));
      }
    }
  }

  double normal() { return normal_(random_); }
  double value(std::size_t e, double share) const {
    const double along = std::clamp(share, 0.0, 1.0) * steps;
    const auto k = std::min<std::size_t>(static_cast<std::size_t>(along), steps - 1);
    return std::lerp(curves_[e][k], curves_[e][k + 1], along - static_cast<double>(k));
  }
  double share(std::size_t axis, double q) const {
    return (q - model.travel.lowest_mm[axis]) / (model.travel.highest_mm[axis] - model.travel.lowest_mm[axis]);
  }
  /// With its mean taken off, of straightness its best straight line too.
  double in_gauge(std::size_t e, double position) const {
    const ErrorMotion error{e / motion_count, e % motion_count};
    double mean = 0.0, slope = 0.0;
    for (std::size_t k = 0; k < steps; ++k) {
      const double x = 2.0 * (static_cast<double>(k) + 0.5) / steps - 1.0;
      const double at = value(e, 0.5 * (x + 1.0));
      mean += at / steps;
      slope += 3.0 * at * x / steps;
    }
    const double s = share(error.axis, position);
    return value(e, s) - mean - (error.is_straightness() ? slope * (2.0 * s - 1.0) : 0.0);
  }
  /// Each run begins at both ends of the travels where asked.
  VolumetricLengths measured(std::size_t points, bool reaches_ends = false) {
    VolumetricLengths lengths{{}, {}, {"1"}, {}};
    for (const Tool& tool : model.tools) lengths.tools.push_back(tool.name);
    const auto stations = test::four_stations();
    for (std::size_t s = 0; s < stations.size(); ++s) {
      lengths.stations.push_back(stations[s].name);
      for (std::size_t t = 0; t < model.tools.size(); ++t)
        for (std::size_t k = 0; k < points; ++k) {
          Vector3 q;
          ErrorValues errors;
          for (std::size_t a = 0; a < axis_count; ++a) {
            const double anywhere = std::uniform_real_distribution<double>(0.0, 1.0)(random_);
            const double along = reaches_ends && k < 2 ? static_cast<double>(k) : anywhere;
            q[a] = std::lerp(model.travel.lowest_mm[a], model.travel.highest_mm[a], along);
            for (std::size_t m = 0; m < motion_count; ++m) errors.motions[a][m] = value(a * motion_count + m, along);
          }
          const Vector3 tool = model.tools[t].offset_mm;
          const double far_mm = distance(q + tool + 1e-3 * displacement_um(model, errors, q, tool), stations[s].at_mm);
          lengths.readings.push_back({s, t, 0, q, far_mm - 400.0 + 1e-3 * model.sigma_um(far_mm) * normal()});
        }
    }
    return lengths;
  }

  MachineModel model{.chain = KinematicChain::make("XFYZ").value()};

 private:
  static constexpr std::size_t steps = 400;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::array<std::array<double, steps + 1>, curve_count> curves_{};
};

IdentifyOptions smooth(Smoothness smoothness, std::size_t spans) {
  IdentifyOptions options;
  options.sizes = {spans, spans, spans};
  options.smoothness = smoothness;
  return options;
}

constexpr Smoothness automatic{.kind = Smoothness::Kind::automatic};
constexpr Smoothness stated(double displacement_um, double rotation_urad) {
  return {Smoothness::Kind::stated, displacement_um, rotation_urad};
}

const VolumetricFinding* smoothing_finding(const Identification& result, std::string_view id) {
  const auto at = std::ranges::find(result.findings, id, &VolumetricFinding::id);
  return at == result.findings.end() ? nullptr : &*at;
}

/// How many values are held by 1.96 u, and by how much they are off.
struct Held {
  std::size_t held = 0, all = 0;
  double squares = 0.0, normalised = 0.0;

  void add(const WanderingMachine& machine, const Identification& result) {
    for (std::size_t e = 0; e < curve_count; ++e)
      for (const CurveNode& node : curve_nodes(result.model, {e / motion_count, e % motion_count}, 9)) {
        const double off = node.mean.value - machine.in_gauge(e, node.position_mm);
        held += std::abs(off) < 1.96 * node.mean.u;
        ++all;
        squares += off * off;
        normalised += off * off / (node.mean.u * node.mean.u);
      }
  }
  double share() const { return static_cast<double>(held) / static_cast<double>(all); }
};

TEST(CurvaturePenalty, IsOneIntegralForAnyNumberOfSpans) {
  // ∫ (f″)² of f = 5 x² is 100 over [0, 1]; of three motions of Z alone, with τ = 2: 25 each.
  for (const std::size_t spans : {4u, 9u, 30u})
    for (const CurveKind kind : {CurveKind::spline, CurveKind::nodes}) {
      const auto c = *Coefficients::make(kind, {{0, 0, -500}, {1000, 600, 0}}, {spans, spans, spans}, Reversal::none);
      std::vector<double> raw(c.raw(), 0.0);
      const double n = static_cast<double>(spans);
      for (std::size_t k = 0; k < c.basis(2).functions(); ++k)
        for (const std::size_t m : {0u, 1u, 2u}) {
          const double x = (static_cast<double>(k) - 1.0) / n;
          raw[c.curve(2) + k * motion_count + m] = 3.0 + 7.0 * x + 5.0 * x * x;
        }
      CurvaturePenalty penalty(c, {});
      penalty.set({2.0, 1.0}, 1.0);
      const double knots = kind == CurveKind::spline ? n + 1.0 : n - 1.0;
      EXPECT_NEAR(penalty.value(raw), 3.0 * 25.0 * knots / n, 1e-9);
      double product = 0.0;
      const std::vector<double> times = penalty.times(raw);
      for (std::size_t k = 0; k < raw.size(); ++k) product += raw[k] * times[k];
      EXPECT_NEAR(product, penalty.value(raw), 1e-9);
      const std::size_t left_out[] = {2 * motion_count + 1};  // EYZ
      CurvaturePenalty less(c, left_out);
      less.set({2.0, 1.0}, 1.0);
      EXPECT_NEAR(less.value(raw), 2.0 * 25.0 * knots / n, 1e-9);
    }
}

TEST(Smoothness, IsFoundAsItIsAndItsUncertaintiesHoldTheTruth) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  Held with, without;
  double displacement = 0.0, rotation = 0.0;
  constexpr unsigned machines = 12;
  for (unsigned seed = 1; seed <= machines; ++seed) {
    WanderingMachine machine(20.0, 20.0, seed);
    const VolumetricLengths lengths = machine.measured(70);
    const auto plain = identify(machine.model, lengths, smooth({}, 14));
    const auto result = identify(machine.model, lengths, smooth(automatic, 14));
    ASSERT_TRUE(plain && result);
    ASSERT_TRUE(result->smoothed);
    EXPECT_FALSE(plain->smoothed);
    displacement += std::log(result->smoothed->displacement_um / 20.0) / machines;
    rotation += std::log(result->smoothed->rotation_urad / 20.0) / machines;
    with.add(machine, *result);
    without.add(machine, *plain);
    EXPECT_EQ(smoothing_finding(*result, "volumetric-smoothness-contradicted"), nullptr) << seed;
    EXPECT_GT(result->degrees_of_freedom, plain->degrees_of_freedom);
  }
  EXPECT_NEAR(displacement, 0.0, 0.15);
  EXPECT_NEAR(rotation, 0.0, 0.25);
  // 1944 values each, of which some 600 are independent: 0.9 % by chance. τ, found from the same lengths, costs 1 %.
  EXPECT_GT(with.share(), 0.92);
  EXPECT_LT(with.share(), 0.97);
  EXPECT_GT(without.share(), 0.925);
  EXPECT_LT(without.share(), 0.975);
  EXPECT_LT(with.normalised / static_cast<double>(with.all), 1.25);
  EXPECT_LT(with.squares, 0.6 * without.squares);
}

TEST(Smoothness, ThatIsFoundToBeTheLeastIsToldAsABound) {
  WanderingMachine machine(0.0, 0.0, 2);
  const auto result = identify(machine.model, machine.measured(70), smooth(automatic, 8));
  ASSERT_TRUE(result);
  const VolumetricFinding* told = smoothing_finding(*result, "volumetric-smoothness");
  ASSERT_NE(told, nullptr);
  const auto bounds = [&](double found, const char* text) {
    EXPECT_EQ(found == Smoothness::least, told->message.contains(text)) << told->message;
  };
  bounds(result->smoothed->displacement_um, "slopes of displacements change by no more than 0.10 µm");
  bounds(result->smoothed->rotation_urad, "slopes of rotations change by no more than 0.10 µrad");
  EXPECT_TRUE(result->smoothed->displacement_um == Smoothness::least ||
              result->smoothed->rotation_urad == Smoothness::least);
  const auto known = identify(machine.model, machine.measured(70), smooth(stated(0.1, 0.25), 8));
  ASSERT_TRUE(known);
  EXPECT_THAT(smoothing_finding(*known, "volumetric-smoothness")->message,
              HasSubstr("change by 0.1 µm from one end of an axis to the other (standard deviation); slopes of "
                        "rotations change by 0.25 µrad"));
}

TEST(Smoothness, ThatLengthsContradictIsTold) {
  WanderingMachine machine(60.0, 20.0, 3);
  const VolumetricLengths lengths = machine.measured(70);
  const auto result = identify(machine.model, lengths, smooth(stated(1.0, 20.0), 14));
  ASSERT_TRUE(result);
  const VolumetricFinding* told = smoothing_finding(*result, "volumetric-smoothness-contradicted");
  ASSERT_NE(told, nullptr);
  EXPECT_TRUE(told->serious);
  EXPECT_THAT(told->message, HasSubstr("farther than the smoothness allows"));
  const auto fitting = identify(machine.model, lengths, smooth(stated(60.0, 20.0), 14));
  ASSERT_TRUE(fitting);
  EXPECT_EQ(smoothing_finding(*fitting, "volumetric-smoothness-contradicted"), nullptr);
}

TEST(Smoothness, ThatDecidesIsToldAndOneThatAddsNothingIsNot) {
  WanderingMachine machine(10.0, 10.0, 4);
  const VolumetricLengths lengths = machine.measured(60);
  const auto result = identify(machine.model, lengths, smooth(stated(10.0, 10.0), 12));
  ASSERT_TRUE(result);
  EXPECT_NE(smoothing_finding(*result, "volumetric-smoothness-decides"), nullptr);
  const auto loose = identify(machine.model, lengths, smooth(stated(1e6, 1e6), 12));
  const auto plain = identify(machine.model, lengths, smooth({}, 12));
  ASSERT_TRUE(loose && plain);
  EXPECT_EQ(smoothing_finding(*loose, "volumetric-smoothness-decides"), nullptr);
  // Nothing is left of it: the same numbers.
  for (std::size_t e = 0; e < curve_count; ++e) {
    const ErrorMotion error{e / motion_count, e % motion_count};
    const auto a = curve_nodes(loose->model, error, 5), b = curve_nodes(plain->model, error, 5);
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_NEAR(a[k].mean.value, b[k].mean.value, 1e-3 * b[k].mean.u);
      EXPECT_NEAR(a[k].mean.u, b[k].mean.u, 1e-3 * b[k].mean.u);
    }
  }
}

/// Mean of u² over the places at which the program judges a curve.
double mean_square_u(const Identification& result, std::size_t e) {
  double mean = 0.0;
  const auto nodes = curve_nodes(result.model, {e / motion_count, e % motion_count}, 21);
  for (const CurveNode& node : nodes) mean += node.mean.u * node.mean.u / static_cast<double>(nodes.size());
  return mean;
}

TEST(Smoothness, SaysHowMuchLargerUncertaintiesWouldBeByTheLengthsAlone) {
  WanderingMachine machine(10.0, 10.0, 8);
  // Nodes lie where readings are, the program judges over the travels: here they are the same.
  const VolumetricLengths lengths = machine.measured(60, true);
  const auto result = identify(machine.model, lengths, smooth(stated(10.0, 10.0), 12));
  const auto plain = identify(machine.model, lengths, smooth({}, 12));
  ASSERT_TRUE(result && plain);
  ASSERT_EQ(result->smoothed->errors.size(), curve_count);
  double largest = 0.0;
  for (const SmoothedError& s : result->smoothed->errors) {
    EXPECT_NEAR(s.u_ratio, std::sqrt(mean_square_u(*plain, s.error) / mean_square_u(*result, s.error)),
                1e-3 * s.u_ratio);
    largest = std::max(largest, s.u_ratio);
  }
  EXPECT_GT(largest, 1.5);
}

/// Of each error in each direction: the curve is straight, half of the difference between the directions bends. Spans
/// are wide, since near the ends of a travel next to nothing is approached from beyond.
TEST(Smoothness, TellsTheBiasOfCurvesThatDifferByDirectionToo) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  WanderingMachine machine(0.0, 0.0, 9);
  VolumetricLengths lengths = machine.measured(150);
  constexpr double half_um = 12.0;
  for (std::size_t k = 0; k < lengths.readings.size(); ++k) {
    VolumetricReading& reading = lengths.readings[k];
    const VolumetricReading* before = k > 0 ? &lengths.readings[k - 1] : nullptr;
    if (before == nullptr || before->station != reading.station || before->tool != reading.tool) continue;
    const double up = reading.axes_mm.y > before->axes_mm.y ? 1.0 : -1.0;
    // What EYY's half adds along the sight, to first order.
    const Vector3 at = reading.axes_mm + machine.model.tools[reading.tool].offset_mm;
    const Vector3 sight = at - test::four_stations()[reading.station].at_mm;
    const double bent = half_um * std::sin(2.0 * std::numbers::pi * machine.share(1, reading.axes_mm.y));
    reading.length_mm += 1e-3 * up * bent * sight.y / norm(sight);
  }
  IdentifyOptions options = smooth(stated(2.0, 2.0), 6);
  options.reversal = Reversal::curves;
  const auto result = identify(machine.model, lengths, options);
  ASSERT_TRUE(result) << result.error().message;
  const auto at = std::ranges::find(result->smoothed->errors, motion_count + 1, &SmoothedError::error);  // EYY
  ASSERT_NE(at, result->smoothed->errors.end());
  EXPECT_GT(at->bias, 0.1 * half_um);
}

/// A smoothness tells no error that the lengths do not tell: it is refused as before, and nothing else changes for it.
TEST(Smoothness, GivesNoNumberToWhatTheLengthsDoNotTell) {
  WanderingMachine machine(60.0, 20.0, 5);
  machine.model.tools.resize(1);
  const VolumetricLengths lengths = machine.measured(150);
  const auto plain = identify(machine.model, lengths, smooth({}, 6));
  const auto result = identify(machine.model, lengths, smooth(stated(60.0, 20.0), 6));
  ASSERT_TRUE(plain && result);
  EXPECT_FALSE(plain->model.unseen_errors().empty());
  EXPECT_EQ(result->model.unseen_errors(), plain->model.unseen_errors());
  EXPECT_EQ(result->rank.null_directions, plain->rank.null_directions);
  for (const SmoothedError& s : result->smoothed->errors)
    EXPECT_EQ(std::ranges::count(plain->model.unseen_errors(), s.error), 0);
}

TEST(Smoothness, IsRefusedWhereItMeansNothing) {
  WanderingMachine wandering(10.0, 10.0, 7);
  const MachineModel& machine = wandering.model;
  const VolumetricLengths lengths = wandering.measured(30);
  IdentifyOptions options = smooth(automatic, 4);
  options.curves = CurveKind::legendre;
  const auto polynomials = identify(machine, lengths, options);
  ASSERT_FALSE(polynomials);
  EXPECT_THAT(polynomials.error().message, HasSubstr("Legendre"));
  for (const double bend : {0.0, -1.0, 0.09, 2e6, std::nan("")}) {
    const auto result = identify(machine, lengths, smooth(stated(bend, 1.0), 4));
    ASSERT_FALSE(result) << bend;
    EXPECT_THAT(result.error().message, HasSubstr("found a smoothness of"));
  }
}

/// Where no spans are given the smoothness, not the criterion, says how far curves may bend.
TEST(Smoothness, TakesFinerSpansWhereNoneAreGiven) {
  WanderingMachine machine(60.0, 20.0, 6);
  const VolumetricLengths lengths = machine.measured(120);
  const auto plain = identify(machine.model, lengths, {});
  const auto result = identify(machine.model, lengths, {.smoothness = automatic});
  ASSERT_TRUE(plain && result);
  for (std::size_t a = 0; a < axis_count; ++a)
    EXPECT_GT(result->model.coefficients().basis(a).size(), plain->model.coefficients().basis(a).size());
}

}  // namespace
}  // namespace axiometry::volumetric
