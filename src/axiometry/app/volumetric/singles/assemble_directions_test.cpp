// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/volumetric/predict_line.h"
#include "axiometry/app/volumetric/singles/assemble_singles.h"
#include "axiometry/app/volumetric/singles/single_means.h"
#include "axiometry/app/volumetric/tables/volume_compensation.h"
#include "tests/support/temporary_folder.h"

// Tests of both directions, put together with `volumetric assemble`, and the same tests predicted from what it made.
namespace axiometry::app {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* directed_machine =
    R"({"chain": "XFYZ", "travel_mm": {"X": [-900, 0], "Y": [0, 500], "Z": [-400, 0]},
        "tools_mm": {"T": [0, 0, -150]}})";

/// Six positions from −900 to 0 mm, three runs that scatter by 0.1; what a position reads in a direction, and nothing
/// where that is not a number.
std::string directed_test(const std::string& head, const std::function<double(int, bool)>& read) {
  std::string text = head;
  for (const int run : {1, 2, 3})
    for (int k = 0; k < 6; ++k)
      for (const bool up : {true, false})
        if (const double value = read(k, up); std::isfinite(value))
          text += fmt::format("{},{},{},{:.4f}\n", -900 + 180 * k, run, up ? "up" : "down", value + 0.1 * (run - 2));
  return text;
}
const std::string directed_positions = "# axis.name: X\ntarget_mm,run,direction,deviation_um\n";

double bent(int k, bool up) { return 0.4 * k * k - 3.0 * k + (up ? 2.0 - 0.3 * k : -1.0); }
double turned(int k, bool up) { return 5.0 * std::sin(k) + (up ? 4.0 : -2.0 - k); }

AssembleRequest request_of(const testing_support::TemporaryFolder& folder, const std::string& exx) {
  AssembleRequest request;
  request.machine = folder.written("machine.json", directed_machine);
  request.items = {{.name = "EXX", .file = folder.written("exx.csv", exx)}};
  const std::string names[] = {"EAX", "EBX", "ECX"};
  for (const std::string& name : names)
    request.items.push_back(
        {.name = name,
         .file = folder.written(
             name + ".csv",
             directed_test("# error: " + name + "\nposition_mm,run,direction,deviation_urad\n", turned))});
  request.stands[0] = SingleStand{{0, 300, -250}, "T"};
  return request;
}

std::string kept_result(const testing_support::TemporaryFolder& folder, const Assembled& assembled) {
  return folder.written("result.json", json::dump(present(assembled, {}).json, 0));
}

std::vector<std::string> messages(const std::vector<NamedFinding>& findings) {
  std::vector<std::string> all;
  for (const NamedFinding& f : findings) all.push_back(f.message);
  return all;
}

TEST(SingleMeans, SayOfOneRunWhereNothingTellsItsUncertainty) {
  const std::vector<PositionMeans> positions = {{-50.0, DirectionMean{1.0, {}, 1}, {}},
                                                {100.0, DirectionMean{2.0, {}, 1}, {}}};
  const auto refusal = [&](std::optional<error_motions::InstrumentUncertainty> instrument) {
    const auto means = single_means({0, 1}, positions, instrument);
    return means ? std::string("none") : means.error().message;
  };
  EXPECT_THAT(refusal({}), HasSubstr("found one run of EYX and no uncertainty of its instrument"));
  EXPECT_THAT(refusal(error_motions::InstrumentUncertainty{0.0, 2.0}),
              HasSubstr("found one run of EYX and 0 as uncertainty of its instrument at \u221250 mm"))
      << "it is stated, but is none at the lowest position";
  EXPECT_EQ(refusal(error_motions::InstrumentUncertainty{0.1, 2.0}), "none");
}

TEST(SingleMeans, RefuseRunsThatAllAgreeWhereNoInstrumentSaysHowWellTheyAreKnown) {
  std::vector<PositionMeans> positions;
  for (const double at : {0.0, 100.0, 200.0}) positions.push_back({at, DirectionMean{1.0, 0.0, 3}, {}});
  const auto equal = single_means({0, 1}, positions, {});
  ASSERT_FALSE(equal);
  EXPECT_THAT(equal.error().message, HasSubstr("found runs of EYX that agree to the last digit and no uncertainty"));
  const auto none_there = single_means({0, 1}, positions, error_motions::InstrumentUncertainty{0.0, 2.0});
  ASSERT_FALSE(none_there);
  EXPECT_THAT(none_there.error().message,
              HasSubstr("that agree to the last digit and 0 as uncertainty of its instrument at 0 mm"));
  EXPECT_TRUE(single_means({0, 1}, positions, error_motions::InstrumentUncertainty{0.4, 0.0}));
  positions[1].up->s = 0.1;
  const auto stepped = single_means({0, 1}, positions, {});
  ASSERT_TRUE(stepped);
  EXPECT_GT(stepped->motion.u[0], 0.0);
}

TEST(AssembleDirections, PredictTheirOwnTestWithItsEAndBAndM) {
  const testing_support::TemporaryFolder folder;
  const AssembleRequest request = request_of(folder, directed_test(directed_positions, bent));
  const auto assembled = assemble_singles(request);
  ASSERT_TRUE(assembled) << assembled.error().to_string();
  EXPECT_THAT(assembled->remarks, Not(Contains(HasSubstr("differ by direction"))));
  EXPECT_EQ(assembled->items[0].directions, "both");
  const auto predicted = predict_test({.result = kept_result(folder, *assembled),
                                       .axis = "X",
                                       .at = "y=300,z=-250",
                                       .measured = request.items[0].file});
  ASSERT_TRUE(predicted) << predicted.error().to_string();
  const auto test = read_test(request.items[0].file);
  ASSERT_TRUE(test);
  const iso230_2::Evaluation measured = iso230_2::evaluate(test->series);
  double highest = -1e9, lowest = 1e9;
  for (std::size_t k = 0; k < 6; ++k) {
    const double mean = 0.5 * (predicted->predicted.up[k].value + predicted->predicted.down[k].value);
    highest = std::max(highest, mean);
    lowest = std::min(lowest, mean);
  }
  EXPECT_NEAR(predicted->predicted.systematic.value, measured.parameters.E->in_native(), 1e-6);
  EXPECT_NEAR(predicted->predicted.reversal_um, measured.parameters.B->in_native(), 1e-6);
  EXPECT_NEAR(highest - lowest, measured.parameters.M->in_native(), 1e-6);
  ASSERT_TRUE(predicted->comparison);
  EXPECT_TRUE(predicted->comparison->by_direction);
  EXPECT_LT(predicted->comparison->chi_squared, 1e-6);
  EXPECT_THAT(messages(predicted->findings), Not(Contains(HasSubstr("which the errors do not hold"))));
}

TEST(AssembleDirections, OfATestThatWasStatedDownTheAxisAreThoseOfTheAxis) {
  // The same readings along a line that leads from 0 to −900 mm: positions, signs and directions are the other ones.
  const testing_support::TemporaryFolder folder;
  std::string text =
      "# axis.name: X\n# axis.line_origin_mm: 0 300 -250\n# axis.line_direction: -1 0 0\n"
      "target_mm,run,direction,deviation_um\n";
  for (const int run : {1, 2, 3})
    for (int k = 0; k < 6; ++k)
      for (const bool up : {true, false})
        text +=
            fmt::format("{},{},{},{:.4f}\n", 900 - 180 * k, run, up ? "down" : "up", -bent(k, up) - 0.1 * (run - 2));
  const auto straight = assemble_singles(request_of(folder, directed_test(directed_positions, bent)));
  const auto turned_round = assemble_singles(request_of(folder, text));
  ASSERT_TRUE(straight && turned_round) << turned_round.error().to_string();
  for (const double q : {-900.0, -540.0, 0.0})
    for (const double d : {1.0, 0.0, -1.0}) {
      const auto a = straight->made.model.motion({0, 0}, q, d), b = turned_round->made.model.motion({0, 0}, q, d);
      ASSERT_TRUE(a && b);
      EXPECT_NEAR(a->value, b->value, 1e-9);
      EXPECT_NEAR(a->u, b->u, 1e-9);
    }
  text.replace(text.find("-1 0 0"), 6, "-1 1 0");
  const auto diagonal = assemble_singles(request_of(folder, text));
  ASSERT_FALSE(diagonal);
  EXPECT_THAT(diagonal.error().to_string(), HasSubstr("found a test along a line that X does not move on alone"));
}

TEST(AssembleDirections, LeaveOutTheEndsThatWereApproachedFromOneSide) {
  const testing_support::TemporaryFolder folder;
  const auto without_ends = [](int k, bool up) {
    return (k == 0 && up) || (k == 5 && !up) ? std::nan("") : bent(k, up);
  };
  const AssembleRequest request = request_of(folder, directed_test(directed_positions, without_ends));
  const auto assembled = assemble_singles(request);
  ASSERT_TRUE(assembled) << assembled.error().to_string();
  EXPECT_THAT(assembled->remarks,
              Contains("EXX: positions at the ends that were approached from one side alone are left "
                       "out: -900 mm, 0 mm"));
  EXPECT_EQ(assembled->made.model.observed().lowest_mm.x, -720.0);
  const auto predicted = predict_test({.result = kept_result(folder, *assembled),
                                       .axis = "X",
                                       .at = "y=300,z=-250",
                                       .measured = request.items[0].file});
  ASSERT_TRUE(predicted) << predicted.error().to_string();
  EXPECT_LT(predicted->comparison->chi_squared, 1e-6);
  // Between others it is a reading that lacks.
  const auto inside = [](int k, bool up) { return k == 2 && up ? std::nan("") : bent(k, up); };
  const auto refused = assemble_singles(request_of(folder, directed_test(directed_positions, inside)));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("found -540 mm approached from one side alone"));
  const auto hardly = [](int k, bool up) { return up == (k < 3) ? bent(k, up) : std::nan(""); };
  const auto none = assemble_singles(request_of(folder, directed_test(directed_positions, hardly)));
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().to_string(), HasSubstr("found fewer than two positions approached from both sides"));
}

TEST(AssembleDirections, OfOneDirectionAreTakenForTheMeanAndSaidToBe) {
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = request_of(folder, directed_test(directed_positions, bent));
  const std::string yaw = "# error: ECX\nposition_mm,run,direction,deviation_urad\n";
  request.items[3].file =
      folder.written("one.csv", directed_test(yaw, [](int k, bool up) { return up ? turned(k, up) : std::nan(""); }));
  const auto assembled = assemble_singles(request);
  ASSERT_TRUE(assembled) << assembled.error().to_string();
  EXPECT_EQ(assembled->items[3].directions, "up");
  EXPECT_THAT(assembled->remarks, Contains("read in one direction alone, which is taken for the mean of both: ECX"));
  const std::string result = kept_result(folder, *assembled);
  const auto there = predict_test({.result = result, .axis = "X", .at = "y=300,z=-250"});
  ASSERT_TRUE(there) << there.error().to_string();
  EXPECT_TRUE(there->predicted.has_directions);
  const auto beside = predict_test({.result = result, .axis = "X", .at = "y=100,z=-250"});
  ASSERT_TRUE(beside) << beside.error().to_string();
  EXPECT_FALSE(beside->predicted.has_directions);
  EXPECT_THAT(messages(beside->findings), Contains("nothing tells by what the directions differ of EXX and ECX on this "
                                                   "line: what is predicted is the mean of both, without reversal"));
}

TEST(AssembleDirections, AreHeldAgainstATestOfOneDirectionByThatDirection) {
  const testing_support::TemporaryFolder folder;
  const auto assembled = assemble_singles(request_of(folder, directed_test(directed_positions, bent)));
  ASSERT_TRUE(assembled);
  PredictRequest request{.result = kept_result(folder, *assembled), .axis = "X", .at = "y=300,z=-250"};
  for (const bool direction : {true, false}) {
    request.measured = folder.written("one.csv", directed_test(directed_positions, [&](int k, bool up) {
                                        return up == direction ? bent(k, up) + 7.0 : std::nan("");
                                      }));
    const auto one = predict_test(request);
    ASSERT_TRUE(one) << one.error().to_string();
    EXPECT_LT(one->comparison->chi_squared, 1e-6);
    EXPECT_EQ(one->comparison->degrees_of_freedom, 5u);
    EXPECT_THAT(json::dump(present(*one, {}).json, 0),
                HasSubstr(direction ? R"("direction":"up")" : R"("direction":"down")"));
    const auto& predicted = direction ? one->predicted.up : one->predicted.down;
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(one->comparison->measured_um[k], predicted[k].value, 1e-6);
  }
}

TEST(AssembleDirections, AreTheSameOutOfReadingsAndOutOfTheResultOfTheirVerb) {
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = request_of(folder, directed_test(directed_positions, bent));
  const std::string readings =
      folder.written("eyx.csv", directed_test("# error: EYX\n# positive: -Y\nposition_mm,run,direction,deviation_um\n",
                                              [](int k, bool up) { return -bent(k, up) - 4.0 * k; }));
  const std::string result =
      folder.written("eyx.json", json::dump(present(*measure_straightness({.file = readings}), {}, {}).json));
  request.items.push_back({.name = "EYX", .file = readings});
  const auto direct = assemble_singles(request);
  request.items.back().file = result;
  const auto kept = assemble_singles(request);
  ASSERT_TRUE(direct && kept) << kept.error().to_string();
  for (const double q : {-900.0, -360.0, 0.0})
    for (const double d : {1.0, -1.0}) {
      const auto a = direct->made.model.motion({0, 1}, q, d), b = kept->made.model.motion({0, 1}, q, d);
      ASSERT_TRUE(a && b);
      EXPECT_NEAR(a->value, b->value, 1e-9);
      EXPECT_NEAR(a->u, b->u, 1e-9);
    }
  // By hand, at 0 mm: 1.5 µm along +Y, of which EAX makes −11 µrad · −400 mm = 4.4 µm; ECX has no lever there.
  const volumetric::ErrorModel& model = kept->made.model;
  EXPECT_NEAR(model.motion({0, 1}, 0.0, 1.0)->value - model.motion({0, 1}, 0.0, -1.0)->value, 1.5 - 4.4, 1e-4);
}

TEST(AssembleDirections, HaveTheUncertaintyOfTheirRunsAndShareThatOfTheInstrument) {
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = request_of(folder, directed_test(directed_positions, bent));
  request.items[0].instrument = error_motions::InstrumentUncertainty{4.0, 0.0};
  const auto both = assemble_singles(request);
  ASSERT_TRUE(both) << both.error().to_string();
  const auto& c = both->made.model.coefficients();
  const std::size_t half = c.half(0);
  // Three runs of 0.1 µm: s = 0.1, of each mean 0.1/√3, of half of the difference of two 0.1/√6; no instrument in it.
  // Six positions in both directions tell s with 24 degrees of freedom: Student's t for 95.45 % is 2.10969602 in place
  // of 2.
  const double widening = 2.109696019518304 / 2.0;
  EXPECT_NEAR(both->items[0].u_largest, std::hypot(widening * 0.1 / std::sqrt(6.0), 2.0), 1e-6);
  const double of_rotations =
      std::pow(0.1e-3 / std::sqrt(6.0), 2) * (300.0 * 300.0 + 400.0 * 400.0);  // y, z of the tool
  EXPECT_NEAR(both->made.model.parts().covariance[half * c.raw() + half],
              widening * widening * (0.01 / 6.0 + of_rotations), 1e-9);
  // One run: its scatter is not known, and the difference is as uncertain as the instrument.
  request.items = {
      {.name = "EXX",
       .file = folder.written("once.csv", directed_positions + "-900,1,up,1\n-900,1,down,0\n0,1,up,3\n0,1,down,1\n")}};
  request.items[0].instrument = error_motions::InstrumentUncertainty{4.0, 0.0};
  const auto once = assemble_singles(request);
  ASSERT_TRUE(once) << once.error().to_string();
  EXPECT_THAT(once->remarks, Contains(HasSubstr("EXX: of one run of each direction, what these differ by is taken")));
}

TEST(AssembleDirections, AreLostWhereTheMeanIsAskedFor) {
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = request_of(folder, directed_test(directed_positions, bent));
  request.reversal = volumetric::Reversal::none;
  const auto mean = assemble_singles(request);
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean->made.model.coefficients().reversal(), volumetric::Reversal::none);
  EXPECT_THAT(mean->remarks,
              Contains(HasSubstr("displacements differ by direction, by up to 3.00 µm of EXX: the errors "
                                 "hold their mean")));
  request.reversal = volumetric::Reversal::curves;
  const auto both = assemble_singles(request);
  for (const double q : {-900.0, -180.0}) {
    EXPECT_NEAR(mean->made.model.motion({0, 0}, q)->value, both->made.model.motion({0, 0}, q)->value, 1e-12);
    EXPECT_NEAR(mean->made.model.motion({0, 0}, q)->u, both->made.model.motion({0, 0}, q)->u, 1e-12);
  }
}

}  // namespace
}  // namespace axiometry::app
