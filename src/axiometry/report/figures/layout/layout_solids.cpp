// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/layout/layout_solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report::plot {
namespace {

constexpr int parts_of_circle = 48;
const Stroke edge_line = ink::solid(ink::grey, 0.6);
const Stroke hidden_line{.colour = ink::extension_grey, .width = 0.4, .dashes = {2.0, 1.6}};
const Stroke solid_line = ink::solid(ink::faint(ink::black, 0.7), 0.5);
constexpr Colour floor_tint{0.45, 0.45, 0.45, 0.05};
constexpr Colour solid_tint{0.55, 0.5, 0.4, 0.16};

/// Corner k of a box: bit 0 says whether X is high, bit 1 Y, bit 2 Z.
std::vector<Vector3> corners(Vector3 low, Vector3 high) {
  std::vector<Vector3> all;
  for (std::size_t k = 0; k < 8; ++k)
    all.push_back({(k & 1U) != 0 ? high.x : low.x, (k & 2U) != 0 ? high.y : low.y, (k & 4U) != 0 ? high.z : low.z});
  return all;
}

/// Sides towards the reader, by the bits that their corners share.
std::vector<std::array<std::size_t, 4>> sides_towards(const Projection& view) {
  std::vector<std::array<std::size_t, 4>> sides;
  constexpr double edge_on = 1e-9;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double towards = view.sight.towards[axis];
    if (std::abs(towards) < edge_on) continue;
    const std::size_t own = std::size_t{1} << axis, a = std::size_t{1} << (axis + 1) % 3,
                      b = std::size_t{1} << (axis + 2) % 3;
    const std::size_t base = towards > 0.0 ? own : 0;
    sides.push_back({base, base | a, base | a | b, base | b});
  }
  return sides;
}

Path polygon(const std::vector<Point>& points, const Stroke& stroke, Colour fill) {
  return {.points = points, .closed = true, .stroke = stroke, .fill = fill};
}

void draw_edges(Operations& operations, const std::vector<Vector3>& all, const Projection& view, const Stroke& seen,
                const Stroke& hidden) {
  const auto towards = sides_towards(view);
  for (const bool visible : {false, true})
    for (std::size_t k = 0; k < 8; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t other = k | std::size_t{1} << axis;
        if (other == k) continue;
        const bool is_seen = std::ranges::any_of(towards, [&](const auto& side) {
          return std::ranges::find(side, k) != side.end() && std::ranges::find(side, other) != side.end();
        });
        const Point from = view(all[k]), to = view(all[other]);
        if (is_seen != visible || std::hypot(to.x - from.x, to.y - from.y) < 1e-6) continue;
        const bool behind_another = !is_seen && towards.size() < 3;  // of a view along an axis
        if (!behind_another) operations.push_back(line(from, to, is_seen ? seen : hidden));
      }
}

void draw_tinted_box(Operations& operations, const BoxObstacle& box, const Projection& view) {
  const auto all = corners(box.lowest_mm, box.highest_mm);
  for (const auto& side : sides_towards(view)) {
    std::vector<Point> points;
    for (std::size_t k : side) points.push_back(view(all[k]));
    operations.push_back(polygon(points, ink::solid(ink::none, 0.0), solid_tint));
  }
  draw_edges(operations, all, view, solid_line,
             {.colour = ink::faint(ink::black, 0.4), .width = 0.3, .dashes = {1.5, 1.5}});
}

void draw_tinted_sphere(Operations& operations, const SphereObstacle& sphere, const Projection& view) {
  draw_sphere(operations, sphere.centre_mm, sphere.radius_mm, view, solid_line, solid_tint);
  draw_ring(operations, sphere.centre_mm, sphere.radius_mm, view, ink::solid(ink::faint(ink::black, 0.35), 0.3),
            ink::none);
}

/// Two ends and the sides between them: what sweeps from the lower ring to the upper one.
void draw_tinted_cylinder(Operations& operations, const CylinderObstacle& cylinder, const Projection& view) {
  const Vector3 base = cylinder.base_mm, top = base + Vector3{0, 0, cylinder.height_mm};
  const Vector3 aside = cylinder.radius_mm * view.sight.right;  // horizontal in every sight that is used
  const std::vector<Point> sides = {view(base - aside), view(base + aside), view(top + aside), view(top - aside)};
  operations.push_back(polygon(sides, ink::solid(ink::none, 0.0), solid_tint));
  draw_ring(operations, base, cylinder.radius_mm, view, solid_line, solid_tint);
  draw_ring(operations, top, cylinder.radius_mm, view, solid_line, solid_tint);
  operations.push_back(line(sides[0], sides[3], solid_line));
  operations.push_back(line(sides[1], sides[2], solid_line));
}

BoxObstacle around(const Obstacle& obstacle) {
  if (const auto* box = std::get_if<BoxObstacle>(&obstacle.shape)) return *box;
  if (const auto* sphere = std::get_if<SphereObstacle>(&obstacle.shape)) {
    const Vector3 r{sphere->radius_mm, sphere->radius_mm, sphere->radius_mm};
    return {sphere->centre_mm - r, sphere->centre_mm + r};
  }
  const auto& cylinder = std::get<CylinderObstacle>(obstacle.shape);
  const Vector3 r{cylinder.radius_mm, cylinder.radius_mm, 0.0};
  return {cylinder.base_mm - r, cylinder.base_mm + r + Vector3{0, 0, cylinder.height_mm}};
}

}  // namespace

std::vector<Vector3> corners_of(const TravelBox& box) { return corners(box.lowest_mm, box.highest_mm); }

std::vector<Vector3> corners_of(const Obstacle& obstacle) {
  const BoxObstacle box = around(obstacle);
  return corners(box.lowest_mm, box.highest_mm);
}

Vector3 centre_of(const Obstacle& obstacle) {
  const BoxObstacle box = around(obstacle);
  return 0.5 * (box.lowest_mm + box.highest_mm);
}

void draw_box(Operations& operations, const TravelBox& box, const Projection& view) {
  const auto all = corners_of(box);
  operations.push_back(
      polygon({view(all[0]), view(all[1]), view(all[3]), view(all[2])}, ink::solid(ink::none, 0.0), floor_tint));
  draw_edges(operations, all, view, edge_line, hidden_line);
}

void draw_solid(Operations& operations, const Obstacle& obstacle, const Projection& view) {
  struct Draw {
    Operations& operations;
    const Projection& view;
    void operator()(const BoxObstacle& box) const { draw_tinted_box(operations, box, view); }
    void operator()(const SphereObstacle& sphere) const { draw_tinted_sphere(operations, sphere, view); }
    void operator()(const CylinderObstacle& cylinder) const { draw_tinted_cylinder(operations, cylinder, view); }
  };
  std::visit(Draw{operations, view}, obstacle.shape);
}

void draw_ring(Operations& operations, Vector3 centre, double radius_mm, const Projection& view, const Stroke& stroke,
               Colour fill) {
  std::vector<Point> points;
  for (int k = 0; k < parts_of_circle; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / parts_of_circle;
    points.push_back(view(centre + Vector3{radius_mm * std::cos(angle), radius_mm * std::sin(angle), 0.0}));
  }
  operations.push_back(polygon(points, stroke, fill));
}

void draw_sphere(Operations& operations, Vector3 centre, double radius_mm, const Projection& view, const Stroke& stroke,
                 Colour fill) {
  std::vector<Point> points;
  const Point at = view(centre);
  const double radius = radius_mm * view.points_per_mm;
  for (int k = 0; k < parts_of_circle; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / parts_of_circle;
    points.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
  }
  operations.push_back(polygon(points, stroke, fill));
}

}  // namespace axiometry::report::plot
