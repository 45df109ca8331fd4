// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/curves/curve_basis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"

namespace axiometry::volumetric {
namespace {

/// The four uniform cubic B-splines of a span at 0 ≤ t ≤ 1 (outside: their continuation).
void set_cubic(std::size_t span, double t, ActiveFunctions& f) {
  const double s = 1.0 - t;
  f.first = span;
  f.count = 4;
  constexpr double sixth = 1.0 / 6.0;
  f.values[0] = sixth * (s * s * s);
  f.values[1] = sixth * (3.0 * t * t * t - 6.0 * t * t + 4.0);
  f.values[2] = sixth * (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0);
  f.values[3] = sixth * (t * t * t);
}

/// By (k + 1) P_{k+1} = (2k + 1) x P_k − k P_{k−1}.
void set_legendre(std::size_t degree, double x, ActiveFunctions& f) {
  f.first = 0;
  f.count = degree + 1;
  f.values[0] = 1.0;
  f.values[1] = x;
  for (std::size_t k = 1; k < degree; ++k) {
    const double n = static_cast<double>(k);
    f.values[k + 1] = ((2.0 * n + 1.0) * x * f.values[k] - n * f.values[k - 1]) / (n + 1.0);
  }
}

}  // namespace

std::string_view curve_kind_name(CurveKind kind) {
  switch (kind) {
    case CurveKind::spline: return "b-spline";
    case CurveKind::legendre: return "legendre";
    case CurveKind::nodes: return "nodes";
  }
  return "";
}

Result<CurveBasis> CurveBasis::make(CurveKind kind, double lower_mm, double upper_mm, std::size_t size) {
  if (!(lower_mm < upper_mm) || !std::isfinite(upper_mm - lower_mm))
    return fail(fmt::format("found a travel from {} to {} mm, expected its lower end first", format_exact(lower_mm),
                            format_exact(upper_mm)));
  const std::size_t most = kind == CurveKind::legendre ? ActiveFunctions::most - 1 : 400;
  if (size < 1 || size > most)
    return fail(fmt::format("found curves of {} {}, expected 1 to {}", size,
                            kind == CurveKind::legendre ? "degrees" : "spans", most));
  CurveBasis basis;
  basis.kind_ = kind;
  basis.lower_ = lower_mm;
  basis.upper_ = upper_mm;
  basis.size_ = size;
  basis.spans_per_mm_ = static_cast<double>(size) / (upper_mm - lower_mm);
  basis.functions_ = kind == CurveKind::spline ? size + 3 : size + 1;
  return basis;
}

std::size_t CurveBasis::first_active(double position_mm) const {
  if (kind_ == CurveKind::legendre) return 0;
  const double last = static_cast<double>(size_) - 1.0;
  return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(std::clamp(spans_along(position_mm), 0.0, last)));
}

void CurveBasis::set_at(double position_mm, ActiveFunctions& f) const {
  if (kind_ == CurveKind::legendre)
    return set_legendre(size_, (2.0 * position_mm - lower_ - upper_) / (upper_ - lower_), f);
  const std::size_t first = first_active(position_mm);
  const double t = spans_along(position_mm) - static_cast<double>(first);
  if (kind_ == CurveKind::spline) return set_cubic(first, t, f);
  f.first = first;
  f.count = 2;
  f.values[0] = 1.0 - t;
  f.values[1] = t;
}

/// By Gauss–Legendre quadrature in each span, exact for polynomials up to degree 15: 8 nodes.
template <typename Weight>
std::vector<double> CurveBasis::integrals(Weight weight) const {
  constexpr std::array<double, 4> at_x = {0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                          0.96028985649753623};
  constexpr std::array<double, 4> share = {0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                           0.10122853629037626};
  const std::size_t spans = kind_ == CurveKind::legendre ? 1 : size_;
  const double width = (upper_ - lower_) / static_cast<double>(spans);
  std::vector<double> sums(functions_, 0.0);
  for (std::size_t k = 0; k < spans; ++k)
    for (std::size_t i = 0; i < at_x.size(); ++i)
      for (const double sign : {-1.0, 1.0}) {
        const double q = lower_ + width * (static_cast<double>(k) + 0.5 + 0.5 * sign * at_x[i]);
        const double w =
            0.5 * share[i] / static_cast<double>(spans) * weight((2.0 * q - lower_ - upper_) / (upper_ - lower_));
        const ActiveFunctions f = at(q);
        for (std::size_t j = 0; j < f.count; ++j) sums[f.first + j] += w * f.values[j];
      }
  return sums;
}

std::vector<double> CurveBasis::means() const {
  return integrals([](double) { return 1.0; });
}

/// Of B-splines the values where they are highest (Greville's abscissae).
std::vector<double> CurveBasis::line() const {
  std::vector<double> coefficients(functions_, 0.0);
  if (kind_ == CurveKind::legendre) {
    coefficients[1] = 1.0;
    return coefficients;
  }
  const double before = kind_ == CurveKind::spline ? 1.0 : 0.0;
  for (std::size_t k = 0; k < functions_; ++k)
    coefficients[k] = 2.0 * (static_cast<double>(k) - before) / static_cast<double>(size_) - 1.0;
  return coefficients;
}

std::vector<double> CurveBasis::slopes() const {
  return integrals([](double x) { return x; });
}

}  // namespace axiometry::volumetric
