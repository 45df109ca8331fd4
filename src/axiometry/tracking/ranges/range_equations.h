// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "axiometry/model/tracking.h"
#include "axiometry/tracking/ranges/multilateration.h"

/// The equations of multilateration, laid out for passes over the points. Internal to multilaterate().
namespace axiometry::tracking::detail {

/// Readings by point; those of one point lie together. Columns of the reduced system are, per station, three
/// coordinates and with free scales one for κ, then one per segment.
struct RangeLayout {
  std::size_t points = 0;
  std::size_t stations = 0;
  bool free_scales = false;
  std::vector<std::size_t> first;       ///< beginning of each point in the arrays below; points + 1 of them
  std::vector<std::uint32_t> station;   ///< station per reading
  std::vector<std::uint32_t> segment;   ///< segment per reading, counted over all stations
  std::vector<std::uint32_t> reading;   ///< index in the order given
  std::vector<double> length_mm;        ///< length per reading
  std::vector<std::uint32_t> owner;     ///< station of each segment
  std::vector<std::size_t> segment_of;  ///< number within its station, per segment

  std::size_t readings() const { return length_mm.size(); }
  std::size_t block() const { return free_scales ? 4 : 3; }
  std::size_t station_column(std::size_t j) const { return j * block(); }
  std::size_t segment_column(std::size_t k) const { return stations * block() + k; }
  std::size_t columns() const { return stations * block() + owner.size(); }
};

/// Needs valid indices. `segments` are those of the readings, as used.
RangeLayout lay_out(std::size_t points, std::size_t stations, std::span<const RangeReading> readings,
                    std::span<const std::size_t> segments, bool free_scales);

/// All unknowns.
struct RangeState {
  std::vector<Vector3> points;
  std::vector<Vector3> stations;
  std::vector<double> dead;  ///< l_0 per segment
  std::vector<double> scales;
};

/// σ² of a length, and the length by which the columns of κ are scaled.
struct RangeWeighting {
  RangingUncertainty ranging;
  double repeatability_mm = 0.0;
  double scale_length_mm = 1.0;

  double variance(double distance_mm) const {
    const double u = ranging.standard_mm(distance_mm);
    return u * u + repeatability_mm * repeatability_mm;
  }
};

/// One reading about a state: residual w = κd − l − l_0, and its derivatives by the point (κu), by the station (−κu),
/// by l_0 (−1) and by κ times the scale length.
struct RangeRow {
  double residual = 0.0;
  double weight = 0.0;  ///< 1/σ²
  Vector3 along;        ///< κu
  double by_scale = 0.0;
};

inline RangeRow range_row(const RangeLayout& layout, const RangeState& state, const RangeWeighting& weighting,
                          Vector3 point, std::size_t t) {
  const std::size_t j = layout.station[t];
  const Vector3 beam = point - state.stations[j];
  const double d = std::sqrt(dot(beam, beam));  // no coordinate of a machine overflows
  const double kappa = state.scales[j];
  return {kappa * d - layout.length_mm[t] - state.dead[layout.segment[t]], 1.0 / weighting.variance(d),
          (d > 0.0 ? kappa / d : 0.0) * beam, d / weighting.scale_length_mm};
}

/// Lower triangle of V = Σ weight · along alongᵀ by Cholesky; `weak` where a pivot is nothing but rounding (the beams
/// lie in one plane), and then made large enough to go on with.
struct PointFactor {
  double xx = 0.0, yx = 0.0, yy = 0.0, zx = 0.0, zy = 0.0, zz = 0.0;
  bool weak = false;

  void add(double w, Vector3 a) {
    xx += w * a.x * a.x;
    yx += w * a.y * a.x;
    yy += w * a.y * a.y;
    zx += w * a.z * a.x;
    zy += w * a.z * a.y;
    zz += w * a.z * a.z;
  }
  void factor(double damping) {
    const double least = 1e-14 * (xx + yy + zz);
    const auto root = [&](double pivot) {
      if (!(pivot > least)) weak = true;
      return std::sqrt(std::max(pivot, 1e-9 * (least / 1e-14)));
    };
    const double ddx = damping * xx, ddy = damping * yy, ddz = damping * zz;
    xx = root(xx + ddx);
    yx /= xx;
    zx /= xx;
    yy = root(yy + ddy - yx * yx);
    zy = (zy - zx * yx) / yy;
    zz = root(zz + ddz - zx * zx - zy * zy);
  }
  /// L⁻¹ b.
  Vector3 forward(Vector3 b) const {
    const double x = b.x / xx;
    const double y = (b.y - yx * x) / yy;
    return {x, y, (b.z - zx * x - zy * y) / zz};
  }
  /// L⁻ᵀ b.
  Vector3 backward(Vector3 b) const {
    const double z = b.z / zz;
    const double y = (b.y - zy * z) / yy;
    return {(b.x - yx * y - zx * z) / xx, y, z};
  }
  Vector3 solve(Vector3 b) const { return backward(forward(b)); }
};

/// Which columns a point touches, in compact numbering, kept from point to point as long as it stays the same.
class ColumnPattern {
 public:
  /// Whether the readings from `begin` to `end` have the pattern at hand.
  bool fits(const RangeLayout& layout, std::size_t begin, std::size_t end) const;
  void take(const RangeLayout& layout, std::size_t begin, std::size_t end);

  std::size_t size() const { return columns_.size(); }
  std::span<const std::size_t> columns() const { return columns_; }
  std::size_t station_at(std::size_t k) const { return station_at_[k]; }  ///< compact column of the k-th reading
  std::size_t segment_at(std::size_t k) const { return segment_at_[k]; }

 private:
  std::vector<std::uint32_t> station_, segment_;
  std::vector<std::size_t> columns_, station_at_, segment_at_;
};

/// Runs work(chunk, begin, end) for every chunk of the points on several threads. The chunks depend on the number of
/// points alone, so that sums over them in their order do not depend on threads.
struct PointChunks {
  std::size_t points = 0;
  std::size_t count = 1;
  std::size_t threads = 1;
};
PointChunks point_chunks(std::size_t points, std::size_t columns, std::size_t threads);

using ChunkWork = std::function<void(std::size_t chunk, std::size_t begin, std::size_t end)>;
void for_chunks(const PointChunks& chunks, const ChunkWork& work);

}  // namespace axiometry::tracking::detail
