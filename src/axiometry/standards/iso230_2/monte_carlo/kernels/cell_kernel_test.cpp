// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "axiometry/numeric/moments.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/monte_carlo/kernels/cell_kernel_types.h"

namespace axiometry::iso230_2 {
namespace {

constexpr std::size_t kernel_trials = 29;  // whole registers of every target, and a rest

std::vector<double> normal_rows(std::uint64_t stream, std::size_t rows) {
  std::vector<double> numbers(rows * kernel_trials);
  numeric::fill_normal({11, stream, 0}, numbers);
  return numbers;
}

/// Calls check(kernel) for every target.
template <typename Check>
void for_every_kernel(const Check& check) {
  for (numeric::VectorTarget target : numeric::available_vector_targets()) {
    SCOPED_TRACE(std::string(numeric::vector_target_name(target)));
    check(cell_kernel_of(target));
  }
}

TEST(CellKernel, SharesAsTheFormulaSaysOnEveryTarget) {
  const auto z = normal_rows(1, 5);
  const double* const rows = z.data();
  std::vector<double> sds(rows, rows + kernel_trials);
  for (double& sd : sds) sd = std::max(0.0, sd);  // some scatter by nothing
  for (const double noise : {0.0, 0.09})
    for (const double own : {0.0, 0.04})
      for_every_kernel([&](const CellKernel& kernel) {
        std::vector<double> means(rows + kernel_trials, rows + 2 * kernel_trials), machines(kernel_trials);
        const std::vector<double> before = means;
        kernel.share({.trials = kernel_trials,
                      .observed_mean = 0.7,
                      .count = 5.0,
                      .noise_variance = noise,
                      .own_variance = own,
                      .sds = sds.data(),
                      .shift = rows + 2 * kernel_trials,
                      .direction_normals = rows + 3 * kernel_trials,
                      .reading_normals = rows + 4 * kernel_trials,
                      .means = means.data(),
                      .machines = machines.data()});
        for (std::size_t t = 0; t < kernel_trials; ++t) {
          const double scatter = sds[t] * sds[t];
          const double machine = scatter == 0.0 ? 0.0 : scatter / (scatter + noise);
          double left = 0.7 - before[t] - rows[2 * kernel_trials + t];
          if (own > 0.0) {
            const double variance = (scatter + noise) / 5.0, part = own / (own + variance);
            left -= part * left + std::sqrt(part * variance) * rows[3 * kernel_trials + t];
          }
          ASSERT_EQ(machines[t], machine);
          ASSERT_EQ(means[t],
                    before[t] + (machine * left + std::sqrt(machine * noise / 5.0) * rows[4 * kernel_trials + t]));
        }
      });
}

TEST(CellKernel, MakesReadingsAboutTheirMeanOnEveryTarget) {
  const double residuals[] = {0.3, -0.2, 0.5, -0.4, -0.2, 0.1, -0.1};
  const auto z = normal_rows(2, 2 + 2 * std::size(residuals));
  std::vector<double> machines(kernel_trials, 0.25);
  for (const double noise : {0.0, 0.3})
    for (std::size_t count : {1u, 5u, 7u})
      for_every_kernel([&](const CellKernel& kernel) {
        std::vector<double> memory(count * kernel_trials);
        std::vector<const double*> shifts;
        std::vector<double*> readings;
        for (std::size_t j = 0; j < count; ++j) {
          shifts.push_back(z.data() + (2 + j) * kernel_trials);
          readings.push_back(memory.data() + j * kernel_trials);
        }
        const double* const normals = z.data() + (2 + count) * kernel_trials;
        kernel.readings({kernel_trials, count, noise, residuals, z.data(), machines.data(), shifts.data(), normals,
                         readings.data()});
        for (std::size_t t = 0; t < kernel_trials; ++t) {
          double about = 0.0;
          for (std::size_t j = 0; j < count; ++j)
            about += std::sqrt(0.25) * noise * normals[j * kernel_trials + t] / double(count);
          for (std::size_t j = 0; j < count; ++j)
            ASSERT_EQ(readings[j][t], z[t] + shifts[j][t] + 0.25 * residuals[j] +
                                          std::sqrt(0.25) * noise * normals[j * kernel_trials + t] - about)
                << count << " readings, " << noise;
        }
      });
}

TEST(CellKernel, FindsMomentsOfMovedReadingsOnEveryTarget) {
  const auto z = normal_rows(3, 9);
  for (std::size_t count : {1u, 2u, 5u, 7u})
    for (const bool moved : {false, true})
      for_every_kernel([&](const CellKernel& kernel) {
        std::vector<const double*> readings;
        for (std::size_t j = 0; j < count; ++j) readings.push_back(z.data() + (2 + j) * kernel_trials);
        std::vector<double> means(kernel_trials), estimators(kernel_trials, -1.0);
        kernel.moments({kernel_trials, count, readings.data(), 250.0, moved ? z.data() : nullptr,
                        moved ? z.data() + kernel_trials : nullptr, means.data(), estimators.data()});
        for (std::size_t t = 0; t < kernel_trials; ++t) {
          std::vector<double> cell;
          for (const double* row : readings)
            cell.push_back(moved ? row[t] + 250.0 * z[t] - z[kernel_trials + t] : row[t]);
          const numeric::Moments expected = numeric::moments(cell);
          ASSERT_EQ(means[t], expected.mean) << count;
          ASSERT_EQ(estimators[t], expected.standard_deviation) << count;
        }
      });
}

TEST(CellKernel, SharesTheShiftsOfRunsOnEveryTarget) {
  constexpr std::size_t cells = 3, runs = 2;
  const auto z = normal_rows(4, cells + 1 + runs);
  const double observed[] = {0.8, -0.8};
  for (const double noise : {0.0, 0.09})
    for_every_kernel([&](const CellKernel& kernel) {
      const double measured = noise == 0.0 ? 0.0 : 0.04 + noise / 3.0;
      std::vector<double> shifts(runs * kernel_trials);
      const double* const run_sds = z.data() + cells * kernel_trials;
      const double* const normals = run_sds + kernel_trials;
      kernel.run_shifts(
          {kernel_trials, cells, runs, noise, measured, 3.0, z.data(), run_sds, observed, normals, shifts.data()});
      for (std::size_t t = 0; t < kernel_trials; ++t) {
        double scatter = 0.0;
        for (std::size_t c = 0; c < cells; ++c) scatter += z[c * kernel_trials + t] * z[c * kernel_trials + t];
        scatter /= 3.0;
        const double machine = run_sds[t] * run_sds[t] + scatter / 3.0;
        const double own = measured == 0.0 ? 1.0 : machine / (machine + measured);
        const double of_readings = scatter / (scatter + noise) * noise / 3.0;
        const double noise_sd = std::sqrt(std::max(0.0, own * measured - of_readings));
        for (std::size_t j = 0; j < runs; ++j)
          ASSERT_EQ(shifts[j * kernel_trials + t], own * observed[j] + noise_sd * normals[j * kernel_trials + t]);
      }
    });
}

}  // namespace
}  // namespace axiometry::iso230_2
