// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/station_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/station/station_checks.h"

namespace axiometry::tracking {
namespace {

bool is_cone(const RefinedSolution& refined) {
  const double length = mean(refined.distances_mm);
  const double hidden = 2.0 * std::sqrt(2.0 * mean(refined.fit.sigma_mm) / length);
  const double n = static_cast<double>(refined.distances_mm.size());
  return !(refined.fit.singular_values[3] / std::sqrt(n) > hidden);
}

/// Roots of the sums of squares of the distances from the best line and the best plane.
struct Extents {
  double off_line_mm = 0.0;
  double off_plane_mm = 0.0;
  Vector3 along;  ///< direction of the best line, a unit vector
};
Extents extents_of(std::span<const LocationPoint> points) {
  Vector3 centre;
  for (const LocationPoint& p : points) centre += 1.0 / static_cast<double>(points.size()) * p.at_mm;
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3 d = points[i].at_mm - centre;
    rows.row(static_cast<Eigen::Index>(i)) << d.x, d.y, d.z;
  }
  const auto svd = rows.jacobiSvd(Eigen::ComputeThinV);
  const auto values = svd.singularValues();
  const auto along = svd.matrixV().col(0);
  return {std::hypot(values[1], values[2]), values[2], {along[0], along[1], along[2]}};
}

double off_sphere_mm(std::span<const LocationPoint> points) {
  double centre = 0.0, squares = 0.0;
  for (const LocationPoint& p : points) centre += p.length_difference_mm / static_cast<double>(points.size());
  for (const LocationPoint& p : points)
    squares += (p.length_difference_mm - centre) * (p.length_difference_mm - centre);
  return std::sqrt(squares);
}

/// Half the angle of the cone on which the beams lie, and its axis: u·axis is alike for all beams.
struct Cone {
  Vector3 axis;
  double half_angle_deg = 0.0;
};
Cone cone_of(const RefinedSolution& refined, std::span<const LocationPoint> points) {
  Cone cone{refined.weakest};
  double along = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    along += dot(cone.axis, points[i].at_mm - refined.fit.station_mm) / refined.distances_mm[i];
  along /= static_cast<double>(points.size());
  if (along < 0.0) cone.axis = -cone.axis;
  cone.half_angle_deg = std::acos(std::clamp(std::abs(along), 0.0, 1.0)) * 180.0 / M_PI;
  return cone;
}

std::string direction_text(Vector3 d) {
  return fmt::format("({}, {}, {})", format_fixed(d.x, 3), format_fixed(d.y, 3), format_fixed(d.z, 3));
}

std::string surface_text(const StationLocation& location) {
  switch (location.surface) {
    case CriticalSurface::line: return "all points lie on one line";
    case CriticalSurface::plane: return "all points lie on one plane";
    case CriticalSurface::sphere: return "all points lie on a sphere about the station (all lengths are alike)";
    case CriticalSurface::repeated: return "fewer than five points are different";
    case CriticalSurface::ellipsoid:
    case CriticalSurface::paraboloid:
    case CriticalSurface::hyperboloid: {
      const std::string_view name = critical_surface_name(location.surface);
      return fmt::format("all points lie on {} {} of revolution with a focus at the station (eccentricity {})",
                         name.front() == 'e' ? "an" : "a", name, format_fixed(location.eccentricity.value_or(1.0), 3));
    }
    case CriticalSurface::cone:
    case CriticalSurface::none: break;
  }
  return "";
}

void add_mirror_finding(const StationOptions& options, StationLocation& location) {
  const RefinedFit& fit = location.refined;
  const std::string both =
      fmt::format("the lengths fit {} and {} alike", shown_point(fit.station_mm), shown_point(*fit.mirror_mm));
  if (!options.near_mm) {
    location.findings.push_back({"station-mirror-image", true,
                                 fmt::format("{}; the {} was taken: say about where the station stands", both,
                                             fit.station_mm.z < fit.mirror_mm->z ? "lower" : "first")});
    return;
  }
  const double chosen = distance(fit.station_mm, *options.near_mm);
  const double other = distance(*fit.mirror_mm, *options.near_mm);
  const bool unclear = chosen > 0.5 * other;
  location.findings.push_back(
      {"station-mirror-image", unclear,
       fmt::format("{}; the first is {} from the place that was said, the other {}{}", both, shown_mm(chosen),
                   shown_mm(other), unclear ? ", which does not decide" : "")});
}

double largest_amplification(const std::vector<Vector3>& gain) {
  double worst = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    double squares = 0.0;
    for (const Vector3& g : gain) squares += g[k] * g[k];
    worst = std::max(worst, std::sqrt(squares));
  }
  return worst;
}

}  // namespace

bool can_be_told(CriticalSurface surface) {
  return surface != CriticalSurface::line && surface != CriticalSurface::cone;
}

std::string_view critical_surface_name(CriticalSurface surface) {
  switch (surface) {
    case CriticalSurface::none: return "none";
    case CriticalSurface::line: return "line";
    case CriticalSurface::plane: return "plane";
    case CriticalSurface::sphere: return "sphere";
    case CriticalSurface::ellipsoid: return "ellipsoid";
    case CriticalSurface::paraboloid: return "paraboloid";
    case CriticalSurface::hyperboloid: return "hyperboloid";
    case CriticalSurface::cone: return "cone";
    case CriticalSurface::repeated: return "repeated";
  }
  return "";
}

void name_surface(const LinearEstimate& linear, const RefinedSolution& refined, const MatrixNoise& noise,
                  std::span<const LocationPoint> points, StationLocation& location) {
  const auto set = [&](CriticalSurface surface) { location.surface = surface; };
  const double root_n = std::sqrt(static_cast<double>(points.size()));
  const Extents extents = extents_of(points);
  if (extents.off_line_mm <= 3.0 * root_n * noise.point_mm) return set(CriticalSurface::line);
  if (is_cone(refined)) return set(CriticalSurface::cone);
  if (linear.fit.rank == 5) return set(CriticalSurface::none);
  if (different_points(points) < 5) return set(CriticalSurface::repeated);
  if (extents.off_plane_mm <= 3.0 * root_n * noise.point_mm) return set(CriticalSurface::plane);
  if (off_sphere_mm(points) <= 3.0 * root_n * noise.length_mm) return set(CriticalSurface::sphere);
  const auto& v = linear.directions[4];
  const double a = std::hypot(v[0], v[1], v[2]), b = std::abs(v[3]);
  if (!(b > 1e-9 * a)) return set(CriticalSurface::plane);
  const double eccentricity = a / b;
  location.eccentricity = eccentricity;
  // an eccentricity follows from a and b, which noise moves by what the rank leaves open
  const double open = std::max(1e-6, linear.fit.rank_tolerance / linear.fit.singular_values[3]);
  set(std::abs(eccentricity - 1.0) < open ? CriticalSurface::paraboloid
      : eccentricity < 1.0                ? CriticalSurface::ellipsoid
                                          : CriticalSurface::hyperboloid);
}

void add_surface_findings(const LinearEstimate& linear, const RefinedSolution& refined,
                          std::span<const LocationPoint> points, const StationOptions& options,
                          StationLocation& location) {
  std::vector<Finding>& findings = location.findings;
  const LinearFit& fit = linear.fit;
  if (location.surface == CriticalSurface::cone) {
    const Cone cone = cone_of(refined, points);
    const bool flat = cone.half_angle_deg > 89.9;
    findings.push_back(
        {"station-points-on-cone", true,
         fmt::format("{}: eq. 14 has rank {} of 5, the refined rows have the condition {:.1e}, and no estimator "
                     "can tell the station along {}; choose points at different {}",
                     flat ? std::string("the station lies in the plane of all points")
                          : fmt::format("all beams lie on a cone about the station with a half angle of {} deg",
                                        format_fixed(cone.half_angle_deg, 2)),
                     fit.rank, refined.fit.condition, direction_text(cone.axis),
                     flat ? "heights above the station" : "elevations")});
  }
  if (location.surface == CriticalSurface::line)
    findings.push_back(
        {"station-points-on-line", true,
         fmt::format("all points lie on one line along {}: eq. 14 has rank {} of 5, the station may stand anywhere "
                     "on a circle about that line, and no estimator can tell where; choose points off the line",
                     direction_text(extents_of(points).along), fit.rank)});
  if (can_be_told(location.surface) && location.surface != CriticalSurface::none)
    findings.push_back({"station-critical-surface", false,
                        fmt::format("{}: eq. 14 has rank {} of 5 (smallest singular value {:.1e}, below the "
                                    "{:.1e} that noise may produce) and gives no station; the refined one holds",
                                    surface_text(location), fit.rank, fit.singular_values[4], fit.rank_tolerance)});
  if (location.refined.mirror_mm) add_mirror_finding(options, location);
  constexpr double poor = 25.0;  // µm per µm; good layouts have 1 to 4
  if (location.surface == CriticalSurface::none && location.has_linear())
    if (const double worst = largest_amplification(linear.gain); worst > poor)
      findings.push_back({"station-nearly-critical", false,
                          fmt::format("eq. 14 is nearly critical (condition {}): an error of 1 µm in each length "
                                      "moves its station by {} µm; rely on the refined one",
                                      format_fixed(fit.condition, 0), format_fixed(worst, 0))});
  if (can_be_told(location.surface))
    if (const double worst = largest_amplification(refined.gain); worst > poor)
      findings.push_back({"station-badly-known", refined.weakest_u_mm > 1.0,
                          fmt::format("the points tell the station badly along {} (condition {}): an error of 1 µm in "
                                      "each length moves it by {} µm",
                                      direction_text(refined.weakest), format_fixed(refined.fit.condition, 0),
                                      format_fixed(worst, 0))});
}

}  // namespace axiometry::tracking
