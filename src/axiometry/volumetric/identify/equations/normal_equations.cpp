// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/equations/normal_equations.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/side_by_side.h"
#include "axiometry/volumetric/identify/equations/row_sums.h"

namespace axiometry::volumetric::detail {
namespace {

/// Readings that one sum takes: what is added up in which order does not depend on the threads.
constexpr std::size_t chunk_least = 1000;
constexpr std::size_t chunks_most = 8;

/// A sum has a matrix of its own, which should cost less than its readings.
std::size_t chunk_count(const Problem& problem) {
  const std::size_t least = std::max(chunk_least, 4 * problem.unknowns.columns);
  return std::clamp(problem.readings.size() / least, std::size_t{1}, chunks_most);
}

/// work(chunk, begin, end) for all chunks.
template <typename Work>
void for_chunks(const Problem& problem, const Work& work) {
  const std::size_t n = problem.readings.size(), chunks = chunk_count(problem);
  numeric::side_by_side(chunks, problem.threads, [&](std::size_t c) { work(c, n * c / chunks, n * (c + 1) / chunks); });
}

/// factor · a of one reading.
void add_times(const Problem& problem, const BeamRow& beam, std::size_t i, Vector3 u, double factor,
               std::vector<double>& sum) {
  beam.add_times(u, factor, sum);
  const BeamStretch& stretch = problem.unknowns.stretches[problem.unknowns.stretch_of[i]];
  const std::size_t station = problem.unknowns.stations[stretch.virtual_station].column;
  for (std::size_t k = 0; k < 3; ++k) sum[station + k] -= factor * u[k];
  sum[stretch.column] -= factor;
  if (problem.unknowns.drift) sum[stretch.column + 1] += factor * problem.unknowns.along_stretch[i];
}

/// One for each chunk, added up in order.
std::vector<double> sum_of(std::vector<std::vector<double>> parts) {
  for (std::size_t c = 1; c < parts.size(); ++c)
    for (std::size_t k = 0; k < parts[0].size(); ++k) parts[0][k] += parts[c][k];
  return std::move(parts[0]);
}

}  // namespace

Sights sights(const Problem& problem, const State& state) {
  const std::size_t n = problem.readings.size();
  Sights sights{std::vector<double>(n), std::vector<Vector3>(n), {}};
  std::vector<std::vector<double>> gradients(chunk_count(problem));
  for_chunks(problem, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    std::vector<double> gradient(problem.unknowns.columns, 0.0);
    for (std::size_t i = begin; i < end; ++i) {
      const VolumetricReading& reading = problem.readings[i];
      const BeamRow row = beam_row(problem, i);
      const Vector3 delta_um = row.displacement_um(state.coefficients);
      const std::size_t stretch = problem.unknowns.stretch_of[i];
      const Vector3 s = state.stations_mm[problem.unknowns.stretches[stretch].virtual_station];
      const Vector3 beam = reading.axes_mm + problem.tool_mm(i) + 1e-3 * delta_um - s;
      const double distance_mm = std::sqrt(dot(beam, beam));
      const double drift_um =
          problem.unknowns.drift ? state.drifts_um[stretch] * problem.unknowns.along_stretch[i] : 0.0;
      sights.beams[i] = 1.0 / distance_mm * beam;
      sights.residuals_um[i] = 1000.0 * (reading.length_mm - (distance_mm - state.dead_paths_mm[stretch])) - drift_um;
      if (problem.weights[i] != 0.0)
        add_times(problem, row, i, sights.beams[i], problem.weights[i] * sights.residuals_um[i], gradient);
    }
    gradients[chunk] = std::move(gradient);
  });
  sights.gradient = sum_of(std::move(gradients));
  return sights;
}

NormalEquations normal_equations(const Problem& problem, const Sights& sights) {
  std::vector<std::vector<double>> parts(chunk_count(problem));
  for_chunks(problem, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    parts[chunk] = row_sums(problem, sights.beams, begin, end);
  });
  NormalEquations equations{problem.unknowns.columns, sum_of(std::move(parts))};
  fill_upper_triangle(problem, equations.matrix);
  return equations;
}

std::vector<double> gradient(const Problem& problem, std::span<const Vector3> beams, std::span<const double> v) {
  std::vector<std::vector<double>> parts(chunk_count(problem));
  for_chunks(problem, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    std::vector<double> sum(problem.unknowns.columns, 0.0);
    for (std::size_t i = begin; i < end; ++i)
      if (problem.weights[i] != 0.0 && v[i] != 0.0)
        add_times(problem, beam_row(problem, i), i, beams[i], problem.weights[i] * v[i], sum);
    parts[chunk] = std::move(sum);
  });
  return sum_of(std::move(parts));
}

State with_stations_joined(const Problem& problem, const State& state) {
  constexpr double alike_mm = 20.0;
  const std::vector<VirtualStation>& stations = problem.unknowns.stations;
  std::size_t count = 0;
  for (const VirtualStation& v : stations) count = std::max(count, v.station + 1);
  std::vector<Vector3> sums(count);
  std::vector<double> counts(count, 0.0);
  for (std::size_t v = 0; v < stations.size(); ++v) {
    sums[stations[v].station] += state.stations_mm[v];
    counts[stations[v].station] += 1.0;
  }
  State joined = state;
  for (std::size_t v = 0; v < stations.size(); ++v) {
    const Vector3 mean = 1.0 / counts[stations[v].station] * sums[stations[v].station];
    if (distance(mean, state.stations_mm[v]) < alike_mm) joined.stations_mm[v] = mean;
  }
  return joined;
}

double chi_squared(const Problem& problem, std::span<const double> residuals) {
  double sum = 0.0;
  for (std::size_t i = 0; i < residuals.size(); ++i) sum += problem.weights[i] * residuals[i] * residuals[i];
  return sum;
}

}  // namespace axiometry::volumetric::detail
