// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/derivatives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"

namespace axiometry::uncertainty {
namespace {

constexpr std::size_t levels = 10;

/// The best entry of a tableau: rows for steps h, h/2, h/4, …, columns for orders h², h⁴, h⁶, … of the error.
Derivative extrapolated(const std::array<double, levels>& differences, const std::array<double, levels>& rounding) {
  std::array<std::array<double, levels>, levels> table{};
  Derivative best{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  for (std::size_t row = 0; row < levels; ++row) {
    table[row][0] = differences[row];
    double power = 1.0;
    for (std::size_t column = 1; column <= row; ++column) {
      power *= 4.0;
      const double left = table[row][column - 1], above = table[row - 1][column - 1];
      table[row][column] = left + (left - above) / (power - 1.0);
      const double extrapolation = std::max(std::abs(table[row][column] - left), std::abs(table[row][column] - above));
      const double error = extrapolation + 2 * rounding[row];
      if (error < best.error) best = {table[row][column], error};  // false for NaN
    }
  }
  return best;
}

}  // namespace

std::vector<Derivative> first_derivatives(const ModelFunction& model, std::size_t outputs, std::span<const double> x,
                                          std::size_t input, double step) {
  AXIOMETRY_CONTRACT(step > 0.0);
  std::vector<std::array<double, levels>> differences(outputs), rounding(outputs);
  std::vector<double> moved(x.begin(), x.end()), above(outputs), below(outputs);
  for (std::size_t level = 0; level < levels; ++level) {
    moved[input] = x[input] + std::ldexp(step, -static_cast<int>(level));
    const double right = moved[input];
    model(moved, above);
    moved[input] = x[input] - std::ldexp(step, -static_cast<int>(level));
    const double distance = right - moved[input];  // what the step became by rounding
    model(moved, below);
    for (std::size_t k = 0; k < outputs; ++k) {
      differences[k][level] = (above[k] - below[k]) / distance;
      const double size = std::max(std::abs(above[k]), std::abs(below[k]));
      rounding[k][level] = std::numeric_limits<double>::epsilon() * size / distance;
    }
  }
  std::vector<Derivative> result;
  for (std::size_t k = 0; k < outputs; ++k) result.push_back(extrapolated(differences[k], rounding[k]));
  return result;
}

namespace {

/// The model about x in coordinates w, one output after another, at steps along one or two of them.
class Neighbourhood {
 public:
  Neighbourhood(const ModelFunction& model, std::size_t outputs, std::span<const double> x,
                std::span<const double> transform)
      : model_(model), outputs_(outputs), x_(x), transform_(transform) {}

  std::vector<double> at(std::size_t j, double step_j, std::size_t k = 0, double step_k = 0.0) const {
    std::vector<double> moved(x_.begin(), x_.end()), y(outputs_);
    for (std::size_t i = 0; i < moved.size(); ++i)
      moved[i] += transform_[i * x_.size() + j] * step_j + transform_[i * x_.size() + k] * step_k;
    model_(moved, y);
    return y;
  }

 private:
  const ModelFunction& model_;
  std::size_t outputs_;
  std::span<const double> x_;
  std::span<const double> transform_;
};

struct Derivatives {
  double first_j = 0.0, first_k = 0.0, second = 0.0, third_jkk = 0.0, third_kjj = 0.0;

  Derivatives extrapolated_from(const Derivatives& twice) const {
    const auto better = [](double half, double whole) { return half + (half - whole) / 3; };
    return {better(first_j, twice.first_j), better(first_k, twice.first_k), better(second, twice.second),
            better(third_jkk, twice.third_jkk), better(third_kjj, twice.third_kjj)};
  }
};

/// Along j alone: f_j, f_jj, f_jjj.
std::vector<Derivatives> along(const Neighbourhood& near, std::size_t j, double h) {
  const auto zero = near.at(j, 0), p = near.at(j, h), m = near.at(j, -h), pp = near.at(j, 2 * h),
             mm = near.at(j, -2 * h);
  std::vector<Derivatives> result(zero.size());
  for (std::size_t o = 0; o < result.size(); ++o) {
    result[o].first_j = (p[o] - m[o]) / (2 * h);
    result[o].second = (p[o] - 2 * zero[o] + m[o]) / (h * h);
    result[o].third_jkk = (pp[o] - 2 * p[o] + 2 * m[o] - mm[o]) / (2 * h * h * h);
  }
  return result;
}

/// Along j and k: f_jk, f_jkk, f_kjj.
std::vector<Derivatives> across(const Neighbourhood& near, std::size_t j, std::size_t k, double h) {
  const auto jp = near.at(j, h), jm = near.at(j, -h), kp = near.at(k, h), km = near.at(k, -h);
  const auto pp = near.at(j, h, k, h), pm = near.at(j, h, k, -h), mp = near.at(j, -h, k, h), mm = near.at(j, -h, k, -h);
  std::vector<Derivatives> result(jp.size());
  for (std::size_t o = 0; o < result.size(); ++o) {
    Derivatives& d = result[o];
    d.first_j = (jp[o] - jm[o]) / (2 * h);
    d.first_k = (kp[o] - km[o]) / (2 * h);
    d.second = (pp[o] - pm[o] - mp[o] + mm[o]) / (4 * h * h);
    d.third_jkk = (pp[o] + pm[o] - 2 * jp[o] - mp[o] - mm[o] + 2 * jm[o]) / (2 * h * h * h);
    d.third_kjj = (pp[o] + mp[o] - 2 * kp[o] - pm[o] - mm[o] + 2 * km[o]) / (2 * h * h * h);
  }
  return result;
}

}  // namespace

std::vector<Curvature> curvatures(const ModelFunction& model, std::size_t outputs, std::span<const double> x,
                                  std::span<const double> transform) {
  AXIOMETRY_CONTRACT(transform.size() == x.size() * x.size());
  const Neighbourhood near(model, outputs, x, transform);
  std::vector<Curvature> result(outputs);
  for (std::size_t j = 0; j < x.size(); ++j) {
    const auto whole = along(near, j, 1.0), half = along(near, j, 0.5);
    for (std::size_t o = 0; o < outputs; ++o) {
      const Derivatives d = half[o].extrapolated_from(whole[o]);
      result[o].diagonal += d.second;
      result[o].variance += d.second * d.second / 2 + d.first_j * d.third_jkk;
    }
    for (std::size_t k = 0; k < j; ++k) {
      const auto whole_across = across(near, j, k, 1.0), half_across = across(near, j, k, 0.5);
      for (std::size_t o = 0; o < outputs; ++o) {
        const Derivatives d = half_across[o].extrapolated_from(whole_across[o]);
        result[o].variance += d.second * d.second + d.first_j * d.third_jkk + d.first_k * d.third_kjj;
      }
    }
  }
  return result;
}

}  // namespace axiometry::uncertainty
