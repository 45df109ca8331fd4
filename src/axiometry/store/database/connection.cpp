// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/connection.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "axiometry/base/text/text.h"

namespace axiometry::store {
namespace {

Result<void> check(const Parameter& parameter) {
  if (const auto* real = std::get_if<double>(&parameter); real != nullptr && !std::isfinite(*real))
    return fail("found a number that is not finite, expected one that can be kept");
  const auto* text = std::get_if<std::string_view>(&parameter);
  if (text == nullptr) return {};
  if (const auto at = text::invalid_utf8(*text))
    return fail(
        fmt::format("found bytes that are no UTF-8 at byte {} of {}, expected text", *at + 1, text::quoted(*text)));
  if (text->find('\0') != std::string_view::npos)
    return fail(fmt::format("found a NUL in {}, expected text", text::quoted(*text)));
  return {};
}

}  // namespace

Parameter parameter(const Cell& cell) {
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) return *integer;
  if (const auto* real = std::get_if<double>(&cell)) return *real;
  if (const auto* text = std::get_if<std::string>(&cell)) return std::string_view(*text);
  if (const auto* bytes = std::get_if<Bytes>(&cell)) return BytesView{bytes->bytes};
  return {};
}

bool Row::null(std::size_t column) const { return std::holds_alternative<std::monostate>(cells_.at(column)); }

std::int64_t Row::integer(std::size_t column) const {
  const auto* value = std::get_if<std::int64_t>(&cells_.at(column));
  if (value == nullptr) throw DamagedCell();
  return *value;
}

int Row::number(std::size_t column) const {
  const std::int64_t value = integer(column);
  if (!std::in_range<int>(value)) throw DamagedCell();
  return static_cast<int>(value);
}

bool Row::flag(std::size_t column) const {
  const std::int64_t value = integer(column);
  if (value != 0 && value != 1) throw DamagedCell();
  return value == 1;
}

std::optional<std::int64_t> Row::optional_integer(std::size_t column) const {
  if (null(column)) return {};
  return integer(column);
}

double Row::real(std::size_t column) const {
  const auto* value = std::get_if<double>(&cells_.at(column));
  return value != nullptr ? *value : static_cast<double>(integer(column));
}

std::optional<double> Row::optional_real(std::size_t column) const {
  if (null(column)) return {};
  return real(column);
}

const std::string& Row::text(std::size_t column) const {
  const Cell& cell = cells_.at(column);
  if (const auto* bytes = std::get_if<Bytes>(&cell)) return bytes->bytes;
  const auto* value = std::get_if<std::string>(&cell);
  if (value == nullptr) throw DamagedCell();
  return *value;
}

Result<Rows> Connection::query(std::string_view sql, std::span<const Parameter> parameters) {
  for (const Parameter& parameter : parameters) AXIOMETRY_TRY_VOID(check(parameter));
  return execute(sql, parameters);
}

Result<void> Connection::run(std::string_view sql, std::initializer_list<Parameter> parameters) {
  return run(sql, std::span(parameters.begin(), parameters.size()));
}

Result<void> Connection::run(std::string_view sql, std::span<const Parameter> parameters) {
  AXIOMETRY_TRY(const Rows rows, query(sql, parameters));
  static_cast<void>(rows);
  return {};
}

}  // namespace axiometry::store
