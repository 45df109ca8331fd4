// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <unordered_map>

#include "axiometry/base/counted.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry {

const Field* find_field(std::string_view key) {
  static const std::unordered_map<std::string_view, const Field*> by_key = [] {
    std::unordered_map<std::string_view, const Field*> all;
    for (const Field& field : metadata_fields()) all.emplace(field.key, &field);  // the first of a key
    return all;
  }();
  const auto found = by_key.find(key);
  return found == by_key.end() ? nullptr : found->second;
}

bool is_given(const Field& field, const Metadata& metadata) {
  return !std::holds_alternative<std::monostate>(field.get(metadata));
}

bool is_wanted(const Field& field, const Metadata& metadata) {
  switch (field.wanted) {
    case Field::Wanted::no: return false;
    case Field::Wanted::always: return true;
    case Field::Wanted::linear: return metadata.axis.kind == AxisKind::linear;
    case Field::Wanted::rotary: return metadata.axis.kind == AxisKind::rotary;
    case Field::Wanted::with_nde: return metadata.nde.applied == true;
  }
  return false;
}

std::string_view field_unit(const Field& field, AxisKind kind) {
  return kind == AxisKind::linear ? field.unit_linear : field.unit_rotary;
}

namespace {

std::string_view type_name(const FieldValue& value) {
  constexpr std::string_view names[] = {"nothing",           "a text",           "a number", "a truth value",
                                        "a list of numbers", "a list of records"};
  return names[value.index()];
}

std::string_view expected_type(FieldType type) {
  switch (type) {
    case FieldType::text: return "a text";
    case FieldType::number: return "a number";
    case FieldType::boolean: return "true or false";
    case FieldType::choice: return "one of its words";
    case FieldType::numbers: return "a list of numbers";
    case FieldType::records: return "a list of records";
  }
  return "";
}

bool has_type(const FieldValue& value, FieldType type) {
  switch (type) {
    case FieldType::text:
    case FieldType::choice: return std::holds_alternative<std::string>(value);
    case FieldType::number: return std::holds_alternative<double>(value);
    case FieldType::boolean: return std::holds_alternative<bool>(value);
    case FieldType::numbers: return std::holds_alternative<std::vector<double>>(value);
    case FieldType::records: return std::holds_alternative<Records>(value);
  }
  return false;
}

Result<void> check_number(const Field& field, double x) {
  const auto within = [&](double y) { return std::isfinite(y) && y >= field.minimum && y <= field.maximum; };
  if (within(x)) return {};
  const bool hectopascal = field.key.ends_with("_kPa") && within(x / 10.0);
  return fail(fmt::format("found {} = {}, expected a number from {} to {}{}", field.key, format_exact(x),
                          format_exact(field.minimum), format_exact(field.maximum), hectopascal ? ": is it hPa?" : ""));
}

Result<void> check_choice(const Field& field, const std::string& word) {
  if (std::ranges::find(field.choices, word) != field.choices.end()) return {};
  return fail(
      fmt::format("found {} = {}, expected one of {}", field.key, text::quoted(word), fmt::join(field.choices, ", ")));
}

Result<void> check_records(const Field& field, const Records& records) {
  if (records.size() > read_budget::records)
    return fail(fmt::format("found more than {} records of {}, expected fewer", read_budget::records, field.key));
  for (const auto& record : records) {
    if (record.size() != field.columns.size())
      return fail(fmt::format("found a record of {} with {}, expected {}", field.key, counted(record.size(), "cell"),
                              field.columns.size()));
    for (std::size_t c = 0; c < record.size(); ++c) {
      const RecordColumn& column = field.columns[c];
      const bool number = std::holds_alternative<double>(record[c]);
      const bool text = std::holds_alternative<std::string>(record[c]);
      if ((number && column.type != FieldType::number) || (text && column.type == FieldType::number))
        return fail(fmt::format("found {}.{} that is not {}", field.key, column.key, expected_type(column.type)));
      if (number && !(std::abs(std::get<double>(record[c])) <= 1e6))
        return fail(fmt::format("found {}.{} = {}, expected a magnitude up to 1e6", field.key, column.key,
                                std::get<double>(record[c])));
    }
  }
  return {};
}

Result<double> number_from(const Field& field, std::string_view word) {
  if (auto x = parse_number(word)) return *x;
  return fail(fmt::format("found {} = {}, expected a number", field.key, text::quoted(word)));
}

Result<FieldValue> record_from(const Field& field, std::string_view line) {
  const auto cells = text::split(line, '|');
  if (cells.size() > field.columns.size())
    return fail(fmt::format("found {} cells in {}, expected at most {} separated by |", cells.size(), field.key,
                            field.columns.size()));
  std::vector<Cell> record(field.columns.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const std::string_view cell = text::trim(cells[c]);
    if (cell.empty()) continue;
    if (field.columns[c].type == FieldType::number) {
      AXIOMETRY_TRY(record[c], number_from(field, cell));
    } else {
      record[c] = std::string(cell);
    }
  }
  return Records{record};
}

Result<FieldValue> value_from_text(const Field& field, std::string_view line) {
  const std::string_view value = text::trim(line);
  if (value.empty()) return FieldValue{};
  switch (field.type) {
    case FieldType::text: return FieldValue(std::string(value));
    case FieldType::choice: return FieldValue(text::to_lower(value));
    case FieldType::number: {
      AXIOMETRY_TRY(const double x, number_from(field, value));
      return FieldValue(x);
    }
    case FieldType::boolean: {
      const std::string word = text::to_lower(value);
      if (word == "true" || word == "yes" || word == "1") return FieldValue(true);
      if (word == "false" || word == "no" || word == "0") return FieldValue(false);
      return fail(fmt::format("found {} = {}, expected yes or no", field.key, text::quoted(value)));
    }
    case FieldType::numbers: {
      std::vector<double> numbers;
      for (std::string_view word : text::words(value)) {
        AXIOMETRY_TRY(const double x, number_from(field, word));
        numbers.push_back(x);
      }
      return FieldValue(std::move(numbers));
    }
    case FieldType::records: return record_from(field, value);
  }
  return FieldValue{};
}

std::string cell_text(const Cell& cell) {
  if (const auto* s = std::get_if<std::string>(&cell)) return *s;
  if (const auto* x = std::get_if<double>(&cell)) return format_exact(*x);
  return "";
}

}  // namespace

Result<void> set_field(Metadata& metadata, const Field& field, FieldValue value) {
  if (!std::holds_alternative<std::monostate>(value)) {
    if (!has_type(value, field.type))
      return fail(
          fmt::format("found {} that is {}, expected {}", field.key, type_name(value), expected_type(field.type)));
    if (const auto* x = std::get_if<double>(&value)) AXIOMETRY_TRY_VOID(check_number(field, *x));
    if (field.type == FieldType::choice) AXIOMETRY_TRY_VOID(check_choice(field, std::get<std::string>(value)));
    if (const auto* numbers = std::get_if<std::vector<double>>(&value))
      for (double x : *numbers) AXIOMETRY_TRY_VOID(check_number(field, x));
    if (const auto* records = std::get_if<Records>(&value)) AXIOMETRY_TRY_VOID(check_records(field, *records));
  }
  field.put(metadata, value);
  return {};
}

Result<void> set_field_text(Metadata& metadata, std::string_view key, std::string_view line) {
  const Field* field = find_field(key);
  if (field == nullptr) {
    std::vector<std::string_view> keys;
    for (const Field& f : metadata_fields()) keys.push_back(f.key);
    const auto near = text::nearest(key, keys);
    return fail(fmt::format(
        "found the unknown key {}, expected {}", text::quoted(key),
        near ? fmt::format("perhaps {}", *near) : std::string("one that 'axiometry formats metadata' lists")));
  }
  AXIOMETRY_TRY(FieldValue value, value_from_text(*field, line));
  if (field->type == FieldType::records && std::holds_alternative<Records>(value)) {
    const FieldValue before = field->get(metadata);
    Records all = std::holds_alternative<Records>(before) ? std::get<Records>(before) : Records{};
    all.push_back(std::get<Records>(value).front());
    value = std::move(all);
  }
  return set_field(metadata, *field, std::move(value));
}

std::string field_text(const Field& field, const FieldValue& value) {
  if (std::holds_alternative<std::monostate>(value)) return "";
  switch (field.type) {
    case FieldType::text:
    case FieldType::choice: return std::get<std::string>(value);
    case FieldType::number: return format_exact(std::get<double>(value));
    case FieldType::boolean: return std::get<bool>(value) ? "yes" : "no";
    case FieldType::numbers: {
      std::string result;
      for (double x : std::get<std::vector<double>>(value)) result += (result.empty() ? "" : " ") + format_exact(x);
      return result;
    }
    case FieldType::records: {
      std::string result;
      for (const auto& record : std::get<Records>(value)) {
        if (!result.empty()) result += "; ";
        std::size_t last = record.size();
        while (last > 1 && !field.columns[last - 1].shown_empty && cell_text(record[last - 1]).empty()) --last;
        for (std::size_t c = 0; c < last; ++c) result += (c == 0 ? "" : " | ") + cell_text(record[c]);
      }
      return result;
    }
  }
  return "";
}

}  // namespace axiometry
