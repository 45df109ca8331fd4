// SPDX-License-Identifier: Apache-2.0
//
// Validation: the published vectors of Philox, a scalar xoshiro256++, and Box–Muller in long double from the same
// bits. The statistics have fixed keys, so that a test passes or fails for ever; their limits are at 5 σ.
#include "axiometry/numeric/random/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "axiometry/numeric/random/philox.h"

namespace axiometry::numeric {
namespace {

using Bits = std::uint64_t;

Bits next(std::array<Bits, 4>& s) {
  const Bits result = std::rotl(s[0] + s[3], 23) + s[0];
  const Bits t = s[1] << 17;
  s[2] ^= s[0];
  s[3] ^= s[1];
  s[1] ^= s[2];
  s[0] ^= s[3];
  s[2] ^= t;
  s[3] = std::rotl(s[3], 45);
  return result;
}

struct Exact {
  long double radius = 0;
  long double first = 0;
  long double second = 0;
};

/// Box–Muller as random.h defines it, from u and the angle within a quarter turn.
Exact exact(long double u, long double w, bool other_side, bool exchanged) {
  const long double r = std::sqrt(-2.0L * std::log(u));
  const long double angle = std::numbers::pi_v<long double> / 2 * w;
  const long double c = r * (other_side ? -std::cos(angle) : std::cos(angle));
  const long double s = r * std::sin(angle);
  return exchanged ? Exact{r, s, c} : Exact{r, c, s};
}

/// u is the nearest double of the bits, as the header says: a relative 2⁻⁵³, which is nothing but next to u = 1.
Exact exact(Bits radius_bits, Bits angle_bits) {
  const double u = static_cast<double>(radius_bits | 1) * 0x1p-64;
  const long double w = static_cast<long double>((angle_bits >> 12) | 1) * 0x1p-52L - 0.5L;
  return exact(u, w, (angle_bits & 2) != 0, (angle_bits & 1) != 0);
}

Exact exact_single(std::uint32_t radius_bits, std::uint32_t angle_bits) {
  const long double u = static_cast<long double>((radius_bits >> 1) | 1) * 0x1p-31L;
  const auto w = static_cast<long double>(static_cast<std::int32_t>((angle_bits & ~3u) | 2u)) * 0x1p-32L;
  return exact(u, w, (angle_bits & 2) != 0, (angle_bits & 1) != 0);
}

template <typename Number>
std::vector<Number> normals(RandomKey key, std::size_t count) {
  std::vector<Number> numbers(count);
  fill_normal(key, numbers);
  return numbers;
}

std::vector<double> uniforms(RandomKey key, std::size_t count) {
  std::vector<double> numbers(count);
  fill_uniform(key, numbers);
  return numbers;
}

double normal_below(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// √N·D of Kolmogorov and Smirnov; above 2.73 once in 1.7 million.
template <typename Number, typename Function>
double kolmogorov(std::vector<Number> numbers, Function below) {
  std::ranges::sort(numbers);
  const auto count = static_cast<double>(numbers.size());
  double distance = 0.0;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const double f = below(static_cast<double>(numbers[k]));
    distance = std::max({distance, f - static_cast<double>(k) / count, static_cast<double>(k + 1) / count - f});
  }
  return distance * std::sqrt(count);
}

TEST(Philox, GivesThePublishedVectors) {
  using Counter = std::array<Bits, 4>;
  constexpr Bits ones = ~Bits{0};
  EXPECT_EQ(philox4x64({0, 0, 0, 0}, {0, 0}),
            (Counter{0x16554d9eca36314c, 0xdb20fe9d672d0fdc, 0xd7e772cee186176b, 0x7e68b68aec7ba23b}));
  EXPECT_EQ(philox4x64({ones, ones, ones, ones}, {ones, ones}),
            (Counter{0x87b092c3013fe90b, 0x438c3c67be8d0224, 0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0}));
  EXPECT_EQ(philox4x64({0x243f6a8885a308d3, 0x13198a2e03707344, 0xa4093822299f31d0, 0x082efa98ec4e6c89},
                       {0x452821e638d01377, 0xbe5466cf34e90c6c}),
            (Counter{0xa528f45403e61d95, 0x38c72dbd566e9788, 0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6}));
}

TEST(RandomStream, IsEightLanesOfXoshiroThatPhiloxStarts) {
  const RandomKey key{0x0123456789abcdef, 77, 1u << 20};
  std::vector<Bits> bits(8 * 100);
  RandomStream(key).fill_bits(bits);
  for (std::size_t lane = 0; lane < 8; ++lane) {
    auto state = philox4x64({key.block, key.stream, lane, 0}, {key.seed, 0});
    for (std::size_t k = lane; k < bits.size(); k += 8) ASSERT_EQ(bits[k], next(state)) << k;
  }
}

/// From an implementation of its own in Python, with numpy's Philox and 40 digits.
TEST(Random, GivesTheNumbersOfAnotherImplementation) {
  const RandomKey key{1, 2, 3};
  const auto z = normals<double>(key, 16);
  EXPECT_NEAR(z[0] / -1.0486881756390478043, 1.0, 1e-15);
  EXPECT_NEAR(z[8] / -1.5361732913355438419, 1.0, 1e-15);
  EXPECT_NEAR(z[7] / -1.5260283126312931673, 1.0, 1e-15);
  EXPECT_NEAR(z[15] / -0.080724458649264998531, 1.0, 1e-15);
  const auto single = normals<float>(key, 32);
  EXPECT_NEAR(single[0] / 1.6149834458, 1.0, 6e-7);
  EXPECT_NEAR(single[16] / -1.94309926834, 1.0, 6e-7);
  EXPECT_NEAR(single[14] / -0.39125833761, 1.0, 6e-7);
  EXPECT_NEAR(single[30] / -0.318955577821, 1.0, 6e-7);
  EXPECT_EQ(uniforms(key, 8)[0], 0.17732206290613239386);
  EXPECT_EQ(uniforms(key, 8)[7], 0.31110045124785379311);
}

TEST(Random, HasTheSameBitsOnEveryTarget) {
  for (std::size_t count : {1u, 7u, 8u, 31u, 32u, 33u, 1000u, 4096u}) {
    std::vector<double> uniform(count), normal(count), u(count), z(count);
    std::vector<float> single(count), f(count);
    std::vector<Bits> bits(count), b(count);
    const RandomKey key{5, 6, count};
    RandomStream(key, VectorTarget::plain).fill_bits(bits);
    RandomStream(key, VectorTarget::plain).fill_uniform(uniform);
    RandomStream(key, VectorTarget::plain).fill_normal(normal);
    RandomStream(key, VectorTarget::plain).fill_normal(std::span(single));
    for (VectorTarget target : available_vector_targets()) {
      SCOPED_TRACE(std::string(vector_target_name(target)));
      RandomStream(key, target).fill_bits(b);
      RandomStream(key, target).fill_uniform(u);
      RandomStream(key, target).fill_normal(z);
      RandomStream(key, target).fill_normal(std::span(f));
      EXPECT_EQ(b, bits);
      EXPECT_EQ(u, uniform);
      EXPECT_EQ(z, normal);
      EXPECT_EQ(f, single);
    }
  }
}

TEST(Random, GivesAShorterSpanTheBeginningOfALongerOne) {
  const RandomKey key{1, 1, 1};
  const auto u = uniforms(key, 200);
  const auto z = normals<double>(key, 200);
  const auto f = normals<float>(key, 200);
  for (std::size_t count = 0; count < 200; count += 3) {
    EXPECT_TRUE(std::ranges::equal(uniforms(key, count), std::span(u).first(count)));
    EXPECT_TRUE(std::ranges::equal(normals<double>(key, count), std::span(z).first(count)));
    EXPECT_TRUE(std::ranges::equal(normals<float>(key, count), std::span(f).first(count)));
  }
}

TEST(RandomStream, ContinuesFromPieceToPiece) {
  const RandomKey key{9, 8, 7};
  const auto whole = normals<double>(key, 5 * RandomStream::group + 3);
  std::vector<double> pieces(whole.size());
  RandomStream stream(key);
  stream.fill_normal(std::span(pieces).first(2 * RandomStream::group));
  stream.fill_normal(std::span(pieces).subspan(2 * RandomStream::group));
  EXPECT_EQ(pieces, whole);
}

TEST(NormalNumbers, AreThoseOfExactArithmetic) {
  constexpr std::size_t groups = 20'000;
  std::vector<Bits> bits(16 * groups);
  RandomStream({2, 0, 0}).fill_bits(bits);
  const auto z = normals<double>({2, 0, 0}, 16 * groups);
  long double worst = 0;
  for (std::size_t k = 0; k < bits.size(); k += 16)
    for (std::size_t lane = k; lane < k + 8; ++lane) {
      const Exact e = exact(bits[lane], bits[lane + 8]);
      worst = std::max({worst, std::abs(z[lane] / e.first - 1), std::abs(z[lane + 8] / e.second - 1)});
    }
  EXPECT_LT(worst, 1e-15L);
}

/// A state whose first number is chosen: rotl(s0 + s3, 23) + s0 with s0 = 0. The second is what follows.
struct Chosen {
  RandomState state{};
  std::array<Bits, random_lanes> second{};

  explicit Chosen(const std::array<Bits, random_lanes>& first) {
    for (std::size_t lane = 0; lane < random_lanes; ++lane) {
      std::array<Bits, 4> s = {0, 0x9e3779b97f4a7c15u * (lane + 1), 1, std::rotr(first[lane], 23)};
      for (std::size_t word = 0; word < 4; ++word) state.words[word][lane] = s[word];
      next(s);
      second[lane] = next(s);
    }
  }
};

TEST(NormalNumbers, AreExactToTheEndsOfTheTails) {
  constexpr auto sqrt_half = static_cast<Bits>(0x0.b504f333f9de6484p64L);
  const std::array<Bits, random_lanes> radius_bits = {0,
                                                      2,
                                                      Bits{1} << 24,
                                                      sqrt_half & ~Bits{0x3ff},
                                                      (sqrt_half & ~Bits{0x3ff}) + 0x800,
                                                      Bits{1} << 63,
                                                      ~Bits{0} << 12,
                                                      ~Bits{0}};
  const Chosen chosen(radius_bits);
  for (VectorTarget target : available_vector_targets()) {
    std::array<double, 16> z{};
    RandomState state = chosen.state;
    random_kernel_of(target).normal(state, z.data(), 1);
    for (std::size_t lane = 0; lane < random_lanes; ++lane) {
      const Exact e = exact(radius_bits[lane], chosen.second[lane]);
      EXPECT_NEAR(z[lane], static_cast<double>(e.first), 1e-15 * std::abs(static_cast<double>(e.first))) << lane;
      EXPECT_NEAR(z[lane + 8], static_cast<double>(e.second), 1e-15 * std::abs(static_cast<double>(e.second))) << lane;
    }
    EXPECT_NEAR(std::hypot(z[0], z[8]), 9.419, 0.001) << "the longest";
    EXPECT_EQ(std::hypot(z[7], z[15]), 0.0) << "bits that round to u = 1";
  }
}

TEST(UniformNumbers, AreInsideTheOpenIntervalAndSymmetric) {
  const Chosen chosen({0, ~Bits{0}, 1, Bits{1} << 12, 0, 0, 0, 0});
  for (VectorTarget target : available_vector_targets()) {
    std::array<double, 8> u{};
    RandomState state = chosen.state;
    random_kernel_of(target).uniform(state, u.data(), 1);
    EXPECT_EQ(u[0], 0x1p-53);
    EXPECT_EQ(u[1], 1.0 - 0x1p-53);
    EXPECT_EQ(u[2], 0x1p-53);
    EXPECT_EQ(u[3], 0x3p-53);
  }
}

TEST(NormalNumbersInSinglePrecision, KeepTheirErrorBound) {
  constexpr std::size_t groups = 20'000;
  std::vector<Bits> bits(16 * groups);
  RandomStream({3, 0, 0}).fill_bits(bits);
  const auto z = normals<float>({3, 0, 0}, 32 * groups);
  for (std::size_t group = 0; group < groups; ++group)
    for (std::size_t k = 0; k < 16; ++k) {
      const auto half = [&](std::size_t word) {
        return static_cast<std::uint32_t>(bits[16 * group + word] >> (k % 2 ? 32 : 0));
      };
      const Exact e = exact_single(half(k / 2), half(8 + k / 2));
      const long double relative = 6e-7L + 1.3e-7L / (e.radius * e.radius);
      ASSERT_LE(std::abs(z[32 * group + k] - e.first), relative * std::abs(e.first)) << group << ' ' << k;
      ASSERT_LE(std::abs(z[32 * group + 16 + k] - e.second), relative * std::abs(e.second)) << group << ' ' << k;
    }
}

template <typename Number>
void expect_normal_moments(RandomKey key, std::size_t count) {
  const auto z = normals<Number>(key, count);
  std::array<double, 5> sums{};
  for (double x : z)
    for (double power = x; double& sum : std::span(sums).subspan(1)) {
      sum += power;
      power *= x;
    }
  const auto n = static_cast<double>(count);
  EXPECT_NEAR(sums[1] / n, 0.0, 5 * std::sqrt(1 / n));
  EXPECT_NEAR(sums[2] / n, 1.0, 5 * std::sqrt(2 / n));
  EXPECT_NEAR(sums[3] / n, 0.0, 5 * std::sqrt(15 / n));
  EXPECT_NEAR(sums[4] / n, 3.0, 5 * std::sqrt(96 / n));
}

TEST(NormalNumbers, HaveTheMomentsOfTheNormalDistribution) { expect_normal_moments<double>({4, 0, 0}, 4'000'000); }
TEST(NormalNumbersInSinglePrecision, HaveTheMomentsToo) { expect_normal_moments<float>({4, 0, 0}, 4'000'000); }

TEST(Random, HasTheRightDistributionFunctions) {
  EXPECT_LT(kolmogorov(uniforms({5, 0, 0}, 500'000), [](double x) { return x; }), 2.73);
  EXPECT_LT(kolmogorov(normals<double>({5, 0, 0}, 500'000), normal_below), 2.73);
  EXPECT_LT(kolmogorov(normals<float>({5, 0, 0}, 500'000), normal_below), 2.73);
}

template <typename Number>
void expect_normal_tails(RandomKey key) {
  constexpr std::size_t count = 8'000'000;
  const auto z = normals<Number>(key, count);
  for (double limit : {1.0, 2.0, 3.0, 4.0, 4.5, 5.0}) {
    const double expected = static_cast<double>(count) * normal_below(-limit);
    const auto above = std::ranges::count_if(z, [=](double x) { return x > limit; });
    const auto below = std::ranges::count_if(z, [=](double x) { return x < -limit; });
    EXPECT_NEAR(static_cast<double>(above), expected, 5 * std::sqrt(expected)) << limit;
    EXPECT_NEAR(static_cast<double>(below), expected, 5 * std::sqrt(expected)) << limit;
  }
}

TEST(NormalNumbers, HaveTheRightTails) { expect_normal_tails<double>({6, 0, 0}); }
TEST(NormalNumbersInSinglePrecision, HaveTheRightTails) { expect_normal_tails<float>({6, 0, 0}); }

/// √N times the correlation of two sequences of mean 0 and standard deviation 1: standard normal.
double correlation(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum / std::sqrt(static_cast<double>(a.size()));
}

std::vector<double> squares(std::vector<double> z) {
  for (double& x : z) x = (x * x - 1) / std::numbers::sqrt2;
  return z;
}

TEST(Random, IsIndependentBetweenNeighbouringKeys) {
  constexpr std::size_t count = 100'000;
  const RandomKey key{7, 7, 7};
  const auto z = normals<double>(key, count);
  for (RandomKey other : {RandomKey{8, 7, 7}, RandomKey{7, 8, 7}, RandomKey{7, 7, 8}, RandomKey{6, 7, 7},
                          RandomKey{7, 6, 7}, RandomKey{7, 7, 6}, RandomKey{7, 7, Bits{1} << 63}}) {
    const auto y = normals<double>(other, count);
    EXPECT_LT(std::abs(correlation(z, y)), 5);
    EXPECT_LT(std::abs(correlation(squares(z), squares(y))), 5) << "their sizes";
  }
  EXPECT_NE(normals<double>({1, 2, 0}, 8), normals<double>({2, 1, 0}, 8)) << "the members are not exchangeable";
}

TEST(Random, IsIndependentWithinASequence) {
  constexpr std::size_t count = 100'000;
  const auto z = normals<double>({10, 0, 0}, count + 64);
  const auto sizes = squares(z);
  for (std::size_t lag : {1u, 2u, 7u, 8u, 9u, 16u, 32u, 64u}) {
    EXPECT_LT(std::abs(correlation(std::span(z).first(count), std::span(z).subspan(lag, count))), 5) << lag;
    EXPECT_LT(std::abs(correlation(std::span(sizes).first(count), std::span(sizes).subspan(lag, count))), 5) << lag;
  }
}

/// Many short sequences, as blocks of trials use them: the first numbers of successive blocks are a sample too.
TEST(Random, StartsEveryBlockAnew) {
  std::vector<double> firsts;
  for (Bits block = 0; block < 20'000; ++block) firsts.push_back(normals<double>({11, 3, block}, 1).front());
  EXPECT_LT(kolmogorov(firsts, normal_below), 2.73);
  const std::span all(firsts);
  EXPECT_LT(std::abs(correlation(all.first(firsts.size() - 1), all.subspan(1))), 5);
}

}  // namespace
}  // namespace axiometry::numeric
