// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/table_effect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/volumetric/field/curve_nodes.h"
#include "axiometry/volumetric/field/field_rows.h"

namespace axiometry::volumetric {
namespace {

constexpr std::size_t places_least = 11;  // places along each axis
constexpr std::size_t searched_least = SearchedGrid{}.searched, searched_most = 192;

/// Of whose spans none but the ends is a position of the tables: there a table leaves nothing.
std::size_t places_between(std::size_t nodes) {
  std::size_t spans = places_least - 1;
  while (std::gcd(spans, nodes - 1) != 1) ++spans;
  return spans + 1;
}

double on_straight_lines(const std::vector<CurveNode>& curve, double position) {
  const auto above = std::ranges::upper_bound(curve, position, {}, &CurveNode::position_mm);
  if (above == curve.begin()) return curve.front().mean.value;
  if (above == curve.end()) return curve.back().mean.value;
  const CurveNode &a = *(above - 1), &b = *above;
  return std::lerp(a.mean.value, b.mean.value, (position - a.position_mm) / (b.position_mm - a.position_mm));
}

}  // namespace

std::optional<TableEffect> table_effect(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes,
                                        const std::function<Vector3(Vector3 axes_mm)>& compensated_um) {
  AXIOMETRY_CONTRACT(nodes >= 2);
  // Eight in each span of up to 25 nodes, within which what straight lines leave is a parabola; of more it is little.
  const std::size_t searched = std::clamp<std::size_t>(8 * (nodes - 1), searched_least, searched_most) + 1;
  const auto before = sizes_without_rigid_motion(model, tool_mm, places_between(nodes));
  if (!before) return std::nullopt;
  const SearchedGrid grid{places_between(nodes), searched};
  return TableEffect{*before, remaining_without_rigid_motion(model, tool_mm, grid, compensated_um)};
}

std::optional<TableEffect> effect_of_all_errors(const ErrorModel& model, Vector3 tool_mm, std::size_t nodes) {
  AXIOMETRY_CONTRACT(nodes >= 2);
  std::array<std::array<std::vector<CurveNode>, motion_count>, axis_count> curves;
  ErrorValues errors;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m)
      if (curves[a][m] = curve_nodes(model, {a, m}, nodes); curves[a][m].empty()) return std::nullopt;
  for (std::size_t k = 0; k < squareness_names.size(); ++k) {
    const auto squareness = model.squareness(static_cast<Squareness>(k));
    if (!squareness) return std::nullopt;
    errors.squareness_urad[k] = squareness->value;
  }
  return table_effect(model, tool_mm, nodes, [&](Vector3 q) {
    for (std::size_t a = 0; a < axis_count; ++a)
      for (std::size_t m = 0; m < motion_count; ++m) errors.motions[a][m] = on_straight_lines(curves[a][m], q[a]);
    return displacement_um(model.machine(), errors, q, tool_mm);
  });
}

std::optional<double> half_reversal_um(const ErrorModel& model, Vector3 tool_mm) {
  if (model.coefficients().reversal() == Reversal::none) return 0.0;
  if (!model.unseen_reversals().empty()) return std::nullopt;
  const auto displacement = [&](Vector3 q, Approaches approaches) {
    return BeamRow(model.coefficients(), model.machine(), q, tool_mm, approaches).displacement_um(model.parts().values);
  };
  double most = 0.0;
  constexpr std::size_t n = places_least;
  const auto share = [](std::size_t k) { return static_cast<double>(k) / static_cast<double>(n - 1); };
  for (std::size_t k = 0; k < n * n * n; ++k) {
    const Vector3 q = place_in(model.observed(), {share(k % n), share(k / n % n), share(k / n / n)});
    const Vector3 mean = displacement(q, {});
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) most = std::max(most, norm(displacement(q, {1.0, y, z}) - mean));
  }
  return most;
}

}  // namespace axiometry::volumetric
