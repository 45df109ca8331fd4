// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/periodic_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/compensation/prediction.h"
#include "axiometry/numeric/moments.h"

namespace axiometry::compensation {
namespace {

constexpr double chance_most = 0.01;
constexpr double even_share = 0.01;  // of the period: what targets on even steps may lie beside them

std::size_t index_of(Direction direction) { return static_cast<std::size_t>(direction); }

/// "1.52 µm ↑ and 1.48 µm ↓", of the directions in which it is significant.
std::string amplitudes(const PeriodicPart& part, AxisKind kind) {
  std::string text;
  for (const Direction direction : {Direction::up, Direction::down})
    if (part.is_significant(direction))
      text += fmt::format("{}{:.2f} {} {}", text.empty() ? "" : " and ",
                          part.directions[index_of(direction)]->amplitude, deviation_unit(kind), arrow(direction));
  return text;
}

double widest_spacing(std::span<const double> nodes) {
  double widest = 0.0;
  for (std::size_t k = 1; k < nodes.size(); ++k) widest = std::max(widest, nodes[k] - nodes[k - 1]);
  return widest;
}

/// The largest length that both are multiples of, within `slack` (Euclid).
double common_measure(double a, double b, double slack) {
  while (b > slack) {
    const double left = std::fmod(a, b);
    a = std::exchange(b, b - left <= slack ? 0.0 : left);
  }
  return a;
}

/// The step from whose multiples no place lies further than `slack`; 0 without one. Contract: two places or more.
double even_step(const std::vector<double>& places, double slack) {
  const double travel = places.back() - places.front();
  double step = travel;
  for (std::size_t k = 1; k < places.size(); ++k) step = common_measure(step, places[k] - places[k - 1], slack);
  step = travel / std::max(1.0, std::round(travel / step));
  for (const double place : places)
    if (std::abs(std::remainder(place - places.front(), step)) > slack) return 0.0;
  return step;
}

/// The longest of the other periods whose sinusoid is the same on all multiples of the step.
double period_alike(double period, double step) { return step / std::abs(std::remainder(step / period, 1.0)); }

/// Where these places do not tell the sinusoid from one of another period.
std::optional<Ambiguity> ambiguity_of(const std::vector<double>& places, const numeric::SineBesideCurve& fit) {
  const double step = even_step(places, even_share * fit.period);
  if (2.0 * step <= fit.period) return std::nullopt;
  return Ambiguity{step, period_alike(fit.period, step), fit.amplitude};
}

/// Takes one direction's sinusoid, or why the places do not tell it.
void take(PeriodicPart& part, Direction direction, const std::vector<double>& places,
          const std::vector<double>& means) {
  const auto fit = numeric::fit_sine_beside_curve({places, means}, part.period);
  if (!fit) return;
  part.widest_of_targets = std::max(part.widest_of_targets, widest_spacing(places));
  const auto ambiguity = ambiguity_of(places, *fit);
  if (!ambiguity)
    part.directions[index_of(direction)] = fit;
  else if (fit->chance < chance_most && (!part.ambiguity || part.ambiguity->amplitude < ambiguity->amplitude))
    part.ambiguity = ambiguity;
}

NamedFinding finding_of_ambiguity(const PeriodicPart& part, AxisKind kind) {
  const std::string_view unit = position_unit(kind);
  return {"compensation-periodic-ambiguous", true,
          fmt::format("found a periodic part of an amplitude of {:.2f} {} in the readings, and targets on even steps "
                      "of {} {}, above half the period of {} {}: they do not tell it from one with a period of {} {}, "
                      "and if it has the shorter one the table is wrong between them; a test for periodic errors "
                      "tells which",
                      part.ambiguity->amplitude, deviation_unit(kind), format_rounded(part.ambiguity->step), unit,
                      format_rounded(part.period), unit, format_rounded(part.ambiguity->other_period), unit)};
}

}  // namespace

bool PeriodicPart::is_significant(Direction direction) const {
  const auto& fit = directions[index_of(direction)];
  return fit && fit->chance < chance_most;
}

double PeriodicPart::at(double position, Direction direction) const {
  return is_significant(direction) ? directions[index_of(direction)]->at(position) : 0.0;
}

PeriodicPart periodic_part(const Series& series, double period) {
  PeriodicPart part{period};
  for (const Direction direction : {Direction::up, Direction::down}) {
    std::vector<double> places, means;
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const numeric::Moments m = numeric::moments(series.cell(i, direction));
      if (m.count == 0) continue;
      places.push_back(series.targets()[i].in_native());
      means.push_back(m.mean);
    }
    take(part, direction, places, means);
  }
  return part;
}

Result<Series> without_periodic(const Series& series, const PeriodicPart& part) {
  return shifted_series(series, [&](double position, Direction direction) { return -part.at(position, direction); });
}

std::vector<NamedFinding> findings_of_periodic(const PeriodicPart& part, Periodic choice, std::span<const double> nodes,
                                               AxisKind kind) {
  const std::string period = fmt::format("{} {}", format_rounded(part.period), position_unit(kind));
  if (choice == Periodic::leave) {
    if (part.is_significant())
      return {
          {"compensation-periodic-left", false,
           fmt::format("the periodic part with a period of {}, of an amplitude of {}, is not in the table: it stays, "
                       "and is in what is predicted",
                       period, amplitudes(part, kind))}};
    return {{"compensation-nothing-periodic", false,
             part.is_told() ? fmt::format("found no periodic part with a period of {} in the readings that noise would "
                                          "not make in one test of a hundred: nothing was left out",
                                          period)
                            : fmt::format("the targets do not tell a periodic part with a period of {}: nothing was "
                                          "left out",
                                          period)}};
  }
  if (nodes.size() < 3) return {};
  if (part.ambiguity) return {finding_of_ambiguity(part, kind)};
  const double spacing = std::max(widest_spacing(nodes), part.widest_of_targets);
  if (spacing <= 0.5 * part.period || !part.is_significant()) return {};
  return {
      {"compensation-periodic-aliased", true,
       fmt::format("found a periodic part with a period of {}, of an amplitude of {}, in the readings, and positions "
                   "of the table or targets up to {} {} apart, above half the period: the table holds what the targets "
                   "happened to meet of it, and is wrong between them; the part can be left out of it",
                   period, amplitudes(part, kind), format_rounded(spacing), position_unit(kind))}};
}

}  // namespace axiometry::compensation
