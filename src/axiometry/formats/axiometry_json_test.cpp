// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "axiometry/formats/format.h"
#include "axiometry/formats/test_schema.h"
#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace {

const Format& format() { return *find_format("json"); }

std::string file(const std::string& path) {
  std::ifstream stream(AXIOMETRY_SOURCE_DIR "/" + path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

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

TEST(AxiometryJson, GivesBackEveryFieldAndReading) {
  std::mt19937 random(230);
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (int trial = 0; trial < 200; ++trial) {
    Metadata metadata;
    for (const Field& field : metadata_fields()) {
      if (field.key == "axis.kind" || random() % 3 == 0) continue;
      ASSERT_TRUE(set_field(metadata, field, sample(field, random))) << field.key;
    }
    if (trial % 2) metadata.axis.kind = AxisKind::rotary;
    const std::size_t runs = 1 + random() % 4;
    std::vector<double> deviations;
    for (std::size_t k = 0; k < 2 * 3 * runs; ++k)
      deviations.push_back(random() % 3 == 0 ? none : static_cast<double>(random()) / 1e8 - 20.0);
    for (std::size_t i = 0; i < 3; ++i) deviations[i * runs] = 1.0 / 3.0;
    auto series = Series::make_dense({Position::native(-0.1), Position::native(1.0 / 3.0), Position::native(1e5)}, runs,
                                     deviations);
    ASSERT_TRUE(series);
    const axiometry::Test test{metadata, *series, {}};
    const auto again = format().read(format().write(test));
    ASSERT_TRUE(again) << again.error().to_string() << format().write(test);
    expect_same(test, *again);
    EXPECT_EQ(format().write(*again), format().write(test));
  }
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
  const auto json = format().read(file("examples/iso230-2-table2.json"));
  const auto csv = find_format("csv-long")->read(file("examples/iso230-2-table2.csv"));
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
  EXPECT_EQ(file("schema/axiometry-test.schema.json"), test_schema());
}

}  // namespace
}  // namespace axiometry::formats
