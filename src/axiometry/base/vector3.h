// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace axiometry {

/// A point, a displacement or a direction in the machine's coordinates X, Y, Z. The name of a variable says the unit:
/// `station_mm`; a direction has length 1.
struct Vector3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  constexpr double operator[](std::size_t k) const { return k == 0 ? x : k == 1 ? y : z; }
  constexpr double& operator[](std::size_t k) { return k == 0 ? x : k == 1 ? y : z; }

  constexpr Vector3& operator+=(Vector3 b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  constexpr Vector3& operator-=(Vector3 b) { return *this = {x - b.x, y - b.y, z - b.z}; }
  friend constexpr Vector3 operator+(Vector3 a, Vector3 b) { return a += b; }
  friend constexpr Vector3 operator-(Vector3 a, Vector3 b) { return a -= b; }
  friend constexpr Vector3 operator-(Vector3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vector3 operator*(double k, Vector3 a) { return {k * a.x, k * a.y, k * a.z}; }
  friend constexpr bool operator==(const Vector3&, const Vector3&) = default;
};

constexpr double dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vector3 cross(Vector3 a, Vector3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Vector3 a) { return std::hypot(a.x, a.y, a.z); }
inline double distance(Vector3 a, Vector3 b) { return norm(a - b); }
/// Of length 1. Needs a ≠ 0.
inline Vector3 unit(Vector3 a) { return 1.0 / norm(a) * a; }
inline bool is_finite(Vector3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// A symmetric 3 × 3 matrix by rows, such as a covariance in mm².
using Matrix3 = std::array<std::array<double, 3>, 3>;

/// aᵀ M b.
constexpr double quadratic(Vector3 a, const Matrix3& m, Vector3 b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) sum += a[i] * m[i][k] * b[k];
  return sum;
}

}  // namespace axiometry
