// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/station/station_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/tracking/station/residual_findings.h"

namespace axiometry::tracking {
namespace {

constexpr std::size_t most_pairs_from = 5000;

/// In whole µm.
using PlaceUm = std::tuple<long long, long long, long long>;
PlaceUm place_um(Vector3 p) {
  return {std::llround(p.x * 1000.0), std::llround(p.y * 1000.0), std::llround(p.z * 1000.0)};
}

struct OtherReading {
  double factor;
  std::string_view words;
};
constexpr OtherReading other_readings[] = {
    {1e-3, "in µm"},
    {1e3, "in m"},
    {1e-6, "in nm"},
    {1e6, "in km, or the coordinates in nm"},
    {25.4, "in inches"},
    {1 / 25.4, "in mm and the coordinates in inches"},
    {-1.0, "with the other sign: L_0 − L_i"},
};

}  // namespace

double mean(std::span<const double> values) {
  double sum = 0.0;
  for (double x : values) sum += x;
  return sum / static_cast<double>(values.size());
}

double root_mean_square(std::span<const double> values) {
  double squares = 0.0;
  for (double x : values) squares += x * x;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

std::string shown_chi_squared(double x) { return x < 1e4 ? format_fixed(x, 1) : fmt::format("{:.2e}", x); }
std::string shown_mm(double x) { return format_fixed(x, std::abs(x) < 1e6 ? 4 : 0) + " mm"; }

std::string shown_um(double x_mm) {
  const double um = x_mm * 1000.0;
  return format_fixed(um, std::abs(um) < 10.0 ? 2 : std::abs(um) < 1000.0 ? 1 : 0) + " µm";
}

std::string shown_point(Vector3 p) {
  return fmt::format("({}, {}, {}) mm", format_fixed(p.x, 3), format_fixed(p.y, 3), format_fixed(p.z, 3));
}

Result<void> check_points(std::span<const LocationPoint> points, const StationOptions& options) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const LocationPoint& p = points[i];
    for (double x : {p.at_mm.x, p.at_mm.y, p.at_mm.z, p.length_difference_mm})
      if (!(std::abs(x) <= largest_stated))
        return fail(fmt::format("found {} at point {}, expected finite lengths up to 1e9 mm",
                                std::isfinite(x) ? format_exact(x) : "a number that is not finite", i + 1));
  }
  if (options.near_mm && !is_finite(*options.near_mm))
    return fail("found an approximate station that is not finite, expected three numbers in mm");
  const double a = options.ranging.constant.in_mm(), b = options.ranging.per_length.in_um_per_m();
  if (!(a >= 0.0) || !(b >= 0.0) || !(options.machine_sigma_mm >= 0.0) || !std::isfinite(a + b) ||
      !std::isfinite(options.machine_sigma_mm))
    return fail("found an uncertainty of lengths or points that is negative or not finite, expected 0 or more");
  if (a == 0.0 && options.machine_sigma_mm == 0.0)
    return fail(
        "found lengths and points without any uncertainty, expected the constant part of the instrument's U "
        "or the machine's uncertainty above 0: they weigh the lengths");
  if (const std::size_t different = different_points(points); different < 4)
    return fail(
        fmt::format("found {} different point{}, expected 6 or more: the station has 3 coordinates and the "
                    "zero of the lengths is unknown too",
                    different, different == 1 ? "" : "s"));
  return {};
}

std::size_t different_points(std::span<const LocationPoint> points) {
  std::vector<PlaceUm> places;
  for (const LocationPoint& p : points) places.push_back(place_um(p.at_mm));
  std::ranges::sort(places);
  return static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
}

void add_count_findings(std::span<const LocationPoint> points, const StationOptions& options,
                        std::vector<Finding>& findings) {
  const std::size_t different = different_points(points);
  if (different < 6)
    findings.push_back({"station-few-points", different < 5,
                        fmt::format("found {} different points, expected 6 or more: {}", different,
                                    different == 4 ? "nothing checks the station, and eq. 14 cannot be solved"
                                                   : "nothing checks eq. 14, one equation the refined station")});
  std::map<PlaceUm, std::size_t> first;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [found, is_new] = first.emplace(place_um(points[i].at_mm), i);
    if (is_new) continue;
    const std::size_t k = found->second;
    const double gap = points[i].length_difference_mm - points[k].length_difference_mm;
    const double sigma = std::sqrt(2.0) * length_sigma_mm(options, 1000.0);
    const bool serious = std::abs(gap) > absurd_error_mm;
    findings.push_back(
        {"station-repeated-point", serious,
         fmt::format("point {} stands where point {} stood; it is a check of the lengths, not of the station: they "
                     "differ by {}{}",
                     i + 1, k + 1, shown_um(gap),
                     std::abs(gap) <= 4.0 * sigma
                         ? ""
                         : fmt::format(", expected less than {}{}", shown_um(4.0 * sigma),
                                       serious ? "; the beam was broken or the reflector moved" : ""))});
  }
}

Result<void> check_triangles(std::span<const LocationPoint> points, const StationOptions& options,
                             std::vector<Finding>& findings) {
  struct Worst {
    double excess = 0.0;
    std::size_t i = 0, k = 0;
    double gap = 0.0, apart = 0.0;
  } worst, worst_relative;
  const double slack = 0.02 + 6.0 * std::sqrt(2.0) * length_sigma_mm(options, 1000.0);
  constexpr double surely = 1.0 - 1e-9;  // factor for squares: beyond their rounding, far below any slack
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = points.size() > most_pairs_from ? i - std::min<std::size_t>(i, 1) : 0; k < i; ++k) {
      const double gap = std::abs(points[i].length_difference_mm - points[k].length_difference_mm);
      const Vector3 between = points[i].at_mm - points[k].at_mm;
      if (gap * gap < surely * dot(between, between)) continue;  // nearly all pairs end here, without a square root
      const double apart = distance(points[i].at_mm, points[k].at_mm);
      if (gap - apart > worst.excess) worst = {gap - apart, i, k, gap, apart};
      const double beyond = gap - 1.02 * apart - absurd_error_mm;
      if (apart > 0.001 && beyond > worst_relative.excess) worst_relative = {beyond, i, k, gap, apart};
    }
  const auto sentence = [](const Worst& w) {
    return fmt::format(
        "found lengths at points {} and {} that differ by {}, expected at most the distance of the "
        "points, {}",
        w.k + 1, w.i + 1, shown_mm(w.gap), shown_mm(w.apart));
  };
  if (worst_relative.excess > 0.0) {
    const std::string reading = better_reading(points, options, std::numeric_limits<double>::infinity());
    const double ratio = worst_relative.gap / worst_relative.apart;
    std::string hint;
    if (!reading.empty())
      hint = "; the lengths fit when they are read " + reading;
    else if (ratio > 300.0)
      hint = fmt::format("; that is {} times as much: are units mixed up?", format_fixed(ratio, 0));
    else
      hint = "; a length was misread, or the beam was broken between them";
    return fail(sentence(worst_relative) + hint);
  }
  if (worst.apart > 0.001 && worst.excess > slack)
    findings.push_back(
        {"station-impossible-length", true, sentence(worst) + ", and what instrument and machine may err"});
  return {};
}

std::string better_reading(std::span<const LocationPoint> points, const StationOptions& options, double rms_mm) {
  if (different_points(points) < 5 || points.size() > most_pairs_from) return "";
  for (const OtherReading& reading : other_readings) {
    std::vector<LocationPoint> other(points.begin(), points.end());
    for (LocationPoint& p : other) p.length_difference_mm *= reading.factor;
    const LinearEstimate linear = solve_linear(other);
    std::vector<Vector3> first = linear.candidates;
    if (linear.fit.numerical_rank == 5) first.push_back(linear.fit.station_mm);
    // a machine that is wrong by a thousandth does not hide a wrong unit; lengths that are nothing beside the points
    // fit no better by being read smaller still
    double longest = 0.0;
    for (const LocationPoint& p : other) longest = std::max(longest, std::abs(p.length_difference_mm));
    const double fitting_mm = std::min(rms_mm / 100.0, longest / 1000.0);
    // Where all fit so well, some have no more than all of their squares.
    const double chi_squared_most =
        static_cast<double>(other.size()) * std::pow(fitting_mm / length_sigma_mm(options, 0.0), 2);
    const auto minima = refine_from_all(other, options, starts_around(other, first), {}, chi_squared_most);
    if (minima.empty() || !minima.front().converged) continue;
    const RefinedSolution solution = describe(other, options, minima.front());
    if (root_mean_square(solution.fit.residuals_mm) < fitting_mm) return std::string(reading.words);
  }
  return "";
}

double machine_error_mm(const RefinedFit& fit) {
  if (fit.degrees_of_freedom == 0) return 0.0;
  const double ratio = fit.chi_squared / static_cast<double>(fit.degrees_of_freedom);
  return std::sqrt(std::max(0.0, ratio - 1.0)) * root_mean_square(fit.sigma_mm);
}

void add_scatter_findings(const RefinedSolution& solution, std::vector<Finding>& findings) {
  const RefinedFit& fit = solution.fit;
  const std::size_t nu = fit.degrees_of_freedom;
  if (nu == 0) return;
  if (auto few = few_residuals_finding(fit.chi_squared, nu)) findings.push_back(*std::move(few));
  const double misfit = root_mean_square(fit.residuals_mm);
  if (fit.chance < 0.001) {
    const double ratio = fit.chi_squared / static_cast<double>(nu);
    const double machine = machine_error_mm(fit);
    findings.push_back(
        {"station-residuals-large", misfit > absurd_error_mm,
         fmt::format("the residuals ({} root mean square) are {} times what the stated uncertainties explain "
                     "(chi-squared {} with {} degree{} of freedom): errors of the machine's points of {} each would "
                     "explain them; the covariance is that much larger",
                     shown_um(misfit), format_fixed(std::sqrt(ratio), 1), shown_chi_squared(fit.chi_squared), nu,
                     nu == 1 ? "" : "s", shown_um(machine))});
  } else if (1.0 - fit.chance < 0.001) {
    findings.push_back({"station-residuals-small", false,
                        fmt::format("the residuals ({} root mean square) are far smaller than the stated uncertainties "
                                    "(chi-squared {} with {} degree{} of freedom): these are computed data, or the "
                                    "uncertainties are stated too large",
                                    shown_um(misfit), fmt::format("{:.3g}", fit.chi_squared), nu, nu == 1 ? "" : "s")});
  }
}

}  // namespace axiometry::tracking
