// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "axiometry/numeric/random/random_kernel_types.h"
#include "axiometry/numeric/vector_target.h"

/// Random numbers that depend on their place alone: the same key gives the same numbers on any number of
/// threads, in any order and on any processor (only IEEE 754 operations, nothing contracted).
///
/// Method: xoshiro256++ (Blackman and Vigna 2019) in eight lanes, whose starting states are Philox4x64-10 (Salmon et
/// al. 2011) of the counters (block, stream, lane, 0) under the key (seed, 0).
///
/// Independence: Philox is a permutation of the counters, so no two lanes of any stream and block of one seed start
/// alike, and states of neighbouring keys differ as random ones do. Of K lanes that each give L numbers out of the
/// period 2²⁵⁶ − 1, some two overlap with a probability below K²·L·2⁻²⁵⁶: for 2⁴⁰ lanes of 2⁴⁰ numbers 2⁻¹³⁶.
/// The state zero, which xoshiro must not have, is replaced; it comes once in 2²⁵⁶.
namespace axiometry::numeric {

/// A place: one seed per calculation, one stream per random quantity, one block per group of trials.
/// Different keys give independent sequences.
struct RandomKey {
  std::uint64_t seed = 0;
  std::uint64_t stream = 0;
  std::uint64_t block = 0;
};

/// Fills with independent numbers from the open interval (0, 1): the centres of 2⁵² equal parts. A shorter span
/// gets the beginning of what a longer one gets.
void fill_uniform(RandomKey key, std::span<double> numbers);

/// Fills with independent standard normal numbers; the same holds.
///
/// Box–Muller from 64 bits for the radius and 53 for the angle. Each number is within 1e-15 of itself (relative) of
/// what exact arithmetic makes of these bits (found: 7e-16). The tails reach 9.42: P(|z| > x) is right to 1e-6 of
/// itself down to 1e-12 (grid of the radius: 2⁻⁶³ of its tail probability).
void fill_normal(RandomKey key, std::span<double> numbers);

/// The same in single precision, from 31 and 32 bits; other numbers than those in double precision.
///
/// |z − z'| ≤ (6e-7 + 1.3e-7/r²)·|z'| for the exact z' of the same bits at the radius r of its pair; the second term
/// is the rounding of u next to 1. The distribution function is therefore within 3e-7 of the normal one everywhere:
/// 0.242·6e-7 for the first term (the largest |z|·φ(z)), 2⁻²⁴ for u, 2⁻³¹ for its grid. That of 10⁶ trials has a
/// statistical error of 5e-4. The tails end at 6.56 (6e-11 lie beyond).
void fill_normal(RandomKey key, std::span<float> numbers);

/// A sequence taken in pieces. A piece begins a new group of numbers: pieces of a multiple of `group` numbers are what
/// one fill would give, of other pieces the rest of the last group is lost.
class RandomStream {
 public:
  static constexpr std::size_t group = 32;

  explicit RandomStream(RandomKey key, VectorTarget target = best_vector_target());

  void fill_bits(std::span<std::uint64_t> numbers);  ///< whole numbers, all 64 bits random
  void fill_uniform(std::span<double> numbers);
  void fill_normal(std::span<double> numbers);
  void fill_normal(std::span<float> numbers);

 private:
  alignas(64) RandomState state_;
  const RandomKernel* kernel_;
};

}  // namespace axiometry::numeric
