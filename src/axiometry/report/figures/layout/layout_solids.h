// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/model/tracking.h"
#include "axiometry/report/figures/layout/projection.h"
#include "axiometry/report/figures/parts/dimension_line.h"

/// Wire models in a projection.
namespace axiometry::report::plot {

std::vector<Vector3> corners_of(const TravelBox& box);
/// Of the upright box around the obstacle.
std::vector<Vector3> corners_of(const Obstacle& obstacle);
Vector3 centre_of(const Obstacle& obstacle);

/// Edges behind the box are dashed, its floor is tinted.
void draw_box(Operations& operations, const TravelBox& box, const Projection& view);

/// Box, sphere with its equator, or cylinder, tinted so that what stands behind can still be seen.
void draw_solid(Operations& operations, const Obstacle& obstacle, const Projection& view);

/// A horizontal circle.
void draw_ring(Operations& operations, Vector3 centre, double radius_mm, const Projection& view, const Stroke& stroke,
               Colour fill);

/// The outline of a sphere.
void draw_sphere(Operations& operations, Vector3 centre, double radius_mm, const Projection& view, const Stroke& stroke,
                 Colour fill);

}  // namespace axiometry::report::plot
