// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/station_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/text.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/numeric/median.h"
#include "axiometry/numeric/side_by_side.h"
#include "axiometry/tracking/station/station_fit.h"

namespace axiometry::volumetric::detail {
namespace {

using tracking::Minimum;

constexpr std::size_t readings_least = 5;
constexpr std::size_t sights_most = 1000;
constexpr std::size_t points_most = 200;  // enough to find a place; all readings refine it
constexpr double usual_error_mm = 0.03;   // error of a machine before it is calibrated
constexpr double huber = 1.5;             // limit of Huber's weights, in standard deviations
constexpr double no_machine_errs_mm = 1.0;
constexpr double usual_misfit_mm = 0.1;  // largest misfit where the units are right

struct Sight {
  Vector3 reflector_mm;
  double length_mm = 0.0;
  std::size_t stretch = 0;
};

std::vector<LocationPoint> points_of(std::span<const Sight> sights, std::size_t stretch) {
  std::vector<LocationPoint> points;
  for (const Sight& s : sights)
    if (s.stretch == stretch) points.push_back({s.reflector_mm, s.length_mm});
  if (points.size() <= points_most) return points;
  std::vector<LocationPoint> some;
  for (std::size_t k = 0; k < points_most; ++k) some.push_back(points[k * points.size() / points_most]);
  return some;
}

/// The places that fit, the best first; those that fit as well are its mirror images.
std::vector<Vector3> places(std::span<const LocationPoint> points) {
  tracking::StationOptions options;
  options.machine_sigma_mm = usual_error_mm;
  const tracking::LinearEstimate linear = tracking::solve_linear(points);
  std::vector<Vector3> starts = linear.candidates;
  if (linear.fit.numerical_rank == 5) starts.insert(starts.begin(), linear.fit.station_mm);
  std::vector<Minimum> minima;
  if (linear.fit.numerical_rank == 5 && linear.fit.condition < 1e5)
    minima.push_back(tracking::refine(points, options, starts.front()));
  if (minima.empty() || !minima.front().converged)
    minima = tracking::refine_from_all(points, options, tracking::starts_around(points, starts));
  std::vector<Vector3> found;
  for (const Minimum& m : minima)
    if (m.converged && m.chi_squared <= 4.0 * minima.front().chi_squared + 1e-6 * static_cast<double>(points.size()))
      found.push_back(m.station_mm);
  return found;
}

bool fit_reversed(std::vector<LocationPoint> points) {
  for (LocationPoint& p : points) p.length_difference_mm = -p.length_difference_mm;
  return !places(points).empty();
}

/// Median of the residuals' sizes beside their median: what a few wrong lengths do not move.
double misfit_mm(std::span<const LocationPoint> points, Vector3 station) {
  std::vector<double> residuals;
  for (const LocationPoint& p : points) residuals.push_back(distance(p.at_mm, station) - p.length_difference_mm);
  const double middle = numeric::median(residuals);
  for (double& r : residuals) r = std::abs(r - middle);
  return numeric::median(std::move(residuals));
}

double least_misfit_mm(std::span<const LocationPoint> points, std::span<const Vector3> places) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector3& place : places) least = std::min(least, misfit_mm(points, place));
  return least;
}

/// What the lengths fit when it is read in another unit.
struct MistakenUnit {
  double lengths_factor = 1.0;  ///< by which lengths would have to be larger beside the positions
  std::string_view what, unit;
};
constexpr std::array mistaken_units = {MistakenUnit{25.4, "lengths", "inches"},
                                       MistakenUnit{1.0 / 25.4, "positions and tools", "inches"},
                                       MistakenUnit{1e3, "lengths", "m"}, MistakenUnit{1e-3, "lengths", "µm"}};

/// Whether lengths, or else positions, are in another unit than the mm as which they are read.
std::optional<MistakenUnit> mistaken_unit(const std::vector<LocationPoint>& points, double misfit) {
  constexpr double clearly = 0.01;
  if (misfit < no_machine_errs_mm) return std::nullopt;
  for (const MistakenUnit& unit : mistaken_units) {
    std::vector<LocationPoint> other = points;
    for (LocationPoint& p : other) p.length_difference_mm *= unit.lengths_factor;
    if (least_misfit_mm(other, places(other)) < std::min(clearly * misfit, usual_misfit_mm)) return unit;
  }
  return std::nullopt;
}

/// Of one virtual station: its place and the dead paths of its stretches, by least squares that heed outliers less.
class Refinement {
 public:
  Refinement(std::span<const Sight> sights, std::size_t stretches) : sights_(sights), paths_(stretches, 0.0) {}

  Vector3 from(Vector3 s) {
    std::vector<double> weights(sights_.size(), 1.0);
    for (int iteration = 0; iteration < 30; ++iteration) {
      const std::vector<double> residuals = residuals_at(s, weights);
      weights = weights_of(residuals);
      const Vector3 move = step(s, weights);
      s += move;
      if (norm(move) < 1e-7) break;
    }
    residuals_at(s, weights);
    return s;
  }
  double dead_path_mm(std::size_t stretch) const { return paths_[stretch]; }

 private:
  /// Sets the dead paths: weighted means.
  std::vector<double> residuals_at(Vector3 s, std::span<const double> weights) {
    std::vector<double> sums(paths_.size(), 0.0), counts(paths_.size(), 0.0), residuals;
    for (std::size_t i = 0; i < sights_.size(); ++i) {
      sums[sights_[i].stretch] += weights[i] * (distance(sights_[i].reflector_mm, s) - sights_[i].length_mm);
      counts[sights_[i].stretch] += weights[i];
    }
    for (std::size_t k = 0; k < paths_.size(); ++k) paths_[k] = counts[k] > 0.0 ? sums[k] / counts[k] : 0.0;
    for (const Sight& sight : sights_)
      residuals.push_back(sight.length_mm - distance(sight.reflector_mm, s) + paths_[sight.stretch]);
    return residuals;
  }

  static std::vector<double> weights_of(std::span<const double> residuals) {
    std::vector<double> sizes, weights;
    for (const double r : residuals) sizes.push_back(std::abs(r));
    const double limit = huber * std::max(1.4826 * numeric::median(sizes), usual_error_mm);
    for (const double r : residuals) weights.push_back(std::abs(r) <= limit ? 1.0 : limit / std::abs(r));
    return weights;
  }

  /// Dead paths are eliminated: rows and residuals less the means of their stretch.
  Vector3 step(Vector3 s, std::span<const double> weights) const {
    std::vector<Eigen::Vector4d> means(paths_.size(), Eigen::Vector4d::Zero());
    std::vector<double> counts(paths_.size(), 0.0);
    const auto row_of = [&](const Sight& sight) {
      const Vector3 u = unit(sight.reflector_mm - s);
      return Eigen::Vector4d(-u.x, -u.y, -u.z,
                             sight.length_mm - distance(sight.reflector_mm, s) + paths_[sight.stretch]);
    };
    for (std::size_t i = 0; i < sights_.size(); ++i) {
      means[sights_[i].stretch] += weights[i] * row_of(sights_[i]);
      counts[sights_[i].stretch] += weights[i];
    }
    for (std::size_t k = 0; k < means.size(); ++k)
      if (counts[k] > 0.0) means[k] /= counts[k];
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (std::size_t i = 0; i < sights_.size(); ++i) {
      const Eigen::Vector4d a = row_of(sights_[i]) - means[sights_[i].stretch];
      sum += weights[i] * a * a.transpose();
    }
    const Eigen::Matrix3d normal = sum.topLeftCorner<3, 3>();
    const Eigen::Vector3d gradient = sum.topRightCorner<3, 1>();
    const Eigen::Vector3d move = normal.ldlt().solve(gradient);
    return move.allFinite() ? Vector3{move[0], move[1], move[2]} : Vector3{};
  }

  std::span<const Sight> sights_;
  std::vector<double> paths_;
};

/// At most so many of each stretch, evenly: a start needs no more.
std::vector<Sight> thinned(const std::vector<Sight>& sights, std::size_t stretches) {
  std::vector<std::size_t> counts(stretches, 0), seen(stretches, 0);
  for (const Sight& sight : sights) ++counts[sight.stretch];
  std::vector<Sight> some;
  for (const Sight& sight : sights) {
    const std::size_t step = (counts[sight.stretch] + sights_most - 1) / sights_most;
    if (seen[sight.stretch]++ % step == 0) some.push_back(sight);
  }
  return some;
}

std::optional<Vector3> stated_place(const MachineModel& machine, std::string_view station) {
  for (const NamedStation& s : machine.stations)
    if (s.name == station) return s.at_mm;
  return std::nullopt;
}

/// The nearer one to where it is said to stand, else the lowest: an instrument stands on the table.
Vector3 chosen(std::span<const Vector3> places, std::optional<Vector3> stated) {
  const auto before = [&](Vector3 a, Vector3 b) {
    return stated ? distance(a, *stated) < distance(b, *stated) : a.z < b.z;
  };
  return *std::ranges::min_element(places, before);
}

/// Of one virtual station.
struct Start {
  Vector3 station_mm;
  std::vector<double> dead_paths_mm;  ///< dead paths of its stretches
};

struct StartNames {
  const std::string& station;
  const std::string& tool;
};

/// `longest` is the stretch with the most sights.
Result<Start> start_of(const std::vector<Sight>& sights, std::size_t stretches, std::size_t longest,
                       const StartNames& names, std::optional<Vector3> stated) {
  const auto of_station = [&] {
    return fmt::format("of station {} with tool {}", text::quoted(names.station), text::quoted(names.tool));
  };
  const std::vector<LocationPoint> points = points_of(sights, longest);
  if (points.size() < readings_least)
    return fail(
        fmt::format("found at most {} {} between breaks of the beam, expected at least {}, to find where it stands",
                    counted(points.size(), "length"), of_station(), readings_least));
  const std::vector<Vector3> found = places(points);
  if (const auto mistaken = mistaken_unit(points, least_misfit_mm(points, found)))
    return fail(
        fmt::format("found lengths {} that fit when the {} are read as {}, expected all numbers in mm, or their "
                    "unit in the head",
                    of_station(), mistaken->what, mistaken->unit));
  if (found.empty() && fit_reversed(points))
    return fail(fmt::format(
        "found lengths {} that fit with the other sign, expected lengths that grow with the distance", of_station()));
  if (found.empty())
    return fail(
        fmt::format("found no place for station {} from its lengths with tool {}, expected points that spread in three "
                    "directions and lengths in their unit",
                    text::quoted(names.station), text::quoted(names.tool)));
  const std::vector<Sight> some = thinned(sights, stretches);
  Refinement refinement(some, stretches);
  Start start{refinement.from(chosen(found, stated)), {}};
  for (std::size_t k = 0; k < stretches; ++k) start.dead_paths_mm.push_back(refinement.dead_path_mm(k));
  return start;
}

}  // namespace

Result<State> start_state(const Problem& problem, const VolumetricLengths& names) {
  const Unknowns& unknowns = problem.unknowns;
  State state;
  state.coefficients.assign(unknowns.coefficients, 0.0);
  state.stations_mm.resize(unknowns.stations.size());
  state.dead_paths_mm.resize(unknowns.stretches.size());
  state.drifts_um.assign(unknowns.stretches.size(), 0.0);
  std::vector<std::vector<std::size_t>> stretches(unknowns.stations.size());
  std::vector<std::size_t> place_of(unknowns.stretches.size());
  for (std::size_t k = 0; k < unknowns.stretches.size(); ++k) {
    auto& own = stretches[unknowns.stretches[k].virtual_station];
    place_of[k] = own.size();
    own.push_back(k);
  }
  std::vector<std::vector<Sight>> sights(unknowns.stations.size());
  for (std::size_t i = 0; i < problem.readings.size(); ++i) {
    const std::size_t stretch = unknowns.stretch_of[i];
    sights[unknowns.stretches[stretch].virtual_station].push_back(
        {problem.readings[i].axes_mm + problem.tool_mm(i), problem.readings[i].length_mm, place_of[stretch]});
  }
  std::vector<Result<Start>> starts(unknowns.stations.size(), Start{});
  numeric::side_by_side(starts.size(), problem.threads, [&](std::size_t v) {
    const std::string& station = names.stations[unknowns.stations[v].station];
    const std::size_t longest =
        *std::ranges::max_element(stretches[v], {}, [&](std::size_t k) { return unknowns.stretches[k].readings; });
    starts[v] = start_of(sights[v], stretches[v].size(), place_of[longest],
                         {station, names.tools[unknowns.stations[v].tool]}, stated_place(problem.machine, station));
  });
  for (std::size_t v = 0; v < starts.size(); ++v) {
    AXIOMETRY_TRY(const Start start, std::move(starts[v]));
    state.stations_mm[v] = start.station_mm;
    for (const std::size_t k : stretches[v]) state.dead_paths_mm[k] = start.dead_paths_mm[place_of[k]];
  }
  return state;
}

}  // namespace axiometry::volumetric::detail
