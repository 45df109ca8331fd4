// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/random.h"

#include <cmath>
#include <numbers>

namespace axiometry::numeric {
namespace {
std::uint64_t mix(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}
std::uint64_t start(RandomKey k) {
  return mix(mix(mix(k.seed + 0x9e3779b97f4a7c15u) + k.stream * 0x9e3779b97f4a7c15u) + k.block * 0xd1342543de82ef95u);
}
double unit(std::uint64_t x) { return (static_cast<double>(x >> 12) + 0.5) * 0x1p-52; }
}  // namespace
void fill_uniform(RandomKey key, std::span<double> numbers) {
  std::uint64_t s = start(key);
  for (double& x : numbers) x = unit(mix(s += 0x9e3779b97f4a7c15u));
}
void fill_normal(RandomKey key, std::span<double> numbers) {
  std::uint64_t s = start(key) ^ 0x5555;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    const double r = std::sqrt(-2 * std::log(unit(mix(s += 0x9e3779b97f4a7c15u))));
    const double a = 2 * std::numbers::pi * unit(mix(s += 0x9e3779b97f4a7c15u));
    numbers[i] = r * std::cos(a);
    if (i + 1 < numbers.size()) numbers[i + 1] = r * std::sin(a);
  }
}
}  // namespace axiometry::numeric
