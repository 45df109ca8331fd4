// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/curves/coefficients.h"

#include <algorithm>

namespace axiometry::volumetric {

Coefficients::Coefficients(std::array<CurveBasis, axis_count> bases, Reversal reversal)
    : bases_(bases), reversal_(reversal) {
  std::vector<bool> removed;
  for (std::size_t a = 0; a < axis_count; ++a) {
    curve_[a] = removed.size();
    const std::size_t functions = bases_[a].functions();
    removed.resize(removed.size() + functions * motion_count, false);
    for (std::size_t m = 0; m < motion_count; ++m) {
      gauges_.emplace_back(bases_[a], ErrorMotion{a, m});
      const std::size_t gone = std::min(gauges_.back().removed(), functions);
      for (std::size_t k = 0; k < gone; ++k) removed[curve_[a] + k * motion_count + m] = true;
    }
  }
  squareness_ = removed.size();
  removed.resize(removed.size() + 3, false);
  for (std::size_t a = 0; a < axis_count; ++a) {
    half_[a] = removed.size();
    removed.resize(removed.size() + half_functions(a) * motion_count, false);
  }
  raw_ = removed.size();
  for (std::size_t k = 0; k < raw_; ++k)
    if (!removed[k]) free_.push_back(k);
}

Result<Coefficients> Coefficients::make(CurveKind kind, const TravelBox& ranges,
                                        std::array<std::size_t, axis_count> sizes, Reversal reversal) {
  const auto basis = [&](std::size_t a) {
    return CurveBasis::make(kind, ranges.lowest_mm[a], ranges.highest_mm[a], sizes[a]);
  };
  AXIOMETRY_TRY(const CurveBasis x, basis(0));
  AXIOMETRY_TRY(const CurveBasis y, basis(1));
  AXIOMETRY_TRY(const CurveBasis z, basis(2));
  return Coefficients({x, y, z}, reversal);
}

std::size_t Coefficients::half_functions(std::size_t axis) const {
  switch (reversal_) {
    case Reversal::none: return 0;
    case Reversal::constant: return 1;
    case Reversal::curves: return bases_[axis].functions();
  }
  return 0;
}

template <typename Apply>
void Coefficients::for_functions(const Apply& apply) const {
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) apply(gauges_[a * motion_count + m], curve_[a] + m);
}

std::vector<double> Coefficients::raw_of(std::span<const double> free_coefficients) const {
  std::vector<double> raw(raw_, 0.0);
  for (std::size_t k = 0; k < free_.size(); ++k) raw[free_[k]] = free_coefficients[k];
  for_functions(
      [&](const Gauge& gauge, std::size_t first) { gauge.apply_transposed(raw.data() + first, motion_count); });
  return raw;
}

void Coefficients::turn_vector(std::vector<double>& vector) const {
  for_functions([&](const Gauge& gauge, std::size_t first) { gauge.apply(vector.data() + first, motion_count); });
}

void Coefficients::turn(std::vector<double>& matrix, std::size_t width) const {
  const std::size_t rows = matrix.size() / width;
  for_functions([&](const Gauge& gauge, std::size_t first) {
    for (std::size_t i = 0; i < rows; ++i) gauge.apply(matrix.data() + i * width + first, motion_count);
  });
  for_functions([&](const Gauge& gauge, std::size_t first) {
    for (std::size_t k = 0; k < width; ++k) gauge.apply(matrix.data() + first * width + k, motion_count * width);
  });
}

std::vector<double> Coefficients::raw_covariance(const std::vector<double>& free_covariance) const {
  const std::size_t n = free_.size();
  std::vector<double> raw(raw_ * raw_, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) raw[free_[i] * raw_ + free_[k]] = free_covariance[i * n + k];
  for_functions([&](const Gauge& gauge, std::size_t first) {
    for (std::size_t i = 0; i < raw_; ++i) gauge.apply_transposed(raw.data() + i * raw_ + first, motion_count);
  });
  for_functions([&](const Gauge& gauge, std::size_t first) {
    for (std::size_t k = 0; k < raw_; ++k) gauge.apply_transposed(raw.data() + first * raw_ + k, motion_count * raw_);
  });
  return raw;
}

ErrorValues Coefficients::errors(std::span<const double> raw, Vector3 axes_mm, Approaches approaches) const {
  ErrorValues errors;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const ActiveFunctions f = bases_[a].at(axes_mm[a]);
    const auto add = [&](const double* from, std::size_t functions, double factor) {
      for (std::size_t k = 0; k < functions; ++k)
        for (std::size_t m = 0; m < motion_count; ++m)
          errors.motions[a][m] += factor * f.values[k] * from[k * motion_count + m];
    };
    add(raw.data() + curve_[a] + f.first * motion_count, f.count, 1.0);
    if (reversal_ == Reversal::curves) add(raw.data() + half_[a] + f.first * motion_count, f.count, approaches[a]);
    if (reversal_ == Reversal::constant)
      for (std::size_t m = 0; m < motion_count; ++m) errors.motions[a][m] += approaches[a] * raw[half_[a] + m];
  }
  for (std::size_t k = 0; k < 3; ++k) errors.squareness_urad[k] = raw[squareness_ + k];
  return errors;
}

std::size_t Coefficients::error_of(std::size_t raw_place) const {
  if (raw_place >= squareness_ && raw_place < squareness_ + 3)
    return axis_count * motion_count + (raw_place - squareness_);
  const auto& begin = raw_place < squareness_ ? curve_ : half_;
  std::size_t a = axis_count - 1;
  while (a > 0 && raw_place < begin[a]) --a;
  return a * motion_count + (raw_place - begin[a]) % motion_count;
}

}  // namespace axiometry::volumetric
