// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/workbench.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <thread>

#include "axiometry/app/workbench/examples/example_table2.h"
#include "axiometry/app/workbench/withdrawn.h"
#include "axiometry/app/workbench/workbench_json.h"
#include "axiometry/digest/sha256.h"
#include "tests/support/archive.h"

namespace axiometry::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const store::By me{"A. Tester", "a test"};

class TheWorkbench : public testing::Test {
 protected:
  store::Id keep(std::string_view bytes, const std::string& name = "table2.json") {
    const Upload upload{name, bytes};
    auto received = workbench.receive(std::span(&upload, 1), me);
    EXPECT_TRUE(received) << received.error().to_string();
    return received ? received->tests.front().id : 0;
  }

  double figure(const json::Value& result, std::string_view parameter) {
    return result.find("parameters")->find(parameter)->number();
  }

  double expanded(const json::Value& result, std::string_view parameter) {
    return result.find("uncertainty")->find("annex_a")->find(parameter)->number();
  }

  testing_support::Archive archive;
  store::Store& store = archive.store();
  Workbench workbench{store};
};

constexpr std::string_view two_tests =
    "test,target_mm,direction,run,deviation_um\n"
    "first,0,+,1,1\nfirst,100,+,1,2\nfirst,0,-,1,3\nfirst,100,-,1,4\n"
    "second,0,+,1,5\nsecond,100,+,1,6\nsecond,0,-,1,7\nsecond,100,-,1,8\n";

TEST_F(TheWorkbench, TakesNoDayToComeForTheDayOfATest) {
  std::string later(example_table2);
  const std::size_t at = later.find("2014-05-15");
  ASSERT_NE(at, later.npos);
  later.replace(at, 4, "2914");
  const auto test = workbench.test(keep(later));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->record.state.measured_on, "") << "it would be the newest of its axis for good";
}

TEST_F(TheWorkbench, KeepsATestWithItsEvaluationAndItsVeryBytes) {
  const Upload upload{"../../etc/table 2.json", example_table2};
  const auto received = workbench.receive(std::span(&upload, 1), me);
  ASSERT_TRUE(received) << received.error().to_string();
  EXPECT_NEAR(figure(received->first.result, "A"), 9.586, 5e-4);
  const auto test = workbench.test(received->tests.front().id);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->record.file_name, "table 2.json");
  EXPECT_EQ(test->record.state.title, "table 2");
  EXPECT_EQ(test->record.state.measured_on, "2014-05-15");
  EXPECT_EQ(test->record.sha256, sha256(example_table2));
  EXPECT_EQ(test->size, example_table2.size());
  EXPECT_EQ(test->machine->name, "Table 2 of ISO 230-2 (worked example)");
  EXPECT_EQ(test->axis->name, "X");
  ASSERT_EQ(test->instruments.size(), 2u);
  EXPECT_EQ(test->versions.size(), 1u);
  EXPECT_EQ(test->versions.front().actor, "A. Tester");
  EXPECT_EQ(json::dump(test->outcome.result), json::dump(received->first.result));
  EXPECT_EQ(workbench.raw(test->record.id)->bytes, example_table2);
}

TEST_F(TheWorkbench, RefusesAFileWithItsPlaceAndKeepsNothingOfAllThatCameWithIt) {
  const Upload uploads[] = {{"good.json", example_table2},
                            {"bad.csv", "target_mm,direction,run,deviation_um\n0,+,1,x\n"}};
  const auto received = workbench.receive(uploads, me);
  ASSERT_FALSE(received);
  EXPECT_EQ(received.error().file, "bad.csv");
  EXPECT_EQ(received.error().at.line, 2u);
  EXPECT_EQ(store.counts()->tests, 0);
  EXPECT_EQ(store.counts()->content_bytes, 0);
}

TEST_F(TheWorkbench, MakesANewTestOfBytesItKnowsAndSaysSo) {
  const auto first = keep(example_table2);
  const Upload again{"again.json", example_table2};
  const auto received = workbench.receive(std::span(&again, 1), me);
  ASSERT_TRUE(received);
  EXPECT_THAT(received->same_content, ElementsAre(first));
  EXPECT_NE(received->tests.front().id, first);
  EXPECT_EQ(workbench.test(received->tests.front().id)->record.state.title, "again");
  EXPECT_THAT(workbench.preview({"x.json", example_table2})->same_content,
              ElementsAre(first, received->tests.front().id));
}

TEST_F(TheWorkbench, SaysWhatBecameOfTheMachineThatATestStates) {
  const std::string readings = "target_mm,direction,run,deviation_um\n0,+,1,1\n0,-,1,1\n100,+,1,2\n100,-,1,2\n";
  const auto remarks = [&](const std::string& head) {
    const std::string bytes = head + readings;
    const Upload upload{"mill.csv", bytes};
    return workbench.receive(std::span(&upload, 1), me)->tests.front().remarks;
  };
  EXPECT_THAT(remarks("# machine.name: Mill 5\n"), IsEmpty());
  EXPECT_THAT(remarks("# machine.name: Mill 5\n# machine.serial_number: 11\n"),
              ElementsAre("machine 1 had no serial number and takes over \"11\", which this test states"));
  EXPECT_THAT(remarks("# machine.name: Mill 5\n# axis.name: Z\n"),
              ElementsAre("this test states no serial number: by the name \"Mill 5\" alone it is kept with machine 1, "
                          "whose number is \"11\""));
  EXPECT_THAT(remarks("# machine.name: Mill 5\n# machine.serial_number: 22\n"), IsEmpty());
  EXPECT_THAT(
      remarks("# machine.name: Mill 5\n# axis.name: Y\n"),
      ElementsAre("2 machines of the archive are called \"Mill 5\", and no serial number in this test tells them "
                  "apart: it is kept with a machine without a number"));
  EXPECT_EQ(store.counts()->machines, 3);
  EXPECT_THAT(remarks("# machine.name: Lathe\n# machine.serial_number: 22\n"),
              ElementsAre("this test calls its machine \"Lathe\": by the serial number \"22\" alone it is kept with "
                          "machine 2, called \"Mill 5\""));
  EXPECT_THAT(remarks("# machine.name: mill 5 \n# machine.serial_number: 22\n"), IsEmpty());
}

TEST_F(TheWorkbench, KnowsNoMachineByAWordForNothing) {
  const std::string readings = "target_mm,direction,run,deviation_um\n0,+,1,1\n0,-,1,1\n100,+,1,2\n100,-,1,2\n";
  for (const char* name : {"Mill", "Lathe", "unknown", "n/a"})
    keep(
        fmt::format("# machine.name: {}\n# machine.serial_number: -\n# equipment: Laser | {} | - | n/a\n", name, name) +
            readings,
        "mill.csv");
  EXPECT_EQ(store.counts()->machines, 2);
  EXPECT_EQ(store.counts()->instruments, 2);
}

TEST_F(TheWorkbench, SaysOfEachFileOfManyWhichTestsHaveItsBytes) {
  const auto known = keep(example_table2);
  const Upload uploads[] = {{"new.csv", two_tests}, {"known.json", example_table2}, {"new again.csv", two_tests}};
  const auto received = workbench.receive(uploads, me);
  ASSERT_TRUE(received) << received.error().to_string();
  EXPECT_THAT(received->same_content, ElementsAre(known));
  ASSERT_EQ(received->tests.size(), 5u);
  const auto& tests = received->tests;
  EXPECT_THAT(tests[0].same_content, IsEmpty());
  EXPECT_THAT(tests[1].same_content, IsEmpty()) << "of the same file";
  EXPECT_THAT(tests[2].same_content, ElementsAre(known));
  EXPECT_THAT(tests[3].same_content, ElementsAre(tests[0].id, tests[1].id)) << "twice in one upload";
  EXPECT_THAT(tests[4].same_content, ElementsAre(tests[0].id, tests[1].id));
}

TEST_F(TheWorkbench, KeepsEveryTestOfAFileOfMany) {
  const Upload upload{"many.csv", two_tests};
  const auto received = workbench.receive(std::span(&upload, 1), me);
  ASSERT_TRUE(received) << received.error().to_string();
  ASSERT_EQ(received->tests.size(), 2u);
  EXPECT_EQ(received->tests[1].title, "many second");
  const auto second = workbench.test(received->tests[1].id);
  ASSERT_TRUE(second) << second.error().to_string();
  EXPECT_EQ(second->record.name_in_file, "second");
  EXPECT_EQ(second->outcome.readings.reading(1, Direction::down, 0)->in_native(), 8.0);
}

TEST_F(TheWorkbench, PreviewsWithoutKeepingAndTellsWhyItRefuses) {
  const auto good = workbench.preview({"table2.csv", example_table2});
  ASSERT_TRUE(good);
  EXPECT_EQ(good->format, "json") << "by content, whatever the name says";
  ASSERT_EQ(good->tests.size(), 1u);
  EXPECT_TRUE(good->tests.front().outcome);
  const auto bad = workbench.preview({"photo.jpg", std::string_view("\xFF\xD8\xFF\xE0\0\x10JFIF", 10)});
  ASSERT_TRUE(bad);
  ASSERT_TRUE(bad->refused);
  EXPECT_EQ(bad->refused->file, "photo.jpg");
  EXPECT_THAT(bad->tests, IsEmpty());
  EXPECT_EQ(store.counts()->tests, 0);
}

/// Targets and two columns of readings, without a word about them.
constexpr std::string_view open_table =
    "0 -0.5 0.5\n100 -0.4 0.7\n200 -0.3 0.8\n300 -0.1 0.9\n400 0.1 1.2\n500 0.2 1.3\n";

formats::ImportProfile answered(formats::ImportProfile profile, std::string_view target_unit) {
  using enum formats::ImportRole;
  profile.columns = {{.role = target},
                     {.role = deviation, .direction = Direction::up},
                     {.role = deviation, .direction = Direction::down}};
  profile.direction = formats::DirectionRule::names;
  profile.target_unit = formats::find_unit(target_unit);
  profile.reading_unit = formats::find_unit("um");
  return profile;
}

TEST_F(TheWorkbench, AsksWhatATableLeavesOpenAndReadsItAfterTheAnswers) {
  const auto asked = workbench.preview({"rows.dat", open_table});
  ASSERT_TRUE(asked && asked->refused && asked->table);
  EXPECT_FALSE(asked->table->questions.empty());
  EXPECT_EQ(asked->table->rows.size(), 6u);
  const auto profile = answered(asked->table->profile, "mm");
  const auto stated = workbench.preview({.name = "rows.dat", .bytes = open_table, .profile = profile});
  ASSERT_TRUE(stated);
  ASSERT_FALSE(stated->refused) << stated->refused->to_string();
  EXPECT_EQ(stated->tests.front().readings.reading(5, Direction::down, 0)->in_native(), 1.3);
  ASSERT_TRUE(stated->table) << "the answers may be changed";
  EXPECT_EQ(formats::write_profile(stated->table->profile), formats::write_profile(profile));
  EXPECT_FALSE(workbench.preview({"table2.json", example_table2})->table);
}

TEST_F(TheWorkbench, ReadsTheSameBytesOfEachTestAfterItsOwnProfileEverAfter) {
  const auto guess = workbench.preview({"rows.dat", open_table})->table->profile;
  const auto keep_with = [&](std::string_view unit) {
    const Upload upload{.name = "rows.dat", .bytes = open_table, .profile = answered(guess, unit)};
    const auto received = workbench.receive(std::span(&upload, 1), me);
    EXPECT_TRUE(received) << received.error().to_string();
    return received ? received->tests.front().id : 0;
  };
  const store::Id mm = keep_with("mm");
  const store::Id m = keep_with("m");
  Revision revision;
  revision.base_version = 1;
  revision.draft.changes = {{"tolerance.A", "12"}};
  ASSERT_TRUE(workbench.revise(m, revision, me));
  Workbench later{store};  // nothing of before in its memory
  for (Workbench* bench : {&workbench, &later}) {
    for (const auto& [id, last] : {std::pair(mm, 500.0), std::pair(m, 5e5)}) {
      const auto test = bench->test(id);
      ASSERT_TRUE(test) << test.error().to_string();
      EXPECT_EQ(test->outcome.readings.targets().back().in_native(), last);
      ASSERT_TRUE(test->profile);
      EXPECT_TRUE(bench->report(id, {}, {"html"})) << "the figures that were kept are found again";
      EXPECT_EQ(bench->raw(id)->bytes, open_table);
    }
    EXPECT_EQ(bench->test(m)->record.version, 2);
    EXPECT_THAT(json::dump(bench->test(m)->outcome.result), HasSubstr("columns were read as stated with the file"));
  }
}

TEST_F(TheWorkbench, RefusesATableThatDoesNotFitItsProfileWithThePlace) {
  auto profile = answered(workbench.preview({"rows.dat", open_table})->table->profile, "mm");
  profile.columns.pop_back();
  const auto preview = workbench.preview({.name = "rows.dat", .bytes = open_table, .profile = profile});
  ASSERT_TRUE(preview && preview->refused);
  EXPECT_EQ(preview->refused->at.line, 1u);
  EXPECT_TRUE(preview->table) << "so that the answers can be mended";
}

TEST_F(TheWorkbench, TellsWhatToDoWithARecording) {
  std::string recording = "time_s,position_mm\n";
  for (int k = 0; k < 200; ++k) recording += std::to_string(k * 0.001) + "," + std::to_string(k * 0.01) + "\n";
  const auto preview = workbench.preview({"recording.csv", recording});
  ASSERT_TRUE(preview);
  ASSERT_TRUE(preview->refused);
  EXPECT_THAT(preview->refused->message, HasSubstr("recording"));
  EXPECT_EQ(preview->instead, OtherFile::recording);
  EXPECT_FALSE(preview->table) << "no answers make a test of it";
}

TEST_F(TheWorkbench, TellsWhatAFileIsInsteadOfATest) {
  const auto instead = [&](std::string_view bytes) {
    const auto preview = workbench.preview({"file.dat", bytes});
    EXPECT_TRUE(preview);
    return preview ? preview->instead : std::nullopt;
  };
  EXPECT_EQ(instead("position_mm,run,direction,pitch_um/m\n0,1,up,1\n100,1,up,2\n"), OtherFile::error_motion);
  EXPECT_EQ(instead(R"({"format": "axiometry-plan/1", "targets": [0, 100]})"), OtherFile::plan);
  EXPECT_EQ(instead("time,Air [C]\n2026-03-02T09:00:00,20\n2026-03-02T09:10:00,20.5\n"), OtherFile::temperatures);
  EXPECT_EQ(instead("time,position [mm]\n2026-03-02T09:00:00,20\n2026-03-02T09:10:00,20.5\n"), OtherFile::recording);
  EXPECT_EQ(instead(R"({"format": "axiometry-tracking-plan/1"})"), std::nullopt);
  EXPECT_EQ(instead(R"({"notes": "\"format\": \"axiometry-plan/1\""})"), std::nullopt);
  EXPECT_EQ(instead(example_table2), std::nullopt);
}

TEST_F(TheWorkbench, TriesChangesWithoutKeepingThem) {
  const auto id = keep(example_table2);
  const double before = expanded(workbench.test(id)->outcome.result, "A");
  Draft draft;
  draft.changes = {{"uncertainty.device_calibration_um_per_m", "20"}};
  const auto outcome = workbench.draft(id, draft);
  ASSERT_TRUE(outcome) << outcome.error().to_string();
  EXPECT_GT(expanded(outcome->result, "A"), before + 5.0);
  EXPECT_EQ(expanded(workbench.test(id)->outcome.result, "A"), before);
  EXPECT_EQ(workbench.test(id)->versions.size(), 1u);
}

/// Two approaches from each side to so many targets.
std::string file_of(int targets, int runs) {
  std::string text = "target_mm,direction,run,deviation_um\n";
  for (int run = 1; run <= runs; ++run)
    for (int i = 0; i < targets; ++i)
      for (const char direction : {'+', '-'})
        text += std::to_string(i) + "," + direction + "," + std::to_string(run) + "," + std::to_string(run % 3) + "\n";
  return text;
}

TEST_F(TheWorkbench, RefusesTrialsThatWouldTakeTheWholeMachine) {
  const auto refusal = [this](store::Id test, std::optional<std::size_t> trials) {
    Draft draft;
    draft.changes = {{"uncertainty.misalignment_mm", "1"}};
    draft.options.monte_carlo = true;
    draft.options.trials = trials;
    const auto tried = workbench.draft(test, draft);
    return tried ? "" : tried.error().message;
  };
  EXPECT_THAT(refusal(keep(file_of(501, 2), "wide.csv"), 100),
              HasSubstr("found a test of 501 targets, expected at most 500"));
  const store::Id deep = keep(file_of(12, 10'000), "deep.csv");
  EXPECT_THAT(refusal(deep, 1'000'000), HasSubstr("found 1000000 trials of 12 targets and 240000 readings, expected at "
                                                  "most 83283"));
  EXPECT_THAT(refusal(deep, std::nullopt), HasSubstr("found 100000 trials"));
  EXPECT_EQ(refusal(keep(example_table2), 100), "");
}

TEST_F(TheWorkbench, ComparesAnyNumberOfRunsWithAStatedUncertainty) {
  Draft draft;
  draft.changes = {{"uncertainty.environmental_variation", "1"}};
  const auto tried = workbench.draft(keep(file_of(12, 1000), "deep.csv"), draft);
  EXPECT_TRUE(tried) << tried.error().message;
}

TEST_F(TheWorkbench, GivesUpWhatItIsToldToStopAndKeepsNothing) {
  const store::Id id = keep(example_table2);
  Draft draft;
  draft.options.monte_carlo = true;
  draft.options.trials = 10'000'000;
  std::stop_source source;
  const std::jthread stopping([&] { source.request_stop(); });
  const auto outcome = workbench.draft(id, draft, source.get_token());
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::unavailable);
  const auto revised = workbench.revise(id, {.draft = draft, .base_version = 1, .title = {}}, me, source.get_token());
  ASSERT_FALSE(revised);
  EXPECT_EQ(workbench.test(id)->versions.size(), 1U);
  const Upload upload{"again.json", example_table2};
  EXPECT_FALSE(workbench.receive(std::span(&upload, 1), me, source.get_token()));
  EXPECT_EQ(store.counts()->tests, 1);
  ReportRequest report{.extension = "pdf", .options = {}, .stop = source.get_token()};
  EXPECT_FALSE(workbench.report(id, {}, report));
  report.stop = {};
  EXPECT_TRUE(workbench.report(id, {}, report));
}

TEST_F(TheWorkbench, TakesAValueAwayAndReplacesAList) {
  const auto id = keep(example_table2);
  Draft draft;
  draft.changes = {{"test.inspector", ""}, {"equipment", "Laser | Maker | L1 | 9\nOptics | Maker | O1 | 10\n"}};
  const auto outcome = workbench.draft(id, draft);
  ASSERT_TRUE(outcome) << outcome.error().to_string();
  const json::Value& metadata = *outcome->result.find("metadata");
  EXPECT_EQ(metadata.find("test")->find("inspector"), nullptr);
  EXPECT_EQ(metadata.find("equipment")->items().size(), 2u);
}

TEST_F(TheWorkbench, RevisesIntoANewVersionAndRefusesASecondOneFromTheSameBase) {
  const auto id = keep(example_table2);
  Revision revision;
  revision.base_version = 1;
  revision.title = "Checked";
  revision.draft.changes = {{"tolerance.A", "12"}};
  const auto revised = workbench.revise(id, revision, me);
  ASSERT_TRUE(revised) << revised.error().to_string();
  EXPECT_EQ(revised->record.version, 2);
  EXPECT_EQ(revised->record.state.title, "Checked");
  EXPECT_EQ(revised->record.state.evaluation.verdict, "conforms");
  const auto second = workbench.revise(id, revision, me);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, ErrorKind::conflict);
  const auto first = workbench.test(id, 1);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->record.state.title, "table2");
  EXPECT_EQ(first->outcome.result.find("verdict"), nullptr);
  EXPECT_EQ(workbench.raw(id)->bytes, example_table2);
}

TEST_F(TheWorkbench, ShowsCorrectedReadingsBesideThoseThatWereMeasured) {
  const auto id = keep(example_table2);
  Revision revision;
  revision.base_version = 1;
  revision.draft.options.corrections = {"drift"};
  ASSERT_TRUE(workbench.revise(id, revision, me));
  const auto test = workbench.test(id);
  ASSERT_TRUE(test);
  ASSERT_TRUE(test->outcome.as_measured);
  EXPECT_EQ(test->outcome.as_measured->reading(0, Direction::up, 4)->in_native(), -1.9);
  EXPECT_NE(test->outcome.readings.reading(0, Direction::up, 4)->in_native(), -1.9);
}

/// The interferometer that the file of Table 2 names.
store::InstrumentRecord laser_of_table2() {
  store::InstrumentRecord laser;
  laser.manufacturer = "Example Instruments";
  laser.type = "LI-1";
  laser.serial_number = "1234";
  return laser;
}

void calibrate(store::InstrumentRecord& instrument, const EquipmentCalibration& calibration) {
  instrument.certificate = calibration.certificate;
  instrument.calibrated_on = calibration.calibrated_on;
  instrument.calibration_due = calibration.calibration_due;
}

TEST_F(TheWorkbench, TakesInputsFromTheInstrumentWhereNobodyStatesThem) {
  store::InstrumentRecord laser = laser_of_table2();
  laser.inputs = {{"uncertainty.instrument_resolution", "0.5"}, {"uncertainty.misalignment_mm", "100"}};
  ASSERT_TRUE(store.add(laser, me));
  const auto id = keep(example_table2);
  const auto test = workbench.test(id);
  ASSERT_TRUE(test);
  ASSERT_EQ(test->outcome.from_archive.instruments.size(), 1u);
  const auto& taken = test->outcome.from_archive.instruments.front();
  EXPECT_THAT(taken.inputs,
              ElementsAre(std::pair<std::string, std::string>("uncertainty.instrument_resolution", "0.5")))
      << "the file states the misalignment itself";
  Draft draft;
  draft.changes = {{"uncertainty.instrument_resolution", ""}};
  EXPECT_THAT(workbench.draft(id, draft)->from_archive.instruments, IsEmpty());
}

TEST_F(TheWorkbench, TakesACertificateOfAnInstrumentAsAWholeOrNotAtAll) {
  store::InstrumentRecord laser = laser_of_table2();
  laser.inputs = {{"uncertainty.device_calibration", "2"}};
  ASSERT_TRUE(store.add(laser, me));
  const auto test = workbench.test(keep(example_table2));
  ASSERT_TRUE(test);
  ASSERT_EQ(test->outcome.from_archive.instruments.size(), 1u);
  const auto& taken = test->outcome.from_archive.instruments.front();
  EXPECT_THAT(taken.inputs, IsEmpty()) << "the file states U per metre";
  EXPECT_THAT(taken.left_out, ElementsAre(std::pair<std::string, std::string>("uncertainty.device_calibration", "2")));
  EXPECT_THAT(json::dump(test->outcome.result), HasSubstr("a certificate is taken as a whole"));
}

TEST_F(TheWorkbench, StatesTheCalibrationThatHeldOnTheDayOfTheTest) {
  store::InstrumentRecord laser = laser_of_table2();
  calibrate(laser, {0, "C-2014", "2014-01-10", "2015-01-10"});
  const auto added = store.add(laser, me);
  ASSERT_TRUE(added);
  calibrate(laser, {0, "C-2026", "2026-01-13", "2027-01-13"});
  ASSERT_TRUE(store.change(added->id, 1, laser, me));
  const auto id = keep(example_table2);
  const auto certificate_on = [&](const std::string& day) {
    Draft draft;
    draft.changes = {{"test.date", day}};
    const auto outcome = workbench.draft(id, draft);
    const auto& taken = outcome->from_archive.calibrations;
    return taken.size() == 1 ? taken.front().calibration.certificate : "";
  };
  EXPECT_EQ(certificate_on("2014-05-15"), "C-2014");
  EXPECT_EQ(certificate_on("2026-05-15"), "C-2026");
  EXPECT_EQ(certificate_on("2026-01-13"), "C-2026") << "the day of the calibration itself";
  EXPECT_EQ(certificate_on("2010-05-15"), "") << "before any: none is known";
  EXPECT_EQ(certificate_on("last spring"), "") << "of two nobody can tell which held";
  Draft draft;
  draft.changes = {{"equipment", "laser | Example Instruments | LI-1 | 1234 | of the file"}};
  EXPECT_THAT(workbench.draft(id, draft)->from_archive.calibrations, IsEmpty());
  draft.changes = {{"test.date", "2016-05-15"}};
  EXPECT_THAT(json::dump(workbench.draft(id, draft)->result),
              HasSubstr("Laser interferometer (2014-01-10 – 2015-01-10)"));
}

TEST_F(TheWorkbench, TakesACalibrationAsItWasToldLast) {
  store::InstrumentRecord laser = laser_of_table2();
  calibrate(laser, {0, "C-2012", "2014-05-10", "2015-05-10"});
  auto kept = store.add(laser, me);
  ASSERT_TRUE(kept);
  laser.calibrated_on = "2012-05-10";  // a typing error of the year
  laser.calibration_due = "2013-05-10";
  kept = store.change(kept->id, kept->version, laser, me);
  ASSERT_TRUE(kept);
  const auto id = keep(example_table2);  // of 2014-05-15
  const auto outcome = workbench.draft(id, {});
  ASSERT_TRUE(outcome);
  ASSERT_EQ(outcome->from_archive.calibrations.size(), 1u);
  EXPECT_EQ(outcome->from_archive.calibrations.front().calibration.calibrated_on, "2012-05-10");
  EXPECT_THAT(json::dump(outcome->result), HasSubstr("Laser interferometer (2012-05-10 – 2013-05-10)"));
  laser.certificate = "C-2014";
  laser.calibrated_on = "";
  laser.calibration_due = "2015-12-31";
  ASSERT_TRUE(store.change(kept->id, kept->version, laser, me));
  EXPECT_EQ(workbench.draft(id, {})->from_archive.calibrations.front().calibration.certificate, "C-2014")
      << "rather one of an unknown day than one that did not hold any more";
}

TEST_F(TheWorkbench, ReportsAVersionWithTheInputsOfItsDayAlthoughTheInstrumentHasChanged) {
  store::InstrumentRecord laser = laser_of_table2();
  laser.inputs = {{"uncertainty.instrument_resolution", "0.5"}};
  const auto added = store.add(laser, me);
  ASSERT_TRUE(added);
  const auto id = keep(example_table2);
  laser.inputs = {{"uncertainty.instrument_resolution", "50"}};
  ASSERT_TRUE(store.change(added->id, 1, laser, me));
  Workbench another(store);  // remembers nothing
  const auto csv = another.report(id, 1, {.extension = "csv"});
  ASSERT_TRUE(csv) << csv.error().to_string();
  EXPECT_THAT(csv->bytes, HasSubstr("parameter,,,A,9.58"));
}

TEST_F(TheWorkbench, AppliesTheLimitsOfTheAxisWhereTheTestStatesNone) {
  const auto id = keep(example_table2);
  const auto axis = store.get<store::AxisRecord>(*workbench.test(id)->record.axis);
  ASSERT_TRUE(axis);
  store::AxisRecord limited = axis->value;
  limited.limits = {{"A", 5.0}, {"B", 50.0}};
  ASSERT_TRUE(store.change(axis->id, axis->version, limited, me));
  const auto outcome = workbench.draft(id, {});
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->result.find("verdict")->text(), "does not conform");
  EXPECT_EQ(outcome->result.find("tolerances")->items().front().find("source")->text(), "axis");
  Draft stated;
  stated.changes = {{"tolerance.A", "20"}};
  const auto own = workbench.draft(id, stated);
  EXPECT_EQ(own->result.find("verdict")->text(), "conforms");
  const auto& tolerances = own->result.find("tolerances")->items();
  ASSERT_EQ(tolerances.size(), 2u);  // B stays as the axis has it
  EXPECT_EQ(tolerances[0].find("source")->text(), "entered");
  EXPECT_EQ(tolerances[0].find("replaced")->items().front().find("limit")->number(), 5.0);
  EXPECT_EQ(tolerances[1].find("parameter")->text(), "B");
  EXPECT_EQ(tolerances[1].find("source")->text(), "axis");
}

TEST_F(TheWorkbench, SaysThatAVersionWasJudgedWithLimitsThatTheAxisHasNoMore) {
  const auto id = keep(example_table2);
  const auto axis = store.get<store::AxisRecord>(*workbench.test(id)->record.axis);
  store::AxisRecord limited = axis->value;
  limited.limits = {{"A", 12.0}};
  ASSERT_TRUE(store.change(axis->id, axis->version, limited, me));
  const auto judged = workbench.revise(id, {.draft = {}, .base_version = 1, .title = ""}, me);
  ASSERT_TRUE(judged) << judged.error().to_string();
  EXPECT_EQ(judged->record.state.evaluation.verdict, "conforms");
  const auto html = [&] { return workbench.report(id, 2, {.extension = "html"})->bytes; };
  EXPECT_THAT(html(), HasSubstr("from the limits of the axis as of"));
  EXPECT_THAT(html(), Not(HasSubstr("have changed since")));
  limited.limits = {{"A", 5.0}};
  ASSERT_TRUE(store.change(axis->id, axis->version + 1, limited, me));
  EXPECT_THAT(html(), HasSubstr("have changed since this version was evaluated"));
  EXPECT_THAT(workbench.report(id, 2, {.extension = "json"})->bytes, HasSubstr("axis-limits-changed"));
  EXPECT_THAT(json::dump(workbench.test(id)->outcome.result), HasSubstr("A 12 → 5 µm"));
  EXPECT_EQ(workbench.test(id)->outcome.result.find("verdict")->text(), "conforms") << "as it was kept";
}

TEST_F(TheWorkbench, FindsTheAxisOfAMachineThatWasRenamed) {
  const auto first = keep(example_table2);
  const auto record = workbench.test(first)->record;
  auto machine = store.get<store::MachineRecord>(*record.machine);
  machine->value.name = "M-17";
  ASSERT_TRUE(store.change(machine->id, 1, machine->value, me));
  auto axis = store.get<store::AxisRecord>(*record.axis);
  axis->value.limits = {{"A", 5.0}};
  ASSERT_TRUE(store.change(axis->id, 1, axis->value, me));
  const auto second = workbench.test(keep(example_table2, "second.json"));
  EXPECT_EQ(second->record.machine, record.machine);
  EXPECT_EQ(second->record.state.evaluation.verdict, "does not conform");
}

TEST_F(TheWorkbench, EvaluatesAtOnceWithTheLimitsOfTheAxisThatItLinksTheTestWith) {
  store::MachineRecord mill;
  mill.name = "FRÄSE 7";
  const auto machine = store.add(mill, me);
  ASSERT_TRUE(machine);
  store::AxisRecord axis;
  axis.machine = machine->id;
  axis.name = "x";
  axis.kind = "linear";
  axis.limits = {{"A", 1.0}};
  ASSERT_TRUE(store.add(axis, me));
  const std::string bytes =
      "# machine.name: fräse 7\n# axis.name: X\ntarget_mm,direction,run,deviation_um\n"
      "0,+,1,1\n100,+,1,2\n0,+,2,3\n100,+,2,5\n0,-,1,3\n100,-,1,4\n0,-,2,4\n100,-,2,4\n";
  const auto test = workbench.test(keep(bytes, "run.csv"));
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->record.machine, machine->id);
  ASSERT_TRUE(test->outcome.from_archive.axis);
  EXPECT_EQ(test->outcome.from_archive.axis->axis, test->record.axis);
  EXPECT_EQ(test->record.state.evaluation.verdict, "does not conform");
}

TEST_F(TheWorkbench, JudgesARevisionByTheAxisOfTheMachineThatItStaysWith) {
  const auto of = [](const std::string& number) {
    return "# machine.name: Mill\n" + (number.empty() ? "" : "# machine.serial_number: " + number + "\n") +
           "# axis.name: X\ntarget_mm,direction,run,deviation_um\n"
           "0,+,1,1\n100,+,1,2\n0,+,2,3\n100,+,2,5\n0,-,1,3\n100,-,1,4\n0,-,2,4\n100,-,2,4\n";
  };
  keep(of("A1"), "a1.csv");
  const auto id = keep(of(""), "unnumbered.csv");
  const auto record = workbench.test(id)->record;
  auto axis = store.get<store::AxisRecord>(*record.axis);
  axis->value.limits = {{"A", 1.0}};
  ASSERT_TRUE(store.change(axis->id, 1, axis->value, me));
  keep(of("B2"), "b2.csv");
  ASSERT_EQ(store.counts()->machines, 2);
  keep(of(""), "third.csv");  // of a third machine, now that two are called so
  ASSERT_EQ(store.counts()->machines, 3);
  Draft moved;
  moved.changes = {{"machine.location", "Hall 2"}};
  const auto revised = workbench.revise(id, {.draft = moved, .base_version = 1, .title = ""}, me);
  ASSERT_TRUE(revised) << revised.error().to_string();
  EXPECT_EQ(revised->record.machine, record.machine);
  EXPECT_EQ(revised->record.axis, record.axis);
  ASSERT_TRUE(revised->outcome.from_archive.axis);
  EXPECT_EQ(revised->outcome.from_archive.axis->axis, *record.axis);
  EXPECT_EQ(revised->record.state.evaluation.verdict, "does not conform");
}

TEST_F(TheWorkbench, RefusesAReportWhoseFiguresAreNoLongerThoseThatWereKept) {
  const auto id = keep(example_table2);
  auto record = store.test(id);
  ASSERT_TRUE(record);
  record->state.evaluation.figures.front().value += 0.01;
  record->state.evaluation.program = "axiometry 9.9";
  ASSERT_TRUE(store.revise(id, 1, record->state, me));
  const auto report = workbench.report(id, {}, {.extension = "html"});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ErrorKind::conflict);
  EXPECT_THAT(report.error().message, HasSubstr("axiometry 9.9"));
  EXPECT_TRUE(workbench.report(id, {}, {.extension = "json"})) << "what was kept stays to be had";
  EXPECT_TRUE(workbench.report(id, 1, {.extension = "html"}));
}

TEST_F(TheWorkbench, WritesReportsInEveryFormat) {
  const auto id = keep(example_table2);
  for (const auto& [extension, beginning] : {std::pair{"html", "<!"},
                                             {"pdf", "%PDF"},
                                             {"svg", "<?xml"},
                                             {"png", "\x89PNG"},
                                             {"csv", "axis,"},
                                             {"json", "{"}}) {
    const auto report = workbench.report(id, {}, {.extension = extension});
    ASSERT_TRUE(report) << extension << report.error().to_string();
    EXPECT_EQ(report->bytes.substr(0, std::string_view(beginning).size()), beginning);
    EXPECT_EQ(report->file_name, std::string("table2.") + extension);
  }
  EXPECT_EQ(workbench.report(id, {}, {.extension = "exe"}).error().kind, ErrorKind::not_found);
  EXPECT_EQ(workbench.report(77, {}, {.extension = "pdf"}).error().kind, ErrorKind::not_found);
}

TEST_F(TheWorkbench, KeepsAnIssuedReportAsItWas) {
  const auto id = keep(example_table2);
  const auto document = workbench.issue(id, {}, {.extension = "html"}, me);
  ASSERT_TRUE(document) << document.error().to_string();
  Revision revision;
  revision.base_version = 1;
  revision.draft.changes = {{"test.inspector", "Somebody else"}};
  ASSERT_TRUE(workbench.revise(id, revision, me));
  const auto bytes = workbench.document(document->id);
  ASSERT_TRUE(bytes);
  EXPECT_THAT(bytes->bytes, HasSubstr("A. N. Inspector"));
  EXPECT_EQ(bytes->media_type, "application/octet-stream") << "no browser shall run it";
}

TEST_F(TheWorkbench, IssuesAReportThatProvesTheTrailOfTheArchiveUpToThere) {
  const auto id = keep(example_table2);
  const auto head = store.head();
  ASSERT_TRUE(head);
  for (const std::string extension : {"html", "svg", "png", "csv", "json"}) {
    const std::string before = store::short_text(*store.head());
    const auto document = workbench.issue(id, {}, {.extension = extension}, me);
    ASSERT_TRUE(document) << document.error().to_string();
    EXPECT_THAT(workbench.document(document->id)->bytes, HasSubstr(before)) << extension;
    EXPECT_THAT(workbench.report(id, {}, {.extension = extension})->bytes, Not(HasSubstr(before))) << extension;
  }
  const auto said = store::read_short_head(store::short_text(*head));
  ASSERT_TRUE(said);
  EXPECT_THAT(store.verify({}, std::span(&*said, 1))->problems, testing::IsEmpty());
}

TEST_F(TheWorkbench, HandsOutAttachmentsUnderATypeThatNothingRuns) {
  const auto id = keep(example_table2);
  const auto page = workbench.attach(id, {"x.html", "text/html", "<script>alert(1)</script>"}, me);
  const auto picture = workbench.attach(id, {"x.png", "image/PNG; a=b", "picture"}, me);
  const auto vector = workbench.attach(id, {"x.svg", "image/svg+xml", "<svg onload=''/>"}, me);
  ASSERT_TRUE(page && picture && vector);
  EXPECT_EQ(workbench.document(page->id)->media_type, "application/octet-stream");
  EXPECT_EQ(workbench.document(picture->id)->media_type, "image/png");
  EXPECT_EQ(workbench.document(vector->id)->media_type, "application/octet-stream");
  EXPECT_FALSE(workbench.attach(id, {"x\r\nEvil: 1", "text/plain", "x"}, me));
}

TEST_F(TheWorkbench, DrawsFiguresForBothThemes) {
  const auto id = keep(example_table2);
  const auto titles = workbench.figures(id, {}, {.extension = "svg"});
  ASSERT_TRUE(titles);
  EXPECT_EQ(titles->size(), 6u) << "three of clause 8, the means with their U twice, and the contributions of the GUM";
  const auto light = workbench.figure(id, {}, 0, false, {.extension = "svg"});
  const auto dark = workbench.figure(id, {}, 0, true, {.extension = "svg"});
  ASSERT_TRUE(light && dark);
  EXPECT_NE(*light, *dark);
  EXPECT_EQ(workbench.figure(id, {}, 9, false, {.extension = "svg"}).error().kind, ErrorKind::not_found);
}

TEST_F(TheWorkbench, WithdrawsAndReinstates) {
  const auto id = keep(example_table2);
  EXPECT_TRUE(workbench.withdraw(id, true, me)->record.withdrawn);
  EXPECT_EQ(store.tests({})->total, 0);
  EXPECT_FALSE(workbench.withdraw(id, false, me)->record.withdrawn);
  EXPECT_EQ(store.tests({})->total, 1);
}

TEST_F(TheWorkbench, SaysInEveryReportThatATestIsWithdrawnAndIssuesNone) {
  const auto id = keep(example_table2);
  const std::string words(withdrawn_label);
  const auto report_of = [&](const std::string& extension) {
    const auto report = workbench.report(id, {}, {.extension = extension});
    EXPECT_TRUE(report) << (report ? "" : report.error().message);
    return report ? report->bytes : std::string();
  };
  EXPECT_THAT(report_of("html"), Not(HasSubstr(words)));
  ASSERT_TRUE(workbench.withdraw(id, true, me));
  EXPECT_THAT(report_of("html"), HasSubstr("Label: " + words));
  EXPECT_THAT(report_of("csv"), HasSubstr(words));
  const auto figure = workbench.figure(id, {}, 0, false, {.extension = "svg"});
  ASSERT_TRUE(figure) << figure.error().message;
  EXPECT_THAT(*figure, HasSubstr(words)) << "where it stands alone, too";
  EXPECT_THAT(report_of("json"), HasSubstr("\"withdrawn\": true"));
  const auto issued = workbench.issue(id, {}, {.extension = "html"}, me);
  ASSERT_FALSE(issued);
  EXPECT_EQ(issued.error().kind, ErrorKind::conflict);
  EXPECT_THAT(issued.error().message, HasSubstr("withdrawn"));
}

TEST_F(TheWorkbench, ServesManyAtOnce) {
  const auto id = keep(example_table2);
  std::vector<std::thread> threads;
  std::atomic<int> failures = 0;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&, t] {
      for (int k = 0; k < 8; ++k) {
        Draft draft;
        draft.changes = {{"uncertainty.misalignment_mm", std::to_string(1 + t)}};
        if (!workbench.draft(id, draft) || !workbench.report(id, {}, {.extension = "csv"}) || !workbench.test(id))
          ++failures;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failures, 0);
}

}  // namespace
}  // namespace axiometry::app
