// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/field/error_model.h"

/// How large the error of the tool point is over the volume.
namespace axiometry::volumetric {

/// Of |δ| over the nodes of a grid, µm.
struct FieldSizes {
  Estimate largest;  ///< u is that of |δ| at this place, to first order
  Vector3 largest_at_mm;
  double mean = 0.0;
  double percent_95 = 0.0;  ///< that 95 % of the nodes do not exceed
};

/// Mean and 95 % of displacements; the largest is left to who knows its place.
FieldSizes sizes_of(std::span<const Vector3> field_um);

struct VolumeStatistics {
  /// As it is in the gauge; absent where the lengths do not tell all of it.
  std::optional<FieldSizes> as_found;
  /// Without the displacement and rotation of everything that fits it best (least squares over the nodes): what no
  /// placing of a workpiece takes away. Absent likewise.
  std::optional<FieldSizes> without_rigid_motion;
  Vector3 translation_um;  ///< of that motion, at the middle of the volume
  Vector3 rotation_urad;
};

/// Over the travel that was observed, `nodes` along each axis with both ends. Contract: 2 ≤ nodes ≤ 101.
VolumeStatistics volume_statistics(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes);

/// What is left of the field when `compensated` is taken away at each place, without rigid motion; no uncertainty.
FieldSizes sizes_without_rigid_motion(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes,
                                      const std::function<Vector3(Vector3 axes_mm)>& compensated_um);

/// A grid, and among how many places along each axis the largest is looked for beside its nodes.
struct SearchedGrid {
  std::size_t nodes = 11;
  std::size_t searched = 64;
};

/// Before and after `compensated` is taken away at each place. Mean, 95 % and the rigid motion are those of the nodes;
/// the largest is that of all places: of the largest node of each octant of the volume on, along one axis after the
/// other among all places searched, then between these, until nothing grows. Held against 10⁵ places: within 1 %.
struct FieldReduction {
  FieldSizes before, after;  ///< without rigid motion; `after` has no uncertainties
};
/// Absent where the lengths do not tell the field with this tool. Contract: 2 ≤ nodes, 2 ≤ searched.
std::optional<FieldReduction> field_reduction(const ErrorModel& model, Vector3 tool_mm, SearchedGrid grid,
                                              const std::function<Vector3(Vector3 axes_mm)>& compensated_um);

/// δ on a plane where one axis stands still, nodes with the first of the other two axes fastest; those that the lengths
/// do not tell are absent.
struct FieldSlice {
  std::size_t fixed_axis = 2;
  double at_mm = 0.0;
  std::size_t across_axis = 0, up_axis = 1;
  std::vector<double> across_mm, up_mm;
  std::vector<std::optional<Vector3>> error_um;
};
FieldSlice field_slice(const ErrorModel& model, Vector3 tool_mm, std::size_t fixed_axis, double at_mm,
                       std::size_t nodes);

}  // namespace axiometry::volumetric
