// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/evaluate_many.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/series.h"

namespace axiometry::app {
namespace {

axiometry::Test numbered_test(double number) {
  return {{}, testing_support::make_series({0, 10}, {{number, 2}, {1, number}}, {{0, 1}, {2, 3}}), {}};
}

double number_of(const axiometry::Test& test) { return test.series.cell(0, Direction::up)[0]; }

/// Names and texts in the order in which they are handed over.
struct HandedOver {
  std::vector<std::string> names, texts;
  EvaluatedTextSink sink() {
    return [this](Evaluated&& evaluated, std::string&& text) -> Result<void> {
      names.push_back(evaluated.name);
      texts.push_back(std::move(text));
      return {};
    };
  }
};

TestsSideBySide::Evaluate evaluate_all_but(double refused) {
  return [refused](axiometry::Test&& test) -> Result<Evaluated> {
    if (number_of(test) == refused) return fail("found a test that is refused");
    return evaluate_test(std::move(test), {});
  };
}

MakeText text_of_number() {
  return [](Evaluated& evaluated) -> Result<std::string> { return std::to_string(number_of(evaluated.test)); };
}

/// Adds tests 0 to count − 1, which begin in lines 100, 110 …; the first failure.
Result<void> add_all(TestsSideBySide& tests, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k)
    AXIOMETRY_TRY_VOID(tests.add(numbered_test(double(k)), std::to_string(k), 100 + 10 * k));
  return tests.finish();
}

TEST(TestsSideBySide, AreHandedOverInTheirOrderOnAnyNumberOfThreads) {
  for (unsigned threads : {1u, 2u, 3u, 7u}) {
    HandedOver handed;
    TestsSideBySide tests(evaluate_all_but(-1.0), {threads, text_of_number()}, handed.sink());
    ASSERT_TRUE(add_all(tests, 300));
    ASSERT_EQ(handed.names.size(), 300u);
    for (std::size_t k = 0; k < 300; ++k) {
      EXPECT_EQ(handed.names[k], std::to_string(k));
      EXPECT_EQ(handed.texts[k], std::to_string(double(k)));
    }
  }
}

TEST(TestsSideBySide, EndWithTheFirstThatFails) {
  for (unsigned threads : {1u, 3u})
    for (double refused : {0.0, 57.0, 299.0}) {
      HandedOver handed;
      TestsSideBySide tests(evaluate_all_but(refused), {threads, {}}, handed.sink());
      const auto result = add_all(tests, 300);
      ASSERT_FALSE(result);
      EXPECT_EQ(result.error().message, "found a test that is refused");
      EXPECT_EQ(result.error().at.line, 100 + 10 * static_cast<std::size_t>(refused));
      EXPECT_EQ(handed.names.size(), static_cast<std::size_t>(refused));
      ASSERT_TRUE(tests.finish()) << "nothing is left";
      EXPECT_EQ(handed.names.size(), static_cast<std::size_t>(refused));
    }
}

TEST(TestsSideBySide, EndWhereTheyAreNotTaken) {
  std::size_t taken = 0;
  TestsSideBySide tests(evaluate_all_but(-1.0), {4, {}}, [&](Evaluated&&, std::string&&) -> Result<void> {
    if (++taken == 31) return std::unexpected(Error{"cannot write", "output", {}});
    return {};
  });
  const auto result = add_all(tests, 300);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().file, "output");
  EXPECT_EQ(result.error().at.line, 0u);
  EXPECT_EQ(taken, 31u);
}

TEST(TestsSideBySide, ThrowWhatAThreadThrew) {
  HandedOver handed;
  TestsSideBySide tests(
      [](axiometry::Test&& test) -> Result<Evaluated> {
        if (number_of(test) == 5.0) throw std::runtime_error("five");
        return evaluate_test(std::move(test), {});
      },
      {3, {}}, handed.sink());
  EXPECT_THROW((void)add_all(tests, 20), std::runtime_error);
  EXPECT_EQ(handed.names.size(), 5u);
}

}  // namespace
}  // namespace axiometry::app
