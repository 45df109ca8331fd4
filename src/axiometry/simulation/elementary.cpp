// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/elementary.h"

#include <cmath>
#include <numbers>

namespace axiometry::simulation {
namespace {

/// Of |x| ≤ π/4: the first term left out is below 1e-17 of the sum.
double sine_of(double x) {
  const double y = x * x;
  double sum = 1.0;
  for (int k = 17; k >= 3; k -= 2) sum = 1.0 - y / static_cast<double>(k * (k - 1)) * sum;
  return x * sum;
}

double cosine_of(double x) {
  const double y = x * x;
  double sum = 1.0;
  for (int k = 18; k >= 2; k -= 2) sum = 1.0 - y / static_cast<double>(k * (k - 1)) * sum;
  return sum;
}

}  // namespace

Wave wave(double turns) {
  const double part = turns - std::nearbyint(turns);
  const double quarter = std::nearbyint(4.0 * part);  // −2 … 2
  const double angle = 2.0 * std::numbers::pi * (part - 0.25 * quarter);
  const double sine = sine_of(angle), cosine = cosine_of(angle);
  switch (static_cast<int>(quarter)) {
    case 0: return {sine, cosine};
    case 1: return {cosine, -sine};
    case -1: return {-cosine, sine};
    default: return {-sine, -cosine};
  }
}

double exponential(double x) {
  if (x < -700.0) return 0.0;
  constexpr double ln2_high = 0x1.62e42fefap-1, ln2_low = 0x1.cf79abc9e3b3ap-40;  // the first times k is exact
  const double k = std::nearbyint(x / std::numbers::ln2);
  const double r = (x - k * ln2_high) - k * ln2_low;
  double sum = 1.0;
  for (int n = 14; n >= 1; --n) sum = 1.0 + r / static_cast<double>(n) * sum;
  return std::ldexp(sum, static_cast<int>(k));
}

}  // namespace axiometry::simulation
