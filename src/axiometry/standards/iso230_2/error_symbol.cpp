// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/error_symbol.h"

#include <fmt/format.h>

namespace axiometry::iso230_2 {

std::string error_symbol(const Axis& axis) {
  const std::string& name = axis.name;
  const bool fits = !name.empty() && name.size() <= 2 && name.front() >= 'A' && name.front() <= 'Z' &&
                    (name.size() == 1 || (name[1] >= '0' && name[1] <= '9'));
  return fits && !is_diagonal(axis) ? fmt::format("E_{0}{0}", name) : "";
}

std::string error_symbol(const Axis& axis, const ParameterInfo& parameter) {
  const std::string of_axis = error_symbol(axis);
  return of_axis.empty() ? "" : fmt::format("{},{}", of_axis, parameter.symbol);
}

}  // namespace axiometry::iso230_2
