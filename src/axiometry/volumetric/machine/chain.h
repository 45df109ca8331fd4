// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/base/vector3.h"

/// The kinematic chain of three linear axes in series, from the workpiece over the foundation to the tool.
namespace axiometry::volumetric {

/// Letters before the foundation carry the workpiece, those behind it the tool: XFYZ is a table that moves along X
/// under a column that carries Y, which carries Z. The foundation is written F or b.
class KinematicChain {
 public:
  /// Fails unless `text` holds X, Y, Z and F (or b) once each; w and t at its ends may be written ("wXbYZt").
  static Result<KinematicChain> make(std::string_view text);

  /// Axes (0 to 2) from the workpiece to the tool.
  const std::array<std::size_t, 3>& order() const { return order_; }
  bool carries_workpiece(std::size_t axis) const { return carries_workpiece_[axis]; }

  /// "XFYZ".
  std::string text() const;

  /// r_a of each axis when the axes stand at q and the tool is t: from where the rotation of axis a acts to the tool
  /// point,
  ///   r_a = Σ_{b after a} q_b e_b + [a carries the workpiece] q_a e_a + t.
  std::array<Vector3, 3> levers(Vector3 axes, Vector3 tool) const;

  friend bool operator==(const KinematicChain&, const KinematicChain&) = default;

 private:
  KinematicChain() = default;
  std::array<std::size_t, 3> order_{};
  std::array<bool, 3> carries_workpiece_{};
  std::size_t workpiece_axes_ = 0;
};

}  // namespace axiometry::volumetric
