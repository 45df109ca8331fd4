// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

/// Random numbers that depend on their place alone: the same key gives the same numbers on any number of
/// threads, in any order and on any processor (only IEEE 754 operations, nothing contracted).
namespace axiometry::numeric {

/// A place: one seed per calculation, one stream per random quantity, one block per group of trials.
/// Different keys give independent sequences.
struct RandomKey {
  std::uint64_t seed = 0;
  std::uint64_t stream = 0;
  std::uint64_t block = 0;
};

/// Fills with independent numbers from the open interval (0, 1). A shorter span gets the beginning of
/// what a longer one gets.
void fill_uniform(RandomKey key, std::span<double> numbers);

/// Fills with independent standard normal numbers; the same holds.
void fill_normal(RandomKey key, std::span<double> numbers);

}  // namespace axiometry::numeric
