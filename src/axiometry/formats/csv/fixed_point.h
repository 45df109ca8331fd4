// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

/// The numbers that measuring files consist of, "-4.1" or "1055.890", eight digits at a time. Bit for bit
/// what std::from_chars gives: up to 15 digits are a whole number below 2^53, exact in a double, a power
/// of ten up to 10^22 is exact too, and one division of exact numbers rounds once (Clinger 1990).
namespace axiometry::formats {

/// A plain number and the byte behind it; `end` is null for everything else (an exponent, a plus sign,
/// more than 15 digits), which the general path reads.
struct FixedPoint {
  double value;
  const char* end;
};

/// How many bytes from its first one a number may be looked at beyond what belongs to it.
inline constexpr std::size_t fixed_point_reach = 48;

namespace detail {

struct Digits {
  std::uint64_t value;
  unsigned count;
};

inline constexpr std::uint64_t whole_powers[] = {1,
                                                 10,
                                                 100,
                                                 1'000,
                                                 10'000,
                                                 100'000,
                                                 1'000'000,
                                                 10'000'000,
                                                 100'000'000,
                                                 1'000'000'000,
                                                 10'000'000'000,
                                                 100'000'000'000,
                                                 1'000'000'000'000,
                                                 10'000'000'000'000,
                                                 100'000'000'000'000,
                                                 1'000'000'000'000'000};

inline std::uint64_t load_little_endian(const char* p) {
  std::uint64_t word;
  std::memcpy(&word, p, sizeof word);
  if constexpr (std::endian::native == std::endian::big) word = std::byteswap(word);
  return word;
}

/// The digits at the beginning of eight bytes.
inline Digits digits_of_block(const char* p) {
  const std::uint64_t word = load_little_endian(p) ^ 0x3030303030303030u;  // a digit becomes its value
  // The high bit of a byte is set where it is above 9. A carry runs only upwards, beyond the first such byte.
  const std::uint64_t other = ((word + 0x7676767676767676u) | word) & 0x8080808080808080u;
  const auto count = static_cast<unsigned>(std::countr_zero(other)) / 8;  // 8 when all are digits
  if (count == 0) return {0, 0};
  std::uint64_t v = word << (64 - 8 * count);  // leading zeros in front
  v = ((v & 0x0F0F0F0F0F0F0F0Fu) * 2561) >> 8;
  v = ((v & 0x00FF00FF00FF00FFu) * 6553601) >> 16;
  v = ((v & 0x0000FFFF0000FFFFu) * 42949672960001u) >> 32;
  return {v, count};
}

/// Up to 16 digits.
inline Digits digits_at(const char* p) {
  const Digits first = digits_of_block(p);
  if (first.count < 8) return first;
  const Digits second = digits_of_block(p + 8);
  return {first.value * whole_powers[second.count] + second.value, 8 + second.count};
}

}  // namespace detail

/// For files whose decimal mark no number has shown yet: only whole numbers are plain.
inline constexpr int no_decimal_mark = -1;

/// Reads at `p`; fixed_point_reach bytes from there must be readable.
inline FixedPoint read_fixed_point(const char* p, int decimal_mark) {
  const bool negative = *p == '-';
  p += negative;
  const detail::Digits whole = detail::digits_at(p);
  p += whole.count;
  detail::Digits fraction{0, 0};
  if (static_cast<unsigned char>(*p) == decimal_mark) {
    fraction = detail::digits_at(++p);
    p += fraction.count;
  }
  const unsigned count = whole.count + fraction.count;
  if (count == 0 || count > 15) return {0.0, nullptr};
  const auto scaled = static_cast<double>(whole.value * detail::whole_powers[fraction.count] + fraction.value);
  const double value = scaled / static_cast<double>(detail::whole_powers[fraction.count]);
  // The signs of deviations follow no pattern that a branch could be foretold by.
  const std::uint64_t sign = std::uint64_t{negative} << 63;
  return {std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ sign), p};
}

}  // namespace axiometry::formats
