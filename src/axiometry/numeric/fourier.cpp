// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/fourier.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {
namespace {

using Complex = std::complex<double>;

constexpr double two_pi_of_fourier = 2.0 * std::numbers::pi;
constexpr std::ptrdiff_t reach = 16;  // M_sp, points to each side: what is cut off and what folds back is 3e-15
constexpr double finer = 2.0;         // R, of the grid
constexpr std::size_t most_at_once = 1 << 16;  // frequencies: their grid stays in the cache

/// Products without the C library's care for infinities.
Complex product_of(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Sums for frequencies `middle` + k step, k from −count/2 on; count ≤ modes, a power of two.
class Gridding {
 public:
  Gridding(std::size_t modes, std::size_t rows)
      : modes_(modes),
        size_(static_cast<std::size_t>(finer) * modes),
        tau_(std::numbers::pi * double(reach) / (finer * (finer - 0.5) * double(modes) * double(modes))),
        transform_(size_),
        grids_(rows, std::vector<Complex>(size_)) {}

  void operator()(std::span<const double> places, std::span<const std::span<const double>> weights, double middle,
                  double step) {
    for (auto& grid : grids_) std::ranges::fill(grid, Complex{});
    const double spacing = two_pi_of_fourier / double(size_);
    std::array<double, 2 * reach + 1> bell;
    for (std::size_t j = 0; j < places.size(); ++j) {
      const double turns = step * places[j];
      const double at = (turns - std::floor(turns)) * double(size_);
      const double nearest = std::round(at);
      for (std::ptrdiff_t d = -reach; d <= reach; ++d) {
        const double x = (double(d) - (at - nearest)) * spacing;
        bell[static_cast<std::size_t>(d + reach)] = std::exp(-x * x / (4.0 * tau_));
      }
      const Complex turn = std::polar(1.0, two_pi_of_fourier * middle * places[j]);
      const std::size_t begin = static_cast<std::size_t>(nearest) + size_ - static_cast<std::size_t>(reach);
      for (std::size_t r = 0; r < grids_.size(); ++r) {
        const Complex weighed = weights[r][j] * turn;
        for (std::size_t d = 0; d < bell.size(); ++d) grids_[r][(begin + d) & (size_ - 1)] += bell[d] * weighed;
      }
    }
    for (auto& grid : grids_) transform_(grid);
  }

  /// Of frequency number k of `count`, whose middle is number count/2.
  Complex sum(std::size_t row, std::size_t k, std::size_t count) const {
    const double from_middle = double(k) - double(count / 2);
    const double made_up =
        std::sqrt(std::numbers::pi / tau_) * std::exp(from_middle * from_middle * tau_) / double(size_);
    return made_up * grids_[row][(k + size_ - count / 2) & (size_ - 1)];
  }

 private:
  std::size_t modes_, size_;
  double tau_;
  FourierTransform transform_;
  std::vector<std::vector<Complex>> grids_;
};

}  // namespace

FourierTransform::FourierTransform(std::size_t size) : turns_(size / 2) {
  AXIOMETRY_CONTRACT(std::has_single_bit(size));
  for (std::size_t k = 0; k < turns_.size(); ++k)
    turns_[k] = std::polar(1.0, two_pi_of_fourier * double(k) / double(size));
}

void FourierTransform::operator()(std::span<std::complex<double>> values) const {
  const std::size_t n = values.size();
  AXIOMETRY_CONTRACT(std::has_single_bit(n) && n / 2 == turns_.size());
  for (std::size_t k = 1, mirrored = 0; k < n; ++k) {  // into the order of the bits read backwards
    std::size_t bit = n / 2;
    for (; mirrored & bit; bit /= 2) mirrored ^= bit;
    mirrored |= bit;
    if (k < mirrored) std::swap(values[k], values[mirrored]);
  }
  for (std::size_t half = 1; half < n; half *= 2) {
    const std::size_t stride = n / (2 * half);
    for (std::size_t begin = 0; begin < n; begin += 2 * half)
      for (std::size_t k = 0; k < half; ++k) {
        Complex& a = values[begin + k];
        Complex& b = values[begin + half + k];
        const Complex turned = product_of(b, turns_[k * stride]);
        b = a - turned;
        a += turned;
      }
  }
}

std::vector<std::vector<std::complex<double>>> fourier_sums(std::span<const double> places,
                                                            std::span<const std::span<const double>> weights,
                                                            const FrequencyGrid& grid) {
  for (const auto row : weights) AXIOMETRY_CONTRACT(row.size() == places.size());
  std::vector<std::vector<Complex>> sums(weights.size());
  for (auto& row : sums) row.reserve(grid.count);
  if (grid.count == 0) return sums;
  const std::size_t modes = std::bit_ceil(std::clamp<std::size_t>(grid.count, 2 * reach, most_at_once));
  Gridding gridding(modes, weights.size());
  for (std::size_t begin = 0; begin < grid.count; begin += modes) {
    const std::size_t count = std::min(modes, grid.count - begin);
    gridding(places, weights, grid.first + grid.step * double(begin + count / 2), grid.step);
    for (std::size_t r = 0; r < sums.size(); ++r)
      for (std::size_t k = 0; k < count; ++k) sums[r].push_back(gridding.sum(r, k, count));
  }
  return sums;
}

}  // namespace axiometry::numeric
