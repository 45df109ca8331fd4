// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/equations/unknowns.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace axiometry::volumetric::detail {

Unknowns unknowns_of(const Coefficients& coefficients, std::span<const VolumetricReading> readings,
                     std::span<const std::size_t> breaks, bool drift) {
  Unknowns unknowns;
  unknowns.coefficients = coefficients.raw();
  unknowns.drift = drift;
  std::map<std::tuple<std::size_t, std::size_t>, std::size_t> stations;
  std::map<std::tuple<std::size_t, std::size_t>, std::size_t> stretches;  // newest of each station and segment
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const VolumetricReading& reading = readings[i];
    const auto [station, is_new_station] = stations.try_emplace({reading.station, reading.tool}, stations.size());
    if (is_new_station) unknowns.stations.push_back({reading.station, reading.tool});
    const auto [stretch, is_new] = stretches.try_emplace({station->second, reading.segment}, unknowns.stretches.size());
    if (!is_new && std::ranges::binary_search(breaks, i)) stretch->second = unknowns.stretches.size();
    if (stretch->second == unknowns.stretches.size()) unknowns.stretches.push_back({station->second, reading.segment});
    BeamStretch& own = unknowns.stretches[stretch->second];
    unknowns.along_stretch.push_back(static_cast<double>(own.readings++));
    unknowns.stretch_of.push_back(stretch->second);
  }
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const double last = static_cast<double>(unknowns.stretches[unknowns.stretch_of[i]].readings) - 1.0;
    unknowns.along_stretch[i] = last > 0.0 ? unknowns.along_stretch[i] / last - 0.5 : 0.0;
  }
  std::size_t column = unknowns.coefficients;
  for (VirtualStation& station : unknowns.stations) {
    station.column = column;
    column += 3;
  }
  for (BeamStretch& stretch : unknowns.stretches) {
    stretch.column = column;
    column += drift ? 2 : 1;
  }
  unknowns.columns = column;
  return unknowns;
}

void add_step(const Unknowns& unknowns, std::span<const double> step, State& state) {
  constexpr double mm_per_um = 1e-3;
  for (std::size_t k = 0; k < unknowns.coefficients; ++k) state.coefficients[k] += step[k];
  for (std::size_t v = 0; v < unknowns.stations.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) state.stations_mm[v][k] += mm_per_um * step[unknowns.stations[v].column + k];
  for (std::size_t j = 0; j < unknowns.stretches.size(); ++j) {
    const std::size_t column = unknowns.stretches[j].column;
    state.dead_paths_mm[j] += mm_per_um * step[column];
    if (unknowns.drift) state.drifts_um[j] += step[column + 1];
  }
}

}  // namespace axiometry::volumetric::detail
