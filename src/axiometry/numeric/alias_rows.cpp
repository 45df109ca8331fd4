// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/alias_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {

AliasRows::AliasRows(std::size_t rows, std::size_t alternatives)
    : alternatives_(alternatives),
      scale_(static_cast<double>(alternatives) * static_cast<double>(parts_of_part)),
      entries_(rows * alternatives) {
  AXIOMETRY_CONTRACT(alternatives >= 1 && alternatives <= most_alternatives);
  for (std::size_t k = 0; k < entries_.size(); ++k) entries_[k] = static_cast<std::uint32_t>(k % alternatives);
}

/// A part that has less than its share of the weight is filled up by one that has more, until none is left. Rounding
/// may leave some that should be full on either heap: they are their own.
void AliasRows::set(std::size_t row, std::span<const double> weights) {
  AXIOMETRY_CONTRACT(weights.size() == alternatives_ && (row + 1) * alternatives_ <= entries_.size());
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  AXIOMETRY_CONTRACT(sum > 0.0 && std::isfinite(sum));
  std::array<double, most_alternatives> share;         // share of each alternative, 1 on average
  std::array<std::uint32_t, most_alternatives> heaps;  // shares below 1 from the front, the others from the back
  std::size_t below = 0, above = alternatives_;
  for (std::size_t k = 0; k < alternatives_; ++k) {
    share[k] = weights[k] / sum * static_cast<double>(alternatives_);
    heaps[share[k] < 1.0 ? below++ : --above] = static_cast<std::uint32_t>(k);
  }
  std::uint32_t* const own = entries_.data() + row * alternatives_;
  for (std::size_t k = 0; k < alternatives_; ++k) own[k] = static_cast<std::uint32_t>(k);
  while (below > 0 && above < alternatives_) {
    const std::uint32_t poor = heaps[--below], rich = heaps[above];
    const double parts = std::floor(share[poor] * static_cast<double>(parts_of_part) + 0.5);
    const auto threshold = std::min(static_cast<std::uint32_t>(parts), parts_of_part - 1);
    own[poor] = threshold << alias_bits | rich;
    share[rich] -= 1.0 - share[poor];
    if (share[rich] < 1.0) {
      ++above;
      heaps[below++] = rich;
    }
  }
}

}  // namespace axiometry::numeric
