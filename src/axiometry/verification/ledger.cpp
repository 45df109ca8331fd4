// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/ledger.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace axiometry::verification {

bool Ledger::is_number(double x) { return std::abs(x) <= 1e30; }

std::string Ledger::exact_text(double x) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

bool Ledger::rounds_to(std::string_view printed, const Interval& right, const Interval& rounding, int coarse) {
  const auto decimal = decimal_of(printed);
  if (!decimal) return false;
  const int last_place = decimal->exponent < 0 ? decimal->exponent : std::clamp(coarse, 0, 30);
  if (last_place < -places) return false;
  const Interval half = Interval::of(Decimal{5, last_place - 1});
  return within(Interval::of(*decimal), right, half + rounding);
}

}  // namespace axiometry::verification
