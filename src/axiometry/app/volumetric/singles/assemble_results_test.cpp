// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <random>
#include <string>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/volumetric/singles/assemble_singles.h"
#include "axiometry/volumetric/machine/kinematics.h"
#include "tests/support/temporary_folder.h"

// From a machine whose errors are known, through readings with the sign that an instrument gives them, through
// `straightness`, `angles` and `squareness`, to the model that `volumetric assemble` makes of their results.
namespace axiometry::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using volumetric::ErrorMotion;

constexpr std::size_t simulated_nodes = 6;
constexpr std::string_view simulated_letters = "XYZABC";

struct SimulatedMachine {
  volumetric::MachineModel machine{.chain = *volumetric::KinematicChain::make("XFYZ")};
  std::array<std::array<std::array<double, simulated_nodes>, 6>, 3> curves{};
  std::array<double, 3> square{};  ///< C0Y, B0Z, A0Z, µrad
  std::array<Vector3, 3> stood = {Vector3{0, 120, -260}, {333, 0, -410}, {610, 77, 0}};

  double node(std::size_t a, std::size_t n) const {
    return machine.travel.lowest_mm[a] + (machine.travel.highest_mm[a] - machine.travel.lowest_mm[a]) *
                                             static_cast<double>(n) / static_cast<double>(simulated_nodes - 1);
  }
  double at(std::size_t a, std::size_t m, double q) const {
    std::size_t k = 1;
    while (k + 1 < simulated_nodes && q > node(a, k)) ++k;
    const double share = (q - node(a, k - 1)) / (node(a, k) - node(a, k - 1));
    return (1.0 - share) * curves[a][m][k - 1] + share * curves[a][m][k];
  }
  Vector3 field(Vector3 q) const {
    volumetric::ErrorValues e;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t m = 0; m < 6; ++m) e.motions[a][m] = at(a, m, q[a]);
    e.squareness_urad = square;
    return displacement_um(machine, e, q, machine.tools[0].offset_mm);
  }
  double read(ErrorMotion e, std::size_t n) const {
    Vector3 q = stood[e.axis];
    q[e.axis] = node(e.axis, n);
    return e.is_rotation() ? curves[e.axis][e.motion][n] : field(q)[e.motion];
  }
};

SimulatedMachine simulated_machine() {
  SimulatedMachine m;
  m.machine.travel = {{0, -100, -500}, {900, 500, -80}};
  m.machine.tools = {{"T", {30, -20, -150}}};
  return m;
}

/// Readings of two runs that differ by next to nothing: runs that agree in all say nothing of how good they are.
/// `sign` is the sensor's, told in the file where `told`.
std::string readings_of(const SimulatedMachine& m, ErrorMotion e, int sign, bool told, double apart = 1e-4) {
  const std::string name = volumetric::error_name(e);
  std::string text = "# error: " + name + "\n";
  if (told) text += fmt::format("# positive: {}{}\n", sign < 0 ? "-" : "+", simulated_letters[e.motion]);
  text += fmt::format("position_mm,run,direction,deviation_{}\n", e.is_rotation() ? "urad" : "um");
  for (const int run : {1, 2})
    for (std::size_t n = 0; n < simulated_nodes; ++n)
      text += fmt::format("{},{},up,{}\n", m.node(e.axis, n), run,
                          sign * m.read(e, n) + (run == 1 ? apart : -apart) * static_cast<double>(n));
  return text;
}

struct SquarePair {
  ErrorMotion first, second;
  const char* name;
  std::size_t place;  ///< in C0Y, B0Z, A0Z
};
constexpr SquarePair square_pairs[] = {
    {{0, 1}, {1, 0}, "C0Y", 0}, {{0, 2}, {2, 0}, "B0Z", 1}, {{1, 2}, {2, 1}, "A0Z", 2}};

std::string json_of(const auto& measured) { return json::dump(present(measured, {}, {}).json); }

TEST(SquarenessInTheMachine, HasTheSignOfItsLocationErrorWhicheverWayTheSensorsAndTheFilesStand) {
  const testing_support::TemporaryFolder folder;
  for (const SquarePair& pair : square_pairs) {
    SimulatedMachine m = simulated_machine();
    m.square[pair.place] = 37.5;
    for (const int one : {1, -1})
      for (const int two : {1, -1})
        for (const bool swapped : {false, true}) {
          SquarenessRequest request;
          request.first = folder.written("first.csv", readings_of(m, pair.first, one, true));
          request.second = folder.written("second.csv", readings_of(m, pair.second, two, true));
          if (swapped) std::swap(request.first, request.second);
          const auto measured = measure_squareness(request);
          ASSERT_TRUE(measured) << measured.error().message;
          ASSERT_TRUE(measured->location);
          EXPECT_EQ(measured->location->name, pair.name);
          EXPECT_NEAR(measured->location->urad.value, 37.5, 1e-6) << pair.name << one << two << swapped;
          // C0Y and A0Z open the angle between the positive directions, B0Z closes it.
          EXPECT_GT(measured->result.squareness_arcsec.value * (pair.place == 1 ? -1.0 : 1.0), 0.0);
        }
  }
}

TEST(SquarenessInTheMachine, IsNotTheMakersSumWhereBothReadingsAreAlongTheAxes) {
  // C0Y = 37.5 µrad: of readings along both axes θ₁ = 0 and θ₂ = −37.5 µrad, whose difference has the other sign.
  const testing_support::TemporaryFolder folder;
  SimulatedMachine m = simulated_machine();
  m.square[0] = 37.5;
  SquarenessRequest request;
  request.first = folder.written("first.csv", readings_of(m, {0, 1}, 1, false));
  request.second = folder.written("second.csv", readings_of(m, {1, 0}, 1, false));
  const auto silent = measure_squareness(request);
  ASSERT_TRUE(silent);
  EXPECT_FALSE(silent->location);
  EXPECT_LT(silent->result.squareness_arcsec.value, 0.0);
  EXPECT_THAT(json_of(*silent), HasSubstr("nothing states which way the readings of both lines are positive"));
  request.senses = {ReadingSense{'Y'}, ReadingSense{'X'}};
  request.square.square_error_arcsec = 1.0;
  const auto told = measure_squareness(request);
  ASSERT_TRUE(told && told->location);
  EXPECT_NEAR(told->location->urad.value, 37.5 + 4.84813681, 1e-6);  // 1″: the square has more than 90°
}

TEST(SquarenessInTheMachine, TakesNoSignOfOneLineAlone) {
  const testing_support::TemporaryFolder folder;
  SimulatedMachine m = simulated_machine();
  m.square[0] = 37.5;
  const std::string first = readings_of(m, {0, 1}, 1, false), second = readings_of(m, {1, 0}, 1, false);
  SquarenessRequest request;
  request.first = folder.written("first.csv", "# positive: +Y\n" + first);
  request.second = folder.written("second.csv", second);
  const auto of_one = measure_squareness(request);
  ASSERT_FALSE(of_one);
  EXPECT_THAT(of_one.error().message, HasSubstr("one line only"));
  request.second = folder.written("second.csv", "# positive: +X\n" + second);
  const auto of_both = measure_squareness(request);
  ASSERT_TRUE(of_both && of_both->location) << "the senses name the lines";
  EXPECT_EQ(of_both->location->name, "C0Y");
  EXPECT_NEAR(of_both->location->urad.value, 37.5, 1e-6);
}

/// Every error as the JSON of its measurement, with the sensors turned as it comes.
AssembleRequest measured_by_turned_sensors(const SimulatedMachine& m, const testing_support::TemporaryFolder& folder,
                                           error_motions::Reference reference) {
  AssembleRequest request;
  request.machine =
      folder.written("machine.json",
                     R"({"chain": "XFYZ", "travel_mm": {"X": [0, 900], "Y": [-100, 500], "Z": [-500, -80]},
          "tools_mm": {"T": [30, -20, -150]}, "functional_point_mm": {"X": [0,0,0], "Y": [0,0,0], "Z": [0,0,0]}})");
  const auto put = [&](std::string name, const std::string& file, const std::string& text) {
    request.items.push_back({.name = std::move(name), .file = folder.written(file, text)});
  };
  for (std::size_t a = 0; a < 3; ++a) {
    request.stands[a] = SingleStand{m.stood[a], "T"};
    for (std::size_t k = 0; k < 6; ++k) {
      const ErrorMotion e{a, k};
      const std::string name = volumetric::error_name(e);
      if (e.is_positioning()) {
        std::string text = fmt::format("# axis.name: {}\ntarget_mm,run,direction,deviation_um\n", "XYZ"[a]);
        for (const int run : {1, 2})
          for (std::size_t n = 0; n < simulated_nodes; ++n)
            text += fmt::format("{},{},up,{}\n", m.node(a, n), run, m.read(e, n) + (run == 1 ? 1e-7 : -1e-7));
        put(name, name + ".csv", text);
        continue;
      }
      const int sign = (a + k) % 2 == 0 ? 1 : -1;
      MotionRequest motion{.file = folder.written(name + ".csv", readings_of(m, e, sign, true)),
                           .options = {reference}};
      if (e.is_rotation()) motion.options.reference = error_motions::Reference::none;
      const auto straight = e.is_rotation() ? Result<MeasuredMotion>(fail("an angle")) : measure_straightness(motion);
      const auto angles =
          e.is_rotation() ? measure_angles({.files = {motion}}) : Result<AnglesMeasurement>(fail("not"));
      put(name, name + ".json", e.is_rotation() ? json_of(*angles) : json_of(*straight));
    }
  }
  for (const SquarePair& pair : square_pairs) {
    SquarenessRequest square;
    square.options.reference = reference;
    square.first = folder.written("one.csv", readings_of(m, pair.first, -1, true));
    square.second = folder.written("two.csv", readings_of(m, pair.second, 1, true));
    const auto measured = measure_squareness(square);
    put(pair.name, std::string(pair.name) + ".json", json_of(*measured));
  }
  return request;
}

TEST(AssembleResults, FindTheFieldOfTheMachineByEitherReferenceAndBackWithItsSign) {
  SimulatedMachine m = simulated_machine();
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 10.0);
  for (auto& axis : m.curves)
    for (auto& motion : axis)
      for (double& x : motion) x = normal(random);
  m.square = {41.0, -28.0, 17.0};
  for (const auto reference : {error_motions::Reference::least_squares, error_motions::Reference::end_points}) {
    const testing_support::TemporaryFolder folder;
    const auto assembled = assemble_singles(measured_by_turned_sensors(m, folder, reference));
    ASSERT_TRUE(assembled) << assembled.error().to_string();
    EXPECT_TRUE(assembled->made.findings.empty()) << assembled->made.findings.front().message;
    for (const std::string& remark : assembled->remarks)
      EXPECT_THAT(remark, Not(HasSubstr("nothing states which way")));
    const Vector3 tool = m.machine.tools[0].offset_mm;
    std::vector<Vector3> places, differences;
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int k = 0; k < 30; ++k) {
      Vector3 q;
      for (std::size_t a = 0; a < 3; ++a)
        q[a] = m.machine.travel.lowest_mm[a] +
               share(random) * (m.machine.travel.highest_mm[a] - m.machine.travel.lowest_mm[a]);
      places.push_back(q);
      differences.push_back(assembled->made.model.at(q, tool).error() - m.field(q));
    }
    for (std::size_t i = 0; i < places.size(); ++i)  // a small motion of the whole changes no distance
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_NEAR(dot(differences[i] - differences[k], unit(places[i] - places[k])), 0.0, 1e-6);
  }
}

TEST(AssembleResults, FindTheSquarenessOfAMachineThatHasNoOtherError) {
  SimulatedMachine m = simulated_machine();
  m.square = {41.0, -28.0, 17.0};
  const testing_support::TemporaryFolder folder;
  const auto assembled =
      assemble_singles(measured_by_turned_sensors(m, folder, error_motions::Reference::least_squares));
  ASSERT_TRUE(assembled) << assembled.error().to_string();
  for (const SquarePair& pair : square_pairs) {
    const auto found = assembled->made.model.squareness(static_cast<volumetric::Squareness>(pair.place));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value, m.square[pair.place], 1e-6) << pair.name;
  }
}

TEST(AssembleResults, RefuseWhatDoesNotTellItsSignOrIsAnother) {
  SimulatedMachine m = simulated_machine();
  const testing_support::TemporaryFolder folder;
  SquarenessRequest square;
  square.first = folder.written("first.csv", readings_of(m, {0, 1}, 1, false));
  square.second = folder.written("second.csv", readings_of(m, {1, 0}, 1, false));
  const std::string silent = folder.written("silent.json", json_of(*measure_squareness(square)));
  square.senses = {ReadingSense{'Y'}, ReadingSense{'X'}};
  const std::string told = folder.written("told.json", json_of(*measure_squareness(square)));
  const auto fault = [&](const char* name, const std::string& file, std::optional<double> instrument = {}) {
    AssembleRequest request = measured_by_turned_sensors(m, folder, error_motions::Reference::least_squares);
    std::erase_if(request.items, [&](const SingleItem& item) { return item.name == name; });
    SingleItem item{.name = name, .file = file};
    if (instrument) item.instrument = error_motions::InstrumentUncertainty{*instrument, 0.0};
    request.items.push_back(item);
    const auto made = assemble_singles(request);
    return made ? std::string() : made.error().to_string();
  };
  EXPECT_EQ(fault("C0Y", told), "");
  EXPECT_THAT(fault("C0Y", silent), HasSubstr("silent.json: found a squareness without its sign in the machine"));
  EXPECT_THAT(fault("B0Z", told), HasSubstr("told.json: found C0Y in this result, expected B0Z as given"));
  square.first = folder.written("first.csv", readings_of(m, {0, 1}, 1, false, 0.0));
  square.second = folder.written("second.csv", readings_of(m, {1, 0}, 1, false, 0.0));
  EXPECT_THAT(fault("C0Y", folder.written("equal.json", json_of(*measure_squareness(square)))),
              HasSubstr("equal.json: found runs of C0Y that agree to the last digit and no uncertainty"));
  EXPECT_EQ(fault("EYX", told), "");  // one of its lines
  EXPECT_THAT(fault("EZX", told), HasSubstr("found EYX, EXY in this result, expected EZX as given"));
  EXPECT_THAT(fault("C0Y", folder.path() + "/EYX.json"),
              HasSubstr("found the result straightness, expected squareness as C0Y is"));
  MotionRequest stated{.file = square.first};
  stated.options.instrument = error_motions::InstrumentUncertainty{0.4, 0.5};
  const std::string instrument = folder.written("stated.json", json_of(*measure_straightness(stated)));
  EXPECT_EQ(fault("EYX", instrument), "");
  EXPECT_THAT(fault("EYX", instrument, 0.4), HasSubstr("found an uncertainty of the instrument of EYX in the file"));
  // A line over less of the travel than the errors of its axis have in common.
  m.machine.travel.highest_mm.x = 800.0;
  square.first = folder.written("first.csv", readings_of(m, {0, 1}, 1, false));
  square.second = folder.written("second.csv", readings_of(m, {1, 0}, 1, false));
  const std::string shorter = folder.written("shorter.json", json_of(*measure_squareness(square)));
  m.machine.travel.highest_mm.x = 900.0;
  EXPECT_THAT(fault("C0Y", shorter), HasSubstr("found the line EYX of C0Y read from 0 to 800 mm, expected it over the "
                                               "range that the errors of X have in common, from 0 to 900 mm"));
}

TEST(AssembleResults, NameTheInstrumentsThatTheFilesName) {
  const SimulatedMachine m = simulated_machine();
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = measured_by_turned_sensors(m, folder, error_motions::Reference::least_squares);
  const std::string csv =
      folder.written("named.csv", "# equipment: Laser head | Acme | LI-1 | 1234\n" + readings_of(m, {0, 3}, 1, true));
  const std::string result = folder.written("named.json", json_of(*measure_angles({.files = {{.file = csv}}})));
  request.items = {{.name = "EAX", .file = csv}, {.name = "EBX", .file = request.items[4].file}};
  for (const std::string& file : {csv, result}) {
    request.items[0].file = file;
    const auto assembled = assemble_singles(request);
    ASSERT_TRUE(assembled) << assembled.error().to_string();
    EXPECT_EQ(assembled->items[0].equipment, "Acme LI-1 1234");
    EXPECT_EQ(assembled->items[1].equipment, "");
    const Experiment shown = present(*assembled, {});
    EXPECT_THAT(json::dump(shown.json, 0), HasSubstr(R"("equipment":"Acme LI-1 1234")"));
  }
}

TEST(AssembleResults, TellWhereNobodySaysWhichWayReadingsArePositive) {
  const SimulatedMachine m = simulated_machine();
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = measured_by_turned_sensors(m, folder, error_motions::Reference::least_squares);
  request.items = {{.name = "EAX", .file = folder.written("silent.csv", readings_of(m, {0, 3}, 1, false))}};
  const auto assembled = assemble_singles(request);
  ASSERT_TRUE(assembled) << assembled.error().to_string();
  EXPECT_THAT(assembled->remarks, testing::Contains(HasSubstr("by the right-hand rule about them: EAX")));
}

}  // namespace
}  // namespace axiometry::app
