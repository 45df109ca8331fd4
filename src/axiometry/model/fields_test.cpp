// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/fields.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "axiometry/base/read_budget.h"

namespace axiometry {
namespace {

using testing::HasSubstr;

TEST(Fields, HaveUniqueKeys) {
  std::set<std::string_view> keys;
  for (const Field& field : metadata_fields()) EXPECT_TRUE(keys.insert(field.key).second) << field.key;
}

FieldValue sample(const Field& field) {
  switch (field.type) {
    case FieldType::text: return std::string("some text");
    case FieldType::choice: return std::string(field.choices.back());
    case FieldType::number: return field.minimum + (field.maximum - field.minimum) / 4;
    case FieldType::boolean: return true;
    case FieldType::numbers: return std::vector<double>{0.5, 2.0};
    case FieldType::records: {
      std::vector<Cell> record;
      for (const RecordColumn& column : field.columns)
        record.push_back(column.type == FieldType::number ? Cell(21.5) : Cell(std::string(column.key)));
      return Records{record};
    }
  }
  return {};
}

TEST(Fields, GiveBackWhatWasPutAndNothingElseChanges) {
  for (const Field& field : metadata_fields()) {
    Metadata metadata;
    ASSERT_TRUE(set_field(metadata, field, sample(field))) << field.key;
    EXPECT_EQ(field.get(metadata), sample(field)) << field.key;
    const Metadata untouched;
    for (const Field& other : metadata_fields()) {
      if (other.key == field.key) continue;
      EXPECT_EQ(other.get(metadata), other.get(untouched)) << field.key << " changed " << other.key;
    }
    ASSERT_TRUE(set_field(metadata, field, FieldValue{}));
    EXPECT_EQ(field.get(metadata), field.get(untouched)) << field.key;
  }
}

TEST(Fields, ReadTextAsItStandsInACsvHeader) {
  Metadata m;
  ASSERT_TRUE(set_field_text(m, "machine.name", " Mill 5 "));
  ASSERT_TRUE(set_field_text(m, "test.feed", "1000"));
  ASSERT_TRUE(set_field_text(m, "nde.applied", "yes"));
  ASSERT_TRUE(set_field_text(m, "test.tool_offset_mm", "0 0 120"));
  ASSERT_TRUE(set_field_text(m, "axis.kind", "Rotary"));
  ASSERT_TRUE(set_field_text(m, "sensors", "machine | table, centre | 21.8 | 22.9"));
  ASSERT_TRUE(set_field_text(m, "sensors", "air | | 20.6"));
  EXPECT_EQ(m.machine.name, "Mill 5");
  EXPECT_EQ(m.conditions.feed, 1000.0);
  EXPECT_EQ(m.nde.applied, true);
  EXPECT_EQ(m.conditions.tool_offset_mm, (std::vector<double>{0, 0, 120}));
  EXPECT_EQ(m.axis.kind, AxisKind::rotary);
  ASSERT_EQ(m.environment.sensors.size(), 2u);
  EXPECT_EQ(m.environment.sensors[0].end->in_celsius(), 22.9);
  EXPECT_FALSE(m.environment.sensors[1].end);
}

TEST(Fields, TakeNoMoreRecordsThanTheBudgetAllows) {
  Metadata metadata;
  for (std::size_t k = 0; k < read_budget::records; ++k)
    ASSERT_TRUE(set_field_text(metadata, "equipment", fmt::format("Probe {} | Maker | Type | {}", k, k)));
  const auto refused = set_field_text(metadata, "equipment", "One more | Maker | Type | 1");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "found more than 256 records of equipment, expected fewer");
  EXPECT_EQ(metadata.equipment.size(), read_budget::records);
}

TEST(Fields, SayWhatWasFoundAndExpected) {
  Metadata m;
  const auto message = [&](std::string_view key, std::string_view text) {
    auto result = set_field_text(m, key, text);
    return result ? std::string() : result.error().message;
  };
  EXPECT_THAT(message("machin.name", "x"), HasSubstr("perhaps machine.name"));
  EXPECT_EQ(message("test.dwell_s", "5 s"), "found test.dwell_s = \"5 s\", expected a number");
  EXPECT_EQ(message("test.dwell_s", "-1"), "found test.dwell_s = -1, expected a number from 0 to 1e+06");
  EXPECT_EQ(message("environment.air_pressure_end_kPa", "1013"),
            "found environment.air_pressure_end_kPa = 1013, expected a number from 20 to 150: is it hPa?");
  EXPECT_EQ(message("nde.applied", "maybe"), "found nde.applied = \"maybe\", expected yes or no");
  EXPECT_EQ(message("axis.kind", "curved"), "found axis.kind = \"curved\", expected one of linear, rotary");
  EXPECT_EQ(message("equipment", "a|b|c|d|e|f|g|h"), "found 8 cells in equipment, expected at most 7 separated by |");
}

}  // namespace
}  // namespace axiometry
