// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "axiometry/base/json.h"
#include "axiometry/base/text.h"
#include "axiometry/store/kept/asset_tables.h"

namespace axiometry::store {
namespace {

using json::Kind;
using json::Value;

constexpr std::size_t longest_measured_on = 200;  // as of a test

std::string files_text(const std::vector<CalibrationFile>& files) {
  Value list = Value::array();
  for (const CalibrationFile& file : files) {
    Value& item = list.push(Value::object());
    item.add("role", file.role);
    item.add("name", file.name);
    item.add("content", file.content);
  }
  return json::dump(list, 0);
}

std::string figures_text(const std::vector<CalibrationFigure>& figures) {
  Value list = Value::array();
  for (const CalibrationFigure& figure : figures) {
    Value& item = list.push(Value::object());
    item.add("parameter", figure.parameter);
    item.add("of", figure.of);
    item.add("value", figure.value);
    item.add("u", figure.u ? Value(*figure.u) : Value());
    item.add("unit", figure.unit);
  }
  return json::dump(list, 0);
}

/// Reads what was written by the functions above; notes that something else stands there.
class KeptList {
 public:
  explicit KeptList(const std::string& text) : list_(json::parse(text)) {
    is_sound_ = list_.has_value() && list_->is(Kind::array);
  }

  std::size_t size() const { return is_sound_ ? list_->items().size() : 0; }

  std::string text(std::size_t k, std::string_view name) {
    const Value* value = member(k, name);
    is_sound_ = is_sound_ && value != nullptr && value->is(Kind::text);
    return is_sound_ ? value->text() : std::string();
  }

  std::optional<double> number(std::size_t k, std::string_view name) {
    const Value* value = member(k, name);
    if (value == nullptr || !value->is(Kind::number)) return {};
    return value->number();
  }

  Result<void> checked(std::string_view what) const {
    if (is_sound_) return {};
    return fail(ErrorKind::damaged, fmt::format("found a calibration whose {} cannot be read, expected them as they "
                                                "were written",
                                                what));
  }

  void is_damaged() { is_sound_ = false; }

 private:
  const Value* member(std::size_t k, std::string_view name) const {
    if (!is_sound_ || !list_->items()[k].is(Kind::object)) return nullptr;
    return list_->items()[k].find(name);
  }

  Result<Value> list_;
  bool is_sound_ = false;
};

Result<std::vector<CalibrationFile>> kept_files(const std::string& text) {
  KeptList list(text);
  std::vector<CalibrationFile> files;
  for (std::size_t k = 0; k < list.size(); ++k)
    files.push_back({list.text(k, "role"), list.text(k, "name"), list.text(k, "content")});
  AXIOMETRY_TRY_VOID(list.checked("files"));
  return files;
}

Result<std::vector<CalibrationFigure>> kept_figures(const std::string& text) {
  KeptList list(text);
  std::vector<CalibrationFigure> figures;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const auto value = list.number(k, "value");
    if (!value) list.is_damaged();
    figures.push_back({.parameter = list.text(k, "parameter"),
                       .of = list.text(k, "of"),
                       .value = value.value_or(0.0),
                       .u = list.number(k, "u"),
                       .unit = list.text(k, "unit")});
  }
  AXIOMETRY_TRY_VOID(list.checked("figures"));
  return figures;
}

Result<void> check_values(const Calibration& c) {
  if (c.kind != "lines" && c.kind != "volumetric")
    return fail(fmt::format("found the kind of calibration {}, expected lines or volumetric", text::quoted(c.kind)));
  if (text::trim(c.title).empty()) return fail("found a calibration without a title, expected one");
  if (c.measured_on.size() > longest_measured_on)
    return fail(
        fmt::format("found a date of {} bytes, expected at most {}", c.measured_on.size(), longest_measured_on));
  if (c.instrument.has_value() != c.instrument_version.has_value())
    return fail("found an instrument without its version, expected both or none");
  if (c.files.empty()) return fail("found a calibration without files, expected what it was evaluated from");
  if (const auto options = json::parse(c.options); !options || !options->is(Kind::object))
    return fail(fmt::format("found the options {}, expected a JSON object", text::quoted(c.options)));
  for (const CalibrationFigure& figure : c.figures)
    if (!std::isfinite(figure.value) || (figure.u && !std::isfinite(*figure.u)))
      return fail(fmt::format("found the figure {} without a number, expected one", text::quoted(figure.parameter)));
  return {};
}

}  // namespace

std::vector<Cell> ThingTable<Calibration>::cells(const Calibration& c) {
  const std::optional<std::int64_t> known_as = c.instrument_version;
  return {c.kind,
          c.title,
          cell(c.machine),
          cell(c.instrument),
          cell(known_as),
          c.measured_on,
          c.notes,
          std::int64_t{c.withdrawn},
          files_text(c.files),
          c.program,
          c.options,
          c.result,
          c.verdict,
          std::int64_t{c.serious},
          figures_text(c.figures)};
}

Result<Calibration> ThingTable<Calibration>::thing(const Row& row, std::size_t first) {
  AXIOMETRY_TRY(auto files, kept_files(row.text(first + 8)));
  AXIOMETRY_TRY(auto figures, kept_figures(row.text(first + 14)));
  return Calibration{
      .kind = row.text(first),
      .title = row.text(first + 1),
      .machine = row.optional_integer(first + 2),
      .instrument = row.optional_integer(first + 3),
      .instrument_version = row.null(first + 4) ? std::optional<int>() : std::optional<int>(row.number(first + 4)),
      .measured_on = row.text(first + 5),
      .notes = row.text(first + 6),
      .withdrawn = row.flag(first + 7),
      .files = std::move(files),
      .program = row.text(first + 9),
      .options = row.text(first + 10),
      .result = row.text(first + 11),
      .verdict = row.text(first + 12),
      .serious = row.number(first + 13),
      .figures = std::move(figures)};
}

Result<void> ThingTable<Calibration>::check(Connection& connection, const Calibration& c) {
  AXIOMETRY_TRY_VOID(check_values(c));
  if (c.machine) AXIOMETRY_TRY_VOID(check_exists(connection, "machine", *c.machine));
  if (c.instrument) AXIOMETRY_TRY_VOID(check_exists(connection, "instrument", *c.instrument));
  for (const CalibrationFile& file : c.files)
    AXIOMETRY_TRY_VOID(check_content(connection, file.content, fmt::format("those of {}", text::quoted(file.name))));
  return check_content(connection, c.result, "those of the result");
}

std::string ThingTable<Calibration>::called(const Calibration& c) { return c.title; }

}  // namespace axiometry::store
