// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/test/metadata_json.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/test/metadata_place.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

std::string_view group_of(std::string_view key) { return key.substr(0, key.find('.')); }
std::string_view member_of(std::string_view key) {
  const std::size_t dot = key.find('.');
  return dot == std::string_view::npos ? std::string_view() : key.substr(dot + 1);
}

void put_records(json::Place place, const Field& field, const Records& records) {
  json::List list(place);
  for (const auto& record : records) {
    json::Object item = list.object();
    for (std::size_t c = 0; c < record.size(); ++c) {
      if (const auto* s = std::get_if<std::string>(&record[c])) item.add(field.columns[c].key, *s);
      if (const auto* x = std::get_if<double>(&record[c])) item.add(field.columns[c].key, *x);
    }
  }
}

void put_field(json::Place place, const Field& field, const FieldValue& value) {
  if (const auto* s = std::get_if<std::string>(&value)) return place.put(*s);
  if (const auto* x = std::get_if<double>(&value)) return place.put(*x);
  if (const auto* b = std::get_if<bool>(&value)) return place.put(*b);
  if (const auto* records = std::get_if<Records>(&value)) return put_records(place, field, *records);
  json::List list(place);
  for (double x : std::get<std::vector<double>>(value)) list.push(x);
}

std::unexpected<Error> unknown(std::string_view what, std::string_view name, const std::vector<std::string_view>& known,
                               TextPosition at) {
  const auto near = text::nearest(name, known);
  return fail(fmt::format("found the unknown member {} in {}, expected {}", text::quoted(name), what,
                          near ? fmt::format("perhaps {}", text::quoted(*near))
                               : fmt::format("one of {}", fmt::join(known, ", "))),
              at);
}

std::unexpected<Error> wrong_kind(std::string_view key, const Value& value, std::string_view expected) {
  return fail(fmt::format("found {} that is {} {}, expected {}", key,
                          value.is(Kind::array) || value.is(Kind::object) ? "an" : "a", json::kind_name(value.kind()),
                          expected),
              value.at());
}

Result<Cell> cell_from(const Field& field, const RecordColumn& column, const Value& value) {
  const bool number = column.type == FieldType::number;
  if (value.is(Kind::null)) return Cell{};
  if (number && value.is(Kind::number)) return Cell(value.number());
  if (!number && value.is(Kind::text)) return value.text().empty() ? Cell{} : Cell(value.text());
  return wrong_kind(fmt::format("{}.{}", field.key, column.key), value, number ? "a number" : "a string");
}

Result<FieldValue> records_from(const Field& field, const Value& value) {
  if (!value.is(Kind::array)) return wrong_kind(field.key, value, "an array of objects");
  std::vector<std::string_view> columns;
  for (const RecordColumn& column : field.columns) columns.push_back(column.key);
  Records records;
  for (const Value& item : value.items()) {
    if (!item.is(Kind::object)) return wrong_kind(fmt::format("an item of {}", field.key), item, "an object");
    std::vector<Cell>& record = records.emplace_back(columns.size());
    for (const auto& [name, cell] : item.members()) {
      const auto column = std::ranges::find(columns, std::string_view(name));
      if (column == columns.end()) return unknown(field.key, name, columns, cell.at());
      const auto c = static_cast<std::size_t>(column - columns.begin());
      AXIOMETRY_TRY(record[c], cell_from(field, field.columns[c], cell));
    }
  }
  return records.empty() ? FieldValue{} : FieldValue(std::move(records));
}

Result<FieldValue> numbers_from(const Field& field, const Value& value) {
  if (!value.is(Kind::array)) return wrong_kind(field.key, value, "an array of numbers");
  std::vector<double> numbers;
  for (const Value& item : value.items()) {
    if (!item.is(Kind::number)) return wrong_kind(fmt::format("an item of {}", field.key), item, "a number");
    numbers.push_back(item.number());
  }
  return numbers.empty() ? FieldValue{} : FieldValue(std::move(numbers));
}

Result<FieldValue> field_value_from(const Field& field, const Value& value) {
  if (value.is(Kind::null)) return FieldValue{};
  switch (field.type) {
    case FieldType::text:
      if (!value.is(Kind::text)) return wrong_kind(field.key, value, "a string");
      return value.text().empty() ? FieldValue{} : FieldValue(value.text());
    case FieldType::choice:
      if (!value.is(Kind::text))
        return wrong_kind(field.key, value, fmt::format("one of {}", fmt::join(field.choices, ", ")));
      return FieldValue(value.text());
    case FieldType::number:
      if (!value.is(Kind::number)) return wrong_kind(field.key, value, "a number");
      return FieldValue(value.number());
    case FieldType::boolean:
      if (!value.is(Kind::boolean)) return wrong_kind(field.key, value, "true or false");
      return FieldValue(value.boolean());
    case FieldType::numbers: return numbers_from(field, value);
    case FieldType::records: return records_from(field, value);
  }
  return FieldValue{};
}

Result<void> take(Metadata& metadata, const Field& field, const Value& value) {
  AXIOMETRY_TRY(FieldValue field_value, field_value_from(field, value));
  return placed(set_field(metadata, field, std::move(field_value)), value.at());
}

std::vector<std::string_view> members_of_group(std::string_view group) {
  std::vector<std::string_view> names;
  for (const Field& field : metadata_fields())
    if (group_of(field.key) == group && !member_of(field.key).empty()) names.push_back(member_of(field.key));
  return names;
}

Result<void> take_group(Metadata& metadata, std::string_view group, const Value& value) {
  if (value.is(Kind::null)) return {};
  if (!value.is(Kind::object)) return wrong_kind(group, value, "an object");
  for (const auto& [name, member] : value.members()) {
    const Field* field = find_field(fmt::format("{}.{}", group, name));
    if (field == nullptr) return unknown(group, name, members_of_group(group), member.at());
    AXIOMETRY_TRY_VOID(take(metadata, *field, member));
  }
  return {};
}

}  // namespace

void add_metadata(json::Object& object, const Metadata& metadata) {
  struct Given {
    const Field* field;
    FieldValue value;
    bool told = false;
  };
  std::vector<Given> given;
  for (const Field& field : metadata_fields())
    if (FieldValue value = field.get(metadata); !std::holds_alternative<std::monostate>(value))
      given.push_back({&field, std::move(value)});
  // A field's group may come in pieces in the table: all of it stands where its first member does.
  for (auto first = given.begin(); first != given.end(); ++first) {
    if (first->told) continue;
    if (member_of(first->field->key).empty()) {
      put_field(object.at(first->field->key), *first->field, first->value);
      continue;
    }
    const std::string_view group = group_of(first->field->key);
    json::Object members = object.object(group);
    for (auto other = first; other != given.end(); ++other) {
      if (group_of(other->field->key) != group) continue;
      other->told = true;
      put_field(members.at(member_of(other->field->key)), *other->field, other->value);
    }
  }
}

void add_metadata(Value& object, const Metadata& metadata) {
  Value of_metadata = json::tree_of([&](json::Place place) {
    json::Object members(place);
    add_metadata(members, metadata);
  });
  for (auto& [name, value] : of_metadata.members()) object.add(name, value);
}

Result<Metadata> metadata_from(const Value& object, std::span<const std::string_view> others) {
  Metadata metadata;
  for (const auto& [name, value] : object.members()) {
    if (std::ranges::find(others, std::string_view(name)) != others.end()) continue;
    if (const Field* field = find_field(name); field != nullptr && member_of(name).empty()) {
      AXIOMETRY_TRY_VOID(take(metadata, *field, value));
    } else if (name.find('.') == std::string::npos && !members_of_group(name).empty()) {
      AXIOMETRY_TRY_VOID(take_group(metadata, name, value));
    } else {
      std::vector<std::string_view> known(others.begin(), others.end());
      for (const Field& f : metadata_fields())
        if (std::ranges::find(known, group_of(f.key)) == known.end()) known.push_back(group_of(f.key));
      return unknown("the test", name, known, value.at());
    }
  }
  return metadata;
}

}  // namespace axiometry::formats
