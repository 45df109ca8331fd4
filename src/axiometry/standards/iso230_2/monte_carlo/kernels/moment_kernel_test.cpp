// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/monte_carlo/kernels/moment_kernel_types.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double beyond_chance = 2.73;  // √N·D of Kolmogorov and Smirnov: above it once in 1.7 million

/// A cell of some readings, the same in every trial but for the random numbers.
struct MomentCase {
  MomentCase(std::size_t count, std::size_t trials, double own_length) : trials(trials), count(count) {
    for (std::size_t j = 0; j < count; ++j) {  // v = q − q̄ + w r of this length, where n > 1
      const double along = std::cos(std::numbers::pi * (double(j) + 0.5) / double(count));
      const double unit = count > 1 ? along / std::sqrt(0.5 * double(count)) : 0.0;
      residuals.push_back(0.25 * own_length * unit / machine);
      about.emplace_back(trials, 0.75 * own_length * unit);
    }
    const MomentNumbers numbers = moment_numbers(count);
    normals.resize(numbers.normals * trials);
    bits.resize(numbers.bits * trials);
    numeric::fill_normal({21, 0, count}, normals);
    numeric::RandomStream({21, 1, count}).fill_bits(bits);
  }

  struct Found {
    std::vector<double> means, estimators;
  };
  Found moments(const MomentKernel& kernel) const {
    const std::vector<double> machines(trials, machine), shift(trials, 0.5), own_means(trials, 2.0);
    Found found{std::vector<double>(trials), std::vector<double>(trials, -1.0)};
    std::vector<const double*> rows;
    for (const auto& row : about) rows.push_back(row.data());
    kernel.in_noise({trials, count, noise_variance, residuals.data(), machines.data(), rows.data(), shift.data(),
                     normals.data(), bits.data(), own_means.data(), found.means.data(), found.estimators.data()});
    return found;
  }

  /// A uniform number as the kernel has it for logarithms.
  double unit(std::size_t row, std::size_t t) const {
    return static_cast<double>(bits[row * trials + t] | 1u) * 0x1p-64;
  }

  std::size_t trials, count;
  double machine = 0.6, noise_variance = 0.5;
  std::vector<double> residuals, normals;
  std::vector<std::vector<double>> about;
  std::vector<std::uint64_t> bits;
};

/// S of (1a), by the functions of the library.
double squares_of(const MomentCase& c, std::size_t t) {
  double own = 0.0;
  for (std::size_t j = 0; j < c.count; ++j) own += std::pow(c.about[j][t] + c.machine * c.residuals[j], 2);
  const double noise = c.machine * c.noise_variance;
  if (c.count == standard_approaches) {
    const double length = -2.0 * (std::log(c.unit(0, t)) + std::log(c.unit(1, t)));
    const double share = (static_cast<double>(c.bits[2 * c.trials + t] >> 12) + 0.5) * 0x1p-52;
    const double half_angle =
        0.5 * std::numbers::pi * ((static_cast<double>(c.bits[3 * c.trials + t] >> 12) + 0.5) * 0x1p-52 - 0.5);
    const double cosine = std::cos(2.0 * half_angle) * (c.bits[3 * c.trials + t] % 2 == 1 ? -1.0 : 1.0);
    return own + 2.0 * std::sqrt(own * noise * length * share) * cosine + noise * length;
  }
  const double z = c.normals[t];
  double beside = c.count % 2 == 1 ? std::pow(c.normals[c.trials + t], 2) : 0.0;
  for (std::size_t k = 0; k < (c.count - 2) / 2; ++k) beside += -2.0 * std::log(c.unit(k, t));
  return own + 2.0 * std::sqrt(own * noise) * z + noise * (z * z + beside);
}

/// P(χ² ≤ x) of ν degrees of freedom about a centre at a distance of √λ: chances of Poisson of central ones.
double noncentral_probability(double x, double freedom, double lambda) {
  double sum = 0.0;
  for (int k = 0; k < 100; ++k) {
    const double log_weight =
        lambda == 0.0 ? (k == 0 ? 0.0 : -1e300) : -0.5 * lambda + k * std::log(0.5 * lambda) - std::lgamma(k + 1.0);
    if (log_weight < -40.0) continue;
    sum += std::exp(log_weight) * numeric::chi_square_probability(x, freedom + 2.0 * k);
  }
  return sum;
}

TEST(MomentKernel, DrawsAsTheFormulaSaysOnEveryTarget) {
  for (std::size_t count : {1u, 2u, 3u, 4u, 5u, 6u, 9u, 18u, 20u, 37u}) {
    const MomentCase c(count, 48, 1.5);
    const auto reference = c.moments(moment_kernel_of(numeric::VectorTarget::plain));
    for (std::size_t t = 0; t < c.trials; ++t) {
      ASSERT_EQ(reference.means[t], 2.5);
      const double expected = count < 2 ? 0.0 : std::sqrt(squares_of(c, t) / double(count - 1));
      // √ of what is left of squares of about 1 to 50: their rounding counts most where s is small.
      ASSERT_NEAR(reference.estimators[t], expected, 1e-13 / std::max(expected, 0.01)) << count << ", " << t;
    }
    for (numeric::VectorTarget target : numeric::available_vector_targets()) {
      SCOPED_TRACE(std::string(numeric::vector_target_name(target)));
      const auto found = c.moments(moment_kernel_of(target));
      ASSERT_EQ(found.means, reference.means);
      ASSERT_EQ(found.estimators, reference.estimators);
    }
  }
}

/// Validation: (n − 1) s²/c² is χ² of n − 1 degrees of freedom about a centre at |v|/c.
TEST(MomentKernel, HasTheNoncentralChiSquareDistribution) {
  AXIOMETRY_STATISTICS_OF_TRIALS();
  constexpr std::size_t trials = 160'000, looks = 400;
  for (std::size_t count : {2u, 3u, 4u, 5u, 6u, 7u, 20u})
    for (double lambda : {0.0, 1.0, 20.0}) {
      const double noise = 0.6 * 0.5;
      const MomentCase c(count, trials, std::sqrt(lambda * noise));
      auto s = c.moments(moment_kernel_of(numeric::best_vector_target())).estimators;
      std::ranges::sort(s);
      double distance = 0.0;
      for (std::size_t k = 0; k < looks; ++k) {
        const std::size_t rank = trials * k / looks;
        const double squares = s[rank] * s[rank] * double(count - 1) / noise;
        const double expected = noncentral_probability(squares, double(count - 1), lambda);
        distance = std::max(distance, std::abs(expected - (double(rank) + 0.5) / double(trials)));
      }
      EXPECT_LT(distance * std::sqrt(double(trials)), beyond_chance) << count << " readings, λ = " << lambda;
    }
}

TEST(MomentKernel, PartsShiftsIntoTheirMeanAndWhatIsAboutItOnEveryTarget) {
  constexpr std::size_t trials = 32;
  for (std::size_t count : {1u, 2u, 5u, 7u}) {
    std::vector<double> shifts(count * trials);
    numeric::fill_normal({22, 0, count}, shifts);
    for (numeric::VectorTarget target : numeric::available_vector_targets()) {
      SCOPED_TRACE(std::string(numeric::vector_target_name(target)));
      std::vector<double> about = shifts, mean(trials);
      std::vector<const double*> from;
      std::vector<double*> to;
      for (std::size_t j = 0; j < count; ++j) {
        from.push_back(about.data() + j * trials);
        to.push_back(about.data() + j * trials);
      }
      moment_kernel_of(target).about_mean({trials, count, from.data(), to.data(), mean.data()});
      for (std::size_t t = 0; t < trials; ++t) {
        std::vector<double> own;
        for (std::size_t j = 0; j < count; ++j) own.push_back(shifts[j * trials + t]);
        ASSERT_EQ(mean[t], numeric::moments(own).mean);
        for (std::size_t j = 0; j < count; ++j) ASSERT_EQ(about[j * trials + t], own[j] - mean[t]);
      }
    }
  }
}

}  // namespace
}  // namespace axiometry::iso230_2
