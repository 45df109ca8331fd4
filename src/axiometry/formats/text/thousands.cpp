// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/thousands.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t group = 3;  // digits between marks of thousands

bool only_digits(std::string_view s) {
  return !s.empty() && std::ranges::all_of(s, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

void ThousandsDoubt::look_at(std::size_t column, std::string_view number) {
  if (settled_) return;
  Column& seen = columns_[column];
  std::string_view plain = number;
  for (std::string_view sign : {"-", "+", "\u2212"})
    if (plain.starts_with(sign)) plain.remove_prefix(sign.size());
  const std::size_t mark = plain.find_first_of(".,");
  if (mark == std::string_view::npos) {
    if (!only_digits(plain)) return;
    seen.has_long_whole = seen.has_long_whole || plain.size() > group;
    if (seen.whole.empty()) seen.whole = number;
    return;
  }
  const std::string_view before = plain.substr(0, mark), behind = plain.substr(mark + 1);
  if (!only_digits(before) || before.size() > group || before.front() == '0' || behind.size() != group ||
      !only_digits(behind)) {
    settled_ = true;
    return;
  }
  if (seen.marked.empty()) seen.marked = number;
  ++seen.marks;
  seen.ends_with_zero = seen.ends_with_zero || behind.back() == '0';
}

std::optional<ThousandsDoubt::Found> ThousandsDoubt::found() const {
  if (settled_) return std::nullopt;
  for (const Column& c : columns_)
    if (c.marks > 0 && !c.whole.empty() && !c.has_long_whole && (c.ends_with_zero || c.marks > 1))
      return Found{c.marked, c.whole};
  return std::nullopt;
}

std::string thousands_fault(const ThousandsDoubt::Found& found) {
  return fmt::format(
      "found {} and {} in one column, whose mark may part thousands; expected whole numbers without it, "
      "or as many decimals in all",
      text::quoted(found.marked), text::quoted(found.whole));
}

}  // namespace axiometry::formats
