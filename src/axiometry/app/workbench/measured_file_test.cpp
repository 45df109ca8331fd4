// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/measured_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/workbench/examples/example_table2.h"
#include "axiometry/app/workbench/same_answer.h"
#include "axiometry/app/workbench/workbench_state.h"
#include "tests/support/archive.h"

namespace axiometry::app {
namespace {

using testing::HasSubstr;

/// Tests in one file, all with the same equipment above the table.
std::string table(int equipment, int tests) {
  std::string text = "# machine.name: Mill\n# axis.name: X\n";
  for (int k = 0; k < equipment; ++k) text += "# equipment: a|b|c|1\n";
  text += "test,target_mm,direction,run,deviation_um\n";
  for (int test = 1; test <= tests; ++test)
    for (const char* direction : {"up", "down"})
      for (int target = 0; target < 3; ++target)
        for (int run = 1; run <= 2; ++run)
          text += fmt::format("t{},{},{},{},{}\n", test, target * 100, direction, run, 0.1 * run + target);
  return text;
}

Result<MeasuredFile> read_table(const std::string& bytes) { return read_measured(HashedBytes::of(bytes), "run.csv"); }

TEST(MeasuredFile, RefusesEquipmentThatNoSetUpHasBeforeEveryTestHoldsIt) {
  EXPECT_TRUE(read_table(table(100, 3)));
  const auto refused = read_table(table(200, 2000));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(),
              HasSubstr("found 200 pieces of test equipment in one test, expected at most"));
}

TEST(MeasuredFile, KnowsWhatItsTestsTakeInMemoryAndNotOnlyTheFile) {
  const std::string bytes = table(100, 200);
  const auto read = read_table(bytes);
  ASSERT_TRUE(read) << read.error().to_string();
  EXPECT_EQ(read->tests.size(), 200u);
  EXPECT_GT(read->memory, 200 * 100 * sizeof(Equipment));
}

TEST(MeasuredFile, RefusesWhatIsTheSameForAllWhereItTakesTheMemory) {
  std::string bytes = table(0, 2000);
  std::string recording = "# uncertainty.drift_recording: 0";
  for (int k = 1; k < 20'000; ++k) recording += " 1";
  bytes.insert(0, recording + "\n");
  const auto refused = read_table(bytes);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().to_string(), HasSubstr("more than 128 MiB of memory up to test"));
}

/// A table that no format describes and that leaves nothing open.
constexpr std::string_view guessed_table =
    "Lauf;Soll [mm];Abweichung [µm]\n1;0;0.1\n1;100;0.4\n1;200;0.7\n1;200;0.9\n1;100;0.6\n1;0;0.2\n"
    "2;0;0.2\n2;100;0.5\n2;200;0.6\n2;200;0.8\n2;100;0.7\n2;0;0.3\n";

TEST(MeasuredFile, IsReadOnceHoweverOftenItComes) {
  testing_support::Archive archive;
  Workbench::State state(archive.store());
  const auto sent = HashedBytes::of(guessed_table);
  const auto first = state.read(sent, "first.csv", {});
  ASSERT_TRUE(first) << first.error().to_string();
  EXPECT_EQ(*state.read(sent, "second.csv", {}), *first);
  const std::string other = std::string(guessed_table) + "\n";
  EXPECT_NE(*state.read(HashedBytes::of(other), "first.csv", {}), *first);
  ASSERT_TRUE((*first)->guess);
  const auto by_profile = state.read(sent, "first.csv", (*first)->guess->profile);
  ASSERT_TRUE(by_profile) << by_profile.error().to_string();
  EXPECT_NE(*by_profile, *first) << "what the profile says is another reading of the same bytes";
}

TEST(MeasuredFile, KeepsTheGuessItWasReadAfterAndNoOther) {
  const auto table = read_measured(HashedBytes::of(guessed_table), "run.csv");
  ASSERT_TRUE(table) << table.error().to_string();
  EXPECT_EQ(table->format, "generic");
  EXPECT_EQ(table->tests.front().test.provenance.sha256, table->sha256);
  ASSERT_TRUE(table->guess);
  EXPECT_EQ(formats::write_profile(table->guess->profile),
            formats::write_profile(guess_measured(guessed_table)->profile));
  EXPECT_FALSE(read_measured(HashedBytes::of(example_table2), "run.csv")->guess);
}

TEST(MeasuredFile, HoldsWhatAnyProgramFindsInTheFile) {
  for (const std::string& bytes : {table(1, 3), std::string(example_table2), std::string(guessed_table)}) {
    const auto file = read_measured(HashedBytes::of(bytes), "run.csv");
    ASSERT_TRUE(file) << file.error().to_string();
    Source source = Source::of_bytes("run.csv", bytes);
    std::size_t count = 0;
    const auto read = read_tests(source, [&](axiometry::Test&& test, std::string&& name) -> Result<void> {
      const MeasuredTest& same = file->tests.at(count++);
      EXPECT_EQ(same.name, name);
      EXPECT_EQ(same.test.provenance.file, test.provenance.file);
      EXPECT_EQ(same.test.provenance.sha256, test.provenance.sha256);
      EXPECT_EQ(same.test.provenance.format, test.provenance.format);
      EXPECT_EQ(same.test.provenance.remarks.size(), test.provenance.remarks.size());
      EXPECT_EQ(same.test.series.reading(1, Direction::down, 1), test.series.reading(1, Direction::down, 1));
      return {};
    });
    ASSERT_TRUE(read) << read.error().to_string();
    EXPECT_EQ(count, file->tests.size());
  }
}

TEST(MeasuredFile, GoesByTheNameUnderWhichItCameThisTime) {
  testing_support::Archive archive;
  Workbench workbench(archive.store());
  const auto file_of = [](const json::Value& result) { return result.find("source")->find("file")->text(); };
  const auto previewed = workbench.preview({"first.json", example_table2});
  ASSERT_TRUE(previewed && previewed->tests.size() == 1 && previewed->tests.front().outcome);
  EXPECT_EQ(file_of(previewed->tests.front().outcome->result), "first.json");
  const auto tried = workbench.evaluate({"second.json", example_table2}, {});
  ASSERT_TRUE(tried) << tried.error().to_string();
  EXPECT_EQ(file_of(tried->result), "second.json");
  const Upload upload{"third.json", example_table2};
  const auto received = workbench.receive(std::span(&upload, 1), {"A. Tester", ""});
  ASSERT_TRUE(received) << received.error().to_string();
  EXPECT_EQ(file_of(received->first.result), "third.json");
}

TEST(SameAnswer, SeesEveryDifference) {
  const FromArchive answer{
      .instruments =
          {{.instrument = 1, .version = 2, .name = "Laser", .inputs = {{"a", "1"}}, .left_out = {{"b", "2"}}}},
      .calibrations = {{.instrument = 1, .version = 2, .calibration = {0, "C-1", "2014-01-10", "2015-01-10"}}},
      .axis = AxisLimits{.axis = 3, .version = 1, .limits = {{"A", 10.0}}}};
  EXPECT_TRUE(same(answer, answer));
  EXPECT_TRUE(same({}, {}));
  EXPECT_FALSE(same(answer, {}));
  const auto differs = [&](auto change) {
    FromArchive other = answer;
    change(other);
    return !same(answer, other) && !same(other, answer);
  };
  EXPECT_TRUE(differs([](FromArchive& a) { a.instruments.clear(); }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.instruments[0].instrument = 9; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.instruments[0].version = 9; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.instruments[0].name = "Optics"; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.instruments[0].inputs[0].second = "9"; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.instruments[0].left_out.clear(); }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.calibrations.clear(); }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.calibrations[0].instrument = 9; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.calibrations[0].version = 9; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.calibrations[0].calibration.component = 9; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.calibrations[0].calibration.certificate = "C-2"; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.calibrations[0].calibration.calibrated_on = ""; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.calibrations[0].calibration.calibration_due = ""; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.axis.reset(); }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.axis->axis = 9; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.axis->version = 9; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.axis->limits[0].parameter = "E"; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.axis->limits[0].value = 10.5; }));
  EXPECT_TRUE(differs([](FromArchive& a) { a.axis->limits.push_back({"E", 5.0}); }));
}

}  // namespace
}  // namespace axiometry::app
