// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/periodic/periodic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/base/counted.h"
#include "axiometry/model/plan.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"
#include "axiometry/numeric/harmonic_fit.h"
#include "axiometry/numeric/series/period_search.h"
#include "axiometry/standards/iso230_2/periodic/enlarged_uncertainties.h"
#include "axiometry/standards/iso230_2/periodic/findings.h"
#include "axiometry/standards/iso230_2/periodic/run_means.h"

namespace axiometry::iso230_2 {
namespace {

using numeric::HarmonicFit;
using numeric::PeriodBand;
using numeric::PeriodSearch;

constexpr std::size_t most_harmonics = 4;
constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double deg = 180.0 / std::numbers::pi;
// At twice the spacing equal steps show a cosine and no sine.
constexpr double shortest_spacings = 2.1;
constexpr double most_steps = 1e11;

std::string_view unit_of(const Test& test) { return position_unit(test.metadata.axis.kind); }

Result<void> check_options(const PeriodicOptions& options, std::string_view unit) {
  const auto check = [&](const std::optional<Position>& x, std::string_view what) -> Result<void> {
    if (!x || (x->in_native() > 0.0 && x->in_native() <= 1e9)) return {};
    return fail(
        fmt::format("found the {} {:g} {}, expected one above 0 and at most 1e9 {}", what, x->in_native(), unit, unit));
  };
  AXIOMETRY_TRY_VOID(check(options.period, "period"));
  AXIOMETRY_TRY_VOID(check(options.shortest, "shortest period"));
  AXIOMETRY_TRY_VOID(check(options.longest, "longest period"));
  if (options.period && (options.shortest || options.longest))
    return fail("found a known period and a band to search, expected one of them");
  return {};
}

/// What is searched; for a known period what the spectrum shows.
Result<PeriodBand> band_of(const RunMeans& means, const PeriodicOptions& options, std::string_view unit) {
  PeriodBand band{shortest_spacings * means.spacing(), means.travel() / 2.0};
  if (options.shortest) band.shortest = options.shortest->in_native();
  if (options.longest) band.longest = options.longest->in_native();
  if (options.period) {
    band.shortest = std::min(band.shortest, options.period->in_native() / 1.5);
    band.longest = std::max(band.longest, options.period->in_native() * 1.5);
  }
  if (!(band.shortest < band.longest))
    return fail(
        fmt::format("found a band of periods from {:.6g} {} to {:.6g} {}, expected the shortest below the "
                    "longest (the mean spacing of the targets is {:.6g} {}, the measured travel {:.6g} {})",
                    band.shortest, unit, band.longest, unit, means.spacing(), unit, means.travel(), unit));
  const double lines = numeric::spectral_lines(means.places, band);
  const double steps = lines * static_cast<double>(means.places.size());
  if (lines > options.lines_most || steps > most_steps) {
    if (options.period) {  // the spectrum is only shown: what fits around the known period
      band = {options.period->in_native() / 1.5, options.period->in_native() * 1.5};
      if (numeric::spectral_lines(means.places, band) <= options.lines_most) return band;
    }
    return fail(
        fmt::format("found {:.3g} periods to search between {:.6g} {} and {:.6g} {}, expected at most {:g}: "
                    "give a longer shortest period",
                    lines, band.shortest, unit, band.longest, unit,
                    std::min(options.lines_most, most_steps / static_cast<double>(means.places.size()))));
  }
  return band;
}

/// Orders that have more than two targets per period on average, as far as the data tell twice as much.
std::vector<std::size_t> resolvable(const RunMeans& means, double period) {
  std::vector<std::size_t> orders = {1};
  for (std::size_t h = 2; h <= most_harmonics; ++h) {
    if (period / static_cast<double>(h) <= 2.0 * means.spacing() * (1.0 + 1e-9)) break;
    if (means.places.size() < 2 * (3 + 2 * h)) break;
    orders.push_back(h);
  }
  return orders;
}

/// The fit with the orders that count, and one with all orders at its period, which tells why.
struct Fits {
  HarmonicFit curve;
  HarmonicFit all_orders;
};

/// Orders that noise alone would make as large have no part in the curve: they would disturb the period, and make its
/// uncertainty too small. Which they are is seen at the period of the fundamental alone.
std::optional<Fits> fit(const RunMeans& means, double start, bool known, double rounding) {
  const auto fit_with = [&](double period, std::span<const std::size_t> orders) {
    auto result = known ? std::nullopt : numeric::fit_harmonics_and_period(means.data(), period, orders);
    return result ? result : numeric::fit_harmonics(means.data(), period, orders);
  };
  const std::size_t fundamental[] = {1};
  const auto first = fit_with(start, fundamental);
  if (!first) return std::nullopt;
  std::optional<HarmonicFit> all;
  auto orders = resolvable(means, first->period);
  while (!(all = numeric::fit_harmonics(means.data(), first->period, orders)) && orders.size() > 1) orders.pop_back();
  if (!all) return std::nullopt;
  std::vector<std::size_t> counting = {1};
  for (std::size_t h : orders)
    if (h > 1 && std::hypot(all->sine(h), all->cosine(h)) > rounding && all->chance_of(h) < periodic_significance)
      counting.push_back(h);
  auto curve = fit_with(first->period, counting);
  if (!curve) return std::nullopt;
  all = numeric::fit_harmonics(means.data(), curve->period, orders);
  if (!all) return std::nullopt;
  return Fits{*std::move(curve), *std::move(all)};
}

/// By more than noise moves a period that stands at the end: a tenth of what the travel tells apart.
bool is_beyond(const PeriodBand& band, double period, double travel) {
  const double end = period > band.longest ? band.longest : band.shortest;
  const bool is_outside = period > band.longest || period < band.shortest;
  return is_outside && std::abs(1.0 / period - 1.0 / end) > 0.1 / travel;
}

double root(double variance) { return std::sqrt(std::max(variance, 0.0)); }

double to_half_turn(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  return turned <= -180.0 ? turned + 360.0 : turned;
}

PeriodicHarmonic harmonic_of(const HarmonicFit& fit, std::size_t order, double rounding) {
  const double s = fit.sine(order), c = fit.cosine(order);
  const std::size_t at = fit.place_of(order);
  const double ss = fit.covariance_of(at, at), cc = fit.covariance_of(at + 1, at + 1);
  const double sc = fit.covariance_of(at, at + 1);
  const double A = std::hypot(s, c);
  PeriodicHarmonic result;
  result.order = order;
  result.amplitude.value = Deviation::native(A);
  const double u = A > 0.0 ? root((s * s * ss + 2.0 * s * c * sc + c * c * cc) / (A * A)) : root((ss + cc) / 2.0);
  result.amplitude.u = Deviation::native(u);
  result.phase.value = Angle::deg(A > 0.0 ? std::atan2(c, s) * deg : 0.0);
  const double u_phase =
      A > 0.0 ? root((c * c * ss - 2.0 * s * c * sc + s * s * cc) / (A * A)) / A * deg : nothing_known_deg;
  result.phase.u = Angle::deg(std::min(u_phase, nothing_known_deg));
  result.chance = A <= rounding ? 1.0 : fit.chance_of(order);
  return result;
}

/// φ_1 at position 0: φ − 2π P_1/λ, with the covariance between φ and λ.
Estimate<Angle> phase_at_zero(const HarmonicFit& fit, const PeriodicHarmonic& fundamental) {
  const double s = fit.sine(1), c = fit.cosine(1), square = s * s + c * c;
  const double value = fundamental.phase.value.in_deg() - std::fmod(fit.origin, fit.period) / fit.period * 360.0;
  if (square == 0.0) return {Angle::deg(0.0), Angle::deg(nothing_known_deg)};
  std::vector<double> by(fit.coefficients.size(), 0.0);
  by[2] = -c / square;
  by[3] = s / square;
  if (fit.period_fitted) by.back() = two_pi * fit.origin / (fit.period * fit.period);
  double variance = 0.0;
  for (std::size_t i = 0; i < by.size(); ++i)
    for (std::size_t j = 0; j < by.size(); ++j) variance += by[i] * by[j] * fit.covariance_of(i, j);
  return {Angle::deg(to_half_turn(value)), Angle::deg(std::min(root(variance) * deg, nothing_known_deg))};
}

/// Value of the curve at an angle of the fundamental.
double folded(const HarmonicFit& fit, double angle) {
  double y = 0.0;
  for (std::size_t h : fit.orders) {
    const double turned = static_cast<double>(h) * angle;
    y += fit.sine(h) * std::sin(turned) + fit.cosine(h) * std::cos(turned);
  }
  return y;
}

/// The angle of the highest (sign +1) or lowest (−1) point: a fine comb, then the vertex of the parabola through three.
double extremum(const HarmonicFit& fit, double sign) {
  constexpr int teeth = 2880;
  constexpr double pitch = two_pi / teeth;
  const auto value = [&](int k) { return sign * folded(fit, pitch * k); };
  int best = 0;
  for (int k = 1; k < teeth; ++k)
    if (value(k) > value(best)) best = k;
  const double before = value(best - 1), here = value(best), after = value(best + 1);
  const double bend = before - 2.0 * here + after;
  return pitch * (best + (bend < 0.0 ? 0.5 * (before - after) / bend : 0.0));
}

/// Highest less lowest point of the curve. Both are stationary, so that only the coefficients count in u.
Estimate<Deviation> peak_to_valley(const HarmonicFit& fit) {
  const double high = extremum(fit, 1.0), low = extremum(fit, -1.0);
  std::vector<double> by(fit.coefficients.size(), 0.0);
  for (std::size_t h : fit.orders) {
    const double n = static_cast<double>(h);
    by[fit.place_of(h)] = std::sin(n * high) - std::sin(n * low);
    by[fit.place_of(h) + 1] = std::cos(n * high) - std::cos(n * low);
  }
  double variance = 0.0;
  for (std::size_t i = 0; i < by.size(); ++i)
    for (std::size_t j = 0; j < by.size(); ++j) variance += by[i] * by[j] * fit.covariance_of(i, j);
  return {Deviation::native(folded(fit, high) - folded(fit, low)), Deviation::native(root(variance))};
}

double range(const std::vector<double>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  return high - low;
}

void add_points(PeriodicDirection& result, const RunMeans& means) {
  std::vector<double> about_line, residuals;
  for (std::size_t k = 0; k < means.places.size(); ++k) {
    const double place = means.places[k];
    const double line = result.line_native(place);
    const double curve = result.curve_native(place);
    const double turns = (place - means.places.front()) / result.period.value.in_native();
    result.points.push_back({Position::native(place), Deviation::native(means.values[k]), Deviation::native(line),
                             Deviation::native(curve), 360.0 * (turns - std::floor(turns))});
    about_line.push_back(means.values[k] - line);
    residuals.push_back(means.values[k] - line - curve);
  }
  result.range_about_line = Deviation::native(range(about_line));
  result.range_of_residuals = Deviation::native(range(residuals));
}

/// The highest peak of what the fit leaves, where it stands out.
std::optional<FurtherPeriod> further_period(const RunMeans& means, const HarmonicFit& fit, const PeriodSearch& search,
                                            const NoiseCorrelation& noise, double rounding) {
  const numeric::SpectralLine highest = search.spectrum(fit.residuals).highest;
  const double chance =
      search.false_alarm_probability(noise.white_reduction(highest.reduction, highest.period / means.spacing()));
  if (chance >= periodic_significance || highest.amplitude <= rounding) return std::nullopt;
  return FurtherPeriod{Position::native(highest.period), Deviation::native(highest.amplitude), chance};
}

/// The reduction that is a false alarm in 1 % of bands without any period, as an amplitude beside these residuals.
double noise_level(const HarmonicFit& fit, const PeriodSearch& search) {
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 50; ++k) {
    const double middle = (low + high) / 2.0;
    (search.false_alarm_probability(middle) > periodic_significance ? low : high) = middle;
  }
  return std::sqrt(2.0 * high / std::max(1.0 - high, 1e-12) * fit.sum_of_squares /
                   static_cast<double>(fit.residuals.size()));
}

/// What the fits say by themselves.
void add_fits(PeriodicDirection& result, const Fits& fits, double rounding) {
  const HarmonicFit& fit = fits.curve;
  const auto u = [&](std::size_t k) { return root(fit.covariance_of(k, k)); };
  result.origin = Position::native(fit.origin);
  result.offset = {Deviation::native(fit.coefficients[0]), Deviation::native(u(0))};
  result.slope_native = {fit.coefficients[1], u(1)};
  result.period.value = Position::native(fit.period);
  if (fit.period_fitted) result.period.u = Position::native(u(fit.coefficients.size() - 1));
  for (std::size_t h : fits.all_orders.orders) {
    const bool counts = std::ranges::find(fit.orders, h) != fit.orders.end();
    result.harmonics.push_back(harmonic_of(counts ? fit : fits.all_orders, h, rounding));
    result.harmonics.back().significant = h == 1 ? result.harmonics.back().chance < periodic_significance : counts;
  }
  result.phase_at_zero = phase_at_zero(fit, result.harmonics.front());
  result.peak_to_valley = peak_to_valley(fit);
  result.degrees_of_freedom = fit.degrees_of_freedom;
  const double nu = static_cast<double>(fit.degrees_of_freedom);
  result.residual_sd = Deviation::native(std::sqrt(fit.sum_of_squares / nu));
  result.coverage_factor = numeric::student_t_quantile(numeric::normal_probability(2.0), nu);
}

/// By white noise, then by noise that is as correlated as the residuals may be, to which a reduction that white noise
/// gives is less.
void add_chances(PeriodicDirection& result, const RunMeans& means, const PeriodSearch& search,
                 const numeric::SpectralLine& highest, const HarmonicFit& fit, double rounding) {
  if (std::sqrt(fit.sum_of_squares / static_cast<double>(means.places.size())) > rounding)
    result.residual_correlation = noise_correlation(fit.residuals, fit.degrees_of_freedom);
  const NoiseCorrelation& noise = result.residual_correlation;
  const double targets = fit.period / means.spacing();
  if (result.period_known) {
    const double half = 0.5 * static_cast<double>(fit.degrees_of_freedom);
    const double chance = result.harmonics.front().chance;  // (1 − reduction)^(ν/2)
    const double reduction = noise.white_reduction(1.0 - std::pow(chance, 1.0 / half), targets);
    result.false_alarm = chance;
    result.false_alarm_correlated = std::max(chance, std::pow(1.0 - reduction, half));
  } else if (highest.amplitude > rounding) {
    result.false_alarm = search.false_alarm_probability(highest.reduction);
    result.false_alarm_correlated = search.false_alarm_probability(noise.white_reduction(highest.reduction, targets));
  }
  result.significant = result.false_alarm_correlated < periodic_significance;
}

/// What the spectrum says.
void add_spectrum(PeriodicDirection& result, const RunMeans& means, const PeriodSearch& search,
                  const numeric::Spectrum& spectrum, const HarmonicFit& fit, double rounding) {
  add_chances(result, means, search, spectrum.highest, fit, rounding);
  // At a period searched as the highest peak the F test of a period stated beforehand tells nothing.
  result.harmonics.front().chance = result.false_alarm;
  result.harmonics.front().significant = result.significant;
  // Of an error with a period beyond the band the fit at its end leaves a part, which is no other error.
  if (!result.beyond_band) result.further = further_period(means, fit, search, result.residual_correlation, rounding);
  result.noise_level = Deviation::native(noise_level(fit, search));
  result.peak_at_end = !result.period_known && (spectrum.at_end || result.beyond_band);
  for (const numeric::SpectralLine& line : spectrum.lines)
    result.spectrum.push_back({Position::native(line.period), Deviation::native(line.amplitude)});
}

Result<PeriodicDirection> evaluate_direction(const Test& test, Direction direction, const PeriodicOptions& options) {
  AXIOMETRY_TRY(const RunMeans means, run_means_of(test.series, direction));
  const std::string_view unit = unit_of(test);
  PeriodicDirection result;
  result.period_known = options.period.has_value();
  const std::size_t needed = result.period_known ? 6 : 7;
  if (means.places.size() < needed)
    return fail(fmt::format("found {} with readings {}, expected at least {} for a periodic error",
                            counted(means.places.size(), "target"), arrow(direction), needed));
  AXIOMETRY_TRY(const PeriodBand band, band_of(means, options, unit));
  const PeriodSearch search(means.places, band);
  const numeric::Spectrum spectrum = search.spectrum(means.values);
  const double start = result.period_known ? options.period->in_native() : spectrum.highest.period;
  const double magnitude = std::abs(*std::ranges::max_element(means.values, {}, [](double x) { return std::abs(x); }));
  const double rounding = 1e-12 * magnitude;  // far above the rounding of the fit, far below any measurement
  auto fits = fit(means, start, result.period_known, rounding);
  // Beyond the band nothing was searched, and no chance is known there: the peak at its end is what was found.
  result.beyond_band =
      fits && !result.period_known && spectrum.at_end && is_beyond(band, fits->curve.period, means.travel());
  if (result.beyond_band) fits = fit(means, start, true, rounding);
  if (!fits)
    return fail(
        fmt::format("found {} targets {} every {:.6g} {} on average that cannot show a period of {:.6g} {}, "
                    "expected them elsewhere than every half period and over more of it",
                    means.places.size(), arrow(direction), means.spacing(), unit, start, unit));

  result.direction = direction;
  result.runs = means.runs;
  result.missing = means.missing;
  if (means.scatter) result.scatter_of_means = Deviation::native(*means.scatter);
  add_fits(result, *fits, rounding);
  // What could not be refined, of values on a straight line or at the end of the band, may be any period of it.
  if (!result.period_known && !fits->curve.period_fitted)
    result.period.u = Position::native((band.longest - band.shortest) / std::sqrt(12.0));
  result.periods_covered = means.travel() / fits->curve.period;
  result.targets_per_period = fits->curve.period / means.spacing();
  add_spectrum(result, means, search, spectrum, fits->curve, rounding);
  enlarge_uncertainties(result, means.places.size());
  if (means.missing > 0) hold_shifts(result, means.u_means, means.travel());
  add_points(result, means);
  return result;
}

}  // namespace

double PeriodicDirection::curve_native(double position) const {
  double y = 0.0;
  const double turns = (position - origin.in_native()) / period.value.in_native();
  for (const PeriodicHarmonic& h : harmonics) {
    if (h.order > 1 && !h.significant) continue;
    y += h.amplitude.value.in_native() *
         std::sin(two_pi * static_cast<double>(h.order) * turns + h.phase.value.in_deg() / deg);
  }
  return y;
}

Result<PeriodicError> periodic_error(const Test& test, const PeriodicOptions& options) {
  AXIOMETRY_TRY_VOID(check_options(options, unit_of(test)));
  PeriodicError result;
  for (Direction direction : {Direction::up, Direction::down}) {
    if (!test.series.has(direction)) continue;
    AXIOMETRY_TRY(PeriodicDirection found, evaluate_direction(test, direction, options));
    result.directions.push_back(std::move(found));
  }
  // One direction only is what this test wants; every other cycle but the standard one keeps its label.
  if (test.metadata.conditions.cycle != TestCycle::unidirectional)
    result.label = cycle_label(test.metadata.conditions.cycle_or_standard());
  result.findings = periodic_findings(test, result.directions);
  return result;
}

}  // namespace axiometry::iso230_2
