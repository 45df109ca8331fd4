// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/curves/coefficients.h"
#include "axiometry/volumetric/machine/kinematics.h"

/// Errors of a machine that are known, to try a calibration with.
namespace axiometry::volumetric {

/// A curve as a table of values, µm or µrad, at rising positions; between them the cubic through the four nearest (the
/// parabola, the straight line where there are only three or two), which also continues it beyond its ends.
class TrueCurve {
 public:
  /// 0 everywhere.
  TrueCurve() = default;

  struct Node {
    double position_mm = 0.0;
    double value = 0.0;
  };
  /// Fails on fewer than 2 nodes or more than 100 000, on numbers that are not finite and positions that do not rise.
  static Result<TrueCurve> make(std::vector<Node> nodes);

  const std::vector<Node>& nodes() const { return nodes_; }
  double at(double position_mm) const;

  /// c0 and c1 of the best straight line c0 + c1·(q − middle) over a range (least squares), exact.
  struct Line {
    double mean = 0.0;
    double slope_per_mm = 0.0;
  };
  Line line(double lower_mm, double upper_mm) const;
  /// Less a line about the middle of a range.
  TrueCurve less(Line line, double lower_mm, double upper_mm) const;

 private:
  std::vector<Node> nodes_;
};

struct TrueErrors {
  std::array<std::array<TrueCurve, motion_count>, axis_count> curves;  ///< [axis][motion]
  std::array<double, 3> squareness_urad{};                             ///< C0Y, B0Z, A0Z
  /// Half of what the two directions of an axis differ by: added where it came to rest moving up. It has no gauge.
  std::array<std::array<TrueCurve, motion_count>, axis_count> halves = {};

  ErrorValues at(Vector3 axes_mm, Approaches approaches = {}) const;
  bool has_reversal() const;
};

/// How large errors are that are drawn.
struct DrawnSize {
  double displacement_um = 8.0;
  double rotation_urad = 12.0;  ///< size of rotations and squareness
};

/// Which draw: trials of one seed are independent.
struct Draw {
  std::uint64_t seed = 1;
  std::uint64_t trial = 0;
};

/// Smooth ones: of each curve size·Σ g_k/k·P_k(x), k = 1 to 6, and a constant size·g_0, with standard normal g and
/// Legendre's P over the travel, as a table of 65 values.
TrueErrors drawn_errors(const TravelBox& travel, DrawnSize size, Draw draw);

/// The same machine with halves of reversal a quarter as large: of each motion size/4·Σ g_k/k·P_k(x), k = 1 to 3, and a
/// constant size/4·g_0, or that constant alone. Cubics, which every spline holds.
TrueErrors with_drawn_reversal(TrueErrors errors, const TravelBox& travel, Reversal reversal, DrawnSize size,
                               Draw draw);

/// The same machine in the gauge of curves/gauge.h over its travels. What is taken off the curves is, to first order, a
/// place of the whole machine, one of each tool, a rotation of the whole, and squareness: with A the matrix by which
/// slopes of straightness, means of rotations and squareness displace in proportion to q,
///   C0Y = −(A_xy + A_yx),  B0Z = A_xz + A_zx,  A0Z = −(A_yz + A_zy).
TrueErrors in_gauge(const TrueErrors& errors, const MachineModel& machine);

}  // namespace axiometry::volumetric
