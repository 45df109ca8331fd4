// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/ranges/range_start.h"

namespace axiometry::tracking::detail {
namespace {

constexpr double machine_error_most_mm = 1.0;
constexpr double step_least_mm = 0.05;
constexpr double step_over_scatter = 8.0;
constexpr double freedom_least = 8.0;  // below it the scatter itself is too uncertain

/// A segment's residuals and rows about a start: [−u, w], less their means.
struct Segment {
  std::vector<std::size_t> at;  // indices of the segment's readings among those of the station
  std::vector<Eigen::Vector4d> rows;
};

std::vector<Segment> segments_of(const StationReadings& r, const StationStart& start) {
  std::vector<Segment> segments(r.segments);
  for (std::size_t k = 0; k < r.length_mm.size(); ++k) {
    const Vector3 beam = r.nominal_mm[k] - start.station_mm;
    const double d = norm(beam);
    Segment& segment = segments[r.segment[k]];
    segment.at.push_back(k);
    const Vector3 u = d > 0.0 ? 1.0 / d * beam : Vector3{};
    segment.rows.emplace_back(-u.x, -u.y, -u.z, d - r.length_mm[k] - start.dead_mm[r.segment[k]]);
  }
  for (Segment& segment : segments) {
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    for (const auto& row : segment.rows) mean += row / static_cast<double>(segment.rows.size());
    for (auto& row : segment.rows) row -= mean;
  }
  return segments;
}

}  // namespace

std::optional<LengthStep> find_step(const StationReadings& r, const StationStart& start) {
  const auto segments = segments_of(r, start);
  Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
  for (const Segment& segment : segments)
    for (const auto& row : segment.rows) sum += row * row.transpose();
  const Eigen::Matrix3d normal = sum.topLeftCorner<3, 3>();
  const Eigen::Matrix3d damped = normal + 1e-12 * normal.trace() * Eigen::Matrix3d::Identity();
  const Eigen::LDLT<Eigen::Matrix3d> solver(damped);
  const double unknowns = 4.0 + static_cast<double>(r.segments);
  const double freedom = static_cast<double>(r.length_mm.size()) - unknowns;
  if (freedom < freedom_least) return std::nullopt;

  // A further column that is 1 from t on: what it takes from the sum of squares, (Σ w)² over its squared length beside
  // the other columns.
  std::optional<LengthStep> best;
  double most = 0.0;
  for (const Segment& segment : segments) {
    const std::size_t n = segment.rows.size();
    Eigen::Vector4d behind = Eigen::Vector4d::Zero();
    for (std::size_t t = n - 1; t >= 1 && n >= 2; --t) {
      behind += segment.rows[t];
      const auto count = static_cast<double>(n - t);
      const Eigen::Vector3d q = behind.head<3>();
      const double whole = count * (1.0 - count / static_cast<double>(n));
      const double own = whole - q.dot(solver.solve(q));
      if (own < 0.02 * whole || own < 0.2) continue;  // hardly to be told from another place of the station
      const double taken = behind[3] * behind[3] / own;
      if (!(taken > most)) continue;
      most = taken;
      best = LengthStep{segment.at[t], -behind[3] / own};
    }
  }
  if (!best) return std::nullopt;
  const double scatter = std::sqrt(std::max(sum(3, 3) - most, 0.0) / freedom);
  if (std::abs(best->jump_mm) < std::max(step_least_mm, step_over_scatter * scatter)) return std::nullopt;
  return best;
}

TriangleCheck check_triangles(const StationReadings& r) {
  TriangleCheck check;
  std::vector<std::optional<std::size_t>> last(r.segments);
  for (std::size_t k = 0; k < r.length_mm.size(); ++k) {
    auto& before = last[r.segment[k]];
    if (before) {
      ++check.pairs;
      const double change = r.length_mm[k] - r.length_mm[*before];
      const double way = distance(r.nominal_mm[k], r.nominal_mm[*before]);
      if (std::abs(change) > 1.01 * way + machine_error_most_mm) check.violations.push_back({k, change});
    }
    before = k;
  }
  return check;
}

void restart_segment(StationReadings& r, std::size_t before) {
  const std::size_t segment = r.segment[before];
  for (std::size_t k = before; k < r.segment.size(); ++k)
    if (r.segment[k] == segment) r.segment[k] = r.segments;
  ++r.segments;
}

std::size_t settle_restart(StationReadings& r, std::size_t before, const StationStart& start) {
  const std::size_t fresh = r.segments - 1;
  // The segment that it was cut from: the one of the reading before in time that is cut nowhere else in between.
  std::size_t old = fresh;
  for (std::size_t k = before; k-- > 0 && old == fresh;)
    if (r.segment[k] != fresh) old = r.segment[k];
  if (old == fresh) return before;
  std::vector<std::size_t> both;
  for (std::size_t k = 0; k < r.segment.size(); ++k)
    if (r.segment[k] == old || r.segment[k] == fresh) both.push_back(k);
  double least = 0.0, sum = 0.0;  // Σ over the readings given to `old`: square about `old` less square about `fresh`
  std::size_t cut = 0;
  for (std::size_t k = 0; k < both.size(); ++k) {
    const double e = distance(r.nominal_mm[both[k]], start.station_mm) - r.length_mm[both[k]];
    const double about_old = e - start.dead_mm[old], about_fresh = e - start.dead_mm[fresh];
    sum += about_old * about_old - about_fresh * about_fresh;
    if (k == 0 || sum < least) {
      least = sum;
      cut = k + 1;
    }
  }
  if (cut == 0 || cut >= both.size()) return before;
  for (std::size_t k = 0; k < both.size(); ++k) r.segment[both[k]] = k < cut ? old : fresh;
  return both[cut];
}

}  // namespace axiometry::tracking::detail
