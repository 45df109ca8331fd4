// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/error_motions/motion_estimate.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::error_motions {
namespace {

constexpr double two_sigma = 0.97724986805182079;  // Φ(2): 95.45 % between −2 and 2

/// A whole number that rounding brought just below itself stays what it is.
double cut_degrees(double degrees) { return std::max(1.0, std::floor(degrees * (1.0 + 1e-12))); }

}  // namespace

ScatterPart combined_scatter(std::span<const ScatterPart> parts) {
  double largest = 0.0;
  for (const ScatterPart& part : parts) largest = std::max(largest, part.u);
  if (!(largest > 0.0)) return {};
  double squares = 0.0, fourths = 0.0;
  for (const ScatterPart& part : parts) {
    const double share = part.u / largest;
    squares += share * share;
    fourths += share * share * share * share / part.degrees;
  }
  return {largest * std::sqrt(squares),
          fourths > 0.0 ? squares * squares / fourths : std::numeric_limits<double>::infinity()};
}

double coverage_of(double degrees) {
  return std::isfinite(degrees) ? numeric::student_t_quantile(two_sigma, cut_degrees(degrees)) : 2.0;
}

bool MotionEstimate::U_is_rounding() const { return U() <= rounding * std::max(std::abs(value), 1.0); }

MotionEstimate combined(MotionEstimate e) {
  if (e.scatter == MotionEstimate::Scatter::none && !e.instrument_u && !e.other_u) return e;
  const ScatterPart parts[] = {
      {e.scatter_u, e.scatter_degrees}, {e.instrument_u.value_or(0.0)}, {e.other_u.value_or(0.0)}};
  const ScatterPart all = combined_scatter(parts);
  e.u = all.u;
  e.k = coverage_of(all.degrees);
  return e;
}

}  // namespace axiometry::error_motions
