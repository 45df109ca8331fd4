// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/test_names.h"

#include "axiometry/base/text/number_text.h"

namespace axiometry::formats {
namespace {

struct NumberedName {
  std::string stem;  ///< text before the number; with the width when zeros fill it, so that T07 is not T7
  std::uint64_t number;
};

std::optional<NumberedName> parted(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  const std::size_t begin = last == std::string_view::npos ? 0 : last + 1;
  const std::string_view digits = name.substr(begin);
  constexpr std::size_t digits_that_fit = 18;
  if (digits.empty() || digits.size() > digits_that_fit) return std::nullopt;
  std::string stem(name.substr(0, begin));
  if (digits.front() == '0' && digits.size() > 1) {
    stem += '\0';
    stem += static_cast<char>(digits.size());
  }
  return NumberedName{std::move(stem), *parse_count(digits)};
}

}  // namespace

std::optional<std::size_t> TestNames::add_to(Runs& runs, std::uint64_t number, std::size_t line) {
  auto after = runs.upper_bound(number);
  if (after != runs.begin()) {
    auto& [first, run] = *std::prev(after);
    if (number <= run.last) return run.first_line + static_cast<std::size_t>(number - first) * run.lines_each;
    // Lines come in order, so a new name stands behind every old one.
    const std::size_t last_line = run.first_line + static_cast<std::size_t>(run.last - first) * run.lines_each;
    const bool evenly = run.lines_each == 0 || line == last_line + run.lines_each;
    if (number == run.last + 1 && evenly && line > last_line) {
      run.lines_each = line - last_line;
      run.last = number;
      return std::nullopt;
    }
  }
  runs.emplace_hint(after, number, Run{number, line, 0});
  return std::nullopt;
}

std::optional<std::size_t> TestNames::add(std::string_view name, std::size_t line) {
  if (const auto numbered = parted(name)) return add_to(numbered_[numbered->stem], numbered->number, line);
  const auto [entry, inserted] = others_.try_emplace(std::string(name), line);
  return inserted ? std::nullopt : std::optional(entry->second);
}

std::size_t TestNames::entry_count() const {
  std::size_t count = others_.size();
  for (const auto& [stem, runs] : numbered_) count += runs.size();
  return count;
}

}  // namespace axiometry::formats
