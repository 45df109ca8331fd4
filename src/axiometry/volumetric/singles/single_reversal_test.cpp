// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "axiometry/volumetric/field/line_prediction.h"
#include "axiometry/volumetric/machine/kinematics.h"
#include "axiometry/volumetric/singles/measured_square.h"
#include "axiometry/volumetric/singles/single_errors.h"
#include "axiometry/volumetric/singles/single_places.h"

// From a machine whose errors differ by direction, read one after the other in both, to the model and back to each
// test.
namespace axiometry::volumetric {
namespace {

constexpr std::size_t directed_nodes = 6;

/// True errors at nodes, of the mean and of half the difference of both directions.
struct DirectedTruth {
  using Curves = std::array<std::array<std::array<double, directed_nodes>, motion_count>, axis_count>;
  MachineModel machine;
  Curves means{}, halves{};
  std::array<double, 3> square{};
  std::array<Vector3, 3> stood = {Vector3{0, 120, -260}, {333, 0, -410}, {610, 77, 0}};
  std::array<std::size_t, 3> tool = {0, 1, 0};  ///< with which each axis was measured
  /// In which direction the others had come to rest there.
  std::array<Approaches, 3> approaches = {Approaches{0, 1, -1}, Approaches{1, 0, 1}, Approaches{-1, -1, 0}};

  double node(std::size_t a, std::size_t n) const {
    const double share = static_cast<double>(n) / (directed_nodes - 1);
    return machine.travel.lowest_mm[a] + share * (machine.travel.highest_mm[a] - machine.travel.lowest_mm[a]);
  }
  static double between(const std::array<double, directed_nodes>& curve, double spans) {
    const auto k = std::min<std::size_t>(static_cast<std::size_t>(spans), directed_nodes - 2);
    return std::lerp(curve[k], curve[k + 1], spans - static_cast<double>(k));
  }
  Vector3 field(Vector3 q, Vector3 tool_mm, Approaches moving) const {
    ErrorValues e;
    for (std::size_t a = 0; a < axis_count; ++a) {
      const double spans = (q[a] - node(a, 0)) / (node(a, 1) - node(a, 0));
      for (std::size_t m = 0; m < motion_count; ++m)
        e.motions[a][m] = between(means[a][m], spans) + moving[a] * between(halves[a][m], spans);
    }
    e.squareness_urad = square;
    return displacement_um(machine, e, q, tool_mm);
  }
  Vector3 offset_mm(std::size_t a) const { return machine.tools[tool[a]].offset_mm; }
  Vector3 place(std::size_t a, std::size_t n) const {
    Vector3 q = stood[a];
    q[a] = node(a, n);
    return q;
  }
  /// What an instrument reads at a node: of a rotation and of everything else with a zero of its own.
  double read(ErrorMotion e, std::size_t n, double direction) const {
    if (e.is_rotation()) return means[e.axis][e.motion][n] + direction * halves[e.axis][e.motion][n] + 55.0;
    Approaches moving = approaches[e.axis];
    moving[e.axis] = direction;
    return field(place(e.axis, n), offset_mm(e.axis), moving)[e.motion] + 9.0;
  }
};

DirectedTruth directed_truth(const char* chain) {
  DirectedTruth truth{{.chain = *KinematicChain::make(chain)}};
  truth.machine.travel = {{-900, -100, -500}, {0, 500, -80}};
  truth.machine.tools = {{"long", {30, -20, -150}}, {"beside", {-80, 45, -60}}};
  truth.machine.functional_point_mm = {Vector3{10, 200, -300}, {0, 0, 0}, {50, 60, -70}};
  truth.stood[1].x = -333;
  truth.stood[2].x = -610;
  std::mt19937 random(17);
  std::normal_distribution<double> normal(0.0, 10.0);
  for (DirectedTruth::Curves* curves : {&truth.means, &truth.halves})
    for (auto& axis : *curves)
      for (auto& motion : axis)
        for (double& x : motion) x = normal(random);
  for (double& x : truth.square) x = 3.0 * normal(random);
  return truth;
}

SingleMotion directed_motion(const DirectedTruth& truth, ErrorMotion e) {
  SingleMotion motion{e, {}, {}, std::vector<double>(directed_nodes, 0.3), SingleReversal{}};
  motion.reversal->u.assign(directed_nodes, 0.2);
  motion.reversal->covariances.assign(directed_nodes, 0.0);
  for (std::size_t n = 0; n < directed_nodes; ++n) {
    const double up = truth.read(e, n, 1.0), down = truth.read(e, n, -1.0);
    motion.positions_mm.push_back(truth.node(e.axis, n));
    motion.values.push_back(0.5 * (up + down));
    motion.reversal->halves.push_back(0.5 * (up - down));
  }
  return motion;
}

SingleErrors directed_errors(const DirectedTruth& truth) {
  SingleErrors errors;
  for (std::size_t a = 0; a < axis_count; ++a) {
    errors.places[a] = SinglePlace{truth.stood[a], truth.offset_mm(a), truth.approaches[a]};
    for (std::size_t m = 0; m < motion_count; ++m) errors.motions.push_back(directed_motion(truth, {a, m}));
  }
  errors.squareness = {{Squareness::C0Y, 10.0, 1.0}, {Squareness::B0Z, -20.0, 1.0}, {Squareness::A0Z, 5.0, 1.0}};
  return errors;
}

TestedLine line_of_test(const DirectedTruth& truth, std::size_t a) {
  TestedLine line{.name = "test", .from_mm = truth.place(a, 0), .to_mm = truth.place(a, directed_nodes - 1)};
  line.tool_mm = truth.offset_mm(a);
  line.first_mm = truth.node(a, 0);
  for (std::size_t n = 0; n < directed_nodes; ++n) line.positions_mm.push_back(truth.node(a, n));
  return line;
}

double range(const std::vector<double>& numbers) {
  return *std::ranges::max_element(numbers) - *std::ranges::min_element(numbers);
}

constexpr const char* directed_chains[] = {"FXYZ", "XFYZ", "ZFXY", "YXFZ", "ZYXF", "XYFZ"};

TEST(SingleReversalOfAModel, PredictsEachTestOfPositionsThatItWasMadeFrom) {
  for (const char* chain : directed_chains) {
    const DirectedTruth truth = directed_truth(chain);
    const auto made = model_of_singles(truth.machine, directed_errors(truth));
    ASSERT_TRUE(made) << chain << ": " << made.error().message;
    EXPECT_TRUE(made->findings.empty()) << chain << ": " << made->findings.front().message;
    for (std::size_t a = 0; a < axis_count; ++a) {
      const auto predicted = predict_line(made->model, line_of_test(truth, a));
      ASSERT_TRUE(predicted) << chain;
      EXPECT_TRUE(predicted->has_directions) << chain;
      std::vector<double> read, means, predicted_means;
      double B = 0.0, mean = 0.0;
      for (std::size_t n = 0; n < directed_nodes; ++n) {
        const double up = truth.read({a, a}, n, 1.0), down = truth.read({a, a}, n, -1.0);
        read.insert(read.end(), {up, down});
        means.push_back(0.5 * (up + down));
        predicted_means.push_back(0.5 * (predicted->up[n].value + predicted->down[n].value));
        B = std::max(B, std::abs(up - down));
        mean += means.back() / directed_nodes;
      }
      for (std::size_t n = 0; n < directed_nodes; ++n) {
        EXPECT_NEAR(predicted->up[n].value, read[2 * n] - mean, 1e-9) << chain << a << n;
        EXPECT_NEAR(predicted->down[n].value, read[2 * n + 1] - mean, 1e-9) << chain << a << n;
      }
      EXPECT_NEAR(predicted->systematic.value, range(read), 1e-9) << chain;
      EXPECT_NEAR(predicted->reversal_um, B, 1e-9) << chain;
      EXPECT_NEAR(range(predicted_means), range(means), 1e-9) << chain << ": M";
    }
  }
}

TEST(SingleReversalOfAModel, HasTheStraightnessAndTheAnglesOfBothDirections) {
  for (const char* chain : directed_chains) {
    const DirectedTruth truth = directed_truth(chain);
    const auto made = model_of_singles(truth.machine, directed_errors(truth));
    ASSERT_TRUE(made);
    for (std::size_t a = 0; a < axis_count; ++a)
      for (std::size_t m = 0; m < motion_count; ++m) {
        const auto shown = [&](std::size_t n, double direction) {
          Approaches approaches{};
          approaches[a] = direction;
          return m < first_rotation ? *made->model.at(truth.place(a, n), truth.offset_mm(a), approaches).error_um[m]
                                    : made->model.motion({a, m}, truth.node(a, n), direction)->value;
        };
        const auto off = [&](std::size_t n, double d) { return shown(n, d) - truth.read({a, m}, n, d); };
        // All readings are met but for one zero and, of straightness, one slope: those of where the straightedge lay.
        const bool has_slope = m < first_rotation && m != a;
        const double slope = has_slope ? (off(directed_nodes - 1, 1.0) - off(0, 1.0)) / (directed_nodes - 1) : 0.0;
        for (std::size_t n = 0; n < directed_nodes; ++n)
          for (const double d : {1.0, -1.0})
            EXPECT_NEAR(off(n, d), off(0, 1.0) + slope * static_cast<double>(n), 1e-9) << chain << a << m << n << d;
      }
  }
}

TEST(SingleReversalOfAModel, HasTheFieldOfTheMachineByDirectionButForItsPlaceAndOrientation) {
  const DirectedTruth truth = directed_truth("YXFZ");
  const auto made = model_of_singles(truth.machine, directed_errors(truth));
  ASSERT_TRUE(made);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int k = 0; k < 30; ++k) {
    Vector3 q;
    Approaches up{}, down{};
    for (std::size_t a = 0; a < axis_count; ++a) {
      q[a] = std::lerp(truth.node(a, 0), truth.node(a, directed_nodes - 1), share(random));
      up[a] = k % 3 == static_cast<int>(a) ? 1.0 : -1.0;
      down[a] = -up[a];
    }
    for (const Tool& tool : truth.machine.tools) {
      const Vector3 shown =
          made->model.at(q, tool.offset_mm, up).error() - made->model.at(q, tool.offset_mm, down).error();
      const Vector3 true_um = truth.field(q, tool.offset_mm, up) - truth.field(q, tool.offset_mm, down);
      // Between nodes a lever that changes with the position makes a parabola of what is straight there.
      EXPECT_LT(norm(shown - true_um), 0.6);
    }
  }
}

TEST(SingleReversalOfAModel, CarriesWhatItsReadingsShareAndWhatTheyDoNot) {
  // By hand: two positions; the mean less that of both is (m₂ − m₁)/2, the half stays h₂. Moving up both add:
  // u² = (u_m² + u_m²)/4 + u_h² + cov; moving down cov is taken away.
  SingleErrors errors;
  errors.motions.push_back(
      {{0, 5}, {0.0, 900.0}, {4.0, 6.0}, {0.5, 0.5}, SingleReversal{{1.5, 2.0}, {0.3, 0.3}, {0.04, 0.04}}});
  MachineModel machine{.chain = *KinematicChain::make("FXYZ")};
  machine.travel = {{0, 0, -500}, {900, 500, 0}};
  machine.tools = {{"T", {0, 0, -150}}};
  const auto made = model_of_singles(machine, errors);
  ASSERT_TRUE(made) << made.error().message;
  const auto up = made->model.motion({0, 5}, 900.0, 1.0), down = made->model.motion({0, 5}, 900.0, -1.0);
  ASSERT_TRUE(up && down);
  EXPECT_NEAR(up->value, 1.0 + 2.0, 1e-12);
  EXPECT_NEAR(down->value, 1.0 - 2.0, 1e-12);
  EXPECT_NEAR(up->u, std::sqrt(0.125 + 0.09 + 0.04), 1e-12);
  EXPECT_NEAR(down->u, std::sqrt(0.125 + 0.09 - 0.04), 1e-12);
}

TEST(SingleReversalOfAModel, IsToldAtItsLineAloneWhereARotationWasReadInOneDirection) {
  const DirectedTruth truth = directed_truth("XFYZ");
  SingleErrors errors = directed_errors(truth);
  const auto yaw = std::ranges::find_if(errors.motions, [](const SingleMotion& m) {
    return m.error == ErrorMotion{0, 5};
  });
  yaw->reversal.reset();
  const auto made = model_of_singles(truth.machine, errors);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->findings.size(), 2u);
  EXPECT_EQ(made->findings[0].id, "single-directions-lacking");
  EXPECT_TRUE(made->findings[0].message.starts_with(
      "what the directions of EXX differ by is told only at the line where it was read: there it holds ECX (lever "))
      << made->findings[0].message;
  EXPECT_TRUE(made->model.unseen_means().empty());
  EXPECT_EQ(made->model.unseen_reversals(), (std::vector<std::size_t>{0, 1, 5}));  // EXX, EYX, ECX
  EXPECT_FALSE(made->model.motion({0, 5}, -450.0, 1.0));
  EXPECT_TRUE(made->model.motion({0, 5}, -450.0));
  EXPECT_TRUE(made->model.motion({0, 4}, -450.0, -1.0));

  TestedLine line = line_of_test(truth, 0);
  const auto there = predict_line(made->model, line);
  ASSERT_TRUE(there);
  EXPECT_TRUE(there->has_directions);
  EXPECT_NEAR(there->up[2].value - there->down[2].value, truth.read({0, 0}, 2, 1.0) - truth.read({0, 0}, 2, -1.0),
              1e-9);
  for (Vector3* end : {&line.from_mm, &line.to_mm}) end->y += 90.0;
  const auto beside = predict_line(made->model, line);
  ASSERT_TRUE(beside);
  EXPECT_FALSE(beside->has_directions);
  EXPECT_EQ(beside->untold_reversals, (std::vector<std::size_t>{0, 5}));
  EXPECT_EQ(beside->reversal_um, 0.0);
}

/// What the best straight lines of both straightness errors make of it: of the means of both directions, of each line
/// but for its one direction where that is stated.
double squareness_urad(const DirectedTruth& truth, const SquareLines& pair, std::array<double, 2> directions) {
  double urad = 0.0;
  for (const ErrorMotion line : {pair.first, pair.second}) {
    const double direction = directions[line == pair.first ? 0 : 1];
    std::vector<double> positions;
    for (std::size_t n = 0; n < directed_nodes; ++n) positions.push_back(truth.node(line.axis, n));
    const std::vector<double> weights = curve_slope_weights(positions);
    for (std::size_t n = 0; n < directed_nodes; ++n)
      for (const double d : {1.0, -1.0})
        urad += pair.sign * 0.5 * (1.0 + d * direction) * 1e3 * weights[n] * truth.read(line, n, d);
  }
  return urad;
}

TEST(SingleReversalOfAModel, HasTheFieldOfTheMachineInEveryCombinationOfDirections) {
  // Standing axes turn the lines by the directions in which they came to rest, and lines of one direction have its
  // slope: both are carried, and one motion of the whole is left over, whatever the directions are.
  for (const char* chain : directed_chains) {
    const DirectedTruth truth = directed_truth(chain);
    SingleErrors errors = directed_errors(truth);
    const std::array<double, 2> lines_of[] = {{0.0, 0.0}, {1.0, 0.0}, {-1.0, 1.0}};
    for (std::size_t k = 0; k < 3; ++k)
      errors.squareness[k] = {static_cast<Squareness>(k), squareness_urad(truth, square_lines[k], lines_of[k]), 1.0,
                              true, lines_of[k]};
    const auto made = model_of_singles(truth.machine, errors);
    ASSERT_TRUE(made) << chain << ": " << made.error().message;
    EXPECT_TRUE(made->findings.empty()) << chain << ": " << made->findings.front().message;
    const Vector3 tool = truth.machine.tools[0].offset_mm;
    std::vector<Vector3> places, differences;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int k = 0; k < 40; ++k) {
      Vector3 q;
      Approaches moving{};
      for (std::size_t a = 0; a < axis_count; ++a) {
        q[a] = std::lerp(truth.node(a, 0), truth.node(a, directed_nodes - 1), share(random));
        moving[a] = (k >> a) % 2 == 0 ? 1.0 : -1.0;
      }
      places.push_back(q);
      differences.push_back(made->model.at(q, tool, moving).error() - truth.field(q, tool, moving));
    }
    for (std::size_t i = 0; i < places.size(); ++i)  // a small motion of the whole changes no distance
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_NEAR(dot(differences[i] - differences[k], unit(places[i] - places[k])), 0.0, 1e-6) << chain;
  }
}

/// A table that carries X turns by 2 µrad more where it moved up, and by as much less where it moved down.
SingleErrors turning_table() {
  SingleErrors errors;
  errors.motions.push_back(
      {{0, 5}, {0.0, 1000.0}, {0.0, 0.0}, {0.2, 0.2}, SingleReversal{{2.0, 2.0}, {0.1, 0.1}, {0.0, 0.0}}});
  errors.squareness = {{Squareness::C0Y, 10.0, 0.6, true}};
  errors.places[0] = SinglePlace{{0, 0, 0}, {0, 0, 0}};
  errors.places[1] = SinglePlace{{500, 0, 0}, {0, 0, 0}};
  return errors;
}

MachineModel machine_with_turning_table() {
  MachineModel machine{.chain = *KinematicChain::make("XFYZ")};
  machine.travel = {{0, 0, -500}, {1000, 600, 0}};
  machine.tools = {{"T", {0, 0, 0}}};
  return machine;
}

TEST(SingleReversalOfAModel, TurnsALineByTheDirectionInWhichAnAxisBeforeItCameToRest) {
  // By hand: while Y moves, ECX = ±2 µrad moves the tool by −ECX·y along X, which reads as C0Y. Of its uncertainty
  // ECX has, as the lever of EYX, half of the difference of two readings, 0.2/√2, and by the direction 0.1/√2.
  SingleErrors errors = turning_table();
  for (const Reversal reversal : {Reversal::curves, Reversal::none})
    for (const double direction : {1.0, -1.0}) {
      errors.reversal = reversal;
      errors.places[1]->approaches = {direction, 0, 0};
      const auto made = model_of_singles(machine_with_turning_table(), errors);
      ASSERT_TRUE(made) << made.error().message;
      EXPECT_EQ(made->model.coefficients().reversal(), reversal);
      const auto square = made->model.squareness(Squareness::C0Y);
      ASSERT_TRUE(square);
      EXPECT_NEAR(square->value, 10.0 - 2.0 * direction, 1e-9);
      EXPECT_NEAR(square->u, std::sqrt(0.36 + 0.02 + 0.005), 1e-9);
      ASSERT_EQ(made->findings.size(), 1u);
      EXPECT_EQ(made->findings[0].id, "single-not-measured");
    }
}

TEST(SingleReversalOfAModel, MakesASquarenessAsUncertainWhereNothingSaysThatDirection) {
  const auto made = model_of_singles(machine_with_turning_table(), turning_table());
  ASSERT_TRUE(made) << made.error().message;
  const auto square = made->model.squareness(Squareness::C0Y);
  ASSERT_TRUE(square);
  EXPECT_NEAR(square->value, 10.0, 1e-9);
  EXPECT_NEAR(square->u, std::sqrt(0.36 + 0.02 + 4.0), 1e-9);
  ASSERT_EQ(made->findings.size(), 2u);
  EXPECT_EQ(made->findings[0].id, "single-squareness-approach");
  EXPECT_FALSE(made->findings[0].serious);
  EXPECT_EQ(
      made->findings[0].message,
      "C0Y is uncertain by 2.00 µrad, with everything else by 2.09 µrad, because nothing states in which direction "
      "an axis came to rest that has other rotations in each: X while Y moved");
  // What does not matter is not told, and is in the uncertainty all the same: 0.02 µrad beside 0.62.
  SingleErrors steady = turning_table();
  steady.motions[0].reversal->halves = {0.02, 0.02};
  const auto hardly = model_of_singles(machine_with_turning_table(), steady);
  ASSERT_TRUE(hardly);
  EXPECT_EQ(hardly->findings.size(), 1u);
  EXPECT_NEAR(hardly->model.squareness(Squareness::C0Y)->u, std::sqrt(0.36 + 0.02 + 0.0004), 1e-9);
}

TEST(SingleReversalOfAModel, TakesALineOfOneDirectionForThatDirection) {
  // By hand: EYX rises by 4 µm more over 1000 mm than the mean of both where X moves up, which reads as −4 µrad of C0Y.
  SingleErrors errors = turning_table();
  errors.places[1]->approaches = {1, 0, 0};
  errors.squareness[0].directions = {0, 1};  // EXY, EYX
  const auto of_one = model_of_singles(machine_with_turning_table(), errors);
  ASSERT_TRUE(of_one);
  EXPECT_NEAR(of_one->model.squareness(Squareness::C0Y)->value, 8.0, 1e-9) << "EYX is not known by direction";
  errors.motions.push_back(
      {{0, 1}, {0.0, 1000.0}, {0.0, 0.0}, {0.3, 0.3}, SingleReversal{{0.0, 4.0}, {0.1, 0.1}, {0.0, 0.0}}});
  const auto up = model_of_singles(machine_with_turning_table(), errors);
  errors.squareness[0].directions = {0, -1};
  const auto down = model_of_singles(machine_with_turning_table(), errors);
  ASSERT_TRUE(up && down);
  EXPECT_NEAR(up->model.squareness(Squareness::C0Y)->value, 8.0 + 4.0, 1e-9);
  EXPECT_NEAR(down->model.squareness(Squareness::C0Y)->value, 8.0 - 4.0, 1e-9);
}

TEST(SingleReversalOfAModel, OfNoErrorIsNone) {
  const DirectedTruth truth = directed_truth("XFYZ");
  SingleErrors errors = directed_errors(truth);
  for (SingleMotion& m : errors.motions) m.reversal.reset();
  const auto made = model_of_singles(truth.machine, errors);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->model.coefficients().reversal(), Reversal::none);
  EXPECT_TRUE(made->model.parts().unseen.empty());
}

}  // namespace
}  // namespace axiometry::volumetric
