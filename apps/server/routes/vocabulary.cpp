// SPDX-License-Identifier: Apache-2.0
#include "server/routes/vocabulary.h"

#include <array>
#include <string_view>
#include <utility>

#include "axiometry/formats/compensation/compensation.h"
#include "axiometry/formats/format.h"
#include "axiometry/model/fields.h"
#include "axiometry/model/plan.h"
#include "axiometry/nc/dialect.h"
#include "axiometry/report/writer.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/tracking/instruments/tracker_kinds.h"
#include "axiometry/uncertainty/conformity.h"
#include "axiometry/volumetric/field/line_prediction.h"

namespace axiometry::server {
namespace {

using json::Value;

struct Named {
  std::string_view id;
  std::string_view title;
};

/// As --correct takes them (standards/readings/reading_correction.h), in the order in which they are made.
constexpr std::array corrections = {
    Named{"sign", "Sense of counting of the sensor"},
    Named{"gain", "Gain of the instrument"},
    Named{"air=ciddor", "Refractive index of air after Ciddor"},
    Named{"air=edlen", "Refractive index of air after Edlén"},
    Named{"dead-path", "Dead path of the laser beam"},
    Named{"nde", "Differential thermal expansion"},
    Named{"drift", "Drift over the course of the test"},
};

constexpr std::array cycles = {
    std::pair{TestCycle::standard, std::string_view("Standard test cycle: all targets up, then all down, run by run")},
    std::pair{TestCycle::step, std::string_view("Step cycle (Annex B): all runs at one target, then the next")},
    std::pair{TestCycle::pilgrim, std::string_view("Pilgrim step: all runs up target by target, then all down")},
    std::pair{TestCycle::unidirectional, std::string_view("Unidirectional: all targets up, run by run")},
    std::pair{TestCycle::user_defined, std::string_view("User-defined: approaches in a given order")},
};

using Rule = uncertainty::DecisionRule;
constexpr std::array rules = {
    std::pair{Rule::Kind::simple, std::string_view("Simple acceptance: the value against the limit")},
    std::pair{Rule::Kind::iso_14253_1,
              std::string_view("ISO 14253-1: conforms, or does not, with a probability of 95 % or more")},
    std::pair{Rule::Kind::guard_band, std::string_view("A guard band of a chosen width on either side")},
};

std::string_view type_name(FieldType type) {
  constexpr std::array<std::string_view, 6> names = {"text", "number", "boolean", "choice", "numbers", "records"};
  return names[static_cast<std::size_t>(type)];
}

/// Entries with texts in one language.
class Writer {
 public:
  explicit Writer(language::Language language) : language_(language) {}

  Value text(std::string_view english) const { return english.empty() ? "" : language::translated(english, language_); }

  Value named(std::string_view id, std::string_view title) const {
    Value value = Value::object();
    value.add("id", id);
    value.add("title", text(title));
    return value;
  }

  Value parameter(const iso230_2::ParameterInfo& info) const {
    Value value = Value::object();
    value.add("key", info.key);
    value.add("symbol", info.symbol);
    value.add("title", text(info.title));
    value.add("clause", info.clause);
    return value;
  }

  Value column(const RecordColumn& column) const {
    Value value = Value::object();
    value.add("key", column.key);
    value.add("title", text(column.title));
    value.add("type", type_name(column.type));
    value.add("unit", column.unit);
    return value;
  }

  Value field(const Field& field) const {
    const bool is_number = field.type == FieldType::number || field.type == FieldType::numbers;
    Value value = Value::object();
    value.add("key", field.key);
    value.add("group", field.key.substr(0, field.key.find('.')));
    value.add("title", text(field.title));
    value.add("type", type_name(field.type));
    value.add("unit_linear", field.unit_linear);
    value.add("unit_rotary", field.unit_rotary);
    value.add("clause", field.clause);
    value.add("minimum", is_number ? Value(field.minimum) : Value());
    value.add("maximum", is_number ? Value(field.maximum) : Value());
    Value& choices = value.add("choices", Value::array());
    for (const std::string_view choice : field.choices) choices.push(choice);
    Value& columns = value.add("columns", Value::array());
    for (const RecordColumn& each : field.columns) columns.push(column(each));
    value.add("description", text(field.description));
    value.add("wanted", field.wanted != Field::Wanted::no);
    return value;
  }

  Value format(const formats::Format& format) const {
    Value value = named(format.id, format.title);
    value.add("extensions", format.extensions);
    value.add("manual", format.manual);
    value.add("writes", format.write != nullptr);
    return value;
  }

  Value writer(const report::Writer& writer) const {
    Value value = Value::object();
    value.add("extension", writer.extension);
    value.add("title", text(writer.title));
    return value;
  }

  Value dialect(const nc::Dialect& dialect) const {
    Value value = named(dialect.id, dialect.title);
    value.add("extension", dialect.extension);
    value.add("axes", dialect.axes);
    value.add("has_loops", dialect.has_loops);
    value.add("manual", dialect.manual);
    return value;
  }

 private:
  language::Language language_;
};

template <typename Range, typename Spell>
Value list_of(const Range& range, const Spell& spell) {
  Value list = Value::array();
  for (const auto& item : range) list.push(spell(item));
  return list;
}

}  // namespace

Value vocabulary(language::Language language) {
  const Writer writer(language);
  Value value = Value::object();
  value.add("parameters", list_of(iso230_2::parameters, [&](const auto& info) { return writer.parameter(info); }));
  value.add("fields", list_of(metadata_fields(), [&](const Field& field) { return writer.field(field); }));
  value.add("formats", list_of(formats::format_table(), [&](const auto* format) { return writer.format(*format); }));
  value.add("writers", list_of(report::writer_table(), [&](const auto* each) { return writer.writer(*each); }));
  value.add("dialects", list_of(nc::dialect_table(), [&](const auto* dialect) { return writer.dialect(*dialect); }));
  value.add("compensations", list_of(formats::compensation_table(), [&](const auto* table) {
              Value row = writer.named(table->id, table->title);
              row.add("of_one_tool", table->of_one_tool);
              row.add("manual", table->manual);
              return row;
            }));
  value.add("diagonals", list_of(volumetric::diagonal_names(), [](const std::string& name) { return Value(name); }));
  value.add("trackers", list_of(tracking::tracker_kinds(), [](const tracking::TrackerKind& kind) {
              Value row = Value::object();
              row.add("id", kind.id);
              row.add("title", kind.title);
              row.add("has_angles", kind.across.has_value());
              return row;
            }));
  value.add("corrections", list_of(corrections, [&](const Named& row) { return writer.named(row.id, row.title); }));
  value.add("cycles",
            list_of(cycles, [&](const auto& row) { return writer.named(cycle_name(row.first), row.second); }));
  value.add("rules",
            list_of(rules, [&](const auto& row) { return writer.named(Rule{.kind = row.first}.id(), row.second); }));
  return value;
}

}  // namespace axiometry::server
