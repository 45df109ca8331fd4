// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/identification.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/go_on_unless.h"
#include "axiometry/numeric/side_by_side.h"
#include "axiometry/volumetric/identify/beyond_places.h"
#include "axiometry/volumetric/identify/common_scale.h"
#include "axiometry/volumetric/identify/equations/shape_rank.h"
#include "axiometry/volumetric/identify/findings/findings.h"
#include "axiometry/volumetric/identify/identifier.h"
#include "axiometry/volumetric/identify/smoothing.h"

namespace axiometry::volumetric {
namespace {

using detail::BeamStretch;
using detail::Fit;
using detail::Identifier;
using detail::Problem;
using detail::Unknowns;

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& x : values) x *= factor;
  return values;
}

/// With tools as they count: what is made of the errors has the same.
MachineModel with_seen_tools(MachineModel machine, const Identifier& done, const VolumetricLengths& lengths) {
  for (std::size_t k = 0; k < lengths.tools.size(); ++k)
    machine.tools[*machine.tool_named(lengths.tools[k])].offset_mm = done.tools_mm()[k];
  return machine;
}

/// Those of the parts, and what they leave open of places.
void add_scales(const Identifier& done, std::vector<IdentifiedStation>& stations) {
  if (!done.has_part_scales()) return;
  const auto& scales = done.part_scales();
  for (std::size_t v = 0; v < stations.size(); ++v) {
    const std::vector<double> left_open = covariance_by_scales(*scales, done.unknowns().stations[v].column, 3);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) stations[v].covariance_um2[i][k] += left_open[3 * i + k];
  }
  for (std::size_t p = 0; p < scales->parts.size(); ++p) {
    const auto at = static_cast<Eigen::Index>(p);
    stations[scales->parts[p]].scale_um_per_m = scales->um_per_m[at];
    stations[scales->parts[p]].scale_u_um_per_m = std::sqrt(scales->covariance(at, at));
  }
}

/// Where they stand with the tools as stated: a tool that counts elsewhere moves all places it was seen from as far.
std::vector<IdentifiedStation> stations_of(const Identifier& done, const MachineModel& machine,
                                           const VolumetricLengths& lengths, double factor) {
  const Unknowns& unknowns = done.unknowns();
  std::vector<std::size_t> columns;
  for (const detail::VirtualStation& own : unknowns.stations) columns.push_back(own.column);
  const std::vector<Matrix3> covariances = done.fit().solution.blocks(columns);
  std::vector<IdentifiedStation> stations;
  for (std::size_t v = 0; v < unknowns.stations.size(); ++v) {
    const detail::VirtualStation& own = unknowns.stations[v];
    const Vector3 stated = machine.tools[*machine.tool_named(lengths.tools[own.tool])].offset_mm;
    IdentifiedStation station{own.station, own.tool,
                              done.fit().state.stations_mm[v] + (stated - done.tools_mm()[own.tool])};
    station.covariance_um2 = covariances[v];
    for (auto& row : station.covariance_um2)
      for (double& c : row) c *= factor;
    stations.push_back(station);
  }
  add_scales(done, stations);
  for (std::size_t i = 0; i < lengths.readings.size(); ++i) {
    if (done.set_aside()[i] || done.in_doubt(i) || done.is_copy(i) || done.is_of_unknown_direction(i)) continue;
    IdentifiedStation& station = stations[unknowns.stretches[unknowns.stretch_of[i]].virtual_station];
    const double v = done.fit().residuals_um[i], z = v / done.sigmas_um()[i];
    ++station.readings;
    station.rms_um += v * v;
    station.normalised_rms += z * z;
  }
  for (IdentifiedStation& station : stations) {
    const double n = std::max(1.0, static_cast<double>(station.readings));
    station.rms_um = std::sqrt(station.rms_um / n);
    station.normalised_rms = std::sqrt(station.normalised_rms / n);
  }
  return stations;
}

std::vector<IdentifiedStretch> stretches_of(const Identifier& done) {
  std::vector<IdentifiedStretch> stretches;
  const Unknowns& unknowns = done.unknowns();
  for (std::size_t j = 0; j < unknowns.stretches.size(); ++j) {
    const BeamStretch& own = unknowns.stretches[j];
    IdentifiedStretch stretch{own.virtual_station, own.segment, own.readings, done.fit().state.dead_paths_mm[j], {}};
    if (done.drift()) stretch.drift_um = done.fit().state.drifts_um[j];
    stretches.push_back(stretch);
  }
  return stretches;
}

std::vector<FoundBreak> breaks_of(const Identifier& done) {
  std::vector<FoundBreak> breaks;
  for (const detail::BreakPlace& place : done.breaks())
    breaks.push_back(
        {place.before, detail::jump_um(done.unknowns(), done.fit().state, place.before), place.earliest, place.latest});
  return breaks;
}

std::optional<SetAside::Reason> why_set_aside(const Identifier& done, std::size_t reading) {
  if (done.set_aside()[reading]) return SetAside::Reason::outlier;
  if (done.is_copy(reading)) return std::nullopt;
  if (done.in_doubt(reading)) return SetAside::Reason::beside_break;
  if (done.is_of_unknown_direction(reading)) return SetAside::Reason::unknown_direction;
  return std::nullopt;
}

std::vector<SetAside> set_aside_of(const Identifier& done) {
  std::vector<SetAside> aside;
  for (std::size_t i = 0; i < done.set_aside().size(); ++i)
    if (const auto why = why_set_aside(done, i))
      aside.push_back({i, done.fit().residuals_um[i], done.fit().residuals_um[i] / done.sigmas_um()[i], *why});
  return aside;
}

/// Of what is stated, with the variance factor of each fit: without the smoothness, and with it.
void set_ratios(const Identifier& done, const std::vector<double>& scaled, SmoothedCurves& smoothed) {
  const detail::PerCurve stated = detail::mean_variances(done.coefficients(), scaled);
  for (SmoothedError& s : smoothed.errors)
    if (stated[s.error] > 0.0)
      s.u_ratio = std::sqrt(done.plain_variances()[s.error] * done.penalty()->variance_factor() / stated[s.error]);
}

}  // namespace

Result<Identification> identify(const MachineModel& machine, const VolumetricLengths& lengths,
                                const IdentifyOptions& options) {
  AXIOMETRY_TRY(Identifier first, Identifier::make(machine, lengths, options));
  AXIOMETRY_TRY_VOID(first.run());
  const std::optional<IdentifyOptions> beyond = detail::options_beyond_places(first, lengths, options);
  std::optional<Identifier> finer;
  if (beyond)
    if (auto made = Identifier::make(machine, lengths, *beyond); made && made->run() && leaves_less(*made, first))
      finer.emplace(*std::move(made));
  AXIOMETRY_TRY_VOID(go_on_unless(options.stop));
  const Identifier& done = finer ? *finer : first;
  const Fit& fit = done.fit();
  const std::size_t told = fit.solution.told();
  std::vector<double> covariance;
  double condition = 0.0;
  numeric::side_by_side(2, done.problem().threads, [&](std::size_t part) {
    if (part == 0)
      covariance = fit.solution.coefficient_covariance();
    else
      condition = fit.solution.condition();
  });
  std::optional<SmoothedCurves> smoothed;
  if (done.penalty()) smoothed = detail::smoothed_curves(*done.penalty(), done.coefficients(), fit, covariance);
  // Of what smoothness tells, whole unknowns only, and whole ones that scales take: fewer degrees of freedom make
  // uncertainties larger.
  const auto& scales = done.part_scales();
  const std::size_t fitted = told - (smoothed ? static_cast<std::size_t>(smoothed->taken) : 0) +
                             static_cast<std::size_t>(std::ceil(done.taken_by_scales()));
  const std::size_t dof = done.count() > fitted ? done.count() - fitted : 0;
  const double ratio = dof > 0 ? fit.chi_squared / static_cast<double>(dof) : 1.0;
  const double factor = std::max(1.0, ratio);
  std::vector<double> scaled = times(covariance, factor);
  if (smoothed && options.smoothness.kind == Smoothness::Kind::automatic)
    scaled = detail::with_bend_uncertainty(*done.penalty(), done.coefficients(), fit, covariance, std::move(scaled));
  if (smoothed) set_ratios(done, scaled, *smoothed);
  if (done.has_part_scales()) {
    const std::vector<double> left_open = covariance_by_scales(*scales, 0, done.coefficients().raw());
    for (std::size_t k = 0; k < scaled.size(); ++k) scaled[k] += left_open[k];
  }
  detail::add_common_scale(done.problem(), fit.state, fit.beams, fit.solution, scaled);
  std::vector<std::vector<double>> unseen = fit.solution.unseen();
  const auto by_shape = detail::told_by_shape_alone(done.problem(), fit.state);
  unseen.insert(unseen.end(), by_shape.begin(), by_shape.end());
  ErrorModel model({with_seen_tools(machine, done, lengths), done.coefficients(), fit.state.coefficients,
                    std::move(scaled), std::move(unseen), done.observed()});
  Identification result{.model = std::move(model),
                        .stations = stations_of(done, machine, lengths, factor),
                        .stretches = stretches_of(done),
                        .residuals_um = fit.residuals_um,
                        .sigmas_um = done.sigmas_um(),
                        .set_aside = set_aside_of(done),
                        .breaks = breaks_of(done),
                        .chi_squared = fit.chi_squared,
                        .degrees_of_freedom = dof,
                        .rank = {fit.solution.unknowns(), done.coefficients().free(),
                                 std::max(fit.solution.null_directions(), by_shape.size()), condition},
                        .iterations = fit.iterations,
                        .drift = done.drift(),
                        .smoothed = std::move(smoothed),
                        .part_scales = {},
                        .findings = {}};
  if (scales) result.part_scales = scales->told;
  result.findings = detail::findings_of(done, machine, lengths, result);
  return result;
}

}  // namespace axiometry::volumetric
