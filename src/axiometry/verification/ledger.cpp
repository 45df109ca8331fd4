// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/ledger.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace axiometry::verification {
namespace {

int last_place_of(const Decimal& decimal, int coarse) {
  return decimal.exponent < 0 ? decimal.exponent : std::clamp(coarse, 0, 30);
}

}  // namespace

bool Ledger::is_number(double x) { return std::abs(x) <= 1e30; }

std::string Ledger::exact_text(double x) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

bool Ledger::rounds_to(std::string_view printed, const Interval& right, const Interval& rounding, int coarse) {
  const auto decimal = decimal_of(printed);
  if (!decimal) return false;
  const int last_place = last_place_of(*decimal, coarse);
  if (last_place < -places) return false;
  const Interval half = Interval::of(Decimal{5, last_place - 1});
  return within(Interval::of(*decimal), right, half + rounding);
}

bool Ledger::rounds_inward(std::string_view printed, const Interval& right, const Interval& rounding, bool downward,
                           int coarse) {
  const auto decimal = decimal_of(printed);
  if (!decimal) return false;
  const int last_place = last_place_of(*decimal, coarse);
  if (last_place < -places) return false;
  const Interval found = Interval::of(*decimal);
  const Interval &lower = downward ? found : right, &upper = downward ? right : found;
  return possibly_at_most(lower, upper + rounding) &&
         within(lower, upper, Interval::of(Decimal{1, last_place}) + rounding);
}

}  // namespace axiometry::verification
