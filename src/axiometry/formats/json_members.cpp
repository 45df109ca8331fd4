// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/json_members.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

std::unexpected<Error> wrong_kind(const Value& value, std::string_view what, std::string_view expected) {
  return fail(
      fmt::format("found {} of the kind {}, expected {}", text::quoted(what), json::kind_name(value.kind()), expected),
      value.at());
}

/// A list of three, each read by `read`.
template <typename Read>
Result<void> three_in(const Value& value, std::string_view what, std::string_view expected, Read read) {
  if (!value.is(Kind::array)) return wrong_kind(value, what, expected);
  const auto& items = value.items();
  if (items.size() != 3)
    return fail(fmt::format("found {} with {} values, expected {}", text::quoted(what), items.size(), expected),
                value.at());
  for (std::size_t k = 0; k < 3; ++k) AXIOMETRY_TRY_VOID(read(k, items[k]));
  return {};
}

}  // namespace

Result<double> number_in(const Value& value, std::string_view what) {
  if (!value.is(Kind::number)) return wrong_kind(value, what, "a number");
  return value.number();
}

Result<std::string> text_in(const Value& value, std::string_view what) {
  if (!value.is(Kind::text)) return wrong_kind(value, what, "a string");
  return value.text();
}

Result<Vector3> vector_in(const Value& value, std::string_view what) {
  Vector3 v;
  AXIOMETRY_TRY_VOID(
      three_in(value, what, "three numbers [x, y, z]", [&](std::size_t k, const Value& item) -> Result<void> {
        AXIOMETRY_TRY(v[k], number_in(item, what));
        return {};
      }));
  return v;
}

Result<Matrix3> matrix_in(const Value& value, std::string_view what) {
  Matrix3 m{};
  AXIOMETRY_TRY_VOID(
      three_in(value, what, "three rows of three numbers", [&](std::size_t k, const Value& item) -> Result<void> {
        AXIOMETRY_TRY(const Vector3 row, vector_in(item, what));
        m[k] = {row.x, row.y, row.z};
        return {};
      }));
  return m;
}

Result<const std::vector<Value>*> items_in(const Value& value, std::string_view what) {
  if (!value.is(Kind::array)) return wrong_kind(value, what, "an array");
  return &value.items();
}

Value vector_value(Vector3 v) { return Value::array({v.x, v.y, v.z}); }

Value matrix_value(const Matrix3& m) {
  Value rows = Value::array();
  for (const auto& row : m) rows.push(Value::array({row[0], row[1], row[2]}));
  return rows;
}

Result<JsonMembers> JsonMembers::of(const Value& value, std::string what) {
  if (!value.is(Kind::object)) return wrong_kind(value, what, "an object");
  return JsonMembers(value, std::move(what));
}

const Value* JsonMembers::optional(std::string_view name) {
  known_.emplace_back(name);
  const Value* member = value_->find(name);
  return member != nullptr && !member->is(Kind::null) ? member : nullptr;
}

Result<const Value*> JsonMembers::required(std::string_view name) {
  if (const Value* member = optional(name)) return member;
  return fail(fmt::format("found no member {} in {}, expected it", text::quoted(name), what_), value_->at());
}

Result<void> JsonMembers::take(std::string_view name, double& target) {
  if (const Value* member = optional(name)) {
    AXIOMETRY_TRY(target, number_in(*member, name));
  }
  return {};
}

Result<void> JsonMembers::take(std::string_view name, std::string& target) {
  if (const Value* member = optional(name)) {
    AXIOMETRY_TRY(target, text_in(*member, name));
  }
  return {};
}

Result<void> JsonMembers::take(std::string_view name, Vector3& target) {
  if (const Value* member = optional(name)) {
    AXIOMETRY_TRY(target, vector_in(*member, name));
  }
  return {};
}

void JsonMembers::pass_over(std::string_view name) { known_.emplace_back(name); }

Result<void> JsonMembers::finish() const {
  for (const auto& [name, member] : value_->members()) {
    if (std::ranges::find(known_, name) != known_.end()) continue;
    const std::vector<std::string_view> names(known_.begin(), known_.end());
    const auto near = text::nearest(name, names);
    return fail(fmt::format("found the unknown member {} in {}, expected {}", text::quoted(name), what_,
                            near ? fmt::format("perhaps {}", text::quoted(*near))
                                 : fmt::format("one of {}", fmt::join(names, ", "))),
                member.at());
  }
  return {};
}

}  // namespace axiometry::formats
