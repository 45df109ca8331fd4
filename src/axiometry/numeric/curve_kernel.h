// SPDX-License-Identifier: Apache-2.0
#pragma once

// Draws of curve_posterior.h in the axes of a curve, for one target; compiled once for each (vector_target.h). Lanes
// are places: the axes differ from draw to draw.
#include "axiometry/numeric/curve_kernel_types.h"
#include "axiometry/numeric/kernels/lanes.h"

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {
namespace {

/// Coordinates mean_k + sd_k z_k, made side by side before each is needed in every lane.
constexpr size_t coordinates_at_once = 16;

[[gnu::always_inline]] inline void make_coordinates(const CurveView& view, const double* normals, size_t begin,
                                                    size_t end, double* coordinates) {
  size_t k = begin;
  for (; k + lanes<Doubles> <= end; k += lanes<Doubles>)
    store(coordinates + (k - begin),
          load<Doubles>(view.means + k) + load<Doubles>(view.sds + k) * load<Doubles>(normals + k));
  for (; k < end; ++k) coordinates[k - begin] = view.means[k] + view.sds[k] * normals[k];
}

/// Some registers of places, from the first on.
template <size_t registers>
[[gnu::always_inline]] inline void draw_places(const CurveView& view, const double* normals, size_t first,
                                               double* values) {
  Doubles sums[registers] = {};
  for (size_t begin = 0; begin < view.places; begin += coordinates_at_once) {
    const size_t left = view.places - begin, end = begin + (left < coordinates_at_once ? left : coordinates_at_once);
    double coordinates[coordinates_at_once];
    make_coordinates(view, normals, begin, end, coordinates);
    for (size_t k = begin; k < end; ++k) {
      const Doubles coordinate = all<Doubles>(coordinates[k - begin]);
      const double* const column = view.columns + k * view.stride + first;
      for (size_t r = 0; r < registers; ++r) sums[r] += coordinate * load<Doubles>(column + r * lanes<Doubles>);
    }
  }
  for (size_t r = 0; r < registers; ++r) store(values + first + r * lanes<Doubles>, sums[r]);
}

[[gnu::always_inline]] inline void draw_curve(const CurveView& view, const double* normals, double* values) {
  constexpr size_t wide = 6;  // 12 places of two lanes, and 24 of four
  size_t first = 0;
  for (; first + wide * lanes<Doubles> <= view.places; first += wide * lanes<Doubles>)
    draw_places<wide>(view, normals, first, values);
  const size_t left = (view.places - first + lanes<Doubles> - 1) / lanes<Doubles>;
  switch (left) {
    case 1: return draw_places<1>(view, normals, first, values);
    case 2: return draw_places<2>(view, normals, first, values);
    case 3: return draw_places<3>(view, normals, first, values);
    case 4: return draw_places<4>(view, normals, first, values);
    case 5: return draw_places<5>(view, normals, first, values);
    case 6: return draw_places<6>(view, normals, first, values);
    default: return;
  }
}

void draw(const CurveDraws& curves) {
  for (size_t c = 0; c < curves.count; ++c)
    draw_curve(curves.views[c], curves.normals + c * curves.normals_stride, curves.values + c * curves.values_stride);
}

}  // namespace

extern const CurveKernel curve_kernel;
const CurveKernel curve_kernel = {draw};

}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
