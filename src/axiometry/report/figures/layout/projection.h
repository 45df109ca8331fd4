// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "axiometry/base/vector3.h"
#include "axiometry/report/drawing/figure.h"

/// Parallel projections of the machine's space onto paper.
namespace axiometry::report::plot {

/// How one looks: the directions of space that lie to the right and upwards on paper, and the one that points at the
/// reader. Of length 1, at right angles.
struct Sight {
  Vector3 right;
  Vector3 up;
  Vector3 towards;
};

inline constexpr Sight from_above{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline constexpr Sight from_front{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
inline constexpr Sight from_right{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};

/// From a place in front, turned to the right by `turn` and raised by `raise`, both in rad.
inline Sight axonometric(double turn, double raise) {
  const double s = std::sin(turn), c = std::cos(turn), sr = std::sin(raise), cr = std::cos(raise);
  return {{c, s, 0.0}, {-s * sr, c * sr, cr}, {s * cr, -c * cr, sr}};
}

/// An upright rectangle in the plane of projection, mm: to the right and upwards.
struct Window {
  double left = 0.0, right = 0.0, low = 0.0, high = 0.0;

  double width() const { return right - left; }
  double height() const { return high - low; }
};

/// A sight with its place and scale on paper.
struct Projection {
  Sight sight;
  Window window;             ///< what is shown
  Point corner;              ///< upper left of the window, on paper
  double points_per_mm = 1;  ///< scale

  Point operator()(Vector3 p) const {
    return {corner.x + (dot(p, sight.right) - window.left) * points_per_mm,
            corner.y + (window.high - dot(p, sight.up)) * points_per_mm};
  }
  double depth(Vector3 p) const { return dot(p, sight.towards); }
};

}  // namespace axiometry::report::plot
