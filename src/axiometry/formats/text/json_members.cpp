// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/json_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

constexpr double asymmetry = 1e-9;  // of a covariance, relative to its largest member: both halves print alike
constexpr double rounding = 1e-3;   // relative, of numbers with three digits

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

Result<Matrix3> covariance_in(const Value& value, std::string_view what) {
  constexpr std::string_view axes = "XYZ";
  AXIOMETRY_TRY(const Matrix3 m, matrix_in(value, what));
  double largest = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(m[k][k] >= 0.0))
      return fail(fmt::format("found the variance {} of {}, expected 0 or more", format_exact(m[k][k]), axes[k]),
                  value.items()[k].at());
    largest = std::max(largest, m[k][k]);
  }
  double r[3] = {};  // correlations of Y and X, Z and X, Z and Y
  for (std::size_t i = 1, at = 0; i < 3; ++i)
    for (std::size_t k = 0; k < i; ++k, ++at) {
      const auto refused = [&](std::string_view expected) {
        return fail(
            fmt::format("found the covariances {} and {} of {} and {} beside variances of {} and {}, expected {}",
                        format_exact(m[i][k]), format_exact(m[k][i]), axes[i], axes[k], format_exact(m[i][i]),
                        format_exact(m[k][k]), expected),
            value.items()[i].at());
      };
      if (std::abs(m[i][k] - m[k][i]) > asymmetry * largest) return refused("a symmetric matrix");
      const double most = std::sqrt(m[i][i]) * std::sqrt(m[k][k]);
      if (std::abs(m[i][k]) > most * (1.0 + rounding)) return refused("covariances that such variances can have");
      r[at] = most > 0.0 ? m[i][k] / most : 0.0;
    }
  // of the matrix of correlations; errors of `rounding` in its three members move it by 6 of them at most
  if (const double determinant = 1.0 + 2.0 * r[0] * r[1] * r[2] - r[0] * r[0] - r[1] * r[1] - r[2] * r[2];
      determinant < -6.0 * rounding)
    return fail(
        fmt::format("found {} with the correlations {:.3f}, {:.3f} and {:.3f}, which would make the variance of "
                    "some direction negative; expected a positive semidefinite matrix",
                    text::quoted(what), r[0], r[1], r[2]),
        value.at());
  return m;
}

Result<const std::vector<Value>*> items_in(const Value& value, std::string_view what) {
  if (!value.is(Kind::array)) return wrong_kind(value, what, "an array");
  return &value.items();
}

std::string stated_format(std::string_view bytes) {
  const auto text = utf8_text(bytes);
  const auto root = text ? json::parse(*text) : Result<Value>(std::unexpected(text.error()));
  if (!root || !root->is(Kind::object)) return {};
  const Value* format = root->find("format");
  return format != nullptr && format->is(Kind::text) ? format->text() : std::string();
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
  AXIOMETRY_TRY(const std::vector<std::string> names, others());
  if (names.empty()) return {};
  return fail(fmt::format("found the unknown member {} in {}, expected one of {}", text::quoted(names.front()), what_,
                          fmt::join(known_, ", ")),
              value_->find(names.front())->at());
}

Result<std::vector<std::string>> JsonMembers::others() const {
  std::vector<std::string> names;
  const std::vector<std::string_view> known(known_.begin(), known_.end());
  for (const auto& [name, member] : value_->members()) {
    if (std::ranges::find(known_, name) != known_.end()) continue;
    if (const auto near = text::nearest(name, known))
      return fail(fmt::format("found the unknown member {} in {}, expected perhaps {}", text::quoted(name), what_,
                              text::quoted(*near)),
                  member.at());
    names.push_back(name);
  }
  return names;
}

}  // namespace axiometry::formats
