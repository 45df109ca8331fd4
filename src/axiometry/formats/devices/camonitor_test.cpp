// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

struct Recording {
  std::size_t targets = 6;
  std::size_t cycles = 3;
  std::string head;  ///< lines before the first value
  std::string reference = "IOC_TEST:ILD_DownSample";
  std::function<double(double)> shown = [](double position_mm) { return position_mm; };
};

double target_mm(std::size_t i) { return 12.5 * static_cast<double>(i) - 20; }

/// µm, different for every approach.
double known_deviation_um(std::size_t i, Direction d, std::size_t j) {
  return 0.25 * static_cast<double>(i) - (d == Direction::down ? 3.5 : 0.0) + 0.125 * static_cast<double>(j * i % 5);
}

class Log {
 public:
  explicit Log(const Recording& recording) : recording_(recording), text_(recording.head) {
    // What camonitor prints while it connects, in any order and with times of long ago.
    text_ += recording.reference +
             "        2026-04-06 12:00:00.148376 70.089104  \n"
             "IOC_TEST:TestNumber            2026-04-06 11:48:15.237292 2309  \n"
             "TARGET_DU:X-PosAct             2026-04-06 11:59:59.341968 -20.00002656 LOLO MAJOR\n"
             "TARGET_DU:X-LimitMax           2026-04-06 10:12:36.594459 1  \n"
             "TARGET_DU:X-PosCmd             2026-04-06 11:46:47.037231 -20  \n"
             "TARGET_DU:X-Temp *** Not connected (PV not found)\n";
  }

  void say(std::string_view name, std::string_view value) {
    seconds_ += 0.5;
    const int whole = static_cast<int>(seconds_);
    text_ += fmt::format("{:<30} 2026-04-06 12:{:02}:{:09.6f} {}  \n", name, whole / 60 % 60,
                         seconds_ - whole / 60 * 60, value);
  }

  void point(std::size_t i, Direction d, std::size_t j) {
    const double target = target_mm(i);
    const double position = target + known_deviation_um(i, d, j) / 1000;
    say("TARGET_DU:X-PosCmd", fmt::format("{}", target + (d == Direction::up ? -0.5 : 0.5)));
    say(recording_.reference, fmt::format("{:.9f}", recording_.shown(position - 0.2)));
    say("TARGET_DU:X-PosCmd", fmt::format("{}", target));
    say("TARGET_DU:X-PosAct", fmt::format("{:.8f} LOLO MAJOR", target + 1e-6));
    say(recording_.reference, fmt::format("{:.9f}", recording_.shown(position)));
    say("IOC_TEST:TestNumber", fmt::format("{}{}0{}", d == Direction::up ? 1 : 2, j + 1, i + 1));
    say(recording_.reference, fmt::format("{:.9f}", recording_.shown(position + 0.3)));
  }

  std::string whole() {
    for (std::size_t j = 0; j < recording_.cycles; ++j) {
      for (std::size_t i = 0; i < recording_.targets; ++i) point(i, Direction::up, j);
      for (std::size_t i = recording_.targets; i-- > 0;) point(i, Direction::down, j);
    }
    say("IOC_TEST:TestNumber", "0");
    return text_;
  }

  std::string text() const { return text_; }

 private:
  Recording recording_;
  std::string text_;
  double seconds_ = 0.0;
};

Result<Test> read_camonitor(const std::string& text) {
  const auto format = recognise(std::string_view(text).substr(0, 65536));
  EXPECT_TRUE(format && (*format)->id == "camonitor");
  return find_format("camonitor")->read(text);
}

std::string camonitor_error(const Recording& recording) {
  const auto test = read_camonitor(Log(recording).whole());
  return test ? "no error" : test.error().to_string();
}

void expect_known_deviations(const Result<Test>& test, const Recording& recording) {
  ASSERT_TRUE(test) << test.error().to_string();
  ASSERT_EQ(test->series.target_count(), recording.targets);
  ASSERT_EQ(test->series.run_count(), recording.cycles);
  for (std::size_t i = 0; i < recording.targets; ++i) {
    EXPECT_EQ(test->series.targets()[i].in_native(), target_mm(i));
    for (Direction d : {Direction::up, Direction::down})
      for (std::size_t j = 0; j < recording.cycles; ++j)
        EXPECT_NEAR(test->series.reading(i, d, j)->in_native(), known_deviation_um(i, d, j), 2e-6);
  }
}

TEST(Camonitor, ReadsTheLastReferenceBeforeEachTestNumber) {
  const Recording recording;
  const auto test = read_camonitor(Log(recording).whole());
  expect_known_deviations(test, recording);
  EXPECT_EQ(test->metadata.conditions.date, "2026-04-06");
  EXPECT_EQ(test->metadata.conditions.comment, "Reference IOC_TEST:ILD_DownSample; set-point TARGET_DU:X-PosCmd");
  // A point takes seven lines of half a second; the reference of the first is the fifth of them.
  EXPECT_NEAR(test->times_s[0], 0.0, 1e-5);
  EXPECT_NEAR(test->times_s[recording.cycles], 3.5, 1e-5);
}

TEST(Camonitor, TellsHowTheLogWasTaken) {
  const auto test = read_camonitor(Log({}).whole());
  ASSERT_TRUE(test);
  std::vector<std::string> messages;
  for (const SourceRemark& remark : test->provenance.remarks) {
    EXPECT_FALSE(remark.departs);
    messages.push_back(remark.message);
  }
  EXPECT_EQ(messages,
            (std::vector<std::string>{
                "found a log; the reading of a point is the last value of IOC_TEST:ILD_DownSample before its number in "
                "\"IOC_TEST:TestNumber\", its target the last value of TARGET_DU:X-PosCmd",
                "found lengths without a unit; they were taken in mm",
                "found 1 other test number that no ISO 230-2 test has; they were passed over",
                "found 1 line without a value, the first on line 6; they were passed over"}));
}

TEST(Camonitor, TellsOfTimeThatRunsBackwards) {
  const Recording recording;
  std::string text = Log(recording).whole();
  const std::size_t test_number = text.find("TestNumber            2026-04-06 12:");
  text.insert(text.find('\n', test_number) + 1,
              "IOC_TEST:ILD_DownSample        2026-04-06 12:00:00.000001 3\n"
              "TARGET_DU:X-PosAct             2026-04-06 12:00:00.000002 3\n");
  const auto test = read_camonitor(text);
  expect_known_deviations(test, recording);
  ASSERT_EQ(test->provenance.remarks.size(), 5u);
  EXPECT_EQ(test->provenance.remarks[2].message,
            "found time running backwards: 1 line with a time before that of a line above, the first on line 13 "
            "(2026-04-06 12:00:00.000001 below 2026-04-06 12:00:03.000000); values were taken in the order of the log");
}

TEST(Camonitor, UnderstandsNumbersOfManyTargets) {
  // Ten and more targets make the scripts write two digits, so 1 1 0 09 and 1 1 0 10.
  const auto test = read_camonitor(
      "A:Laser 2026-04-06 12:00:00.1 0\nA:PosSet 2026-04-06 12:00:00.2 0\nA:Laser 2026-04-06 12:00:01 9.001\n"
      "A:PosSet 2026-04-06 12:00:01 9\nA:TestNumber 2026-04-06 12:00:02 11009\nA:Laser 2026-04-06 12:00:03 10.002\n"
      "A:PosSet 2026-04-06 12:00:03 10\nA:TestNumber 2026-04-06 12:00:04 11010\n");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.target_count(), 2u);
  EXPECT_EQ(test->series.run_count(), 1u);
  EXPECT_NEAR(test->series.reading(1, Direction::up, 0)->in_native(), 2.0, 1e-9);
}

TEST(Camonitor, TakesUnitGainAndOffsetThatTheUserStates) {
  Recording recording;
  recording.head = "# UNIT=mm\n# REF_GAIN = -1\n# REF_OFFSET=50.25\n";
  recording.shown = [](double position) { return 50.25 - position; };
  const auto test = read_camonitor(Log(recording).whole());
  expect_known_deviations(test, recording);
  EXPECT_EQ(test->provenance.remarks[1].message,
            "found a stated reference; its values were multiplied by -1 and 50.25 was added");
}

TEST(Camonitor, RefusesAReferenceThatCountsOtherwise) {
  Recording recording;
  recording.shown = [](double position) { return 50 - position; };
  EXPECT_EQ(
      camonitor_error(recording),
      "found a reference \"IOC_TEST:ILD_DownSample\" that changes by -1 when the set-point changes by 1, expected "
      "1; lines '# REF_GAIN=-1' and '# REF_OFFSET=…' state how it counts");
}

TEST(Camonitor, TellsOfAnotherZeroOfTheReference) {
  Recording recording;
  recording.shown = [](double position) { return position + 40; };
  const auto test = read_camonitor(Log(recording).whole());
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_TRUE(test->provenance.remarks[2].message.contains("another zero"));
  EXPECT_NEAR(test->series.reading(1, Direction::up, 0)->in_native(), 40000.25, 1e-5);
}

TEST(Camonitor, AsksForTheReferenceWhenSeveralMayBeIt) {
  Recording recording;
  recording.reference = "IOC_TEST:Enc02-PosAct";
  EXPECT_EQ(camonitor_error(recording),
            "found 2 variables that may be the reference: \"IOC_TEST:Enc02-PosAct\", \"TARGET_DU:X-PosAct\", expected "
            "one; a line '# REF_PV=NAME' names it");
  recording.head = "# REF_PV=IOC_TEST:Enc02-PosAct\n";
  expect_known_deviations(read_camonitor(Log(recording).whole()), recording);
  recording.head = "# REF_PV=IOC_TEST:Nothing\n";
  EXPECT_EQ(camonitor_error(recording),
            "line 1:1: found REF_PV = \"IOC_TEST:Nothing\", expected a variable of the log");
}

TEST(Camonitor, RefusesANumberAgainstTheMove) {
  Log log({});
  log.point(0, Direction::up, 0);
  log.say("TARGET_DU:X-PosCmd", "100");
  log.say("TARGET_DU:X-PosCmd", "-7.5");
  log.say("IOC_TEST:TestNumber", "1102");
  EXPECT_EQ(
      read_camonitor(log.text()).error().to_string(),
      "line 16:1: found test number 1102 after a move ↓ from 100 to -7.5, expected ↑ for a number that begins with "
      "1");
}

TEST(Camonitor, RefusesWhatIsBroken) {
  Log twice({});
  twice.point(0, Direction::up, 0);
  twice.point(1, Direction::up, 0);
  twice.point(0, Direction::up, 0);
  EXPECT_EQ(read_camonitor(twice.text()).error().to_string(),
            "line 26:1: found a second reading of target -20↑ run 1, expected only that on line 12");
  Log wanders({});
  wanders.point(0, Direction::up, 0);
  wanders.say("TARGET_DU:X-PosCmd", "30");
  wanders.say("IOC_TEST:TestNumber", "1201");
  EXPECT_EQ(read_camonitor(wanders.text()).error().to_string(),
            "line 15:1: found target 1 at 30, expected -20 as on line 12");
  EXPECT_EQ(read_camonitor("A:Laser 2026-04-06 12:00:00.1 0\nA:PosSet 2026-04-06 12:00:00.2 0\n").error().to_string(),
            "found no variable with TestNumber in its name, expected the numbers of an ISO 230-2 test; a first line '# "
            "TEST_PV=NAME' names another");
  EXPECT_EQ(read_camonitor("A:TestNumber 2026-04-06 12:00:00.1 0\nB:TestNumber 2026-04-06 12:00:00.2 0\n")
                .error()
                .to_string(),
            "line 2:1: found the test numbers \"A:TestNumber\" and \"B:TestNumber\", expected one; a first line '# "
            "TEST_PV=NAME' names it");
  EXPECT_EQ(read_camonitor(Log({}).text()).error().to_string(),
            "found no test number of an ISO 230-2 test in \"IOC_TEST:TestNumber\", expected 1101, 1102, …");
}

TEST(Camonitor, FindsTheWordOfAReferenceBehindAnotherThatHoldsIt) {
  Recording recording;
  recording.reference = "BUILD7:ILD_DownSample";  // beside X-PosAct, which moves too
  const auto test = read_camonitor(Log(recording).whole());
  expect_known_deviations(test, recording);
  EXPECT_TRUE(test->metadata.conditions.comment.starts_with("Reference BUILD7:ILD_DownSample;"));
}

TEST(Camonitor, RefusesManyChangesAmongManyVariablesBeforeTheyFillTheMemory) {
  std::string text;
  for (int k = 0; k < 3000; ++k) text += fmt::format("A:V{} 2026-04-06 12:00:00.1 0\n", k);
  for (int k = 0; k < 3000; ++k) text += fmt::format("A:TestNumber 2026-04-06 12:00:00.2 {}\n", 1101 + k % 2);
  EXPECT_EQ(find_format("camonitor")->read(text).error().to_string(),
            "line 3232:1: found 232 changes of \"A:TestNumber\" among 3001 variables, expected the log of one test; "
            "record fewer variables")
      << "a log of 200 kB may take no more than 70 MB: read_budget.h";
}

TEST(Camonitor, ReadsLogsOfWindowsShells) {
  const Recording recording;
  std::string utf16 = "\xFF\xFE";
  for (char c : Log(recording).whole()) utf16 += {c, '\0'};
  const auto format = recognise(std::string_view(utf16).substr(0, 65536));
  ASSERT_TRUE(format) << format.error().to_string();
  expect_known_deviations((*format)->read(utf16), recording);
}

TEST(Camonitor, LeavesLogsOfOtherProgramsAlone) {
  const Format& format = *find_format("camonitor");
  EXPECT_EQ(format.recognise("server 2026-01-31 10:00:00 started\nserver 2026-01-31 10:00:01 stopped\n"), 0);
  EXPECT_EQ(format.recognise("a:b 2026-01-31 10:00:00 started\n"), 0);
  EXPECT_EQ(format.recognise("A:Pos 2026-01-31 10:00:00.5 1.25\n"), 40);
}

}  // namespace
}  // namespace axiometry::formats
