// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/test_state.h"

#include <gtest/gtest.h>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/workbench/from_archive/axis_limits.h"

namespace axiometry::app {
namespace {

TEST(KeptVerdict, IsThatOfAllLimitsTogether) {
  using uncertainty::Verdict;
  const auto kept = [](std::initializer_list<Verdict> verdicts) {
    std::vector<iso230_2::Judgement> judgements;
    for (const Verdict verdict : verdicts) judgements.emplace_back().decision.verdict = verdict;
    return kept_verdict(judgements);
  };
  EXPECT_EQ(kept({}), "");
  EXPECT_EQ(kept({Verdict::not_applicable}), "");
  EXPECT_EQ(kept({Verdict::conforms, Verdict::conforms}), "conforms");
  EXPECT_EQ(kept({Verdict::conforms, Verdict::not_applicable}), "undecided") << "of one test or of two lines";
  EXPECT_EQ(kept({Verdict::conforms, Verdict::undecided}), "undecided");
  EXPECT_EQ(kept({Verdict::undecided, Verdict::does_not_conform, Verdict::not_applicable}), "does not conform");
}

TEST(TestOptions, ComeBackAsTheyWereWritten) {
  TestOptions options;
  options.monte_carlo = true;
  options.trials = 20000;
  options.seed = 18446744073709551615u;
  options.coverage = 0.99;
  options.corrections = {"nde", "air=edlen"};
  const auto back = test_options_from(to_json(options));
  ASSERT_TRUE(back) << back.error().to_string();
  EXPECT_EQ(*back, options);
}

// 2^53 + 1 as a number is read as 2^53, another seed than was given.
TEST(TestOptions, TakeNoSeedThatANumberDoesNotHold) {
  const auto seed_of = [](const std::string& text) {
    const auto options = test_options_from(*json::parse("{\"seed\": " + text + "}"));
    return options ? std::to_string(options->seed) : options.error().to_string();
  };
  EXPECT_EQ(seed_of("9007199254740991"), "9007199254740991");
  EXPECT_TRUE(
      seed_of("9007199254740993")
          .ends_with(
              "found a seed that is no whole number from 0 to 9007199254740991, or text up to 18446744073709551615"));
  EXPECT_EQ(seed_of("\"9007199254740993\""), "9007199254740993");
  for (const std::uint64_t seed : {9007199254740991u, 9007199254740992u, 9007199254740993u}) {
    TestOptions options;
    options.seed = seed;
    EXPECT_EQ(test_options_from(to_json(options))->seed, seed);
  }
}

TEST(TestOptions, RefuseWhatIsUnknownWithItsPlace) {
  const auto refused = [](std::string_view text) {
    const auto options = test_options_from(*json::parse(text));
    return options ? std::string("taken") : options.error().to_string();
  };
  EXPECT_EQ(refused(R"({"methods": ["gumm"]})"), "line 1:14: found the method \"gumm\", expected perhaps gum");
  EXPECT_NE(refused(R"({"trials": 1e9})"), "taken");
  EXPECT_NE(refused(R"({"trials": 100.5})"), "taken");
  EXPECT_NE(refused(R"({"seed": -1})"), "taken");
  EXPECT_NE(refused(R"({"coverage": 1})"), "taken");
  EXPECT_NE(refused(R"({"corrections": ["air=ciddor", "air=edlen"]})"), "taken");
  EXPECT_NE(refused(R"({"method": []})"), "taken");
  EXPECT_NE(refused(R"([])"), "taken");
}

TEST(Changes, RefuseUnknownKeysAndTextsThatNoLineHolds) {
  const auto refused = [](std::string_view text) { return !changes_from(*json::parse(text)); };
  EXPECT_FALSE(refused(R"({"machine.name": "<script>alert(1)</script>"})")) << "markup is text";
  EXPECT_TRUE(refused(R"({"machine.nam": "x"})"));
  EXPECT_TRUE(refused(R"({"machine.name": 3})"));
  EXPECT_TRUE(refused(R"({"machine.name": "a\u0000b"})"));
  EXPECT_TRUE(refused("{\"machine.name\": \"" + std::string(20000, 'x') + "\"}"));
}

TEST(GivenText, RefusesControlCharactersInvalidBytesAndWhatHidesNames) {
  EXPECT_EQ(*given_line("title", "  Größe ± 3 µm "), "Größe ± 3 µm");
  EXPECT_FALSE(given_line("title", "a\nb"));
  EXPECT_TRUE(given_text("notes", "a\nb"));
  EXPECT_FALSE(given_line("title", "a\xC3"));
  EXPECT_FALSE(given_line("title", "invoice\u202Efdp.exe"));
  EXPECT_TRUE(given_line("title", std::string(500, 'x')));
  EXPECT_FALSE(given_line("title", std::string(501, 'x')));
  EXPECT_EQ(given_line("title", std::string(501, 'x')).error().message,
            "found 501 characters in title, expected at most 500");
}

TEST(GivenVersion, IsNotCutToANumberThatFits) {
  EXPECT_EQ(*given_version("version", json::Value(7.0)), 7);
  EXPECT_FALSE(given_version("version", json::Value(4294967297.0)));
  EXPECT_FALSE(given_version("version", json::Value(0.0)));
}

TEST(GivenFileName, IsANameAndNothingElse) {
  EXPECT_EQ(*given_file_name("/etc/passwd"), "passwd");
  EXPECT_EQ(*given_file_name("C:\\temp\\a.csv"), "a.csv");
  EXPECT_EQ(*given_file_name(".."), "unnamed");
  EXPECT_EQ(*given_file_name(""), "unnamed");
  EXPECT_FALSE(given_file_name("a\r\nb"));
}

TEST(Limits, RefuseParametersAndSizesThatNoAxisHas) {
  const auto refused = [](std::string_view text) { return !limits_from(*json::parse(text)); };
  EXPECT_FALSE(refused(R"([{"parameter": "A", "value": 10}])"));
  EXPECT_TRUE(refused(R"([{"parameter": "Q", "value": 10}])"));
  EXPECT_TRUE(refused(R"([{"parameter": "A", "value": 0}])"));
  EXPECT_TRUE(refused(R"([{"parameter": "A", "value": 1}, {"parameter": "A", "value": 2}])"));
}

TEST(FromArchive, ComesBackAsItWasWritten) {
  FromArchive taken;
  taken.instruments = {
      {3, 2, "Laser", {{"uncertainty.misalignment_mm", "1"}}, {{"uncertainty.device_calibration", "2"}}}};
  taken.calibrations = {{3, 1, {0, "C-1", "2026-01-13", "2027-01-13"}}};
  taken.axis = AxisLimits{4, 1, {{"A", 10.0}}, "2026-11-26"};
  const auto back = from_archive_of(to_json(taken));
  ASSERT_TRUE(back) << back.error().to_string();
  EXPECT_EQ(json::dump(to_json(*back)), json::dump(to_json(taken)));
}

TEST(ChangedLimits, AreToldByParameter) {
  FromArchive taken;
  store::AxisRecord now;
  now.kind = "linear";
  now.limits = {{"A", 5.0}, {"B", 2.0}};
  EXPECT_FALSE(changed_limits(taken, now)) << "none were taken";
  taken.axis = AxisLimits{4, 1, {{"B", 2.0}, {"A", 5.0}}};
  EXPECT_FALSE(changed_limits(taken, now));
  EXPECT_FALSE(changed_limits(taken, std::nullopt));
  taken.axis->limits = {{"A", 12.0}, {"E", 3.5}, {"B", 2.0}};
  const auto finding = changed_limits(taken, now);
  ASSERT_TRUE(finding);
  EXPECT_EQ(finding->id, "axis-limits-changed");
  EXPECT_TRUE(finding->message.ends_with("of its day: A 12 → 5 µm, E 3.5 → – µm")) << finding->message;
}

TEST(FromArchive, SaysWhoseEachInputIsAndWhatItLeavesOut) {
  FromArchive taken;
  taken.instruments = {
      {3, 2, "Laser", {{"uncertainty.misalignment_mm", "1"}}, {{"uncertainty.device_calibration", "2"}}}};
  const EvaluateOptions options = with_archive({}, {{"uncertainty.length_mm", "900"}}, taken);
  EXPECT_EQ(options.stated.by("uncertainty.misalignment_mm"), StatedBy::instrument);
  EXPECT_EQ(options.stated.find("uncertainty.misalignment_mm")->name, "Laser");
  EXPECT_EQ(options.stated.by("uncertainty.length_mm"), StatedBy::entered);
  ASSERT_EQ(options.remarks.size(), 1u);
  EXPECT_NE(options.remarks[0].find("uncertainty.device_calibration = 2 of Laser"), std::string::npos);
}

TEST(KeptOptions, HoldTheProfileOfATableAndNeedNone) {
  store::EvaluationRecord evaluation;
  evaluation.options = R"({"methods": ["gum"], "from_archive": {"instruments": [], "calibrations": [], "axis": null}})";
  const auto without = kept_options(evaluation);
  ASSERT_TRUE(without) << without.error().to_string();
  EXPECT_FALSE(without->profile);
  evaluation.options =
      R"({"import_profile": {"format": "axiometry-import-profile/1", "sign": -1,
          "columns": [{"role": "target"}, {"role": "deviation"}]}})";
  const auto with = kept_options(evaluation);
  ASSERT_TRUE(with && with->profile) << with.error().to_string();
  EXPECT_EQ(with->profile->sign, -1.0);
  evaluation.options = R"({"import_profile": {"format": "axiometry-import-profile/2"}})";
  EXPECT_EQ(kept_options(evaluation).error().kind, ErrorKind::damaged);
}

}  // namespace
}  // namespace axiometry::app
