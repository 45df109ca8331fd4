// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/fingerprint.h"

#include <fmt/format.h>

#include "axiometry/base/text/number_text.h"

namespace axiometry::store {

void Fingerprint::put(char type, std::string_view text) {
  hash_.update(fmt::format("{}{}:", type, text.size()));
  hash_.update(text);
}

Fingerprint& Fingerprint::add(std::string_view text) {
  put('t', text);
  return *this;
}

Fingerprint& Fingerprint::add_cell(const Cell& cell) {
  if (const auto* integer = std::get_if<std::int64_t>(&cell)) put('i', fmt::format("{}", *integer));
  if (const auto* real = std::get_if<double>(&cell)) put('r', format_exact(*real));
  if (const auto* text = std::get_if<std::string>(&cell)) put('t', *text);
  if (const auto* bytes = std::get_if<Bytes>(&cell)) put('b', bytes->bytes);
  if (std::holds_alternative<std::monostate>(cell)) put('n', "");
  return *this;
}

Fingerprint& Fingerprint::add(std::span<const Cell> cells) {
  for (const Cell& cell : cells) add_cell(cell);
  return *this;
}

}  // namespace axiometry::store
