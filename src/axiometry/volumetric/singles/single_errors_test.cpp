// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/singles/single_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "axiometry/volumetric/machine/kinematics.h"

namespace axiometry::volumetric {
namespace {

constexpr std::size_t test_nodes = 7;

MachineModel single_machine(const char* chain) {
  MachineModel machine{.chain = *KinematicChain::make(chain)};
  machine.travel = {{0, -100, -500}, {900, 500, -80}};
  machine.tools = {{"T", {30, -20, -150}}};
  machine.functional_point_mm = {Vector3{10, 200, -300}, {0, 0, 0}, {50, 60, -70}};
  return machine;
}

/// True errors at nodes; between them straight lines.
struct SingleTruth {
  MachineModel machine;
  std::array<std::array<std::array<double, test_nodes>, motion_count>, axis_count> curves{};
  std::array<double, 3> square{};

  double lower(std::size_t a) const { return machine.travel.lowest_mm[a]; }
  double upper(std::size_t a) const { return machine.travel.highest_mm[a]; }
  double at(std::size_t a, std::size_t m, double q) const {
    const double s = (q - lower(a)) / (upper(a) - lower(a)) * (test_nodes - 1);
    const auto k = std::min<std::size_t>(static_cast<std::size_t>(s), test_nodes - 2);
    const double t = s - static_cast<double>(k);
    return (1 - t) * curves[a][m][k] + t * curves[a][m][k + 1];
  }
  Vector3 field(Vector3 q, Vector3 tool) const {
    ErrorValues e;
    for (std::size_t a = 0; a < axis_count; ++a)
      for (std::size_t m = 0; m < motion_count; ++m) e.motions[a][m] = at(a, m, q[a]);
    e.squareness_urad = square;
    return displacement_um(machine, e, q, tool);
  }
};

SingleTruth single_truth(const char* chain, unsigned seed) {
  SingleTruth truth{single_machine(chain)};
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 10.0);
  for (auto& axis : truth.curves)
    for (auto& motion : axis)
      for (double& x : motion) x = normal(random);
  for (double& x : truth.square) x = 3.0 * normal(random);
  return truth;
}

/// What instruments would read of it, one error after the other.
SingleErrors measured_singly(const SingleTruth& truth) {
  SingleErrors errors;
  const std::array<Vector3, 3> stood = {Vector3{0, 120, -260}, {333, 0, -410}, {610, 77, 0}};
  std::array<std::array<double, 3>, 3> slope{};  // of each straightness, [axis][motion], µrad
  for (std::size_t a = 0; a < axis_count; ++a) {
    errors.places[a] = SinglePlace{stood[a], truth.machine.tools[0].offset_mm};
    const auto basis = *CurveBasis::make(CurveKind::nodes, truth.lower(a), truth.upper(a), test_nodes - 1);
    const auto slopes = basis.slopes();
    for (std::size_t m = 0; m < motion_count; ++m) {
      SingleMotion motion{{a, m}, {}, {}, std::vector<double>(test_nodes, 0.3)};
      for (std::size_t n = 0; n < test_nodes; ++n) {
        Vector3 q = stood[a];
        q[a] = truth.lower(a) + (truth.upper(a) - truth.lower(a)) * static_cast<double>(n) / (test_nodes - 1);
        motion.positions_mm.push_back(q[a]);
        const double value = m < 3 ? truth.field(q, truth.machine.tools[0].offset_mm)[m] : truth.curves[a][m][n] + 77.0;
        motion.values.push_back(value);
        if (m < 3) slope[a][m] += 3.0 * slopes[n] * value * 2.0 / (truth.upper(a) - truth.lower(a)) * 1e3;
      }
      errors.motions.push_back(motion);
    }
  }
  errors.squareness = {{Squareness::C0Y, -slope[1][0] - slope[0][1], 1.0},
                       {Squareness::B0Z, slope[2][0] + slope[0][2], 1.0},
                       {Squareness::A0Z, -slope[2][1] - slope[1][2], 1.0}};
  return errors;
}

TEST(SingleErrors, TogetherGiveTheFieldOfTheMachineButForItsPlaceAndOrientation) {
  for (const char* chain : {"FXYZ", "XFYZ", "YXFZ", "ZYXF", "XYFZ"}) {
    const SingleTruth truth = single_truth(chain, 11);
    const auto made = model_of_singles(truth.machine, measured_singly(truth));
    ASSERT_TRUE(made) << chain << ": " << made.error().message;
    EXPECT_TRUE(made->findings.empty()) << chain << ": " << made->findings.front().message;
    const Vector3 tool = truth.machine.tools[0].offset_mm;
    std::vector<Vector3> places, differences;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int k = 0; k < 40; ++k) {
      Vector3 q;
      for (std::size_t a = 0; a < 3; ++a) q[a] = truth.lower(a) + share(random) * (truth.upper(a) - truth.lower(a));
      const ToolPointError value = made->model.at(q, tool);
      ASSERT_TRUE(value.is_whole()) << chain;
      places.push_back(q);
      differences.push_back(value.error() - truth.field(q, tool));
    }
    // A small motion of the whole, d = t + φ × p, changes no distance.
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_NEAR(dot(differences[i] - differences[k], unit(places[i] - places[k])), 0.0, 1e-6) << chain;
  }
}

TEST(SingleErrors, CarryTheirUncertainties) {
  // By hand: two readings of ±1 of one rotation at the ends, u = 0.3 each: the mean taken out, ±1 with u = 0.3/√2.
  MachineModel machine = single_machine("FXYZ");
  SingleErrors errors;
  errors.motions.push_back({{0, 5}, {0.0, 900.0}, {4.0, 6.0}, {0.3, 0.3}});
  const auto made = model_of_singles(machine, errors);
  ASSERT_TRUE(made) << made.error().message;
  const auto end = made->model.motion({0, 5}, 900.0);
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->value, 1.0, 1e-12);
  EXPECT_NEAR(end->u, 0.3 / std::sqrt(2.0), 1e-12);
  EXPECT_FALSE(made->model.motion({0, 4}, 900.0));
  EXPECT_FALSE(made->model.squareness(Squareness::C0Y));
  ASSERT_EQ(made->findings.size(), 1u);
  EXPECT_EQ(made->findings[0].id, "single-not-measured");
  EXPECT_TRUE(made->findings[0].message.starts_with("not measured: EXX, EYX")) << made->findings[0].message;
}

TEST(SingleErrors, HaveNoNumberWhereARotationThatActsWasNotMeasured) {
  MachineModel machine = single_machine("FXYZ");
  machine.functional_point_mm = {};
  machine.travel.highest_mm.z = 200.0;
  SingleErrors errors;
  errors.motions.push_back({{0, 1}, {0.0, 450.0, 900.0}, {0.0, 5.0, 0.0}, {0.3, 0.3, 0.3}});
  EXPECT_FALSE(model_of_singles(machine, errors));  // no place
  errors.places[0] = SinglePlace{{0, 200, 150}, {0, 0, -150}};
  // [ω × r]_Y = ω_Z r_X − ω_X r_Z: at this place both levers are 0.
  const auto at_line = model_of_singles(machine, errors);
  ASSERT_TRUE(at_line);
  EXPECT_TRUE(at_line->model.motion({0, 1}, 450.0));
  errors.places[0]->axes_mm.z = 0.0;
  const auto off_line = model_of_singles(machine, errors);
  ASSERT_TRUE(off_line);
  EXPECT_FALSE(off_line->model.motion({0, 1}, 450.0));
  EXPECT_EQ(off_line->findings[0].message,
            "EYX has no number: at its line it holds EAX (lever 150.0 mm), not measured");
}

/// The table carries X, whose yaw was read from 200 to 800 mm alone; EYX bends by 40 µm over its last 200 mm.
SingleErrors with_a_bent_end() {
  SingleErrors errors;
  errors.motions.push_back({{0, 5}, {200.0, 800.0}, {0.0, 0.0}, {0.2, 0.2}});
  errors.motions.push_back({{0, 1}, {0.0, 800.0, 1000.0}, {0.0, 0.0, 40.0}, {0.3, 0.3, 0.3}});
  errors.motions.push_back({{1, 0}, {0.0, 600.0}, {0.0, 0.0}, {0.3, 0.3}});
  errors.squareness = {{Squareness::C0Y, 0.0, 0.6}};
  errors.places[0] = SinglePlace{{0, 0, 0}, {0, 0, 0}};
  errors.places[1] = SinglePlace{{500, 0, 0}, {0, 0, 0}};
  return errors;
}

MachineModel machine_with_table() {
  MachineModel machine = single_machine("XFYZ");
  machine.travel = {{0, 0, -500}, {1000, 600, 0}};
  machine.tools = {{"T", {0, 0, 0}}};
  machine.functional_point_mm = {};
  return machine;
}

TEST(SingleErrors, HaveTheSquarenessOfTheRangeTheyHaveInCommon) {
  // By hand: the best line over 1000 mm of a curve that rises by 40 µm from 800 to 1000 mm has the slope
  // 12/1000³ ∫ (q − 500)(q − 800)/5 dq = 12/1e9 (1.2e6 + 0.53333e6) µm/mm = 20.8 µrad; within 200 to 800 mm it has
  // none. Of the readings the last counts 104 · 5 = 0.52 µrad/µm.
  SingleErrors errors = with_a_bent_end();
  const auto made = model_of_singles(machine_with_table(), errors);
  ASSERT_TRUE(made) << made.error().message;
  const auto square = made->model.squareness(Squareness::C0Y);
  ASSERT_TRUE(square);
  EXPECT_NEAR(square->value, 20.8, 1e-9);
  EXPECT_GT(square->u, std::hypot(0.6, 0.3 * 0.52));
  // A straightedge that lies askew changes nothing.
  for (std::size_t k = 0; k < 3; ++k) errors.motions[1].values[k] += 7.0 + 0.05 * errors.motions[1].positions_mm[k];
  const auto askew = model_of_singles(machine_with_table(), errors);
  ASSERT_TRUE(askew);
  EXPECT_NEAR(askew->model.squareness(Squareness::C0Y)->value, 20.8, 1e-9);
}

TEST(SingleErrors, HaveNoSquarenessWhereNothingTellsItsRange) {
  SingleErrors errors = with_a_bent_end();
  errors.motions[1].error = {0, 2};  // EZX
  const auto made = model_of_singles(machine_with_table(), errors);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_FALSE(made->model.squareness(Squareness::C0Y));
  EXPECT_NE(std::ranges::find(made->findings,
                              "C0Y has no number: the errors of X were read over different ranges, and without EYX "
                              "nothing tells over which the squareness was",
                              &NamedFinding::message),
            made->findings.end());
}

TEST(SingleErrors, RefusePlacesBeyondTheTravel) {
  SingleErrors errors = with_a_bent_end();
  errors.places[0]->axes_mm.y = 5000.0;
  const auto made = model_of_singles(machine_with_table(), errors);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "found Y at 5000 mm while X moved, expected it within its travel from 0 to 600 mm");
  errors.places[0]->axes_mm = {-5000.0, 0.0, 0.0};  // that of X itself is not used
  EXPECT_TRUE(model_of_singles(machine_with_table(), errors));
}

TEST(SingleErrors, DoNotContinueRotationsBeyondTheirReadings) {
  SingleErrors errors = with_a_bent_end();
  errors.places[1]->axes_mm.x = 900.0;
  const auto made = model_of_singles(machine_with_table(), errors);
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_FALSE(made->model.squareness(Squareness::C0Y));
  EXPECT_EQ(made->findings[1].message, "C0Y has no number: its lines hold rotation ECX at 900 mm, not measured");
}

TEST(SingleErrors, RefuseReadingsOutsideAndErrorsWithoutACommonRange) {
  SingleErrors errors;
  errors.motions.push_back({{0, 5}, {0.0, 950.0}, {4.0, 6.0}, {0.3, 0.3}});
  EXPECT_FALSE(model_of_singles(single_machine("FXYZ"), errors));
  errors.motions[0].positions_mm = {0.0, 400.0};
  errors.motions.push_back({{0, 4}, {500.0, 900.0}, {4.0, 6.0}, {0.3, 0.3}});
  EXPECT_FALSE(model_of_singles(single_machine("FXYZ"), errors));
  EXPECT_FALSE(model_of_singles(single_machine("FXYZ"), {}));
}

}  // namespace
}  // namespace axiometry::volumetric
