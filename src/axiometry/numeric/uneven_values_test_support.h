// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {

/// 1, 2, … up to this one.
inline std::vector<std::size_t> orders(std::size_t up_to) {
  std::vector<std::size_t> result;
  for (std::size_t h = 1; h <= up_to; ++h) result.push_back(h);
  return result;
}

/// Places about one apart, none where another is.
inline std::vector<double> uneven_places(std::size_t count, std::uint64_t seed) {
  std::vector<double> places(count);
  fill_uniform({seed, 0, 0}, places);
  for (std::size_t k = 0; k < count; ++k) places[k] = static_cast<double>(k) + 0.6 * places[k];
  return places;
}

inline std::vector<double> noise(std::size_t count, std::uint64_t seed) {
  std::vector<double> values(count);
  fill_normal({seed, 1, 0}, values);
  return values;
}

template <typename Function>
std::vector<double> values_at(const std::vector<double>& places, const Function& function) {
  std::vector<double> values;
  for (double x : places) values.push_back(function(x));
  return values;
}

}  // namespace axiometry::numeric
