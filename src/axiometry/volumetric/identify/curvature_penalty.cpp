// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/curvature_penalty.h"

#include <cmath>

#include "axiometry/base/contract.h"

namespace axiometry::volumetric::detail {
namespace {

/// Δ²c = Σ step_k c_k.
constexpr std::array<double, 3> second_difference = {1.0, -2.0, 1.0};

std::size_t place_in(std::size_t first, std::size_t k) { return first + k * motion_count; }

}  // namespace

std::size_t bend_of(std::size_t curve) { return curve % motion_count < first_rotation ? 0 : 1; }

CurvaturePenalty::CurvaturePenalty(const Coefficients& coefficients, std::span<const std::size_t> left_out) {
  std::vector<bool> is_left_out(curve_count, false);
  for (const std::size_t error : left_out)
    if (error < curve_count) is_left_out[error] = true;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const CurveBasis& basis = coefficients.basis(a);
    AXIOMETRY_CONTRACT(basis.kind() != CurveKind::legendre);
    add(basis, coefficients.curve(a), a, is_left_out);
    if (coefficients.half_functions(a) > 1) add(basis, coefficients.half(a), a, is_left_out);
  }
}

void CurvaturePenalty::add(const CurveBasis& basis, std::size_t begin, std::size_t axis,
                           const std::vector<bool>& is_left_out) {
  const double n = static_cast<double>(basis.size());
  for (std::size_t m = 0; m < motion_count; ++m) {
    const std::size_t curve = axis * motion_count + m;
    if (is_left_out[curve]) continue;
    for (std::size_t k = 0; k + 2 < basis.functions(); ++k)
      differences_.push_back({place_in(begin, k) + m, curve, n * std::sqrt(n)});
  }
}

void CurvaturePenalty::set(const Bends& bends, double variance_factor) {
  AXIOMETRY_CONTRACT(bends[0] > 0.0 && bends[1] > 0.0 && variance_factor > 0.0);
  bends_ = bends;
  factor_ = variance_factor;
}

double CurvaturePenalty::value(std::span<const double> raw) const {
  const PerCurve sums = squares(raw);
  double value = 0.0;
  for (std::size_t e = 0; e < curve_count; ++e) value += sums[e] / (bends_[bend_of(e)] * bends_[bend_of(e)]);
  return factor_ * value;
}

std::vector<double> CurvaturePenalty::times(std::span<const double> raw) const {
  std::vector<double> product(raw.size(), 0.0);
  for (const Difference& d : differences_) {
    double bend = 0.0;
    for (std::size_t k = 0; k < 3; ++k) bend += second_difference[k] * raw[place_in(d.first, k)];
    for (std::size_t k = 0; k < 3; ++k)
      product[place_in(d.first, k)] += weight(d) * d.factor * d.factor * second_difference[k] * bend;
  }
  return product;
}

NormalEquations CurvaturePenalty::added_to(NormalEquations equations) const {
  for (const Difference& d : differences_)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = i; k < 3; ++k)
        equations.matrix[place_in(d.first, i) * equations.columns + place_in(d.first, k)] +=
            weight(d) * d.factor * d.factor * second_difference[i] * second_difference[k];
  return equations;
}

PerCurve CurvaturePenalty::ranks() const {
  PerCurve ranks{};
  for (const Difference& d : differences_) ranks[d.curve] += 1.0;
  return ranks;
}

PerCurve CurvaturePenalty::squares(std::span<const double> raw) const {
  PerCurve sums{};
  for (const Difference& d : differences_) {
    double bend = 0.0;
    for (std::size_t k = 0; k < 3; ++k) bend += d.factor * second_difference[k] * raw[place_in(d.first, k)];
    sums[d.curve] += bend * bend;
  }
  return sums;
}

CurvaturePenalty::Told CurvaturePenalty::told(const std::vector<double>& covariance) const {
  const auto width = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(covariance.size()))));
  Told told;
  for (std::size_t i = 0; i < differences_.size(); ++i)
    for (std::size_t k = 0; k < differences_.size(); ++k) {
      const Difference &a = differences_[i], &b = differences_[k];
      if (a.curve != b.curve) continue;
      double together = 0.0;
      for (std::size_t p = 0; p < 3; ++p)
        for (std::size_t q = 0; q < 3; ++q)
          together += second_difference[p] * second_difference[q] *
                      covariance[place_in(a.first, p) * width + place_in(b.first, q)];
      const double entry = (i == k ? 1.0 : 0.0) - weight(a) * a.factor * b.factor * together;
      if (i == k) told.trace[a.curve] += entry;
      told.trace_of_square[a.curve] += entry * entry;
    }
  return told;
}

}  // namespace axiometry::volumetric::detail
