// SPDX-License-Identifier: Apache-2.0
#pragma once

// The moments of moment_kernel_types.h for one target; compiled once for each (numeric/vector_target.h). Operation by
// operation in the order that is written here.
#include "axiometry/numeric/kernels/lanes.h"
#include "axiometry/numeric/random/logarithm_lanes.h"
#include "axiometry/standards/iso230_2/monte_carlo/kernels/moment_kernel_types.h"

namespace axiometry::iso230_2::AXIOMETRY_VECTOR_TARGET {
namespace {

using namespace numeric::AXIOMETRY_VECTOR_TARGET;

template <size_t n>
struct KnownCount {
  constexpr operator size_t() const { return n; }
};

constexpr size_t factors_at_once = 8;  // factors of a product whose logarithm is taken: below 2^512 of 64 bits each

template <typename Count>
[[gnu::always_inline]] inline void about_mean_of(const CellShifts& cell, Count count) {
  for (size_t t = 0; t < cell.trials; t += lanes<Doubles>) {
    Doubles mean{};
    for (size_t j = 0; j < count; ++j) mean += load<Doubles>(cell.shifts[j] + t);
    mean /= static_cast<double>(static_cast<size_t>(count));
    store(cell.mean + t, mean);
    for (size_t j = 0; j < count; ++j) store(cell.about[j] + t, load<Doubles>(cell.shifts[j] + t) - mean);
  }
}

void about_mean(const CellShifts& cell) {
  if (cell.count == standard_approaches) return about_mean_of(cell, KnownCount<standard_approaches>{});
  about_mean_of(cell, cell.count);
}

/// 2⁶⁴ times a uniform number from (0, 1].
[[gnu::always_inline]] inline Doubles unit_of_64_bits(const uint64_t* bits) {
  return converted(load<Words>(bits) | uint64_t{1});
}

/// A uniform number between 1 and 2, in equal steps symmetric about 1½.
[[gnu::always_inline]] inline Doubles unit_above_1(const uint64_t* bits) {
  return reinterpret_cast<Doubles>((load<Words>(bits) >> 12) | (exponent_of_1 | 1));
}

/// cos of an angle that is uniform between 0 and π: 2 cos² − 1 of half of one between 0 and π/2, with either sign.
[[gnu::always_inline]] inline Doubles any_cosine(const uint64_t* bits) {
  const Doubles w = unit_above_1(bits) - 1.5;
  const Doubles cosine = polynomial(w * w, numeric::NormalPolynomials<double>::cosine);
  const Words side = load<Words>(bits) << 63;
  return reinterpret_cast<Doubles>(reinterpret_cast<Words>(2.0 * (cosine * cosine) - 1.0) ^ side);
}

/// |v|²
template <typename Count>
[[gnu::always_inline]] inline Doubles own_squares(const MomentsInNoise& cell, Doubles machine, size_t t, Count count) {
  Doubles squares{};
  for (size_t j = 0; j < count; ++j) {
    const Doubles own = load<Doubles>(cell.about[j] + t) + machine * cell.residuals[j];
    squares += own * own;
  }
  return squares;
}

/// χ² of n − 2 degrees of freedom.
[[gnu::always_inline]] inline Doubles squares_beside(const MomentsInNoise& cell, size_t t) {
  Doubles squares{};
  if (cell.count % 2 == 1) {
    const Doubles z = load<Doubles>(cell.normals + cell.trials + t);
    squares = z * z;
  }
  const size_t rows = (cell.count - 2) / 2;
  for (size_t first = 0; first < rows; first += factors_at_once) {
    const size_t end = first + factors_at_once < rows ? first + factors_at_once : rows;
    Doubles product = unit_of_64_bits(cell.bits + first * cell.trials + t);
    for (size_t k = first + 1; k < end; ++k) product *= unit_of_64_bits(cell.bits + k * cell.trials + t);
    squares += minus_two_ln(product, 64.0 * static_cast<double>(end - first));
  }
  return squares;
}

/// Of the squares this part, 1/(n − 1), is a variance; they are below 0 by rounding alone.
[[gnu::always_inline]] inline void store_moments(const MomentsInNoise& cell, Doubles squares, double part, size_t t) {
  store(cell.means + t, load<Doubles>(cell.own_means + t) + load<Doubles>(cell.shift + t));
  store(cell.estimators + t, square_root(larger(Doubles{}, squares) * part));
}

void five_in_noise(const MomentsInNoise& cell) {
  const uint64_t *const first = cell.bits, *const second = first + cell.trials, *const third = second + cell.trials,
                        *const fourth = third + cell.trials;
#pragma GCC unroll 2  // independent trials side by side
  for (size_t t = 0; t < cell.trials; t += lanes<Doubles>) {
    const Doubles machine = load<Doubles>(cell.machines + t);
    const Doubles own = own_squares(cell, machine, t, KnownCount<standard_approaches>{});
    const Doubles length =
        machine * cell.noise_variance * minus_two_ln(unit_of_64_bits(first + t) * unit_of_64_bits(second + t), 128.0);
    const Doubles along = square_root(own * length * (unit_above_1(third + t) - 1.0)) * any_cosine(fourth + t);
    store_moments(cell, own + (along + along) + length, 0.25, t);
  }
}

void in_noise(const MomentsInNoise& cell) {
  if (cell.count == standard_approaches) return five_in_noise(cell);
  for (size_t t = 0; t < cell.trials; t += lanes<Doubles>) {
    if (cell.count < 2) {
      store_moments(cell, Doubles{}, 1.0, t);
      continue;
    }
    const Doubles machine = load<Doubles>(cell.machines + t), noise = machine * cell.noise_variance;
    const Doubles own = own_squares(cell, machine, t, cell.count), z = load<Doubles>(cell.normals + t);
    const Doubles along = square_root(own * noise) * z;
    store_moments(cell, own + (along + along) + noise * (z * z + squares_beside(cell, t)),
                  1.0 / static_cast<double>(cell.count - 1), t);
  }
}

}  // namespace

extern const MomentKernel moment_kernel;
const MomentKernel moment_kernel = {about_mean, in_noise};

}  // namespace axiometry::iso230_2::AXIOMETRY_VECTOR_TARGET
