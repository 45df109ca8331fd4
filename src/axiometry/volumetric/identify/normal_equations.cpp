// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/normal_equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "axiometry/numeric/outer_sums.h"
#include "axiometry/volumetric/curves/beam_row.h"

namespace axiometry::volumetric::detail {
namespace {

/// Readings that one sum takes: what is added up in which order does not depend on the threads.
constexpr std::size_t chunk_least = 8192;
constexpr std::size_t chunks_most = 8;

std::size_t chunk_count(std::size_t readings) {
  return std::clamp(readings / chunk_least, std::size_t{1}, chunks_most);
}

/// work(chunk, begin, end) for all chunks.
template <typename Work>
void for_chunks(const Problem& problem, const Work& work) {
  const std::size_t n = problem.readings.size(), chunks = chunk_count(n);
  const auto run = [&](std::size_t first, std::size_t step) {
    for (std::size_t c = first; c < chunks; c += step) work(c, n * c / chunks, n * (c + 1) / chunks);
  };
  const std::size_t threads = std::min(std::max(problem.threads, std::size_t{1}), chunks);
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < threads; ++k) others.emplace_back(run, k, threads);
  run(0, threads);
}

Approaches approaches_of(const Problem& problem, std::size_t i) {
  return problem.approaches.empty() ? Approaches{} : problem.approaches[i];
}

/// a of one reading, as pieces of neighbouring columns that rise.
class Row {
 public:
  Row(const Problem& problem, Vector3 u, std::size_t i)
      : beam_(problem.coefficients, problem.machine, problem.readings[i].axes_mm, problem.tool_mm(i),
              approaches_of(problem, i)) {
    const Stretch& stretch = problem.unknowns.stretches[problem.unknowns.stretch_of[i]];
    const VirtualStation& station = problem.unknowns.stations[stretch.virtual_station];
    beam_.along(u);
    for (const BeamRow::Piece& piece : beam_.pieces()) pieces_[count_++] = piece;
    own_ = {-u.x, -u.y, -u.z, -1.0, problem.unknowns.along_stretch[i]};
    pieces_[count_++] = {station.column, 3, own_.data()};
    pieces_[count_++] = {stretch.column, problem.unknowns.drift ? std::size_t{2} : std::size_t{1}, own_.data() + 3};
  }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  std::span<const BeamRow::Piece> pieces() const { return {pieces_.data(), count_}; }

 private:
  BeamRow beam_;
  std::array<double, 5> own_{};
  std::array<BeamRow::Piece, 2 * axis_count + 3> pieces_;
  std::size_t count_ = 0;
};

void add(std::vector<double>& sum, const std::vector<double>& part) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += part[k];
}

}  // namespace

Sights sights(const Problem& problem, const State& state) {
  const std::size_t n = problem.readings.size();
  Sights sights{std::vector<double>(n), std::vector<Vector3>(n)};
  for_chunks(problem, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const VolumetricReading& reading = problem.readings[i];
      const ErrorValues errors =
          problem.coefficients.errors(state.coefficients, reading.axes_mm, approaches_of(problem, i));
      const Vector3 tool = problem.tool_mm(i);
      const Vector3 delta_um = displacement_um(problem.machine, errors, reading.axes_mm, tool);
      const std::size_t stretch = problem.unknowns.stretch_of[i];
      const Vector3 s = state.stations_mm[problem.unknowns.stretches[stretch].virtual_station];
      const Vector3 beam = reading.axes_mm + tool + 1e-3 * delta_um - s;
      const double distance_mm = std::sqrt(dot(beam, beam));
      const double drift_um =
          problem.unknowns.drift ? state.drifts_um[stretch] * problem.unknowns.along_stretch[i] : 0.0;
      sights.beams[i] = 1.0 / distance_mm * beam;
      sights.residuals_um[i] = 1000.0 * (reading.length_mm - (distance_mm - state.dead_paths_mm[stretch])) - drift_um;
    }
  });
  return sights;
}

NormalEquations normal_equations(const Problem& problem, const Sights& sights) {
  const std::size_t n = problem.unknowns.columns;
  std::vector<NormalEquations> parts(chunk_count(problem.readings.size()));
  for_chunks(problem, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    NormalEquations& sum = parts[chunk];
    sum.columns = n;
    sum.matrix.assign(n * n, 0.0);
    sum.gradient.assign(n, 0.0);
    for (std::size_t i = begin; i < end; ++i) {
      if (problem.weights[i] == 0.0) continue;
      const Row row(problem, sights.beams[i], i);
      numeric::add_outer(row.pieces(), problem.weights[i], sum.matrix, n);
      numeric::add_times(row.pieces(), problem.weights[i] * sights.residuals_um[i], sum.gradient);
    }
  });
  for (std::size_t c = 1; c < parts.size(); ++c) {
    add(parts[0].matrix, parts[c].matrix);
    add(parts[0].gradient, parts[c].gradient);
  }
  return std::move(parts[0]);
}

std::vector<double> gradient(const Problem& problem, std::span<const Vector3> beams, std::span<const double> v) {
  std::vector<std::vector<double>> parts(chunk_count(problem.readings.size()));
  for_chunks(problem, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    parts[chunk].assign(problem.unknowns.columns, 0.0);
    for (std::size_t i = begin; i < end; ++i)
      if (problem.weights[i] != 0.0)
        numeric::add_times(Row(problem, beams[i], i).pieces(), problem.weights[i] * v[i], parts[chunk]);
  });
  for (std::size_t c = 1; c < parts.size(); ++c) add(parts[0], parts[c]);
  return std::move(parts[0]);
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
