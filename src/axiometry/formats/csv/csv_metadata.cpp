// SPDX-License-Identifier: Apache-2.0
//
// The lines above a CSV table as metadata of its test.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_preamble.h"
#include "axiometry/formats/csv/csv_values.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace {

/// Decimal comma to point, in the fields that hold numbers only.
std::string with_point(const Field& field, std::string value, char decimal_mark) {
  const bool numeric = field.type == FieldType::number || field.type == FieldType::numbers;
  if (numeric && decimal_mark == ',' && value.find('.') == std::string::npos) std::ranges::replace(value, ',', '.');
  return value;
}

/// Records of fields that may be given again and again. They are put into the metadata when all are known: one by one
/// each would copy all before it.
class GatheredRecords {
 public:
  Result<void> add(const Field& field, std::string_view value, TextPosition at) {
    Metadata alone;
    AXIOMETRY_TRY_VOID(set_line_value(alone, field, value));
    const FieldValue read = field.get(alone);
    auto& [records, last] = records_[&field];
    last = at;
    if (const auto* one = std::get_if<Records>(&read))
      records.insert(records.end(), one->begin(), one->end());
    else
      records.clear();  // an empty line takes back what was given before it
    return {};
  }

  Result<void> put_into(Metadata& metadata) {
    for (auto& [field, given] : records_)
      if (!given.records.empty())
        AXIOMETRY_TRY_VOID(placed(set_field(metadata, *field, std::move(given.records)), given.last));
    return {};
  }

 private:
  struct Given {
    Records records;
    TextPosition last;
  };
  std::map<const Field*, Given> records_;
};

}  // namespace

Result<Metadata> metadata_of(const Preamble& preamble, AxisKind kind, char decimal_mark) {
  Metadata metadata;
  GatheredRecords records;
  std::vector<const MetadataLine*> seen;
  for (const MetadataLine& line : preamble.metadata) {
    const Field& field = *find_field(line.key);
    const auto before =
        std::ranges::find(seen, line.key, [](const MetadataLine* l) -> const std::string& { return l->key; });
    if (before != seen.end() && line.key == "test.comment") {
      metadata.conditions.comment += "; " + line.value;
      continue;
    }
    if (before != seen.end() && field.type != FieldType::records)
      return fail(
          fmt::format("found a second value of {}, expected only that on line {}", line.key, (*before)->at.line),
          line.at);
    if (before == seen.end()) seen.push_back(&line);
    if (field.type == FieldType::records) {
      AXIOMETRY_TRY_VOID(placed(records.add(field, line.value, line.at), line.at));
      continue;
    }
    AXIOMETRY_TRY_VOID(placed(set_line_value(metadata, field, with_point(field, line.value, decimal_mark)), line.at));
    if (line.key == "axis.kind" && metadata.axis.kind != kind)
      return fail(fmt::format("found axis.kind = {} and columns in units of a {} axis, expected the same",
                              text::quoted(line.value), kind == AxisKind::linear ? "linear" : "rotary"),
                  line.at);
  }
  AXIOMETRY_TRY_VOID(records.put_into(metadata));
  metadata.axis.kind = kind;
  return metadata;
}

}  // namespace axiometry::formats
