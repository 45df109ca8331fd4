// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/cases/case_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

using testing::HasSubstr;

constexpr std::string_view small_model =
    "operation model\n"
    "input a normal 1 0.1\n"
    "input b t 4 2 0.2\n"
    "model y = a*b\n"
    "trials 20000\n";

Result<CheckReport> checked_model(std::string_view lines, std::string_view head = small_model) {
  return check_case(std::string(head) + std::string(lines),
                    [](std::string_view) -> Result<Test> { return fail("no"); });
}

std::vector<std::string> failures(std::string_view lines, std::string_view head = small_model) {
  const auto report = checked_model(lines, head);
  if (!report) return {report.error().to_string()};
  std::vector<std::string> texts;
  for (const CaseComparison& c : report->failures()) texts.push_back(to_string(c));
  return texts;
}

std::string failure(std::string_view lines, std::string_view head = small_model) {
  const auto texts = failures(lines, head);
  return texts.empty() ? "none" : texts.front();
}

TEST(ModelCase, ComparesBothMethods) {
  EXPECT_EQ(failure("expect gum y = 2\nexpect gum u = 0.28284271247\nexpect mcm y = 2\nexpect mcm u > 0.29\n"
                    "expect gum sensitivity b = 1\nexpect gum contribution a = 0.2\nexpect gum degrees = 16\n"
                    "expect mcm trials = 20000\nexpect y mcm low < 1.5\nexpect gum k = 2.1199052992\n"
                    "expect gum validated no\n"),
            "none");
}

TEST(ModelCase, SaysWhatWasExpectedAndWhatCame) {
  EXPECT_EQ(failure("expect gum u = 0.3 within 0.001\n"),
            "line 6: gum u = 0.3 within 0.001: got 0.2828, expected 0.3 within 0.001, difference -0.0172");
  EXPECT_THAT(failure("expect gum degrees not applicable\n"), HasSubstr("line 6: gum degrees not applicable: got 16"));
  EXPECT_EQ(failure("expect mcm trials >= 30000\n"),
            "line 6: mcm trials >= 30000: got 20000, expected >= 30000, difference -1e+04");
}

TEST(ModelCase, TakesItsToleranceFromTheNoiseOfTheTrials) {
  // δ of u = 0.35 with three digits is 0.0005, four standard errors of 20 000 trials are larger.
  EXPECT_THAT(failure("digits 3\nexpect mcm y = 2.1\n"), HasSubstr("expected 2.1 within 0.0"));
  EXPECT_THAT(failure("digits 1\nexpect mcm y = 3\n"), HasSubstr("expected 3 within 0.05"));
}

TEST(ModelCase, NamesTheWordItDoesNotUnderstand) {
  EXPECT_THAT(failure("", "operation model\ninput 1a normal 0 1\n"),
              HasSubstr("line 2:7: found \"1a\", expected a name"));
  EXPECT_THAT(failure("", "operation model\ninput sin normal 0 1\n"), HasSubstr("that is no function"));
  EXPECT_EQ(failure("", "operation model\ninput a unifrom 0 1\n"),
            "line 2:9: found the distribution \"unifrom\", expected perhaps 'uniform'");
  EXPECT_EQ(failure("", "operation model\ninput a uniform 3 -3\n"),
            "line 2:9: found limits 3 and -3, expected the lower one first");
  EXPECT_EQ(failure("", "operation model\ninput a normal 0 1\ninput a normal 0 1\n"),
            "line 3:7: found \"a\", expected another name for another input");
  EXPECT_EQ(failure("", "operation model\ninput a normal 0 1 degrees 0\n"),
            "line 2:28: found \"0\", expected more than 0 degrees of freedom");
  EXPECT_EQ(failure("", "operation model\nmodel y = 1\n"),
            "line 2:1: found \"model\", expected 'input' before the model");
  EXPECT_EQ(failure("correlation a c 0.5\n"), "line 6:15: found \"c\", expected the name of an input");
  EXPECT_EQ(failure("trails 5\n"), "line 6:1: found \"trails\", expected perhaps 'trials'");
  EXPECT_EQ(failure("coverage 95\n"), "line 6:10: found \"95\", expected a probability between 0 and 1");
  EXPECT_EQ(failure("expect mcm sd = 1\n"),
            "line 6:12: found \"sd\", expected y, u, low, high, shortest low, shortest high or trials");
  EXPECT_EQ(failure("expect gum sensitivity c = 1\n"), "line 6:24: found \"c\", expected the name of an input");
  EXPECT_EQ(failure("expect gum y = 2\nseed 3\n"),
            "line 7:1: found \"seed\", expected 'expect', or a new 'operation' before other data");
}

TEST(ModelCase, PointsIntoTheFormula) {
  EXPECT_EQ(failure("model z = a + cc*b\n"),
            "line 6:15: found \"a + cc*b\": unexpected token \"cc\" found at position 4, "
            "expected a formula of the inputs");
  EXPECT_THAT(failure("model z = a + (b\n"), HasSubstr("line 6:"));
  EXPECT_THAT(failure("model z = a +\n"), HasSubstr("expected a formula of the inputs"));
}

TEST(ModelCase, ExpectsRefusalOfModelsThatCannotBe) {
  EXPECT_EQ(failure("model z = b - a\ncorrelation a b 1.5\nexpect error \"from -1 to 1\"\n"), "none");
  const std::string_view three =
      "operation model\ninput a normal 0 1\ninput b normal 0 1\ninput c normal 0 1\n"
      "correlation a b 0.9\ncorrelation a c 0.9\ncorrelation b c -0.9\nmodel y = a + b + c\n";
  EXPECT_EQ(failure("expect error \"the eigenvalue -0.8\"\n", three), "none");
  EXPECT_THAT(failure("expect gum u = 1\n", three), HasSubstr("got the error: found a correlation matrix"));
  EXPECT_THAT(failure("expect error \"something else\"\n", three), HasSubstr("got found a correlation matrix"));
  EXPECT_EQ(failure("expect error \"finite\"\n", "operation model\ninput a normal 0 1\nmodel y = sqrt(a)\n"), "none");
}

TEST(ModelCase, AsksForTheOutputWhereThereAreSeveral) {
  EXPECT_EQ(failure("model z = a + b\nexpect gum y = 2\n"),
            "line 7:8: found \"gum\", expected the name of one of the outputs");
  EXPECT_EQ(failure("model z = a + b\nexpect z gum y = 3\nexpect z gum correlation y = 0.94868329805\n"), "none");
}

}  // namespace
}  // namespace axiometry::app
