// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/normal_equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <thread>

#include "axiometry/numeric/outer_sums.h"
#include "axiometry/volumetric/curves/beam_row.h"

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
    weight_ = problem.weights[i];
  }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  std::span<const BeamRow::Piece> pieces() const { return {pieces_.data(), count_}; }
  numeric::PiecedRow pieced() const { return {pieces_.data(), count_, weight_}; }

 private:
  BeamRow beam_;
  std::array<double, 5> own_{};
  std::array<BeamRow::Piece, 2 * axis_count + 3> pieces_;
  std::size_t count_ = 0;
  double weight_ = 0.0;
};

struct Placed {
  std::uint64_t place = 0;  ///< alike: rows have their pieces at the same columns
  std::size_t reading = 0;
  friend auto operator<=>(const Placed&, const Placed&) = default;
};

/// Readings that count, those of the same stretch and spans of all axes together.
std::vector<Placed> by_place(const Problem& problem, std::size_t begin, std::size_t end) {
  std::vector<Placed> order;
  order.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    if (problem.weights[i] == 0.0) continue;
    constexpr std::uint64_t spans_most = 512;
    std::uint64_t place = problem.unknowns.stretch_of[i];
    const Approaches approaches = approaches_of(problem, i);
    for (std::size_t a = 0; a < axis_count; ++a) {
      place = place * spans_most + problem.coefficients.basis(a).first_active(problem.readings[i].axes_mm[a]);
      place = 2 * place + (approaches[a] != 0.0 ? 1 : 0);
    }
    order.push_back({place, i});
  }
  std::ranges::sort(order);
  return order;
}

BeamRow beam_row(const Problem& problem, std::size_t i) {
  return {problem.coefficients, problem.machine, problem.readings[i].axes_mm, problem.tool_mm(i),
          approaches_of(problem, i)};
}

/// factor · a of one reading.
void add_times(const Problem& problem, const BeamRow& beam, std::size_t i, Vector3 u, double factor,
               std::vector<double>& sum) {
  beam.add_times(u, factor, sum);
  const Stretch& stretch = problem.unknowns.stretches[problem.unknowns.stretch_of[i]];
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
  const std::size_t n = problem.unknowns.columns;
  std::vector<std::vector<double>> parts(chunk_count(problem));
  for_chunks(problem, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    std::vector<double>& matrix = parts[chunk];
    matrix.assign(n * n, 0.0);
    const std::vector<Placed> order = by_place(problem, begin, end);
    const auto row = [&](std::size_t k) { return Row(problem, sights.beams[order[k].reading], order[k].reading); };
    for (std::size_t k = 0; k < order.size();) {
      if (k + 3 < order.size() && order[k].place == order[k + 3].place) {
        const Row rows[4] = {row(k), row(k + 1), row(k + 2), row(k + 3)};
        numeric::add_outers({{rows[0].pieced(), rows[1].pieced(), rows[2].pieced(), rows[3].pieced()}}, matrix, n);
        k += 4;
      } else {
        numeric::add_outer(row(k).pieces(), problem.weights[order[k].reading], matrix, n);
        ++k;
      }
    }
  });
  return {n, sum_of(std::move(parts))};
}

std::vector<double> gradient(const Problem& problem, std::span<const Vector3> beams, std::span<const double> v) {
  std::vector<std::vector<double>> parts(chunk_count(problem));
  for_chunks(problem, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    std::vector<double> sum(problem.unknowns.columns, 0.0);
    for (std::size_t i = begin; i < end; ++i)
      if (problem.weights[i] != 0.0)
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
