// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/simulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/app/simulate/simulation_truth.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/simulation/presets.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using iso230_2::AxisParameters;

class Simulated : public testing::Test {
 protected:
  void SetUp() override { request.simulate.plan = *simulation_plan(""); }

  std::string path(const std::string& name) const { return folder_.file(name); }
  std::string content(const std::string& name) const { return folder_.content(name); }

  SimulationRequest request;

 private:
  testing_support::TemporaryFolder folder_;
};

void expect_same(const AxisParameters& a, const AxisParameters& b, double tolerance) {
  for (const auto& info : iso230_2::parameters) {
    const auto &x = a.*info.member, &y = b.*info.member;
    ASSERT_EQ(x.has_value(), y.has_value()) << info.key;
    if (x) {
      EXPECT_NEAR(x->in_native(), y->in_native(), tolerance) << info.key;
    }
  }
}

TEST_F(Simulated, WithoutNoiseTheEvaluationGivesBackTheTruth) {
  simulation::VirtualAxis& axis = request.simulate.axis;
  axis.backlash.size = Deviation::native(4.0);
  axis.cyclic = {{Position::native(10.0), Deviation::native(1.5), {}}};
  axis.pitch.slope = RelativeLength::um_per_m(10.0);
  axis.thermal = {Deviation::native(5.0), Duration::s(300.0), {}, false};
  const auto simulated = simulation::simulate(request.simulate);
  ASSERT_TRUE(simulated);
  const AxisParameters found = iso230_2::evaluate(simulated->test.series).parameters;
  expect_same(found, true_parameters_of_test(*simulated), 0.0);
  // Nothing is random: what many tests come to is what one gives.
  expect_same(found, true_parameters_of_machine(*simulated), 1e-9);
}

TEST_F(Simulated, KnownParametersOfKnownFaults) {
  request.simulate.axis.backlash.size = Deviation::native(4.0);
  request.simulate.axis.pitch.slope = RelativeLength::um_per_m(10.0);
  const auto simulated = simulation::simulate(request.simulate);
  const AxisParameters truth = true_parameters_of_machine(*simulated);
  const auto& targets = request.simulate.plan.targets;
  const double rise = 0.01 * (targets.back().in_native() - targets.front().in_native());
  EXPECT_NEAR(truth.B->in_native(), 4.0, 1e-9);
  EXPECT_NEAR(truth.B_mean->in_native(), -4.0, 1e-9);
  EXPECT_NEAR(truth.M->in_native(), rise, 1e-9);
  EXPECT_NEAR(truth.E->in_native(), rise + 4.0, 1e-9);
  EXPECT_NEAR(truth.E_up->in_native(), rise, 1e-9);
  EXPECT_NEAR(truth.R->in_native(), 4.0, 1e-9);
  EXPECT_NEAR(truth.R_up->in_native(), 0.0, 1e-9);
  EXPECT_NEAR(truth.A->in_native(), rise + 4.0, 1e-9);
}

TEST_F(Simulated, WithNoiseTheMeanReversalOfManySeedsIsTheTruth) {
  simulation::VirtualAxis& axis = request.simulate.axis;
  axis.backlash.size = Deviation::native(4.0);
  axis.stick_slip = {Deviation::native(2.0), Deviation::native(0.5)};
  axis.instrument.noise = Deviation::native(0.7);
  constexpr int seeds = 400;
  double sum = 0.0, squares = 0.0, truth = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    request.simulate.seed = static_cast<std::uint64_t>(seed);
    const auto simulated = simulation::simulate(request.simulate);
    const double x = iso230_2::evaluate(simulated->test.series).parameters.B_mean->in_native();
    sum += x;
    squares += x * x;
    truth = true_parameters_of_machine(*simulated).B_mean->in_native();
  }
  const double mean = sum / seeds, deviation = std::sqrt(squares / seeds - mean * mean);
  // Backlash and both mean stops: −4 − (2 + 0.5)·√(2/π).
  EXPECT_NEAR(truth, -4.0 - 2.5 * std::sqrt(2.0 / std::numbers::pi), 1e-9);
  EXPECT_NEAR(mean, truth, 5.0 * deviation / std::sqrt(1.0 * seeds));
  EXPECT_GT(deviation, 0.0);
}

TEST_F(Simulated, FilesAreReadBackAndTheSameSeedGivesTheSameBytes) {
  request.simulate.axis = simulation::find_preset("mixed")->make(request.simulate.plan);
  request.recording.rate = 50.0;
  ASSERT_TRUE(run_simulation(request, {path("a.json"), path("a.csv"), path("a-truth.json"), ""}));
  ASSERT_TRUE(run_simulation(request, {path("b.json"), path("b.csv"), path("b-truth.json"), ""}));
  EXPECT_EQ(content("a.json"), content("b.json"));
  EXPECT_EQ(content("a.csv"), content("b.csv"));
  EXPECT_EQ(content("a-truth.json"), content("b-truth.json"));
  const auto test = read_test(path("a.json"));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.reading_count(), 110u);
  const auto truth = json::parse(content("a-truth.json"));
  ASSERT_TRUE(truth);
  EXPECT_EQ(truth->find("readings")->items().size(), 110u);
  EXPECT_EQ(truth->find("recording")->find("standstills")->items().size(), 110u);
  request.simulate.seed = 2;
  ASSERT_TRUE(run_simulation(request, {path("c.json"), path("c.csv"), "", ""}));
  EXPECT_NE(content("a.json"), content("c.json"));
  EXPECT_NE(content("a.csv"), content("c.csv"));
}

TEST_F(Simulated, TextNumPyAndCountsHoldTheSameRecording) {
  request.simulate.axis = simulation::find_preset("backlash")->make(request.simulate.plan);
  request.recording = {.rate = 20.0, .gaps = {{Duration::s(10.0), Duration::s(1.0)}}};
  std::vector<Sample> samples;
  ASSERT_TRUE(
      simulation::record(request.simulate, request.recording, [&](std::span<const Sample> some) -> Result<void> {
        samples.insert(samples.end(), some.begin(), some.end());
        return {};
      }));
  for (const char* name : {"r.csv", "r.npy", "r.umd"})
    ASSERT_TRUE(run_simulation(request, {"", path(name), "", ""})) << name;

  const std::string text = content("r.csv"), counts = content("r.umd"), npy = content("r.npy");
  const auto lines = text::split(text, '\n');
  const auto rows = text::split(counts, '\n');
  // That it is simulated, the header, and nothing behind the last line break.
  ASSERT_EQ(lines.size(), samples.size() + 3);
  ASSERT_EQ(rows.size(), samples.size() + 2);
  const std::size_t head = npy.size() - 16 * samples.size();
  EXPECT_EQ(head % 64, 0u);
  EXPECT_EQ(npy.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  EXPECT_NE(npy.find("'shape': (" + std::to_string(samples.size()) + ", 2)"), std::string::npos);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto cells = text::split(lines[k + 2], ',');
    EXPECT_NEAR(*parse_number(cells[0]), samples[k].time_s, 0.6e-7);
    EXPECT_NEAR(*parse_number(cells[1]), samples[k].position, 0.6e-7);
    Sample of_npy;
    std::memcpy(&of_npy, npy.data() + head + 16 * k, 16);
    EXPECT_EQ(of_npy.time_s, samples[k].time_s);
    EXPECT_EQ(of_npy.position, samples[k].position);
    const auto words = text::words(text::trim(rows[k + 1]));
    ASSERT_EQ(words.size(), 8u);
    const double position = (*parse_number(words[2]) + *parse_number(words[4]) / 256.0) * 632.991e-6 / 2.0;
    EXPECT_NEAR(position, samples[k].position, 0.51 * 632.991e-6 / 2.0 / 256.0);
    EXPECT_EQ(*parse_number(words[5]), std::round(samples[k].time_s * 20.0) + 1.0);
  }
}

TEST_F(Simulated, OutputsThatCannotBeAreRefusedBeforeAnythingIsWritten) {
  EXPECT_FALSE(check_simulation_outputs({"test.docx", "", "", ""}));
  EXPECT_FALSE(check_simulation_outputs({"", "raw.wav", "", ""}));
  EXPECT_FALSE(check_simulation_outputs({"x.json", "", "x.json", ""}));
  std::ofstream(path("plan.json")) << "{}";
  EXPECT_FALSE(check_simulation_outputs({path("plan.json"), "", "", path("plan.json")}));
  std::ofstream(path("pitch.csv")) << "0 0\n";
  const auto over_table = check_simulation_outputs({path("pitch.csv"), "", "", "", path("pitch.csv")});
  ASSERT_FALSE(over_table);
  EXPECT_NE(over_table.error().to_string().find("pitch.csv"), std::string::npos);
  request.simulate.plan.axis.kind = AxisKind::rotary;
  EXPECT_FALSE(run_simulation(request, {path("t.json"), path("r.umd"), "", ""}));
  EXPECT_FALSE(std::filesystem::exists(path("t.json")));
}

TEST_F(Simulated, AFileThatIsNoPlanIsNamed) {
  std::ofstream(path("plan.json")) << "{\n  \"runs\": \"many\"\n}";
  const auto plan = simulation_plan(path("plan.json"));
  ASSERT_FALSE(plan);
  EXPECT_EQ(plan.error().file, path("plan.json"));
  EXPECT_GT(plan.error().at.line, 0u);
  EXPECT_FALSE(simulation_plan(path("none.json")));
}

TEST_F(Simulated, APlanMadeForOtherErrorsThanPositionsIsRefused) {
  Plan plan = request.simulate.plan;
  plan.errors = {{'Y', 'X'}};
  std::ofstream(path("plan.json")) << formats::write_plan(plan);
  const auto refused = simulation_plan(path("plan.json"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().file, path("plan.json"));
  EXPECT_NE(refused.error().message.find("made for EYX, expected one of positions"), std::string::npos);
  plan.errors.push_back({'X', 'X'});
  std::ofstream(path("plan.json")) << formats::write_plan(plan);
  EXPECT_TRUE(simulation_plan(path("plan.json")));
}

}  // namespace
}  // namespace axiometry::app
