// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/curve_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace axiometry::volumetric::detail {
namespace {

constexpr double end_share = 0.05;
constexpr std::size_t readings_in_span = 10;
constexpr std::size_t functions_least = 3;  // straightness loses two to the gauge
constexpr std::array<std::size_t, 14> spline_sizes = {1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 26, 32, 40};

std::size_t functions_of(CurveKind kind, std::size_t size) { return kind == CurveKind::spline ? size + 3 : size + 1; }

/// Every window of so many spans as a function is wide holds at least so many readings as it has spans left to tell.
bool carries(const CurveDomain& domain, std::size_t spans, std::span<const double> positions) {
  std::vector<std::size_t> counts(spans, 0);
  for (const double q : positions) {
    const double along = (q - domain.lower_mm) / (domain.upper_mm - domain.lower_mm) * static_cast<double>(spans);
    ++counts[static_cast<std::size_t>(std::clamp(std::floor(along), 0.0, static_cast<double>(spans) - 1.0))];
  }
  return std::ranges::min(counts) >= readings_in_span;
}

}  // namespace

std::array<CurveDomain, axis_count> curve_domains(const TravelBox& travel, const TravelBox& observed) {
  std::array<CurveDomain, axis_count> domains;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const double room = end_share * (travel.highest_mm[a] - travel.lowest_mm[a]);
    const bool low = observed.lowest_mm[a] - travel.lowest_mm[a] <= room;
    const bool high = travel.highest_mm[a] - observed.highest_mm[a] <= room;
    domains[a] = {low ? travel.lowest_mm[a] : observed.lowest_mm[a],
                  high ? travel.highest_mm[a] : observed.highest_mm[a], low && high};
  }
  return domains;
}

std::size_t different_places(std::vector<double> positions, std::size_t enough) {
  const std::size_t some = 16 * enough;
  if (positions.size() > 2 * some) {
    std::vector<double> few;
    for (std::size_t k = 0; k < some; ++k) few.push_back(positions[k * positions.size() / some]);
    if (different_places(std::move(few), enough) == enough) return enough;
  }
  std::ranges::sort(positions);
  constexpr double apart_mm = 0.01;
  std::size_t count = 0;
  double last = -std::numeric_limits<double>::infinity();
  for (const double q : positions) {
    if (q - last < apart_mm) continue;
    ++count;
    last = q;
  }
  return std::min(count, enough);
}

std::vector<std::size_t> supported_sizes(CurveKind kind, const CurveDomain& domain, std::vector<double> positions) {
  const std::size_t enough = places_for_function * (spline_sizes.back() + 3);
  const std::size_t places = different_places(positions, enough);
  std::vector<std::size_t> sizes, interpolating;
  const auto take = [&](std::size_t size) {
    const std::size_t functions = functions_of(kind, size);
    if (functions < functions_least || functions > places) return;
    if (kind != CurveKind::legendre && !carries(domain, size, positions)) return;
    (places_for_function * functions <= places ? sizes : interpolating).push_back(size);
  };
  if (kind == CurveKind::legendre)
    for (std::size_t degree = 1; degree <= 12; ++degree) take(degree);
  else
    for (const std::size_t size : spline_sizes) take(size);
  if (sizes.empty() && !interpolating.empty()) return {interpolating.front()};
  return sizes;
}

Sizes chosen_sizes(const std::array<std::vector<std::size_t>, axis_count>& supported, const Criterion& criterion) {
  std::map<Sizes, std::optional<double>> known;
  const auto value = [&](const Sizes& sizes) {
    const auto [at, is_new] = known.try_emplace(sizes);
    if (is_new) at->second = criterion(sizes);
    return at->second.value_or(std::numeric_limits<double>::infinity());
  };
  const auto nth = [&](std::size_t axis, std::size_t k) {
    return supported[axis][std::min(k, supported[axis].size() - 1)];
  };
  std::size_t longest = 0;
  for (const auto& sizes : supported) longest = std::max(longest, sizes.size());
  Sizes best{nth(0, 0), nth(1, 0), nth(2, 0)};
  std::size_t worse = 0;
  for (std::size_t k = 1; k < longest && worse < 3; ++k) {
    const Sizes next{nth(0, k), nth(1, k), nth(2, k)};
    worse = value(next) < value(best) ? 0 : worse + 1;
    if (worse == 0) best = next;
  }
  for (bool gains = true; gains;) {
    gains = false;
    for (std::size_t a = 0; a < axis_count; ++a)
      for (const int step : {-1, 1, 2}) {
        const auto at = std::ranges::find(supported[a], best[a]) - supported[a].begin() + step;
        if (at < 0 || at >= static_cast<std::ptrdiff_t>(supported[a].size())) continue;
        Sizes next = best;
        next[a] = supported[a][static_cast<std::size_t>(at)];
        if (!(value(next) < value(best))) continue;
        best = next;
        gains = true;
      }
  }
  return best;
}

std::optional<double> akaike(double chi_squared, std::size_t readings, std::size_t unknowns) {
  if (readings < unknowns + 2) return std::nullopt;
  const double n = static_cast<double>(readings), k = static_cast<double>(unknowns);
  const double floor = 1e-20 * n;  // exact data: then the fewest unknowns win
  return n * std::log(std::max(chi_squared, floor) / n) + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0);
}

}  // namespace axiometry::volumetric::detail
