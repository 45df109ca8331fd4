// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace axiometry::numeric {

/// Distributions over the same few alternatives, a row for each, from which a uniform number draws by one comparison,
/// however many alternatives there are and without a branch: the alias method of Walker (1977), set up as by Vose
/// (1991).
///
/// (0, 1) is cut into as many equal parts as there are alternatives. A part belongs to its own alternative from its
/// beginning on, to a threshold that is rounded to 2⁻²⁴ of the part, and behind it to another one. The probability of
/// every alternative is therefore within 2⁻²⁴ of what its weight says.
class AliasRows {
 public:
  static constexpr std::size_t most_alternatives = 256;

  AliasRows() = default;
  /// Every row draws its parts' own alternatives until it is set. Contract: 1 to `most_alternatives`.
  AliasRows(std::size_t rows, std::size_t alternatives);

  bool empty() const { return entries_.empty(); }

  /// Contract: one weight ≥ 0 for each alternative, and a finite sum above 0.
  void set(std::size_t row, std::span<const double> weights);

  /// The alternative that the number draws; contract, unchecked: 0 ≤ it < 1, and such a row.
  std::size_t operator()(std::size_t row, double uniform) const {
    const auto place = static_cast<std::int64_t>(uniform * scale_);  // < scale_, which no number below 1 rounds up to
    const auto own = static_cast<std::uint32_t>(place >> fraction_bits);
    const std::uint32_t entry = entries_[row * alternatives_ + own];
    // What is left of the place, where the threshold stands in the entry, and ones behind it: below the entry if and
    // only if it is below the threshold. All bits or none; no branch.
    const std::uint32_t left = static_cast<std::uint32_t>(place) << alias_bits | (most_alternatives - 1);
    const std::uint32_t if_other = std::uint32_t{left < entry} - 1u;
    return own ^ ((own ^ entry % most_alternatives) & if_other);
  }

 private:
  static constexpr std::uint32_t fraction_bits = 24, alias_bits = 8;
  static constexpr std::uint32_t parts_of_part = 1u << fraction_bits;

  std::size_t alternatives_ = 0;
  double scale_ = 0.0;                  ///< alternatives · 2²⁴
  std::vector<std::uint32_t> entries_;  ///< threshold and, in the last bits, the other alternative
};

}  // namespace axiometry::numeric
