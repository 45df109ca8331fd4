// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/devices/camonitor_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t longest = 9;  // digits

struct Split {
  std::vector<TestCode> codes;
  double fill = -1.0;  ///< share of the grid of cycles and targets, from either direction, that has a code
};

/// Fill −1 when a cycle or a target would be zero.
Split split_at(std::span<const std::string_view> codes, std::size_t cycle_digits) {
  Split split;
  std::size_t cycles = 0;
  std::size_t targets = 0;
  std::set<std::string_view> different(codes.begin(), codes.end());
  for (std::string_view code : codes) {
    const auto cycle = parse_count(code.substr(1, cycle_digits)).value_or(0);
    const auto target = parse_count(code.substr(1 + cycle_digits)).value_or(0);
    if (cycle == 0 || target == 0) return {};
    const Direction direction = code.front() == '1' ? Direction::up : Direction::down;
    split.codes.push_back({direction, static_cast<std::size_t>(cycle), static_cast<std::size_t>(target)});
    cycles = std::max(cycles, split.codes.back().cycle);
    targets = std::max(targets, split.codes.back().target);
  }
  split.fill =
      static_cast<double>(different.size()) / (2.0 * static_cast<double>(cycles) * static_cast<double>(targets));
  return split;
}

}  // namespace

bool is_test_code(std::string_view value) {
  return value.size() >= 3 && value.size() <= longest && (value.front() == '1' || value.front() == '2') &&
         value.find_first_not_of("0123456789") == std::string_view::npos;
}

Result<std::vector<TestCode>> test_codes(std::span<const std::string_view> codes) {
  if (codes.empty()) return std::vector<TestCode>();
  for (std::string_view code : codes)
    if (code.size() != codes.front().size())
      return fail(
          fmt::format("found the test numbers {} and {}, expected all with as many digits", codes.front(), code));
  Split best;
  for (std::size_t digits = 1; digits + 1 < codes.front().size(); ++digits)
    if (Split split = split_at(codes, digits); split.fill > best.fill) best = std::move(split);
  if (best.fill > 0.0) return std::move(best.codes);
  return fail(fmt::format("found test numbers such as {}, expected direction (1 or 2), cycle and target from 1",
                          codes.front()));
}

}  // namespace axiometry::formats
