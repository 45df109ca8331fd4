// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/multilateration_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "axiometry/base/text/number_text.h"
#include "axiometry/tracking/station/residual_findings.h"

namespace axiometry::tracking::detail {
namespace {

constexpr std::size_t most_listed = 5;

void tell_breaks(const FindingInput& in, std::vector<Finding>& findings) {
  for (const RangeBreak& b : in.fit.breaks)
    findings.push_back(
        {"multilateration-beam-broken", false,
         fmt::format("the lengths of station {} jump by {} mm before reading {} (point {}): taken as a beam "
                     "that was broken, with a dead path of its own from there on",
                     station_name(in.options, b.station), format_fixed(b.jump_mm, 4), b.reading + 1,
                     point_name(in.options, in.readings[b.reading].point))});
}

void tell_outliers(const FindingInput& in, std::vector<Finding>& findings) {
  const auto& values = in.fit.normalised_residuals;
  const double limit = outlier_limit(values);
  std::vector<std::size_t> far;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (std::abs(values[k]) > limit) far.push_back(k);
  if (far.empty()) return;
  std::ranges::sort(far, [&](std::size_t a, std::size_t b) { return std::abs(values[a]) > std::abs(values[b]); });
  std::string which;
  for (std::size_t k = 0; k < std::min(far.size(), most_listed); ++k) {
    const RangeReading& r = in.readings[far[k]];
    which += fmt::format("{}reading {} (station {}, point {}) by {} mm, {:.1f} times its standard uncertainty",
                         k == 0 ? "" : "; ", far[k] + 1, station_name(in.options, r.station),
                         point_name(in.options, r.point), format_fixed(in.fit.residuals_mm[far[k]], 5),
                         std::abs(values[far[k]]));
  }
  findings.push_back({"multilateration-outliers", true,
                      fmt::format("{} reading{} not fit the others: {}{}", far.size(),
                                  far.size() == 1 ? " does" : "s do", which, far.size() > most_listed ? "; …" : "")});
}

void tell_chi_squared(const FindingInput& in, std::vector<Finding>& findings) {
  if (in.fit.degrees_of_freedom == 0) {
    findings.push_back({"multilateration-nothing-checks", true,
                        "there are no more readings than unknowns: nothing checks the result"});
    return;
  }
  for (auto* const find : {chi_squared_finding, few_residuals_finding})
    if (auto finding = find(in.fit.chi_squared, in.fit.degrees_of_freedom)) findings.push_back(*std::move(finding));
}

void tell_geometry(const FindingInput& in, std::vector<Finding>& findings) {
  if (!in.mirrored_stations.empty()) {
    std::vector<std::string> names;
    for (std::size_t j : in.mirrored_stations) names.push_back(station_name(in.options, j));
    findings.push_back(
        {"multilateration-station-side", true,
         fmt::format("the nominal points lie on a plane, and no length tells on which side of it the station{} {} "
                     "stand{}: all were taken on its upper side",
                     names.size() == 1 ? "" : "s", listed(names), names.size() == 1 ? "s" : "")});
  }
  if (in.mirrored)
    findings.push_back({"multilateration-mirror-image", true,
                        "the lengths fit the mirror image of the nominal points: one of their axes points the "
                        "wrong way, or two are exchanged"});
  if (in.points_seen_by_three > 0)
    findings.push_back({"multilateration-points-seen-by-three", false,
                        fmt::format("{} point{} seen by three stations only: nothing checks the readings there",
                                    in.points_seen_by_three, in.points_seen_by_three == 1 ? " is" : "s are")});
  const double bend = std::sqrt(in.sigma_mm * in.distance_mm);
  if (in.fit.rank.weakest_mm > bend)
    findings.push_back(
        {"multilateration-station-badly-known", true,
         fmt::format("station {} has a standard uncertainty of {:.2g} mm along the direction known worst; beyond "
                     "{:.2g} mm distances bend by more than lengths are known, and no covariance can be trusted",
                     station_name(in.options, in.weakest_station), in.fit.rank.weakest_mm, bend)});
}

/// What no residual shows and no covariance holds.
void tell_scale(const FindingInput& in, std::vector<Finding>& findings) {
  if (in.options.scale != ScaleModel::fixed) return;
  findings.push_back({"multilateration-scale-known", false,
                      "the scale of the lengths counts as known: an error that all have in common, as of the "
                      "wavelength in air, changes the size of everything, while uncertainties count lengths that err "
                      "each by itself; a common scale with its prior uncertainty holds it"});
}

}  // namespace

std::string station_name(const MultilaterationOptions& options, std::size_t j) {
  return j < options.station_names.size() ? options.station_names[j] : fmt::format("{}", j + 1);
}
std::string point_name(const MultilaterationOptions& options, std::size_t i) {
  return i < options.point_names.size() ? options.point_names[i] : fmt::format("{}", i + 1);
}

std::string listed(std::span<const std::string> names) {
  const std::size_t shown = std::min(names.size(), most_listed);
  std::string text = fmt::format("{}", fmt::join(names.first(shown), ", "));
  if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

std::vector<Finding> multilateration_findings(const FindingInput& in) {
  std::vector<Finding> findings;
  tell_geometry(in, findings);
  tell_breaks(in, findings);
  tell_outliers(in, findings);
  tell_chi_squared(in, findings);
  tell_scale(in, findings);
  return findings;
}

}  // namespace axiometry::tracking::detail
