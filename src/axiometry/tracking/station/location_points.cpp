// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/location_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/geometry/machine_axes.h"
#include "axiometry/tracking/geometry/visibility.h"
#include "axiometry/tracking/station/station_fit.h"

namespace axiometry::tracking {
namespace {

constexpr std::size_t least_count = 6, most_count = 50;

/// Small is good: the logarithm of the largest amplification, and a quarter of that of the condition of eq. 14, so that
/// a design that is twice as good may cost a condition sixteen times as large, and no critical surface is chosen.
double badness(std::span<const Vector3> points, Vector3 station) {
  Eigen::Matrix4d rows = Eigen::Matrix4d::Zero();
  Vector3 centre;
  double length_centre = 0.0;
  const double n = static_cast<double>(points.size());
  for (Vector3 p : points) {
    centre += 1.0 / n * p;
    length_centre += distance(p, station) / n;
  }
  double squares = 0.0;
  for (Vector3 p : points) squares += dot(p - centre, p - centre);
  const double scale = std::sqrt(squares / n);
  if (!(scale > 0.0)) return std::numeric_limits<double>::infinity();
  Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
  for (Vector3 p : points) {
    const double length = distance(p, station);
    const Vector3 u = 1.0 / length * (p - station), q = 2.0 / scale * (p - centre);
    const Eigen::Vector4d row(u.x, u.y, u.z, 1.0);
    rows.noalias() += row * row.transpose();
    Eigen::Matrix<double, 5, 1> wide;
    wide << q.x, q.y, q.z, 2.0 / scale * (length - length_centre), -1.0;
    matrix.noalias() += wide * wide.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> refined(rows);
  const Eigen::VectorXd values = refined.eigenvalues().cwiseMax(epsilon * refined.eigenvalues()[3]);
  double worst = 0.0;
  for (Eigen::Index k = 0; k < 3; ++k)
    worst = std::max(worst, refined.eigenvectors().row(k).cwiseAbs2().dot(values.cwiseInverse()));
  const Eigen::VectorXd linear =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  const double condition = linear[4] / std::max(linear[0], epsilon * linear[4]);  // squared, as `worst` is
  return 0.5 * std::log(worst) + 0.125 * std::log(condition);
}

struct Candidates {
  std::vector<Vector3> points;
  std::string what_took_most;  ///< a reason with the numbers of one case
  std::size_t taken = 0;
};

/// The kind of a reason: its words without the numbers.
std::string kind_of(std::string_view reason) {
  std::string kind;
  for (char c : reason)
    if (!(c >= '0' && c <= '9') && c != '.' && c != '-') kind += c;
  return kind;
}

/// A grid over the travels, 2 % of each left free at its ends.
Candidates candidates_of(const TrackingSetup& setup, int steps) {
  Candidates result;
  std::map<std::string, std::pair<std::size_t, std::string>> reasons;
  const Vector3 low = setup.travel.lowest_mm, high = setup.travel.highest_mm;
  const auto place = [&](std::size_t axis, int step) {
    if (low[axis] == high[axis]) return low[axis];
    const double margin = 0.02;
    return low[axis] + (high[axis] - low[axis]) * (margin + (1.0 - 2.0 * margin) * step / (steps - 1));
  };
  const auto last = [&](std::size_t axis) { return low[axis] == high[axis] ? 1 : steps; };
  for (int i = 0; i < last(0); ++i)
    for (int j = 0; j < last(1); ++j)
      for (int k = 0; k < last(2); ++k) {
        Vector3 p = Vector3{place(0, i), place(1, j), place(2, k)} + setup.tool_offset_mm;
        p = {rounded_to_um(p.x), rounded_to_um(p.y), rounded_to_um(p.z)};
        auto reason = hidden_because(setup, p);
        if (!reason) reason = blocked_because(setup, p, p);
        if (!reason) {
          result.points.push_back(p);
          continue;
        }
        ++result.taken;
        auto& [count, example] = reasons[kind_of(*reason)];
        if (count++ == 0) example = *reason;
      }
  std::size_t most = 0;
  for (const auto& [kind, reason] : reasons)
    if (reason.first > most) {
      most = reason.first;
      result.what_took_most = fmt::format("{} are out of question as one is: {}", reason.first, reason.second);
    }
  return result;
}

/// `count` candidates far from each other, from the given one on.
std::vector<std::size_t> spread(const std::vector<Vector3>& candidates, std::size_t count, std::size_t first) {
  std::vector<std::size_t> chosen{first};
  std::vector<double> nearest(candidates.size(), std::numeric_limits<double>::infinity());
  while (chosen.size() < count) {
    for (std::size_t i = 0; i < candidates.size(); ++i)
      nearest[i] = std::min(nearest[i], distance(candidates[i], candidates[chosen.back()]));
    chosen.push_back(static_cast<std::size_t>(std::ranges::max_element(nearest) - nearest.begin()));
  }
  return chosen;
}

struct Design {
  std::vector<Vector3> points;
  double badness = std::numeric_limits<double>::infinity();
};

/// Exchanges one point after the other for the best candidate, until nothing gets better.
Design exchanged(const std::vector<Vector3>& candidates, const std::vector<std::size_t>& first, Vector3 station) {
  Design design;
  for (std::size_t i : first) design.points.push_back(candidates[i]);
  design.badness = badness(design.points, station);
  for (int pass = 0; pass < 10; ++pass) {
    const double before = design.badness;
    for (std::size_t k = 0; k < design.points.size(); ++k) {
      std::vector<Vector3> trial = design.points;
      for (Vector3 candidate : candidates) {
        if (std::ranges::find(design.points, candidate) != design.points.end()) continue;
        trial[k] = candidate;
        const double found = badness(trial, station);
        if (found < design.badness - 1e-9) {
          design.badness = found;
          design.points = trial;
        }
      }
    }
    if (!(design.badness < before - 1e-3)) break;
  }
  return design;
}

/// What the way costs: its length, and far more when it is barred or the beam is lost on it.
double cost(const TrackingSetup& setup, Vector3 a, Vector3 b) {
  const bool good = !blocked_because(setup, a, b) && !beam_lost_because(setup, a, b);
  return distance(a, b) + (good ? 0.0 : 1e6);
}

/// Nearest neighbour from each point, improved by turning parts of the way round.
std::vector<Vector3> ordered(const TrackingSetup& setup, const std::vector<Vector3>& points) {
  const std::size_t n = points.size();
  std::vector<double> costs(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < i; ++k) costs[i * n + k] = costs[k * n + i] = cost(setup, points[i], points[k]);
  const auto total = [&](const std::vector<std::size_t>& way) {
    double sum = 0.0;
    for (std::size_t i = 1; i < n; ++i) sum += costs[way[i - 1] * n + way[i]];
    return sum;
  };
  std::vector<std::size_t> best;
  for (std::size_t first = 0; first < n; ++first) {
    std::vector<std::size_t> way{first};
    while (way.size() < n) {
      std::size_t next = n;
      for (std::size_t i = 0; i < n; ++i)
        if (std::ranges::find(way, i) == way.end() &&
            (next == n || costs[way.back() * n + i] < costs[way.back() * n + next]))
          next = i;
      way.push_back(next);
    }
    for (bool better = true; better;) {
      better = false;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 1; k < n; ++k) {
          std::vector<std::size_t> turned = way;
          std::reverse(turned.begin() + static_cast<std::ptrdiff_t>(i),
                       turned.begin() + static_cast<std::ptrdiff_t>(k) + 1);
          if (total(turned) < total(way) - 1e-9) {
            way = std::move(turned);
            better = true;
          }
        }
    }
    if (best.empty() || total(way) < total(best) - 1e-9) best = way;
  }
  std::vector<Vector3> result;
  for (std::size_t i : best) result.push_back(points[i]);
  return result;
}

void add_remarks(const TrackingSetup& setup, LocationPlan& plan) {
  for (std::size_t i = 1; i < plan.points_mm.size(); ++i) {
    const Vector3 a = plan.points_mm[i - 1], b = plan.points_mm[i];
    auto reason = blocked_because(setup, a, b);
    if (!reason) reason = beam_lost_because(setup, a, b);
    if (reason)
      plan.remarks.push_back(
          fmt::format("the straight way from point {} to {} is no good ({}): drive around it, with the beam in sight",
                      i, i + 1, *reason));
  }
  const Vector3 gain = plan.quality.amplification;
  const double worst = std::max({gain.x, gain.y, gain.z});
  if (worst > 10.0)
    plan.remarks.push_back(
        fmt::format("an error of 1 µm in each length moves the station by {} µm: give the points "
                    "more room, or move the station",
                    format_fixed(worst, 0)));
  if (plan.quality.condition_linear > 1e5)
    plan.remarks.push_back(
        "all points lie on a critical surface of eq. 14: only the refined station can be had, and "
        "its mirror image must be told apart");
}

}  // namespace

LocationQuality location_quality(std::span<const Vector3> points_mm, Vector3 station_mm,
                                 const RangingUncertainty& ranging) {
  AXIOMETRY_CONTRACT(points_mm.size() >= 4);
  std::vector<LocationPoint> points;
  for (Vector3 p : points_mm) points.push_back({p, distance(p, station_mm)});
  Minimum truth;
  truth.station_mm = station_mm;
  StationOptions options;
  options.ranging = ranging;
  const RefinedSolution refined = describe(points, options, truth);
  LocationQuality quality;
  quality.covariance_mm2 = refined.fit.covariance_stated_mm2;
  quality.condition_refined = refined.fit.condition;
  quality.condition_linear = points.size() < 5 ? 1.0 / epsilon : solve_linear(points).fit.condition;
  options.ranging = {Length::mm(2.0), RelativeLength::um_per_m(0.0)};  // σ = 1 mm for all
  const RefinedSolution alike = describe(points, options, truth);
  for (std::size_t k = 0; k < 3; ++k) quality.amplification[k] = std::sqrt(alike.fit.covariance_stated_mm2[k][k]);
  return quality;
}

Result<LocationPlan> plan_location(const TrackingSetup& setup, std::size_t count) {
  if (count < least_count || count > most_count)
    return fail(
        fmt::format("found {} points for the station location, expected {} to {}", count, least_count, most_count));
  for (std::size_t k = 0; k < 3; ++k)
    if (!(setup.travel.lowest_mm[k] <= setup.travel.highest_mm[k]) || !std::isfinite(setup.travel.lowest_mm[k]) ||
        !std::isfinite(setup.travel.highest_mm[k]))
      return fail(fmt::format("found the travel {} to {} mm of {}, expected its lower end first",
                              format_exact(setup.travel.lowest_mm[k]), format_exact(setup.travel.highest_mm[k]),
                              "XYZ"[k]));
  if (!is_finite(setup.station.position_mm)) return fail("found a station that is not finite, expected numbers in mm");
  Candidates candidates = candidates_of(setup, 6);
  if (candidates.points.size() < 2 * count) candidates = candidates_of(setup, 13);  // a finer grid for narrow places
  if (candidates.points.size() < count)
    return fail(fmt::format(
        "found {} of {} places over the travels that can be reached and seen, expected {} or more; "
        "{}",
        candidates.points.size(), candidates.points.size() + candidates.taken, count, candidates.what_took_most));
  const std::size_t n = candidates.points.size();
  Design best;
  for (std::size_t first : {std::size_t{0}, n / 2, n - 1}) {
    const Design design =
        exchanged(candidates.points, spread(candidates.points, count, first), setup.station.position_mm);
    if (design.badness < best.badness - 1e-9) best = design;
  }
  if (best.points.empty()) return fail("found no points that tell the station, expected travels in three directions");
  LocationPlan plan;
  plan.points_mm = ordered(setup, best.points);
  plan.quality = location_quality(plan.points_mm, setup.station.position_mm, setup.ranging);
  if (plan.quality.condition_refined > 1e6)
    return fail(
        fmt::format("found no choice of {} points that tells the station (best condition {:.1e}), expected "
                    "travels that are no plane through the station",
                    count, plan.quality.condition_refined));
  add_remarks(setup, plan);
  return plan;
}

}  // namespace axiometry::tracking
