// SPDX-License-Identifier: Apache-2.0
#pragma once

// The random numbers of random.h for one target; compiled once for each (vector_target.h). The lanes of the
// generator are cut into parts as wide as a register; a part is independent of the others, so its state stays in
// registers while all groups are made.
#include "axiometry/numeric/kernels/lanes.h"
#include "axiometry/numeric/random/logarithm_lanes.h"
#include "axiometry/numeric/random/random_kernel_types.h"

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the order of half words decides which number is which");

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {
namespace {

[[gnu::always_inline]] inline Words rotated_left(Words x, int by) { return (x << by) | (x >> (64 - by)); }

/// xoshiro256++ 1.0 of Blackman and Vigna (2019), some lanes of it.
struct Generator {
  Words s0, s1, s2, s3;

  [[gnu::always_inline]] Generator(const RandomState& state, size_t lane)
      : s0(load<Words>(state.words[0] + lane)),
        s1(load<Words>(state.words[1] + lane)),
        s2(load<Words>(state.words[2] + lane)),
        s3(load<Words>(state.words[3] + lane)) {}

  [[gnu::always_inline]] void save(RandomState& state, size_t lane) const {
    store(state.words[0] + lane, s0);
    store(state.words[1] + lane, s1);
    store(state.words[2] + lane, s2);
    store(state.words[3] + lane, s3);
  }

  [[gnu::always_inline]] Words next() {
    const Words result = rotated_left(s0 + s3, 23) + s0;
    const Words shifted = s1 << 17;
    s2 ^= s0;
    s3 ^= s1;
    s1 ^= s2;
    s0 ^= s3;
    s2 ^= shifted;
    s3 = rotated_left(s3, 45);
    return result;
  }
};

/// Calls make(generator, lane of the first, group) for every part and group.
template <typename Make>
[[gnu::always_inline]] inline void for_each_group(RandomState& state, size_t groups, Make make) {
  for (size_t lane = 0; lane < random_lanes; lane += lanes<Doubles>) {
    Generator generator(state, lane);
#pragma GCC unroll 8  // its scheduling puts independent groups side by side: a fifth faster
    for (size_t group = 0; group < groups; ++group) make(generator, lane, group);
    generator.save(state, lane);
  }
}

template <typename Vector>
struct Pair {
  Vector first, second;
};

/// √(−2 ln u), u = (bits | 1)·2⁻⁶⁴ rounded: 0 to 9.43.
[[gnu::always_inline]] inline Doubles radius(Words bits) {
  return square_root(minus_two_ln(converted(bits | uint64_t{1}), 64.0));
}

/// Box–Muller: two independent normal numbers from a radius and an angle. The angle within a quarter turn has 51
/// bits, symmetric about zero; one bit more chooses the half plane and one which of both is the sine.
[[gnu::always_inline]] inline Pair<Doubles> normal_pair(Words radius_bits, Words angle_bits) {
  const Doubles r = radius(radius_bits);
  const Doubles w = reinterpret_cast<Doubles>((angle_bits >> 12) | (exponent_of_1 | 1)) - 1.5;
  const Doubles z = w * w;
  const Words sine = reinterpret_cast<Words>(w * polynomial(z, NormalPolynomials<double>::sine));
  const Words side = (angle_bits << 62) & 0x8000'0000'0000'0000u;
  const Words cosine = reinterpret_cast<Words>(polynomial(z, NormalPolynomials<double>::cosine)) ^ side;
  const Words exchange = (sine ^ cosine) & -(angle_bits & uint64_t{1});
  return {r * reinterpret_cast<Doubles>(cosine ^ exchange), r * reinterpret_cast<Doubles>(sine ^ exchange)};
}

/// √(−2 ln u), u = (bits/2 | 1)·2⁻³¹ rounded: 0 to 6.56.
[[gnu::always_inline]] inline Floats radius(HalfWords bits) {
  constexpr uint32_t root_half = 0x3f35'04f3u;
  const Integers odd = reinterpret_cast<Integers>((bits >> 1) | 1u);
  const HalfWords x = reinterpret_cast<HalfWords>(__builtin_convertvector(odd, Floats));
  const HalfWords above = x - root_half;
  const Floats m = reinterpret_cast<Floats>(x - (above & 0xff80'0000u));
  const Floats exponent = __builtin_convertvector(reinterpret_cast<Integers>(above >> 23) - 31, Floats);
  const Floats s = (m - 1.0f) / (m + 1.0f);
  constexpr float minus_2_ln_2 = -0x1.62e43p+0f;
  return square_root(exponent * minus_2_ln_2 + s * polynomial(s * s, NormalPolynomials<float>::logarithm));
}

[[gnu::always_inline]] inline Pair<Floats> normal_pair(HalfWords radius_bits, HalfWords angle_bits) {
  const Floats r = radius(radius_bits);
  const Integers angle = reinterpret_cast<Integers>((angle_bits & ~3u) | 2u);
  const Floats w = __builtin_convertvector(angle, Floats) * 0x1p-32f;
  const Floats z = w * w;
  const HalfWords sine = reinterpret_cast<HalfWords>(w * polynomial(z, NormalPolynomials<float>::sine));
  const HalfWords side = (angle_bits << 30) & 0x8000'0000u;
  const HalfWords cosine = reinterpret_cast<HalfWords>(polynomial(z, NormalPolynomials<float>::cosine)) ^ side;
  const HalfWords exchange = (sine ^ cosine) & -(angle_bits & 1u);
  return {r * reinterpret_cast<Floats>(cosine ^ exchange), r * reinterpret_cast<Floats>(sine ^ exchange)};
}

void make_bits(RandomState& state, uint64_t* numbers, size_t groups) {
  for_each_group(state, groups, [=](Generator& generator, size_t lane, size_t group) {
    store(numbers + group * RandomKernel::bits_group + lane, generator.next());
  });
}

void make_uniform(RandomState& state, double* numbers, size_t groups) {
  for_each_group(state, groups, [=](Generator& generator, size_t lane, size_t group) {
    const Doubles above_1 = reinterpret_cast<Doubles>((generator.next() >> 12) | exponent_of_1);
    store(numbers + group * RandomKernel::uniform_group + lane, above_1 - (1.0 - 0x1p-53));
  });
}

void make_normal(RandomState& state, double* numbers, size_t groups) {
  for_each_group(state, groups, [=](Generator& generator, size_t lane, size_t group) {
    const Words radius_bits = generator.next();
    const Pair<Doubles> pair = normal_pair(radius_bits, generator.next());
    double* const to = numbers + group * RandomKernel::normal_group + lane;
    store(to, pair.first);
    store(to + RandomKernel::normal_group / 2, pair.second);
  });
}

void make_normal_single(RandomState& state, float* numbers, size_t groups) {
  for_each_group(state, groups, [=](Generator& generator, size_t lane, size_t group) {
    const HalfWords radius_bits = reinterpret_cast<HalfWords>(generator.next());
    const Pair<Floats> pair = normal_pair(radius_bits, reinterpret_cast<HalfWords>(generator.next()));
    float* const to = numbers + group * RandomKernel::normal_single_group + 2 * lane;
    store(to, pair.first);
    store(to + RandomKernel::normal_single_group / 2, pair.second);
  });
}

}  // namespace

extern const RandomKernel random_kernel;
const RandomKernel random_kernel = {make_bits, make_uniform, make_normal, make_normal_single};

}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
