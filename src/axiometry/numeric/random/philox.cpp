// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/random/philox.h"

namespace axiometry::numeric {
namespace {

struct Product {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
};

/// All 128 bits: one instruction where the compiler has such a type, which the language has not, else of halves.
Product product(std::uint64_t a, std::uint64_t b) {
#if defined(__SIZEOF_INT128__)
  __extension__ typedef unsigned __int128 Wide;
  const Wide whole = static_cast<Wide>(a) * b;
  return {static_cast<std::uint64_t>(whole >> 64), static_cast<std::uint64_t>(whole)};
#else
  constexpr std::uint64_t half = 0xffff'ffffu;
  const std::uint64_t low = (a & half) * (b & half);
  const std::uint64_t middle = (a >> 32) * (b & half) + (low >> 32);
  const std::uint64_t other = (a & half) * (b >> 32) + (middle & half);
  return {(a >> 32) * (b >> 32) + (middle >> 32) + (other >> 32), a * b};
#endif
}

}  // namespace

std::array<std::uint64_t, 4> philox4x64(std::array<std::uint64_t, 4> counter, std::array<std::uint64_t, 2> key) {
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const Product first = product(0xd2e7'470e'e14c'6c93u, counter[0]);
    const Product second = product(0xca5a'8263'9512'1157u, counter[2]);
    counter = {second.high ^ counter[1] ^ key[0], second.low, first.high ^ counter[3] ^ key[1], first.low};
    key[0] += 0x9e37'79b9'7f4a'7c15u;  // the golden ratio and √3 − 1
    key[1] += 0xbb67'ae85'84ca'a73bu;
  }
  return counter;
}

}  // namespace axiometry::numeric
