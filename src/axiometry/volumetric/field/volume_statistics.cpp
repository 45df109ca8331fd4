// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/volume_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/volumetric/field/field_rows.h"

namespace axiometry::volumetric {
namespace {

constexpr double m_per_mm = 1e-3;
constexpr std::size_t searched_places = SearchedGrid{}.searched;

/// A field on a grid, and the rigid motion within it: of a grid with equal steps the moments of inertia are diagonal.
class VolumeGrid {
 public:
  VolumeGrid(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes) : model_(model), tool_(tool_mm) {
    const double last = static_cast<double>(nodes - 1);
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t j = 0; j < nodes; ++j)
        for (std::size_t k = 0; k < nodes; ++k)
          places_.push_back(place_in(model.observed(), {static_cast<double>(i) / last, static_cast<double>(j) / last,
                                                        static_cast<double>(k) / last}));
    middle_ = place_in(model.observed(), {0.5, 0.5, 0.5});
    for (const Vector3& q : places_) {
      const Vector3 p = lever_m(q);
      const double squares = p.x * p.x + p.y * p.y + p.z * p.z;
      for (std::size_t k = 0; k < 3; ++k) inertia_[k] += squares - p[k] * p[k];
    }
  }

  const std::vector<Vector3>& places() const { return places_; }

  struct RigidMotion {
    Vector3 translation, rotation;
  };
  RigidMotion rigid_motion(const std::vector<Vector3>& field) const {
    RigidMotion motion{};
    for (std::size_t j = 0; j < field.size(); ++j) {
      motion.translation += 1.0 / static_cast<double>(field.size()) * field[j];
      const Vector3 moment = cross(lever_m(places_[j]), field[j]);
      for (std::size_t k = 0; k < 3; ++k) motion.rotation[k] += moment[k] / inertia_[k];
    }
    return motion;
  }
  std::vector<Vector3> without(std::vector<Vector3> field) const {
    const RigidMotion motion = rigid_motion(field);
    for (std::size_t j = 0; j < field.size(); ++j) field[j] = less(motion, field[j], places_[j]);
    return field;
  }

  /// What a motion leaves of a field at any place.
  Vector3 less(const RigidMotion& motion, Vector3 field, Vector3 at_mm) const {
    return field - motion.translation - cross(motion.rotation, lever_m(at_mm));
  }

  /// The row of one component of without(): that of the place less the motion there, which all nodes make.
  DenseRow row_without(Vector3 at_mm, Vector3 along) const {
    DenseRow row;
    add_field(row, model_, at_mm, tool_, along);
    const Vector3 turned = cross(lever_m(at_mm), along);
    Vector3 share;
    for (std::size_t k = 0; k < 3; ++k) share[k] = turned[k] / inertia_[k];
    for (const Vector3& q : places_)
      add_field(row, model_, q, tool_, -(1.0 / static_cast<double>(places_.size()) * along) - cross(share, lever_m(q)));
    return row;
  }

  std::vector<Vector3> field_of(const std::vector<double>& coefficients) const {
    std::vector<Vector3> field;
    for (const Vector3& q : places_) field.push_back(field_um(model_, coefficients, q, tool_));
    return field;
  }

  /// The largest node of each of 64 blocks, but for those that are less than half of the largest: between others may be
  /// the largest of all.
  std::vector<Vector3> largest_of_blocks(const std::vector<Vector3>& field) const {
    constexpr std::size_t blocks = 4;  // blocks along each axis; two missed the largest error that tables leave by 17 %
    std::array<std::optional<std::size_t>, blocks * blocks * blocks> largest;
    const TravelBox box = model_.observed();
    for (std::size_t j = 0; j < field.size(); ++j) {
      std::size_t block = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double share = (places_[j][k] - box.lowest_mm[k]) / (box.highest_mm[k] - box.lowest_mm[k]);
        const double at = std::clamp(share * blocks, 0.0, blocks - 1.0);
        block = blocks * block + static_cast<std::size_t>(at);
      }
      if (!largest[block] || norm(field[j]) > norm(field[*largest[block]])) largest[block] = j;
    }
    double most = 0.0;
    for (const Vector3& f : field) most = std::max(most, norm(f));
    std::vector<Vector3> places;
    for (const auto& node : largest)
      if (node && norm(field[*node]) >= 0.5 * most) places.push_back(places_[*node]);
    return places;
  }

  /// Whether nothing of what the lengths do not tell is left beside a rigid motion, or beside a displacement alone.
  bool is_told(bool but_for_rotation) const {
    for (const auto& direction : model_.parts().unseen) {
      std::vector<Vector3> field = field_of(direction);
      if (but_for_rotation) field = without(std::move(field));
      const Vector3 mean = but_for_rotation ? Vector3{} : rigid_motion(field).translation;
      constexpr double moved_most = 1e-5;
      if (std::ranges::any_of(field, [&](Vector3 f) { return norm(f - mean) > moved_most; })) return false;
    }
    return true;
  }

 private:
  Vector3 lever_m(Vector3 q) const { return m_per_mm * (q - middle_); }

  const ErrorModel& model_;
  Vector3 tool_;
  std::vector<Vector3> places_;
  Vector3 middle_;
  Vector3 inertia_{};
};

Vector3 direction_of(Vector3 f) { return norm(f) > 0.0 ? unit(f) : Vector3{1, 0, 0}; }

using FieldAt = std::function<Vector3(Vector3 axes_mm)>;

/// Where |field| is largest on the line along one axis through a place.
Vector3 largest_along(std::size_t axis, Vector3 from, const TravelBox& box, std::size_t searched,
                      const FieldAt& field) {
  constexpr int between = 8;
  const double lowest = box.lowest_mm[axis], highest = box.highest_mm[axis];
  double most = norm(field(from)), at = from[axis];
  Vector3 q = from;
  const auto look = [&](double position) {
    q[axis] = std::clamp(position, lowest, highest);
    if (const double size = norm(field(q)); size > most) {
      most = size;
      at = q[axis];
    }
  };
  const double step = (highest - lowest) / static_cast<double>(searched - 1);
  for (std::size_t k = 0; k < searched; ++k) look(lowest + step * static_cast<double>(k));
  const double middle = at;
  for (int k = -between + 1; k < between; ++k) look(middle + step / between * k);
  q[axis] = at;
  return q;
}

/// From each of some places, along one axis after the other, until it hardly grows.
Vector3 largest_place(const std::vector<Vector3>& starts, const TravelBox& box, std::size_t searched,
                      const FieldAt& field) {
  constexpr int rounds_most = 6;
  constexpr double grown_least = 1e-3;  // relative growth that ends the search; the result is stated to 1 %
  Vector3 best = starts.front();
  for (const Vector3& start : starts) {
    Vector3 q = start;
    for (int round = 0; round < rounds_most; ++round) {
      const double before = norm(field(q));
      for (std::size_t a = 0; a < axis_count; ++a) q = largest_along(a, q, box, searched, field);
      if (norm(field(q)) <= (1.0 + grown_least) * before) break;
    }
    if (norm(field(q)) > norm(field(best))) best = q;
  }
  return best;
}

/// Mean and 95 % of the nodes, the largest of all places; no uncertainty.
FieldSizes searched_sizes(const VolumeGrid& grid, const std::vector<Vector3>& nodes, const TravelBox& box,
                          std::size_t searched, const FieldAt& field) {
  FieldSizes sizes = sizes_of(nodes);
  sizes.largest_at_mm = largest_place(grid.largest_of_blocks(nodes), box, searched, field);
  sizes.largest.value = norm(field(sizes.largest_at_mm));
  return sizes;
}

/// The same without the rigid motion of the nodes.
FieldSizes searched_sizes_without_motion(const VolumeGrid& grid, const std::vector<Vector3>& nodes,
                                         const TravelBox& box, std::size_t searched, const FieldAt& field) {
  const VolumeGrid::RigidMotion motion = grid.rigid_motion(nodes);
  return searched_sizes(grid, grid.without(nodes), box, searched,
                        [&](Vector3 q) { return grid.less(motion, field(q), q); });
}

/// Of what was found, with the uncertainty of the largest.
FieldSizes found_without_motion(const VolumeGrid& grid, const std::vector<Vector3>& nodes, const ErrorModel& model,
                                const FieldAt& found) {
  FieldSizes sizes = searched_sizes_without_motion(grid, nodes, model.observed(), searched_places, found);
  const Vector3 at = sizes.largest_at_mm, largest = grid.less(grid.rigid_motion(nodes), found(at), at);
  sizes.largest = estimate_of(model, grid.row_without(at, direction_of(largest)));
  return sizes;
}

/// What is left of the field when something is taken away, at the nodes of a grid and anywhere.
struct RemainingField {
  RemainingField(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes, const FieldAt& compensated_um)
      : grid(model, tool_mm, nodes), left([&model, tool_mm, &compensated_um](Vector3 q) {
          return field_um(model, model.parts().values, q, tool_mm) - compensated_um(q);
        }) {
    for (const Vector3& q : grid.places()) at_nodes.push_back(left(q));
  }
  VolumeGrid grid;
  FieldAt left;
  std::vector<Vector3> at_nodes;
};

}  // namespace

FieldSizes sizes_of(std::span<const Vector3> field) {
  FieldSizes sizes;
  std::vector<double> lengths;
  for (const Vector3& f : field) {
    lengths.push_back(norm(f));
    sizes.mean += lengths.back() / static_cast<double>(field.size());
  }
  const auto at = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(lengths.size()))) - 1;
  std::ranges::nth_element(lengths, lengths.begin() + static_cast<std::ptrdiff_t>(at));
  sizes.percent_95 = lengths[at];
  return sizes;
}

VolumeStatistics volume_statistics(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes) {
  AXIOMETRY_CONTRACT(nodes >= 2 && nodes <= 101);
  const VolumeGrid grid(model, tool_mm, nodes);
  const std::vector<Vector3> field = grid.field_of(model.parts().values);
  const FieldAt found = [&](Vector3 q) { return field_um(model, model.parts().values, q, tool_mm); };
  VolumeStatistics statistics;
  if (grid.is_told(false)) {
    FieldSizes sizes = searched_sizes(grid, field, model.observed(), searched_places, found);
    DenseRow row;
    add_field(row, model, sizes.largest_at_mm, tool_mm, direction_of(found(sizes.largest_at_mm)));
    sizes.largest = estimate_of(model, row);
    statistics.as_found = sizes;
  }
  if (grid.is_told(true)) {
    const VolumeGrid::RigidMotion motion = grid.rigid_motion(field);
    statistics.without_rigid_motion = found_without_motion(grid, field, model, found);
    statistics.translation_um = motion.translation;
    statistics.rotation_urad = motion.rotation;
  }
  return statistics;
}

std::optional<FieldSizes> sizes_without_rigid_motion(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes) {
  AXIOMETRY_CONTRACT(nodes >= 2 && nodes <= 101);
  const VolumeGrid grid(model, tool_mm, nodes);
  if (!grid.is_told(true)) return std::nullopt;
  return found_without_motion(grid, grid.field_of(model.parts().values), model,
                              [&](Vector3 q) { return field_um(model, model.parts().values, q, tool_mm); });
}

ToldField told_field(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes) {
  const VolumeGrid grid(model, tool_mm, nodes);
  return {grid.is_told(false), grid.is_told(true)};
}

RemainingSizes sizes_without(const ErrorModel& model, Vector3 tool_mm, SearchedGrid searched,
                             const FieldAt& compensated_um) {
  AXIOMETRY_CONTRACT(searched.nodes >= 2 && searched.searched >= 2);
  const RemainingField rest(model, tool_mm, searched.nodes, compensated_um);
  return {searched_sizes(rest.grid, rest.at_nodes, model.observed(), searched.searched, rest.left),
          searched_sizes_without_motion(rest.grid, rest.at_nodes, model.observed(), searched.searched, rest.left)};
}

FieldSizes remaining_without_rigid_motion(const ErrorModel& model, Vector3 tool_mm, SearchedGrid searched,
                                          const FieldAt& compensated_um) {
  AXIOMETRY_CONTRACT(searched.nodes >= 2 && searched.searched >= 2);
  const RemainingField rest(model, tool_mm, searched.nodes, compensated_um);
  return searched_sizes_without_motion(rest.grid, rest.at_nodes, model.observed(), searched.searched, rest.left);
}

FieldSlice field_slice(const ErrorModel& model, Vector3 tool_mm, std::size_t fixed_axis, double at_mm,
                       std::size_t nodes) {
  AXIOMETRY_CONTRACT(nodes >= 2 && fixed_axis < axis_count);
  FieldSlice slice{.fixed_axis = fixed_axis,
                   .at_mm = at_mm,
                   .across_axis = fixed_axis == 0 ? std::size_t{1} : std::size_t{0},
                   .up_axis = fixed_axis == 2 ? std::size_t{1} : std::size_t{2}};
  for (std::size_t k = 0; k < nodes; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(nodes - 1);
    const Vector3 place = place_in(model.observed(), {share, share, share});
    slice.across_mm.push_back(place[slice.across_axis]);
    slice.up_mm.push_back(place[slice.up_axis]);
  }
  Vector3 q;
  q[fixed_axis] = at_mm;
  for (const double up : slice.up_mm)
    for (const double across : slice.across_mm) {
      q[slice.up_axis] = up;
      q[slice.across_axis] = across;
      const ToolPointError value = model.at(q, tool_mm);
      slice.error_um.push_back(value.is_whole() ? std::optional<Vector3>(value.error()) : std::nullopt);
    }
  return slice;
}

}  // namespace axiometry::volumetric
