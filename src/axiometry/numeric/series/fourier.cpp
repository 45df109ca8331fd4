// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/series/fourier.h"

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
constexpr std::size_t reach = 16;  // M_sp, points to each side: what is cut off and what folds back is 3e-15
constexpr std::size_t finer = 2;   // R: how much finer the grid is
constexpr std::size_t spread_size = finer * FourierSums::most_at_once;
constexpr double spread_spacing = two_pi_of_fourier / double(spread_size);
constexpr double tau =
    std::numbers::pi * double(reach) /
    (double(finer) * (double(finer) - 0.5) * double(FourierSums::most_at_once) * double(FourierSums::most_at_once));

/// Products without the C library's care for infinities.
Complex product_of(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

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

FourierSums::FourierSums(std::span<const double> places, std::span<const std::span<const double>> weights)
    : places_(places),
      weights_(weights.begin(), weights.end()),
      transform_(spread_size),
      grids_(weights.size(), std::vector<Complex>(spread_size + 2 * reach)),
      sums_(weights.size()) {
  for (const auto row : weights) AXIOMETRY_CONTRACT(row.size() == places.size());
  for (std::size_t d = 0; d <= 2 * reach; ++d) {
    const double x = (double(d) - double(reach)) * spread_spacing;
    bell_.push_back(std::exp(-x * x / (4.0 * tau)));
  }
  for (std::size_t k = 0; k <= most_at_once / 2; ++k)
    made_up_.push_back(std::sqrt(std::numbers::pi / tau) * std::exp(double(k) * double(k) * tau) / double(spread_size));
}

/// Of frequencies `middle` + k step. The grids have `reach` points more at both ends, which are those of the other end.
void FourierSums::spread(double middle, double step) {
  for (auto& grid : grids_) std::ranges::fill(grid, Complex{});
  std::array<double, 2 * reach + 1> bell;
  for (std::size_t j = 0; j < places_.size(); ++j) {
    const double turns = step * places_[j];
    const double at = (turns - std::floor(turns)) * double(spread_size);
    const double nearest = std::round(at);
    // e^{−(d h − o)²/4τ} = e^{−o²/4τ} (e^{o h/2τ})^d e^{−(d h)²/4τ}
    const double off = (at - nearest) * spread_spacing;
    const double slope = off * spread_spacing / (2.0 * tau);
    const double further = std::exp(slope);
    double power = std::exp(-off * off / (4.0 * tau) - double(reach) * slope);
    for (std::size_t d = 0; d < bell.size(); ++d, power *= further) bell[d] = power * bell_[d];
    const Complex turn = std::polar(1.0, two_pi_of_fourier * middle * places_[j]);
    const std::size_t begin = static_cast<std::size_t>(nearest) % spread_size;
    for (std::size_t r = 0; r < grids_.size(); ++r) {
      const Complex weighed = weights_[r][j] * turn;
      Complex* const points = &grids_[r][begin];
      for (std::size_t d = 0; d < bell.size(); ++d) points[d] += bell[d] * weighed;
    }
  }
  for (auto& grid : grids_)
    for (std::size_t d = 0; d < reach; ++d) {
      grid[spread_size + d] += grid[d];
      grid[reach + d] += grid[spread_size + reach + d];
    }
}

std::span<const std::vector<std::complex<double>>> FourierSums::operator()(const FrequencyGrid& grid) {
  AXIOMETRY_CONTRACT(grid.count <= most_at_once);
  const std::size_t half = grid.count / 2;
  spread(grid.first + grid.step * double(half), grid.step);
  for (std::size_t r = 0; r < sums_.size(); ++r) {
    const auto values = std::span(grids_[r]).subspan(reach, spread_size);
    transform_(values);
    sums_[r].clear();
    for (std::size_t k = 0; k < grid.count; ++k)
      sums_[r].push_back(made_up_[k < half ? half - k : k - half] * values[(k + spread_size - half) % spread_size]);
  }
  return sums_;
}

}  // namespace axiometry::numeric
