// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/station.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/tracking/station/station_checks.h"
#include "axiometry/tracking/station/station_fit.h"
#include "axiometry/tracking/station/station_surface.h"

namespace axiometry::tracking {
namespace {

// Points of a machine tool are not known better than this, whatever is stated: a relation between them that holds to
// less is one by chance.
constexpr double points_known_mm = 0.001;
constexpr double absurd_distance_mm = 100'000.0;  // no tracking instrument reaches so far
constexpr double catalogue_range_mm = 20'000.0;   // of the instrument of the paper (Table 1)
constexpr double harmful_offset_mm = 1.0;         // what the paper calls harmless is less than this

std::vector<Vector3> first_starts(const LinearEstimate& linear, const StationOptions& options) {
  std::vector<Vector3> first;
  if (linear.fit.numerical_rank == 5) first.push_back(linear.fit.station_mm);
  first.insert(first.end(), linear.candidates.begin(), linear.candidates.end());
  if (options.near_mm) first.push_back(*options.near_mm);
  return first;
}

/// Whether the lengths, with the σ stated and what they misfit anyway, tell two minima apart (3 standard deviations).
bool told_apart(const Minimum& best, const Minimum& other, std::size_t count) {
  const double freedom = static_cast<double>(count) - 4.0;
  const double scatter = freedom > 0.0 ? std::max(1.0, best.chi_squared / freedom) : 1.0;
  return other.chi_squared - best.chi_squared > 9.0 * scatter;
}

/// The minimum that is the station, with the other one that fits as well. Of two such the one near the place that was
/// said, else the lower one: the instrument stands on the table and the reflector moves above it. What lies out of
/// reach fits lengths of any paraboloid, and counts only where nothing else does.
struct Choice {
  Minimum station;
  std::optional<Vector3> mirror;
};
Choice choose(const std::vector<Minimum>& minima, std::span<const LocationPoint> points,
              const StationOptions& options) {
  const Minimum& best = minima.front();
  std::vector<Minimum> possible;
  for (const Minimum& m : minima)
    if (distance(m.station_mm, points.front().at_mm) < absurd_distance_mm && (m.converged || &m == &best) &&
        !told_apart(best, m, points.size()))
      possible.push_back(m);
  if (possible.empty()) return {best, std::nullopt};
  if (possible.size() == 1) return {possible.front(), std::nullopt};
  const auto rank = [&](const Minimum& m) {
    return options.near_mm ? distance(m.station_mm, *options.near_mm) : m.station_mm.z;
  };
  const double apart = distance(possible[0].station_mm, possible[1].station_mm);
  const bool decides = options.near_mm || std::abs(rank(possible[1]) - rank(possible[0])) > 0.1 * apart;
  if (decides && rank(possible[1]) < rank(possible[0])) std::swap(possible[0], possible[1]);
  return {possible[0], possible[1].station_mm};
}

void add_uncertainties(const LinearEstimate& linear, const RefinedSolution& refined, StationLocation& location) {
  LinearFit& fit = *location.linear;
  double misclosure = 0.0;
  for (std::size_t i = 0; i < linear.gain.size(); ++i) {
    const double sigma = refined.fit.sigma_mm[i];
    const Vector3 g = sigma * linear.gain[i];
    const Vector3 d = sigma * (refined.gain[i] - linear.gain[i]);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) fit.covariance_mm2[row][k] += g[row] * g[k];
      location.difference_u_mm[row] += d[row] * d[row];
    }
    misclosure += sigma * linear.misclosure_gain[i] * sigma * linear.misclosure_gain[i];
  }
  fit.misclosure_u_mm2 = std::sqrt(misclosure);
  for (std::size_t k = 0; k < 3; ++k) location.difference_u_mm[k] = std::sqrt(location.difference_u_mm[k]);
  location.difference_mm = refined.fit.station_mm - fit.station_mm;
}

/// Leaves of the linear solution what says why there is none.
void forget_station(LinearFit& fit) {
  LinearFit kept;
  kept.rank = fit.rank;
  kept.numerical_rank = fit.numerical_rank;
  kept.rank_tolerance = fit.rank_tolerance;
  kept.condition = fit.condition;
  kept.singular_values = std::move(fit.singular_values);
  fit = std::move(kept);
}

void add_difference_findings(StationLocation& location) {
  const LinearFit& fit = *location.linear;
  const double apart = norm(location.difference_mm);
  double worst = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    if (location.difference_u_mm[k] > 0.0)
      worst = std::max(worst, std::abs(location.difference_mm[k]) / location.difference_u_mm[k]);
  if (worst > 4.0 && apart > 1e-6)
    location.findings.push_back(
        {"station-estimators-apart", apart > harmful_offset_mm,
         fmt::format("the linear and the refined station are {} apart, {} times what the stated uncertainties explain: "
                     "the machine's points or a length are wrong (an error of scale does this); neither is better "
                     "known than this",
                     shown_mm(apart), format_fixed(worst, 1))});
  const double misclosure = std::abs(fit.misclosure_mm2);
  if (fit.misclosure_u_mm2 > 0.0 && misclosure > 4.0 * fit.misclosure_u_mm2 && misclosure > 1e-6)
    location.findings.push_back(
        {"station-misclosure", false,
         fmt::format("ψ of eq. 13 misses |s|² − L0² by {} mm², {} times what the stated uncertainties explain",
                     format_fixed(fit.misclosure_mm2, 4), format_fixed(misclosure / fit.misclosure_u_mm2, 1))});
}

void add_distance_findings(std::span<const double> distances_mm, std::vector<Finding>& findings) {
  const auto [least, most] = std::ranges::minmax(distances_mm);
  if (most > catalogue_range_mm)
    findings.push_back({"station-points-far", true,
                        fmt::format("found points up to {} from the station, expected the range of an instrument "
                                    "(about 20 m): are units mixed up?",
                                    shown_mm(most))});
  if (most < 10.0)
    findings.push_back({"station-points-near", true,
                        fmt::format("found all points within {} of the station, expected the range of an "
                                    "instrument: are units mixed up?",
                                    shown_mm(most))});
  else if (least < 10.0)
    findings.push_back({"station-point-near", true,
                        fmt::format("found a point only {} from the station, expected at least the radius of "
                                    "the instrument",
                                    shown_mm(least))});
}

Result<void> check_reading(std::span<const LocationPoint> points, const StationOptions& options,
                           const RefinedSolution& refined) {
  const double misfit = root_mean_square(refined.fit.residuals_mm);
  const double far = std::ranges::max(refined.distances_mm);
  if (refined.fit.degrees_of_freedom > 0 && misfit > absurd_error_mm)
    if (const std::string reading = better_reading(points, options, misfit); !reading.empty())
      return fail(
          fmt::format("found lengths that misfit the points by {} (root mean square), expected them in mm and "
                      "as L_i - L_0; they fit when they are read {}",
                      shown_mm(misfit), reading));
  if (far > absurd_distance_mm)
    return fail(
        fmt::format("found a station {} m from the points, expected one within 100 m: are units mixed up, or "
                    "are the lengths from another set-up?",
                    format_fixed(far / 1000.0, 1)));
  return {};
}

/// What was said of the station's place need not be exact, but axes or a sign exchanged show in it.
void add_place_finding(const StationOptions& options, const RefinedSolution& refined, std::vector<Finding>& findings) {
  if (!options.near_mm) return;
  const double off = distance(refined.fit.station_mm, *options.near_mm);
  if (off > 0.5 * mean(refined.distances_mm))
    findings.push_back({"station-not-where-said", false,
                        fmt::format("the station is {} mm from where it was said to stand about, {}: are "
                                    "axes, signs or tools of the two those of the points?",
                                    format_fixed(off, 0), shown_point(*options.near_mm))});
}

}  // namespace

bool StationLocation::is_serious() const {
  return std::ranges::any_of(findings, [](const Finding& f) { return f.serious; });
}

Result<StationLocation> locate_station(std::span<const LocationPoint> points, const StationOptions& options) {
  AXIOMETRY_TRY_VOID(check_points(points, options));
  StationLocation location;
  AXIOMETRY_TRY_VOID(check_triangles(points, options, location.findings));

  LinearEstimate linear = solve_linear(points);
  const auto minima = refine_from_all(points, options, starts_around(points, first_starts(linear, options)));
  if (minima.empty()) return fail("found no station near which the lengths fit, expected at least one");
  const Choice choice = choose(minima, points, options);
  const RefinedSolution refined = describe(points, options, choice.station);
  AXIOMETRY_TRY_VOID(check_reading(points, options, refined));

  const MatrixNoise noise{mean(refined.fit.sigma_mm), std::max(options.machine_sigma_mm, points_known_mm)};
  judge_rank(linear, noise);
  name_surface(linear, refined, noise, points, location);
  location.refined = refined.fit;
  if (can_be_told(location.surface)) location.refined.mirror_mm = choice.mirror;
  if (points.size() >= 5) location.linear = linear.fit;
  if (location.has_linear()) add_uncertainties(linear, refined, location);
  if (location.linear && !location.has_linear()) forget_station(*location.linear);

  add_count_findings(points, options, location.findings);
  add_surface_findings(linear, refined, points, options, location);
  add_distance_findings(refined.distances_mm, location.findings);
  add_place_finding(options, refined, location.findings);
  add_misreading_findings(points, options, refined, location.findings);
  add_scatter_findings(refined, location.findings);
  if (location.has_linear()) add_difference_findings(location);
  if (!location.refined.converged && can_be_told(location.surface))
    location.findings.push_back({"station-not-converged", true, "the refinement did not converge"});
  std::ranges::stable_partition(location.findings, [](const Finding& f) { return f.serious; });
  return location;
}

}  // namespace axiometry::tracking
