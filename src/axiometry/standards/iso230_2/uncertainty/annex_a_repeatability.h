// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

namespace axiometry::iso230_2 {

/// 0.6 stands for 1/√3: half the range, rectangular (divided by √3), expanded by k = 2.
inline constexpr double expanded_per_range = 0.6;

struct RepeatabilityFactors {  // of U_EVE in (A.11) and (A.14)
  double unidirectional = 2.0, bidirectional = 2.2;
};

/// As printed for five approaches and more. Of fewer than five the noise u = U_EVE/2 of n readings makes 4 s uncertain
/// by 4 u/√(n − 1), which is 2 u where n is 5: U = 4/√(n − 1) · U_EVE, joined with (A.12) as in (A.14). Of an
/// environment that is stated to vary slowly, one swing of E_VE over the test (docs/theory/annex-a.md).
inline RepeatabilityFactors repeatability_factors(std::size_t runs, bool slow) {
  if (runs < 2 || (runs >= 5 && !slow)) return {};
  const auto n = static_cast<double>(runs);
  if (!slow) return {4.0 / std::sqrt(n - 1.0), std::sqrt(16.0 / (n - 1.0) + 4.0 / n)};
  const double swing = std::numbers::sqrt2 / expanded_per_range * std::sqrt(n / (n - 1.0));
  return {swing, swing + 1.0 / (expanded_per_range * n)};
}

}  // namespace axiometry::iso230_2
