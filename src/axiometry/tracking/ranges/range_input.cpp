// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/range_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/numeric/median.h"
#include "axiometry/tracking/ranges/multilateration_findings.h"
#include "axiometry/tracking/station/residual_findings.h"

namespace axiometry::tracking::detail {
namespace {

constexpr std::size_t stations_least = 4;
constexpr std::size_t stations_of_point_least = 3;
// Of the stations, whose matrix is dense: 128 MB, and seconds. Eight stations with a break every few minutes have 100.
constexpr std::size_t columns_most = 4000;

/// What weighs the lengths: not negative, finite, and something above 0.
Result<void> check_uncertainties(const MultilaterationOptions& options) {
  const double a = options.ranging.constant.in_mm(), b = options.ranging.per_length.in_um_per_m();
  for (const double u : {a, b, options.repeatability_sigma_mm, options.scale_prior})
    if (!(u >= 0.0) || !std::isfinite(u))
      return fail(
          "found an uncertainty of lengths, points or scale that is negative or not finite, expected 0 or more");
  if (a > 0.0 || b > 0.0 || options.repeatability_sigma_mm > 0.0) return {};
  return fail(
      "found lengths and points without any uncertainty, expected that of the instrument or the machine's "
      "repeatability above 0: they weigh the lengths");
}

Result<void> check_numbers(const RangeInput& in) {
  for (std::size_t i = 0; i < in.nominal_mm.size(); ++i)
    if (!is_finite(in.nominal_mm[i]) || norm(in.nominal_mm[i]) > 1e9)
      return fail(fmt::format("found coordinates of point {} that are no place on a machine, expected numbers in mm",
                              point_name(in.options, i)));
  for (std::size_t k = 0; k < in.readings.size(); ++k) {
    const RangeReading& r = in.readings[k];
    if (r.point >= in.nominal_mm.size() || r.station >= in.stations)
      return fail(fmt::format("found reading {} of point {} from station {}, expected one of {} points and {} stations",
                              k + 1, r.point + 1, r.station + 1, in.nominal_mm.size(), in.stations));
    if (!std::isfinite(r.length_mm) || std::abs(r.length_mm) > 1e9)
      return fail(fmt::format("found the length {} mm in reading {} (station {}, point {}), expected a finite length",
                              r.length_mm, k + 1, station_name(in.options, r.station),
                              point_name(in.options, r.point)));
    if (r.segment >= in.readings.size())
      return fail(
          fmt::format("found segment {} in reading {}, expected fewer segments than readings", r.segment, k + 1));
  }
  return {};
}

std::vector<StationReadings> by_station(const RangeInput& in) {
  std::vector<StationReadings> stations(in.stations);
  for (std::size_t k = 0; k < in.readings.size(); ++k) {
    const RangeReading& r = in.readings[k];
    StationReadings& s = stations[r.station];
    s.nominal_mm.push_back(in.nominal_mm[r.point]);
    s.length_mm.push_back(r.length_mm);
    s.segment.push_back(r.segment);
    s.reading.push_back(k);
    s.point.push_back(r.point);
    s.segments = std::max(s.segments, r.segment + 1);
  }
  return stations;
}

std::string_view unit_advice(const StationReadings& s) {
  double lengths = 0.0, ways = 0.0;
  for (std::size_t k = 1; k < s.length_mm.size(); ++k) {
    if (s.segment[k] != s.segment[k - 1]) continue;
    lengths += std::abs(s.length_mm[k] - s.length_mm[k - 1]);
    ways += distance(s.nominal_mm[k], s.nominal_mm[k - 1]);
  }
  const double ratio = ways > 0.0 ? lengths / ways : 1.0;
  if (ratio > 100.0) return "; are the lengths in µm, or the points in m?";
  if (ratio < 0.01) return "; are the lengths in m, or the points in µm?";
  return "";
}

/// Breaks that no way between points explains. Many of them are no breaks.
Result<std::vector<LengthStep>> broken_triangles(const RangeInput& in, const StationReadings& s, std::size_t j) {
  TriangleCheck check = check_triangles(s);
  if (check.violations.size() > 2 + check.pairs / 10) {
    const auto worst =
        std::ranges::max_element(check.violations, {}, [](const auto& v) { return std::abs(v.jump_mm); });
    const std::size_t k = worst->before;
    std::size_t before = k - 1;
    while (s.segment[before] != s.segment[k]) --before;
    return fail(
        fmt::format("found lengths of station {} that change by more than their points are apart in {} of {} "
                    "places (by {:.3f} mm over {:.3f} mm before reading {}), expected less{}",
                    station_name(in.options, j), check.violations.size(), check.pairs, worst->jump_mm,
                    distance(s.nominal_mm[k], s.nominal_mm[before]), s.reading[k] + 1, unit_advice(s)));
  }
  return std::move(check.violations);
}

double spread_of(const StationReadings& s) {
  Vector3 lowest = s.nominal_mm.front(), highest = lowest;
  for (const Vector3& p : s.nominal_mm)
    for (std::size_t c = 0; c < 3; ++c) {
      lowest[c] = std::min(lowest[c], p[c]);
      highest[c] = std::max(highest[c], p[c]);
    }
  return distance(lowest, highest);
}

Result<StationStart> start_one(const RangeInput& in, StationReadings& s, std::size_t j, bool find_breaks,
                               std::vector<RangeBreak>& breaks) {
  const std::string name = station_name(in.options, j);
  AXIOMETRY_TRY(std::vector<LengthStep> broken, broken_triangles(in, s, j));
  const auto note = [&](const LengthStep& step) { breaks.push_back({j, s.reading[step.before], step.jump_mm}); };
  if (find_breaks)
    for (const LengthStep& step : broken) {
      if (s.length_mm.size() < 4 + s.segments) break;
      note(step);
      restart_segment(s, step.before);
    }
  AXIOMETRY_TRY(StationStart start, start_station(s, name));
  constexpr std::size_t breaks_most = 20;
  for (std::size_t k = 0; find_breaks && k < breaks_most; ++k) {
    const auto step = find_step(s, start);
    if (!step || s.length_mm.size() < 5 + s.segments) break;
    restart_segment(s, step->before);
    AXIOMETRY_TRY(start, start_station(s, name));
    LengthStep settled{settle_restart(s, step->before, start), step->jump_mm};
    AXIOMETRY_TRY(start, start_station(s, name));
    const std::size_t fresh = s.segments - 1;
    std::size_t old = fresh;
    for (std::size_t t = settled.before; t-- > 0 && old == fresh;) old = s.segment[t];
    settled.jump_mm = start.dead_mm[old] - start.dead_mm[fresh];
    note(settled);
  }
  if (start.rms_mm > nominal_misfit_most_mm(spread_of(s)))
    return fail(
        fmt::format("found lengths of station {} that leave {:.3f} mm (root mean square) to the nominal points "
                    "from the place that fits best, expected a few tenths{}",
                    name, start.rms_mm, unit_advice(s)));
  return start;
}

}  // namespace

Result<RangeCounts> check_ranges(const RangeInput& in) {
  if (in.stations < stations_least)
    return fail(fmt::format("found {}, expected at least {}: with fewer no number of points is enough",
                            counted(in.stations, "station"), stations_least));
  if (in.readings.empty()) return fail("found no readings, expected lengths of points from stations");
  if (in.readings.size() > std::numeric_limits<std::uint32_t>::max() / 2)
    return fail(fmt::format("found {} readings, expected fewer than 2 billion", in.readings.size()));
  AXIOMETRY_TRY_VOID(check_uncertainties(in.options));
  AXIOMETRY_TRY_VOID(check_numbers(in));

  std::vector<std::size_t> seen(in.stations, 0), segments(in.stations, 0), stations_of(in.nominal_mm.size(), 0);
  for (const RangeReading& r : in.readings) segments[r.station] = std::max(segments[r.station], r.segment + 1);
  const std::size_t all_segments = std::accumulate(segments.begin(), segments.end(), std::size_t{0});
  if (4 * in.stations + all_segments > columns_most)
    return fail(fmt::format(
        "found {} stations with {} segments and {} points, expected at most {} unknowns of stations (here {}){}",
        in.stations, all_segments, in.nominal_mm.size(), columns_most, 4 * in.stations + all_segments,
        in.stations > in.nominal_mm.size() ? "; are points and stations exchanged?"
        : all_segments > 2 * in.stations   ? "; a segment begins only where the beam was broken"
                                           : ""));
  std::vector<std::vector<bool>> sees(in.stations, std::vector<bool>(in.nominal_mm.size()));
  for (const RangeReading& r : in.readings) {
    ++seen[r.station];
    if (sees[r.station][r.point]) continue;
    sees[r.station][r.point] = true;
    ++stations_of[r.point];
  }
  RangeCounts counts;
  for (std::size_t j = 0; j < in.stations; ++j) {
    if (seen[j] == 0) return fail(fmt::format("found no reading of station {}", station_name(in.options, j)));
    counts.segments += segments[j];
  }
  std::vector<std::string> rare;
  for (std::size_t i = 0; i < stations_of.size(); ++i) {
    if (stations_of[i] < stations_of_point_least) rare.push_back(point_name(in.options, i));
    if (stations_of[i] == stations_of_point_least) ++counts.points_seen_by_three;
  }
  if (!rare.empty())
    return fail(fmt::format(
        "found {} point{} seen by fewer than {} stations ({}), expected {} or more for each: leave "
        "such points out",
        rare.size(), rare.size() == 1 ? "" : "s", stations_of_point_least, listed(rare), stations_of_point_least));
  return counts;
}

Result<void> check_counts(const RangeInput& in, MultilaterationRank& rank, std::size_t segments) {
  const std::size_t n = in.nominal_mm.size();
  const ScaleModel scale = in.options.scale;
  const bool prior = in.options.scale_prior > 0.0;
  const std::size_t scales = scale == ScaleModel::free ? in.stations : scale == ScaleModel::common ? 1 : 0;
  rank.gauge = scale == ScaleModel::fixed || prior ? 6 : 7;
  rank.unknowns = 3 * n + 3 * in.stations + segments + scales - rank.gauge;
  rank.equations = in.readings.size() + (prior ? scales : 0);
  rank.points_least = points_least(in.stations, scale).value_or(0);
  if (rank.equations >= rank.unknowns) return {};
  return fail(
      fmt::format("found {} points from {} stations: {} equations for {} unknowns, expected at least as many; "
                  "{} points are the least for {} stations that see all of them",
                  n, in.stations, rank.equations, rank.unknowns, rank.points_least, in.stations));
}

Result<RangeStarts> start_all(const RangeInput& in, bool find_breaks) {
  std::vector<StationReadings> stations = by_station(in);
  RangeStarts starts;
  starts.segments.resize(in.readings.size());
  for (std::size_t j = 0; j < in.stations; ++j) {
    StationReadings& s = stations[j];
    AXIOMETRY_TRY(const StationStart start, start_one(in, s, j, find_breaks, starts.breaks));
    starts.stations.push_back(start.station_mm);
    starts.dead.push_back(start.dead_mm);
    if (start.mirror_mm) starts.mirrored.push_back(j);
    for (std::size_t k = 0; k < s.reading.size(); ++k) starts.segments[s.reading[k]] = s.segment[k];
  }
  return starts;
}

std::optional<RangeBreak> find_residual_step(const RangeInput& in, std::span<const double> residuals,
                                             std::span<const std::size_t> segments) {
  constexpr std::size_t window_most = 20, window_least = 3;
  // Standard deviations of a difference of means, more than noise alone shows somewhere; a fit decides about what is
  // found.
  const double far = std::max(4.0, 0.5 + std::sqrt(2.0 * std::log(static_cast<double>(residuals.size()))));
  std::vector<std::vector<std::size_t>> readings(in.stations);
  for (std::size_t k = 0; k < in.readings.size(); ++k) readings[in.readings[k].station].push_back(k);
  std::optional<RangeBreak> best;
  double most = far;
  std::vector<double> sizes;
  for (std::size_t j = 0; j < in.stations; ++j) {
    const auto& own = readings[j];
    sizes.clear();
    const std::size_t window = std::min(window_most, own.size() / 4);
    if (window < window_least) continue;
    // From neighbours, whose differences a step leaves alone.
    for (std::size_t k = 1; k < own.size(); ++k)
      sizes.push_back(std::abs(residuals[own[k]] - residuals[own[k - 1]]) / std::sqrt(2.0));
    const double scatter = std::max(numeric::upper_median(sizes) / 0.6745, in.options.ranging.standard_mm(0.0));
    const double unit = scatter * std::sqrt(2.0 / static_cast<double>(window));
    double before = 0.0, after = 0.0;
    for (std::size_t k = 0; k < window; ++k) {
      before += residuals[own[k]];
      after += residuals[own[k + window]];
    }
    for (std::size_t t = window; t + window <= own.size(); ++t) {
      const double jump = (before - after) / static_cast<double>(window);
      const bool within = segments[own[t - window]] == segments[own[t + window - 1]];
      if (within && std::abs(jump) > most * unit) {
        most = std::abs(jump) / unit;
        best = RangeBreak{j, own[t], jump};
      }
      if (t + window == own.size()) break;
      before += residuals[own[t]] - residuals[own[t - window]];
      after += residuals[own[t + window]] - residuals[own[t]];
    }
  }
  return best;
}

}  // namespace axiometry::tracking::detail
