// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "axiometry/formats/format.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/model/fields.h"
#include "axiometry/model/swapped_labels.h"
#include "tests/support/repository_file.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::formats {
namespace {

const Format& format() { return *find_format("json"); }

void expect_same(const axiometry::Test& a, const axiometry::Test& b) {
  for (const Field& field : metadata_fields()) EXPECT_EQ(field.get(a.metadata), field.get(b.metadata)) << field.key;
  ASSERT_TRUE(std::ranges::equal(a.series.targets(), b.series.targets()));
  ASSERT_EQ(a.series.run_count(), b.series.run_count());
  for (Direction d : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < a.series.target_count(); ++i)
      for (std::size_t j = 0; j < a.series.run_count(); ++j)
        EXPECT_EQ(a.series.reading(i, d, j), b.series.reading(i, d, j));
}

FieldValue sample(const Field& field, std::mt19937& random) {
  const auto number = [&] {
    return field.minimum + (field.maximum - field.minimum) * static_cast<double>(random()) / 4294967296.0;
  };
  switch (field.type) {
    case FieldType::text: return std::string("µ \"quoted\" \\ text\n");
    case FieldType::choice: return std::string(field.choices.back());
    case FieldType::number: return number();
    case FieldType::boolean: return false;
    case FieldType::numbers: return std::vector<double>{number(), number()};
    case FieldType::records: {
      std::vector<Cell> record;
      for (const RecordColumn& column : field.columns)
        record.push_back(column.type == FieldType::number ? Cell(21.25) : Cell(std::string(column.title)));
      record.back() = Cell{};
      return Records{record, std::vector<Cell>(field.columns.size())};
    }
  }
  return {};
}

/// A random test of every kind: any metadata, missing readings, one or both directions.
axiometry::Test random_test(std::mt19937& random, bool rotary) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  Metadata metadata;
  for (const Field& field : metadata_fields()) {
    if (field.key == "axis.kind" || random() % 3 == 0) continue;
    EXPECT_TRUE(set_field(metadata, field, sample(field, random))) << field.key;
  }
  if (rotary) metadata.axis.kind = AxisKind::rotary;
  const std::size_t runs = 1 + random() % 4;
  const bool one_way = random() % 4 == 0;
  std::vector<double> deviations;
  for (std::size_t k = 0; k < 2 * 3 * runs; ++k)
    deviations.push_back(random() % 3 == 0 || (one_way && k >= 3 * runs) ? none
                                                                         : static_cast<double>(random()) / 1e8 - 20.0);
  for (std::size_t i = 0; i < 3; ++i) deviations[i * runs] = 1.0 / 3.0;
  deviations[3 * runs - 1] = -1e-7;  // the last run has a reading
  auto series = Series::make_dense({Position::native(-0.1), Position::native(1.0 / 3.0), Position::native(1e5)}, runs,
                                   deviations);
  EXPECT_TRUE(series);
  return {metadata, *std::move(series), {}};
}

TEST(AxiometryJson, GivesBackEveryFieldAndReading) {
  std::mt19937 random(230);
  for (int trial = 0; trial < 200; ++trial) {
    const axiometry::Test test = random_test(random, trial % 2 == 1);
    const auto again = format().read(format().write(test));
    ASSERT_TRUE(again) << again.error().to_string() << format().write(test);
    expect_same(test, *again);
    EXPECT_EQ(format().write(*again), format().write(test));
  }
}

TEST(CsvFormats, GiveBackEveryFieldAndReading) {
  for (const char* id : {"csv-long", "csv-wide"}) {
    std::mt19937 random(2302);
    const Format& csv = *find_format(id);
    for (std::size_t trial = 0; trial < testing_support::as_many(100); ++trial) {
      const axiometry::Test test = random_test(random, trial % 2 == 1);
      const std::string text = csv.write(test);
      EXPECT_EQ((*recognise(text))->id, id);
      const auto again = csv.read(text);
      ASSERT_TRUE(again) << again.error().to_string() << "\n" << text;
      expect_same(test, *again);
      EXPECT_EQ(csv.write(*again), text);
    }
  }
}

TEST(CsvFormats, GiveBackTextsThatALineCannotHold) {
  for (const char* id : {"csv-long", "csv-wide"})
    for (const std::string text :
         {"two\nlines", "ends with ;", " blanks ", "\"in marks\"", "\"", "# mark", "a: b", "[1]"}) {
      axiometry::Test test{{}, *Series::make_dense({Position::native(0), Position::native(1)}, 1, {1, 2, 3, 4}), {}};
      test.metadata.machine.name = text;
      test.metadata.conditions.comment = text;
      test.metadata.equipment = {{text, "", "XL|80", ""}};
      const auto again = find_format(id)->read(find_format(id)->write(test));
      ASSERT_TRUE(again) << again.error().to_string();
      expect_same(test, *again);
    }
}

TEST(AxiometryJson, KeepsTimesInTheOrderOfTheTargets) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto test = format().read(R"({"format": "axiometry-test/1",
    "series": {"unit": "um", "target_unit": "mm", "targets": [10, 0], "up": [[1, 2], [3, 4]], "down": [[5, 6]]},
    "times_s": {"up": [[30, 20.5], [null, 80]]}})");
  ASSERT_TRUE(test) << test.error().to_string();
  ASSERT_EQ(test->times_s.size(), 8u);
  EXPECT_EQ(test->times_s[0], 20.5);  // target 0, run 1
  EXPECT_EQ(test->times_s[1], 80.0);
  EXPECT_EQ(test->times_s[2], 30.0);  // target 10
  EXPECT_TRUE(std::isnan(test->times_s[3]));
  EXPECT_TRUE(std::isnan(test->times_s[4]));
  const auto again = format().read(format().write(*test));
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(format().write(*again), format().write(*test));
  axiometry::Test without = *test;
  without.times_s.assign(8, none);
  EXPECT_FALSE(format().write(without).contains("times_s"));
}

TEST(AxiometryJson, SaysWhereAConvertedTestComesFrom) {
  axiometry::Test test{{}, *Series::make_dense({Position::native(0), Position::native(1)}, 1, {1, 2, 3, 4}), {}};
  test.provenance = {"mill.txt", "ab12", "generic"};
  const auto again = format().read(format().write(test));
  ASSERT_TRUE(again) << again.error().to_string();
  ASSERT_EQ(again->provenance.remarks.size(), 1u);
  EXPECT_EQ(again->provenance.remarks.front().message, "taken from \"mill.txt\", read as \"generic\", SHA-256 ab12");
  EXPECT_TRUE(
      find_format("csv-wide")->write(test).starts_with("# taken from \"mill.txt\", read as generic, SHA-256 ab12\n"));
}

TEST(AxiometryJson, KeepsWhyATestIsNoneOfTheStandard) {
  axiometry::Test test{{}, *Series::make_dense({Position::native(0), Position::native(1)}, 1, {1, 2, 3, 4}), {}};
  test.provenance = {"mill.pos", "ab12", "api-pos", {{false, "a remark"}, {true, "averages only"}}};
  const std::string text = format().write(test);
  const auto again = format().read(text);
  ASSERT_TRUE(again) << again.error().to_string();
  ASSERT_EQ(again->provenance.remarks.size(), 3u);
  EXPECT_TRUE(again->provenance.remarks[2].departs);
  EXPECT_EQ(again->provenance.remarks[2].message, "averages only");
}

/// What was guessed of a table is as uncertain behind its conversion as before.
TEST(AxiometryJson, KeepsWhatTheReaderOfItsSourceHadToRemark) {
  axiometry::Test test{{}, *Series::make_dense({Position::native(0), Position::native(1)}, 1, {1, 2, 3, 4}), {}};
  test.provenance = {"mill.txt", "ab12", "generic", {{false, "the units were guessed"}}};
  auto again = format().read(format().write(test));
  ASSERT_TRUE(again) << again.error().to_string();
  ASSERT_EQ(again->provenance.remarks.size(), 2u);
  EXPECT_FALSE(again->provenance.remarks[1].departs);
  EXPECT_EQ(again->provenance.remarks[1].message, "the units were guessed");
  again->provenance.file = "mill.json";
  const auto twice = format().read(format().write(*again));
  ASSERT_TRUE(twice) << twice.error().to_string();
  EXPECT_EQ(twice->provenance.remarks.size(), 3u) << "and where that was taken from";
}

/// Whether labels are swapped is a value, not the words that tell it.
TEST(AxiometryJson, KeepsThatLabelsOfDirectionAreSwapped) {
  axiometry::Test test{{}, *Series::make_dense({Position::native(0), Position::native(1)}, 1, {1, 2, 3, 4}), {}};
  test.provenance = {"mill.txt", "ab12", "generic", {{false, "the units were guessed"}, swapped_labels_remark()}};
  const std::string text = format().write(test);
  EXPECT_TRUE(text.contains("\"swapped_labels\": true")) << text;
  EXPECT_FALSE(text.contains("rows called")) << "the sentence may be worded otherwise by who reads it";
  const auto again = format().read(text);
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_TRUE(has_swapped_labels(*again));
  ASSERT_EQ(again->provenance.remarks.size(), 3u);
  // Older files have the sentence among their remarks.
  test.provenance.remarks = {{false, std::string(swapped_labels)}};
  const std::string old = format().write(test);
  EXPECT_FALSE(old.contains("\"swapped_labels\""));
  EXPECT_TRUE(has_swapped_labels(*format().read(old)));
  EXPECT_EQ(format().read(old)->provenance.remarks.size(), 2u);
}

TEST(AxiometryJson, KeepsARunWithoutAnyReading) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto series =
      Series::make_dense({Position::native(0), Position::native(1)}, 2, {none, none, none, none, 1, none, 2, none});
  const axiometry::Test test{{}, *series, {}};
  const auto again = format().read(format().write(test));
  ASSERT_TRUE(again) << again.error().to_string();
  EXPECT_EQ(again->series.run_count(), 2u);
}

TEST(AxiometryJson, ReadsTheExampleLikeItsCsv) {
  const auto json = format().read(testing_support::repository_file("examples/iso230-2-table2.json"));
  const auto csv = find_format("csv-long")->read(testing_support::repository_file("examples/iso230-2-table2.csv"));
  ASSERT_TRUE(json) << json.error().to_string();
  ASSERT_TRUE(csv) << csv.error().to_string();
  expect_same(*json, *csv);
}

TEST(AxiometryJson, SortsTargetsAndTakesThemFromMeasuredPositions) {
  const auto test = format().read(R"({"format": "axiometry-test/1", "$schema": "x",
    "series": {"quantity": "position", "unit": "mm", "target_unit": "mm", "targets": [10, 0],
               "down": [[10.001, null], [9.999, 0.002]]}})");
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.targets()[0].in_native(), 0.0);
  EXPECT_FALSE(test->series.reading(0, Direction::down, 0));
  EXPECT_NEAR(test->series.reading(0, Direction::down, 1)->in_native(), 2.0, 1e-9);
  EXPECT_NEAR(test->series.reading(1, Direction::down, 0)->in_native(), 1.0, 1e-9);
  EXPECT_FALSE(test->series.has(Direction::up));
}

TEST(AxiometryJson, TheSchemaInTheRepositoryIsTheOneTheProgramPrints) {
  EXPECT_EQ(testing_support::repository_file("schema/axiometry-test.schema.json"), test_schema());
}

}  // namespace
}  // namespace axiometry::formats
