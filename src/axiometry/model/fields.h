// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/metadata.h"

/// The vocabulary of a test's metadata: one row for every member of Metadata. The JSON test format and
/// its schema, the `# key: value` lines of CSV, `--set key=value`, the identification in reports and
/// the search for items that clause 8.1 wants and a test lacks all read this one table.
namespace axiometry {

enum class FieldType { text, number, boolean, choice, numbers, records };

/// One column of a record list, such as the serial number in the list of equipment.
struct RecordColumn {
  std::string_view key;
  std::string_view title;
  FieldType type;           ///< text or number
  std::string_view unit;    ///< unit of the column, where it holds numbers
  bool shown_empty = true;  ///< whether a report shows it where no record states it
};

using Cell = std::variant<std::monostate, std::string, double>;
using Records = std::vector<std::vector<Cell>>;  ///< rows; each has one cell per column

/// A member's value in the table's unit; monostate when it is not given.
using FieldValue = std::variant<std::monostate, std::string, double, bool, std::vector<double>, Records>;

struct Field {
  std::string_view key;    ///< "machine.serial_number": group and member, also the JSON path
  std::string_view title;  ///< "Machine serial number"
  FieldType type = FieldType::text;
  std::string_view unit_linear;  ///< unit of numbers on a linear axis: "mm/min"; empty without unit
  std::string_view unit_rotary;  ///< the same on a rotary axis; often equal
  std::string_view clause;       ///< "8.1", "A.5"; empty where the standard does not ask for it
  enum class Wanted { no, always, linear, rotary, with_nde } wanted = Wanted::no;  ///< in the report, by clause 8.1
  double minimum = 0.0;                                                            ///< smallest number allowed
  double maximum = 0.0;
  std::span<const std::string_view> choices;  ///< words of a choice
  std::span<const RecordColumn> columns;      ///< columns of a list of records
  std::string_view description;               ///< one sentence for schema and manual
  FieldValue (*get)(const Metadata&);
  void (*put)(Metadata&, const FieldValue&);  ///< unchecked; use set_field()
};

/// Every field, in the order in which reports list them.
std::span<const Field> metadata_fields();

/// nullptr when there is no such key.
const Field* find_field(std::string_view key);

/// Whether the metadata hold a value for the field.
bool is_given(const Field& field, const Metadata& metadata);

/// Whether clause 8.1 asks for the field in the report of such a test.
bool is_wanted(const Field& field, const Metadata& metadata);

/// Unit of a field's numbers on this kind of axis.
std::string_view field_unit(const Field& field, AxisKind kind);

/// Puts a value into the metadata. Fails when the type is not the field's, a number is not finite or
/// outside minimum..maximum, a text is not among the choices, or a record has the wrong cells.
Result<void> set_field(Metadata& metadata, const Field& field, FieldValue value);

/// Puts a value given as text, as in `# key: value` and `--set`: numbers with a decimal point (the
/// caller translates a comma), lists separated by blanks, booleans as true/false/yes/no, one record
/// per call with cells separated by `|`. Fails as set_field() does, and on an unknown key (the message
/// names the nearest one).
Result<void> set_field_text(Metadata& metadata, std::string_view key, std::string_view text);

/// The value as a person reads it, numbers without unit, "" when not given.
std::string field_text(const Field& field, const FieldValue& value);

}  // namespace axiometry
