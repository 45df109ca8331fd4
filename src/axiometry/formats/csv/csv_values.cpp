// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/csv_values.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_columns.h"
#include "axiometry/formats/csv/csv_preamble.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

/// A record from an array of strings, numbers and nulls; nothing when the array is none.
std::optional<std::vector<Cell>> record_in(const Value& array, const Field& field) {
  if (array.items().size() != field.columns.size()) return std::nullopt;
  std::vector<Cell> record;
  for (const Value& item : array.items()) {
    if (item.is(Kind::text))
      record.emplace_back(item.text());
    else if (item.is(Kind::number))
      record.emplace_back(item.number());
    else if (item.is(Kind::null))
      record.emplace_back();
    else
      return std::nullopt;
  }
  return record;
}

std::string record_json(const std::vector<Cell>& record) {
  Value array = Value::array();
  for (const Cell& cell : record) {
    if (const auto* s = std::get_if<std::string>(&cell))
      array.push(*s);
    else if (const auto* x = std::get_if<double>(&cell))
      array.push(*x);
    else
      array.push(Value());
  }
  return json::dump(array, 0);
}

std::string json_of(const FieldValue& value) {
  if (const auto* records = std::get_if<Records>(&value)) return record_json(records->front());
  if (const auto* s = std::get_if<std::string>(&value)) return json::dump(Value(*s), 0);
  return "";
}

/// Whether the reader makes the value of the line again.
bool survives(const std::string& line, const Field& field, const FieldValue& value, AxisKind kind) {
  const auto preamble = read_preamble(fmt::format("{}{}\n", line, long_table_head(AxisKind::linear)));
  if (!preamble || preamble->metadata.size() != 1) return false;
  const auto metadata = metadata_of(*preamble, kind, '.');
  return metadata && field.get(*metadata) == value;
}

bool has_formula(std::string_view line) { return text::no_formula(line) != line; }

/// The same JSON with \\u003d for the sign by which a spreadsheet would begin a formula there. Only in strings: what is
/// outside of them is a number.
std::string without_formulas(const std::string& written) {
  const std::string guarded = text::no_formula(written);
  std::string safe;
  bool in_string = false;
  bool escaped = false;  // by a backslash in front
  for (std::size_t k = 0, g = 0; k < written.size(); ++k, ++g) {
    const bool guard = guarded[g] != written[k];
    if (guard) ++g;
    if (written[k] == '"' && !escaped) in_string = !in_string;
    escaped = written[k] == '\\' && !escaped;
    safe += guard && in_string ? fmt::format("\\u{:04x}", static_cast<unsigned char>(written[k]))
                               : std::string(1, written[k]);
  }
  return safe;
}

/// Plain, or as JSON where that would not be read again as it was, or where a spreadsheet that parts the line at a
/// comma or a semicolon would find a formula behind it.
std::string line_of(const Field& field, const FieldValue& value, AxisKind kind) {
  const std::string plain = fmt::format("# {}: {}\n", field.key, field_text(field, value));
  const std::string quoted = json_of(value);
  const bool plain_will_do = survives(plain, field, value, kind) && (quoted.empty() || !has_formula(plain));
  return plain_will_do ? plain : fmt::format("# {}: {}\n", field.key, without_formulas(quoted));
}

}  // namespace

Result<void> set_line_value(Metadata& metadata, const Field& field, std::string_view value) {
  const bool quoted =
      field.type == FieldType::text && value.size() >= 2 && value.starts_with('"') && value.ends_with('"');
  const bool listed = field.type == FieldType::records && value.starts_with('[') && value.ends_with(']');
  if (quoted || listed) {
    const auto parsed = json::parse(value);
    if (parsed && quoted && parsed->is(Kind::text)) return set_field(metadata, field, parsed->text());
    if (parsed && listed && parsed->is(Kind::array))
      if (auto record = record_in(*parsed, field)) {
        const FieldValue before = field.get(metadata);
        Records all = std::holds_alternative<Records>(before) ? std::get<Records>(before) : Records{};
        all.push_back(std::move(*record));
        return set_field(metadata, field, std::move(all));
      }
  }
  return set_field_text(metadata, field.key, value);
}

std::string metadata_lines(const Test& test) {
  std::string lines;
  const Provenance& source = test.provenance;
  if (!source.file.empty())
    lines += text::no_formula(fmt::format("# taken from {}, read as {}{}{}", text::quoted(source.file), source.format,
                                          source.sha256.empty() ? "" : ", SHA-256 ", source.sha256)) +
             "\n";
  for (const SourceRemark& remark : source.remarks) {
    // Those that say what the readings themselves say are found in them again.
    if (remark.departs || remark.of_swapped_labels) continue;
    std::string_view message = remark.message;
    if (message.starts_with(first_read)) message.remove_prefix(first_read.size());
    std::string line = fmt::format("# {}: {}", source_remark_key, message);
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    lines += text::no_formula(line) + "\n";
  }
  const AxisKind kind = test.metadata.axis.kind;
  for (const Field& field : metadata_fields()) {
    const FieldValue value = field.get(test.metadata);
    if (std::holds_alternative<std::monostate>(value)) continue;
    if (const auto* records = std::get_if<Records>(&value)) {
      for (const auto& record : *records) lines += line_of(field, Records{record}, kind);
    } else {
      lines += line_of(field, value, kind);
    }
  }
  return lines;
}

}  // namespace axiometry::formats
