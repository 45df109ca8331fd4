// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/kept_lists.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/store/kept/asset_tables.h"

namespace axiometry::store {
namespace {

using json::Kind;
using json::Value;

/// Reads what was written by the functions below; notes that something else stands there.
class KeptList {
 public:
  KeptList(const std::string& text, std::string_view whose) : list_(json::parse(text)), whose_(whose) {
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
    return fail(ErrorKind::damaged,
                fmt::format("found a {} whose {} cannot be read, expected them as they were written", whose_, what));
  }

  void is_damaged() { is_sound_ = false; }

 private:
  const Value* member(std::size_t k, std::string_view name) const {
    if (!is_sound_ || !list_->items()[k].is(Kind::object)) return nullptr;
    return list_->items()[k].find(name);
  }

  Result<Value> list_;
  std::string_view whose_;
  bool is_sound_ = false;
};

}  // namespace

std::string files_text(const std::vector<KeptFile>& files) {
  Value list = Value::array();
  for (const KeptFile& file : files) {
    Value& item = list.push(Value::object());
    item.add("role", file.role);
    item.add("name", file.name);
    item.add("content", file.content);
  }
  return json::dump(list, 0);
}

std::string figures_text(const std::vector<KeptFigure>& figures) {
  Value list = Value::array();
  for (const KeptFigure& figure : figures) {
    Value& item = list.push(Value::object());
    item.add("parameter", figure.parameter);
    item.add("of", figure.of);
    item.add("value", figure.value);
    item.add("u", figure.u ? Value(*figure.u) : Value());
    item.add("unit", figure.unit);
  }
  return json::dump(list, 0);
}

Result<std::vector<KeptFile>> kept_files(const std::string& text, std::string_view whose) {
  KeptList list(text, whose);
  std::vector<KeptFile> files;
  for (std::size_t k = 0; k < list.size(); ++k)
    files.push_back({list.text(k, "role"), list.text(k, "name"), list.text(k, "content")});
  AXIOMETRY_TRY_VOID(list.checked("files"));
  return files;
}

Result<std::vector<KeptFigure>> kept_figures(const std::string& text, std::string_view whose) {
  KeptList list(text, whose);
  std::vector<KeptFigure> figures;
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

Result<void> check_options(const std::string& options) {
  if (const auto object = json::parse(options); object && object->is(Kind::object)) return {};
  return fail(fmt::format("found the options {}, expected a JSON object", text::quoted(options)));
}

Result<void> check_figures(const std::vector<KeptFigure>& figures) {
  for (const KeptFigure& figure : figures)
    if (!std::isfinite(figure.value) || (figure.u && !std::isfinite(*figure.u)))
      return fail(fmt::format("found the figure {} without a number, expected one", text::quoted(figure.parameter)));
  return {};
}

Result<void> check_files(Connection& connection, const std::vector<KeptFile>& files) {
  for (const KeptFile& file : files)
    AXIOMETRY_TRY_VOID(check_content(connection, file.content, fmt::format("those of {}", text::quoted(file.name))));
  return {};
}

}  // namespace axiometry::store
