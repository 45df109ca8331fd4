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

/// Of |δ|, µm: mean and 95 % over the nodes of a grid, the largest over all places. It is searched from the largest
/// nodes of 64 blocks of the volume on, along one axis after the other, then between these places, until it grows by
/// 0.1 % at most. Held against 10⁵ places: within 1 %. Without rigid motion: less that of the nodes.
struct FieldSizes {
  Estimate largest;  ///< u is that of |δ| at this place, to first order
  Vector3 largest_at_mm;
  double mean = 0.0;
  double percent_95 = 0.0;  ///< value that 95 % of the nodes do not exceed
};

/// Mean and 95 % of displacements; the largest is left to who knows its place.
FieldSizes sizes_of(std::span<const Vector3> field_um);

struct VolumeStatistics {
  /// As it is in the gauge; absent where the lengths do not tell all of it.
  std::optional<FieldSizes> as_found;
  /// Without the displacement and rotation of everything that fits it best (least squares over the nodes): what no
  /// placing of a workpiece takes away. Absent likewise.
  std::optional<FieldSizes> without_rigid_motion;
  Vector3 translation_um;  ///< translation of that motion, at the middle of the volume
  Vector3 rotation_urad;
};

/// Over the travel that was observed, `nodes` along each axis with both ends. Contract: 2 ≤ nodes ≤ 101.
VolumeStatistics volume_statistics(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes);

/// What volume_statistics() has without rigid motion, alone: half as much is searched.
std::optional<FieldSizes> sizes_without_rigid_motion(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes);

/// What volume_statistics() has of the field.
struct ToldField {
  bool as_found = false;
  bool without_rigid_motion = false;
};
ToldField told_field(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes);

/// A grid, and among how many places along each axis the largest is looked for beside its nodes.
struct SearchedGrid {
  std::size_t nodes = 11;
  std::size_t searched = 64;  ///< enough for a smooth field
};

/// What is left of the field when `compensated` is taken away at each place; no uncertainty. Contract: 2 ≤ nodes,
/// 2 ≤ searched.
struct RemainingSizes {
  FieldSizes as_found, without_rigid_motion;
};
RemainingSizes sizes_without(const ErrorModel& model, Vector3 tool_mm, SearchedGrid grid,
                             const std::function<Vector3(Vector3 axes_mm)>& compensated_um);
/// The same without rigid motion, alone.
FieldSizes remaining_without_rigid_motion(const ErrorModel& model, Vector3 tool_mm, SearchedGrid grid,
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
