// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/type_a_doubt.h"

#include <fmt/format.h>

namespace axiometry::iso230_2 {

std::string doubt_of_type_a(Measurand measurand, TypeA type_a) {
  if (measurand != Measurand::this_machine || type_a == TypeA::pooled) return "";
  return fmt::format(
      "an interval with type A {} held the true value less often in simulated tests than it states; type A {} mends "
      "that",
      type_a_key(type_a), type_a_key(TypeA::pooled));
}

}  // namespace axiometry::iso230_2
