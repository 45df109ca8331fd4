// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/test_standard.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/standards/iso230_6.h"

namespace axiometry {
namespace {

constexpr std::string_view names[] = {"X", "Y", "Z"};

/// As moving_axes() counts them.
bool moves(const SpatialLine& line, std::size_t axis) { return std::abs(line.direction[axis]) > 1e-9; }

std::string moving_names(const SpatialLine& line) {
  std::vector<std::string_view> moving;
  for (std::size_t k = 0; k < 3; ++k)
    if (moves(line, k)) moving.push_back(names[k]);
  std::string text;
  for (std::size_t k = 0; k < moving.size(); ++k)
    text += fmt::format("{}{}", k == 0 ? "" : k + 1 == moving.size() ? " and " : ", ", moving[k]);
  return text;
}

std::string kind_of(const Axis& axis) {
  if (is_diagonal(axis)) return "diagonal of " + moving_names(*spatial_line(axis));
  return axis.kind == AxisKind::linear ? "linear axis" : "rotary axis";
}

}  // namespace

std::string_view standard_of(const Axis& axis) { return is_diagonal(axis) ? "ISO 230-6" : "ISO 230-2"; }

std::string edition_of(const Axis& axis) {
  if (!is_diagonal(axis)) return std::string(iso230_2::edition);
  return fmt::format("{}, parameters as in {}", iso230_6::edition, iso230_2::edition);
}

std::string edition_remark(const Axis& axis) {
  constexpr std::string_view amendment = "Amendment 1:2016 has not been taken into account";
  if (!is_diagonal(axis)) return std::string(amendment);
  return fmt::format(
      "the text of {} was not at hand: line, cycle and set of parameters follow general knowledge of it; of {}, {}",
      iso230_6::edition, iso230_2::edition, amendment);
}

std::string_view word_for(const Axis& axis) { return is_diagonal(axis) ? "diagonal" : "axis"; }

std::string title_of(const Axis& axis) {
  const std::string word = is_diagonal(axis) ? "Diagonal" : "Axis";
  return axis.name.empty() ? word : fmt::format("{} {}", word, axis.name);
}

std::string description_of(const Axis& axis) {
  return axis.name.empty() ? kind_of(axis) : fmt::format("{} ({})", axis.name, kind_of(axis));
}

std::string octant_of(const Axis& axis) {
  const auto line = spatial_line(axis);
  if (!line) return "";
  std::string text;
  for (std::size_t k = 0; k < 3; ++k)
    if (moves(*line, k))
      text += fmt::format("{}{}{}", text.empty() ? "" : " ", line->direction[k] > 0.0 ? "+" : "\u2212", names[k]);
  return text;
}

}  // namespace axiometry
