// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/tried_fit.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "axiometry/volumetric/identify/curve_choice.h"
#include "axiometry/volumetric/identify/equations/thinned_problem.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t tried_readings_most = 20'000;
constexpr double share_least = 0.8;  // share of the excess of χ² that a cause must explain

double degrees_of_freedom(const Fit& fit, std::span<const double> weights) {
  const auto used = std::ranges::count_if(weights, [](double w) { return w > 0.0; });
  return static_cast<double>(used) - static_cast<double>(fit.solution.told());
}

}  // namespace

bool explains(const FitQuality& other, const FitQuality& own) {
  return own.excess() - other.excess() > gain_least && other.ratio() - 1.0 < (1.0 - share_least) * (own.ratio() - 1.0);
}

bool is_in_rows(std::span<const VolumetricReading> readings) {
  constexpr std::size_t readings_at_each = 4;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Vector3>> runs;
  for (const VolumetricReading& reading : readings) runs[{reading.station, reading.tool}].push_back(reading.axes_mm);
  std::size_t in_rows = 0;
  for (const auto& [names, places] : runs)
    for (std::size_t a = 0; a < axis_count; ++a) {
      std::vector<double> positions;
      for (const Vector3& q : places) positions.push_back(q[a]);
      const std::size_t enough = places.size() / readings_at_each;
      if (different_places(std::move(positions), enough) == enough) continue;
      ++in_rows;
      break;
    }
  return 2 * in_rows > runs.size();
}

std::vector<std::size_t> readings_to_try(const Identifier& done) {
  const std::size_t n = done.weights().size();
  if (n > tried_readings_most) return some_of_each_stretch(done.unknowns(), tried_readings_most);
  std::vector<std::size_t> all(n);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::optional<TriedFit> fitted_to(const Problem& some, const Identifier& done) {
  State start = done.fit().state;
  start.coefficients.assign(some.coefficients.raw(), 0.0);
  auto fit = least_squares(some, std::move(start));
  if (!fit) return std::nullopt;
  double freedom = degrees_of_freedom(*fit, some.weights);
  if (done.has_part_scales())
    if (const auto scales = part_scale_fit(some, *fit, freedom, done.middle_mm()); scales && scales->told.held) {
      take_out(*scales, some, *fit);
      freedom -= scales->taken;
    }
  if (freedom < 1.0) return std::nullopt;
  const FitQuality quality{fit->chi_squared, freedom};
  return TriedFit{*std::move(fit), quality};
}

Coefficients with_reversal(const Coefficients& c, Reversal reversal) {
  return Coefficients({c.basis(0), c.basis(1), c.basis(2)}, reversal);
}

std::optional<TriedFit> fitted_with(const Coefficients& coefficients, const Identifier& done,
                                    const VolumetricLengths& lengths, std::span<const std::size_t> kept) {
  std::vector<std::size_t> breaks;
  for (const BreakPlace& place : done.breaks()) breaks.push_back(place.before);
  const Unknowns unknowns = unknowns_of(coefficients, lengths.readings, breaks, done.drift());
  const std::vector<Approaches> approaches = directions_of_rest(lengths.readings);
  const Problem whole = done.problem();
  const ThinnedProblem few(
      {whole.machine, coefficients, unknowns, whole.readings, whole.tools_mm, approaches, whole.weights, whole.threads},
      kept);
  return fitted_to(few.problem(), done);
}

std::optional<FitQuality> own_quality(const Identifier& done, std::span<const std::size_t> kept) {
  if (kept.size() == done.weights().size() && !done.penalty()) {
    const FitQuality quality{done.fit().chi_squared,
                             degrees_of_freedom(done.fit(), done.weights()) - done.taken_by_scales()};
    return quality.degrees_of_freedom < 1.0 ? std::nullopt : std::optional(quality);
  }
  const ThinnedProblem few(done.problem(), kept);
  const auto tried = fitted_to(few.problem(), done);
  return tried ? std::optional(tried->quality) : std::nullopt;
}

FitQuality seen_quality(const Identifier& done, std::span<const std::size_t> kept) {
  FitQuality seen{0.0, 0.0};
  double used = 0.0;
  for (const std::size_t i : kept) {
    const double w = done.weights()[i], v = done.fit().residuals_um[i];
    seen.chi_squared += w * v * v;
    used += w > 0.0 ? 1.0 : 0.0;
  }
  const double told = static_cast<double>(done.fit().solution.told()) + done.taken_by_scales();
  seen.degrees_of_freedom = used * (1.0 - told / static_cast<double>(done.count()));
  return seen;
}

bool is_stated_wrongly(const std::vector<VolumetricFinding>& findings) {
  return std::ranges::any_of(findings, [](const VolumetricFinding& f) {
    return f.serious && (f.id == "volumetric-tool-offset" || f.id == "volumetric-axes-mixed-up");
  });
}

bool is_told_otherwise(const std::vector<VolumetricFinding>& findings) {
  return is_stated_wrongly(findings) || std::ranges::any_of(findings, [](const VolumetricFinding& f) {
           return f.serious && f.id == "volumetric-station-moved";
         });
}

}  // namespace axiometry::volumetric::detail
