// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/curves/gauge.h"

#include <cmath>

namespace axiometry::volumetric {
namespace {

void reflect(const std::vector<double>& v, double* numbers, std::size_t stride) {
  double sum = 0.0;
  for (std::size_t k = 0; k < v.size(); ++k) sum += v[k] * numbers[k * stride];
  for (std::size_t k = 0; k < v.size(); ++k) numbers[k * stride] -= sum * v[k];
}

/// The reflection that brings a column to zeros below place `k`, leaving those before it.
std::vector<double> reflection(const std::vector<double>& column, std::size_t k) {
  std::vector<double> v(column.size(), 0.0);
  double squares = 0.0;
  for (std::size_t i = k; i < column.size(); ++i) squares += column[i] * column[i];
  for (std::size_t i = k; i < column.size(); ++i) v[i] = column[i];
  v[k] += std::copysign(std::sqrt(squares), column[k]);
  double length = 0.0;
  for (const double x : v) length += x * x;
  const double scale = std::sqrt(2.0 / length);
  for (double& x : v) x *= scale;
  return v;
}

}  // namespace

Gauge::Gauge(const CurveBasis& basis, ErrorMotion error) {
  constraints_.push_back(basis.means());
  if (error.is_straightness()) constraints_.push_back(basis.slopes());
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    std::vector<double> column = constraints_[k];
    for (const auto& v : reflections_) reflect(v, column.data(), 1);
    reflections_.push_back(reflection(column, k));
  }
}

void Gauge::apply(double* numbers, std::size_t stride) const {
  for (const auto& v : reflections_) reflect(v, numbers, stride);
}

void Gauge::apply_transposed(double* numbers, std::size_t stride) const {
  for (std::size_t k = reflections_.size(); k-- > 0;) reflect(reflections_[k], numbers, stride);
}

}  // namespace axiometry::volumetric
