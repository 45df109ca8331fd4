// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/json/json.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace axiometry::json {
namespace {

std::string error_of(std::string_view text, ParseLimits limits = {}) {
  const auto result = parse(text, limits);
  return result ? "no error" : result.error().to_string();
}

TEST(Json, RemembersWhereEachValueStood) {
  const auto root = parse("\xEF\xBB\xBF{\n  \"a\": [1, -2.5e3, \"x,: \\\" y\",\n\tnull], \"b\" : {\"c\":true}\n}");
  ASSERT_TRUE(root) << root.error().to_string();
  const auto& list = root->find("a")->items();
  EXPECT_EQ(root->at(), (TextPosition{1, 1}));
  EXPECT_EQ(root->find("a")->at(), (TextPosition{2, 8}));
  EXPECT_EQ(list[0].at(), (TextPosition{2, 9}));
  EXPECT_EQ(list[1].at(), (TextPosition{2, 12}));
  EXPECT_EQ(list[1].number(), -2500.0);
  EXPECT_EQ(list[2].at(), (TextPosition{2, 20}));
  EXPECT_EQ(list[2].text(), "x,: \" y");
  EXPECT_EQ(list[3].at(), (TextPosition{3, 2}));
  EXPECT_EQ(root->find("b")->find("c")->at(), (TextPosition{3, 20}));
}

TEST(Json, ReadsNumbersAsTheNearestDouble) {
  const auto root = parse("[0.1, 9007199254740993, 18446744073709551616, -0, 1e-400]");
  ASSERT_TRUE(root);
  EXPECT_EQ(root->items()[0].number(), 0.1);
  EXPECT_EQ(root->items()[1].number(), 9007199254740992.0);
  EXPECT_EQ(root->items()[2].number(), 18446744073709551616.0);
  EXPECT_TRUE(std::signbit(root->items()[3].number()));
  EXPECT_EQ(root->items()[4].number(), 0.0);
}

TEST(Json, SaysWhatWasFoundAndExpectedAndWhere) {
  EXPECT_EQ(error_of(""), "line 1:1: found the end of the text, expected a JSON value");
  EXPECT_EQ(error_of("{\"a\": 1,\n \"a\": 2}"), "line 2:2: found a second member \"a\", expected each name once");
  EXPECT_EQ(error_of("[1, 1e999]"), "line 1:5: found \"1e999\", expected a number up to 1.8e308");
  EXPECT_EQ(error_of("\xFF\xFE{\0"), "line 1:1: found UTF-16 text, expected UTF-8");
  EXPECT_EQ(error_of("[[[]]]", {.depth = 2}), "line 1:3: found nesting deeper than 2 levels, expected less");
  EXPECT_EQ(error_of("[1,2,3]", {.values = 3}), "line 1:6: found more than 3 values, expected fewer");
  EXPECT_EQ(error_of("[1,2,3]", {.bytes = 3}), "found 7 bytes, expected at most 3");
  EXPECT_EQ(error_of("[NaN]"), "line 1:2: found \"NaN\", expected a JSON value");
  EXPECT_EQ(error_of("[1,\n]"), "line 2:1: found \"]\", expected a JSON value");
  EXPECT_EQ(error_of("[1] x"), "line 1:5: found \"x\", expected the end of the text");
  EXPECT_EQ(error_of("{,}"), "line 1:2: found ',', expected a member name in quotes");
  EXPECT_EQ(error_of("{\"a\": 1"), "line 1:8: found the end of the text, expected '}'");
  EXPECT_EQ(error_of("[\"abc"), "line 1:2: found \"\"abc\", expected a closing quote");
  EXPECT_EQ(error_of("[\"\xB5\"]"), "line 1:2: found \"\"\\xB5\"\", expected UTF-8");
}

TEST(Json, TakesNoByteZeroForItsEnd) {
  using namespace std::string_view_literals;
  EXPECT_EQ(error_of("{\"a\": 1}\0{\"evil\": 1}"sv), "found a byte 0 behind 8 bytes, expected JSON, which has none");
  EXPECT_EQ(error_of("\0"sv), "found a byte 0 behind 0 bytes, expected JSON, which has none");
}

TEST(Json, RefusesNestingOfAMillionLevelsWithoutFallingOver) {
  EXPECT_EQ(error_of(std::string(1'000'000, '[')), "line 1:65: found nesting deeper than 64 levels, expected less");
}

TEST(Json, WritesWhatItReads) {
  Value root = Value::object();
  root.add("list", Value::array({1, 0.1, "tab\t\"quote\" µ", Value(), true}));
  root.add("nested", Value::object()).add("runs", Value::array({Value::array({1, 2}), Value::array({3})}));
  const std::string pretty = dump(root);
  EXPECT_EQ(pretty,
            "{\n  \"list\": [1, 0.1, \"tab\\t\\\"quote\\\" µ\", null, true],\n"
            "  \"nested\": {\n    \"runs\": [\n      [1, 2],\n      [3]\n    ]\n  }\n}");
  EXPECT_EQ(dump(*parse(pretty)), pretty);
  EXPECT_EQ(dump(root, 0), "{\"list\":[1,0.1,\"tab\\t\\\"quote\\\" µ\",null,true],\"nested\":{\"runs\":[[1,2],[3]]}}");
}

TEST(Json, ReplacesBytesThatAreNotUtf8) { EXPECT_EQ(dump(Value("a\xB5z")), "\"a\uFFFDz\""); }

TEST(Json, EscapesWhatHasToBeAndNothingElse) {
  using namespace std::string_view_literals;
  EXPECT_EQ(dump(Value("\0\x01\x1F\n\r\t\x7F~ /"sv)), R"("\u0000\u0001\u001f\n\r\t\u007f~ /")");
  EXPECT_EQ(dump(Value("µ\\–\"😀")), R"("µ\\–\"😀")");
  EXPECT_EQ(dump(Value("\xC3\xA9\xC3")), "\"é\uFFFD\"");               // cut off
  EXPECT_EQ(dump(Value("\xED\xA0\x80!")), "\"\uFFFD\uFFFD\uFFFD!\"");  // half of a pair
}

TEST(Json, WritesACharacterAlikeWhereverItStands) {
  const auto written = [](const std::string& text) {
    const std::string quoted = dump(Value(text));
    return quoted.substr(1, quoted.size() - 2);
  };
  std::vector<std::string> characters = {"ä", "–", "𝄞", "\xB5", "\xE2\x80"};
  for (int byte = 0; byte < 0x80; ++byte) characters.emplace_back(1, static_cast<char>(byte));
  for (std::size_t before = 0; before <= 17; ++before)
    for (std::size_t behind = 0; behind <= 9; ++behind)
      for (const std::string& c : characters) {
        const std::string first(before, 'a'), last(behind, '~');
        ASSERT_EQ(written(first + c + last), first + written(c) + last) << before << " " << behind;
        ASSERT_EQ(written(first + c + c + last), first + written(c) + written(c) + last);
      }
}

// Of every size, of few digits and of all, and the neighbours of powers of ten, where digits and exponents change.
TEST(Json, WritesTheShortestDigitsThatReadBackTheSame) {
  const auto expected = [](double x) {
    char text[32];
    return std::string(text, std::to_chars(text, std::end(text), x).ptr);
  };
  std::mt19937_64 engine(19);
  std::vector<double> numbers;
  for (int exponent = -320; exponent <= 308; ++exponent) {
    const double power = std::pow(10.0, exponent);
    for (double x : {power, std::nextafter(power, 0.0), std::nextafter(power, 1e308), 1.2 * power, 9.995 * power})
      numbers.push_back(x);
  }
  for (int k = 0; k < 200'000; ++k) {
    const double few = std::round(1e6 * static_cast<double>(engine() % 1'000'000)) / 1e9;
    const double all = std::ldexp(static_cast<double>(engine() >> 11), static_cast<int>(engine() % 120) - 110);
    numbers.push_back(few / std::pow(10.0, static_cast<double>(engine() % 9)));
    numbers.push_back(k % 2 == 0 ? all : -all);
  }
  for (double x : numbers) {
    const double size = std::abs(x);
    if (!std::isfinite(x) || (size < 1e15 && size == std::floor(size))) continue;
    ASSERT_EQ(dump(Value(x)), expected(x));
  }
}

TEST(Json, WritesWholeNumbersWithoutAnExponentUpTo1e15) {
  EXPECT_EQ(dump(Value(0.0)), "0");
  EXPECT_EQ(dump(Value(-0.0)), "-0");
  EXPECT_EQ(dump(Value(-1e6)), "-1000000");
  EXPECT_EQ(dump(Value(999'999'999'999'999.0)), "999999999999999");
  EXPECT_EQ(dump(Value(1e15)), "1e+15");
  EXPECT_EQ(dump(Value(-1e300)), "-1e+300");
  EXPECT_EQ(dump(Value(-0.1)), "-0.1");
}

TEST(Json, RefusesASecondMemberOfAnyNumber) {
  for (const int members : {2, 16, 17, 40}) {
    std::string text = "{";
    for (int k = 0; k + 1 < members; ++k) text += "\"m" + std::to_string(k) + "\": 1, ";
    EXPECT_TRUE(parse(text + "\"other\": 2}")) << members;
    EXPECT_TRUE(error_of(text + "\"m0\": 2}").ends_with("found a second member \"m0\", expected each name once"));
  }
}

TEST(JsonDeathTest, RefusesToWriteWhatIsNotANumber) {
  EXPECT_DEATH(dump(Value(std::numeric_limits<double>::quiet_NaN())), "contract broken");
}

}  // namespace
}  // namespace axiometry::json
