// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/studies/bench_monte_carlo.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <span>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/kernels/affine_rows.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/numeric/rows.h"
#include "axiometry/standards/iso230_2/batch.h"

namespace axiometry::app {
namespace {

using numeric::AffineRows;

constexpr std::size_t bench_targets = 11;
constexpr std::size_t bench_runs = 5;
constexpr std::size_t bench_readings = 2 * bench_targets * bench_runs;
constexpr std::size_t draws = bench_readings + bench_runs + 1;  // z, d, c

double position_m(std::size_t i) { return 0.05 + 0.09 * static_cast<double>(i); }

double base_um(Direction direction, std::size_t i) {
  const auto x = static_cast<double>(i);
  const double up = 6.0 * std::sin(0.55 * x) + 0.4 * x;
  return direction == Direction::up ? up : up + 2.5 + 0.6 * std::cos(0.9 * x);
}

/// Readings from draws: row z of the same number, row d of the run, row c.
AffineRows reading_rows() {
  const double scatter = std::sqrt(0.7 * 0.7 + 0.4 * 0.4);
  std::vector<AffineRows::Row> rows;
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < bench_targets; ++i)
      for (std::size_t j = 0; j < bench_runs; ++j)
        rows.push_back(
            {base_um(direction, i),
             {{rows.size(), scatter}, {bench_readings + j, 0.5}, {bench_readings + bench_runs, 1.5 * position_m(i)}}});
  return AffineRows(rows);
}

Series series_of_bases() {
  std::vector<Position> positions;
  std::vector<double> deviations;
  for (std::size_t i = 0; i < bench_targets; ++i) positions.push_back(Position::native(1000.0 * position_m(i)));
  for (Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < bench_targets; ++i)
      deviations.insert(deviations.end(), bench_runs, base_um(direction, i));
  return *Series::make_dense(std::move(positions), bench_runs, std::move(deviations));
}

/// Trials are computed in strips whose draws stay in the processor's cache (60 KB). Readings take the place of the
/// draws that they are made from, so that nothing else must be there.
template <typename Number>
struct StripModel {
  static constexpr std::size_t strip = 512 / sizeof(Number);

  std::uint64_t seed = 0;
  AffineRows rows = reading_rows();
  iso230_2::BatchLayout layout{series_of_bases()};

  /// Always whole strips of draws, so that a trial's are the same however many trials are asked for.
  void operator()(std::uint64_t block, uncertainty::BlockOutputs outputs) const {
    AXIOMETRY_CONTRACT(layout.outputs().size() == std::size(iso230_2::parameters));
    numeric::RandomStream stream({seed, 0, block});
    numeric::RowBuffer<Number> buffer(draws, strip);
    numeric::RowBuffer<Number> result_buffer(layout.outputs().size(), strip);  // numbers of single precision
    for (std::size_t first = 0; first < outputs.trials; first += strip) {
      const std::size_t count = std::min(strip, outputs.trials - first);
      const numeric::Rows<Number> readings = buffer.rows();
      stream.fill_normal(readings.values);
      rows.apply(readings, readings, count);
      if constexpr (std::is_same_v<Number, double>) {  // straight to where they are wanted
        const numeric::Rows<double> results{outputs.values.subspan(first), outputs.trials};
        iso230_2::evaluate_batch(layout, readings, count, results);
      } else {
        iso230_2::evaluate_batch(layout, readings, count, result_buffer.rows());
        for (std::size_t k = 0; k < layout.outputs().size(); ++k)
          std::ranges::copy(result_buffer.rows().row(k, count), outputs.row(k).begin() + first);
      }
    }
  }
};

json::Value summary_json(const uncertainty::OutputSummary& summary) {
  json::Value value = json::Value::object();
  value.add("mean", summary.mean);
  value.add("sd", summary.sd);
  value.add("q025", summary.symmetric.lower);
  value.add("q975", summary.symmetric.upper);
  return value;
}

}  // namespace

uncertainty::BlockModel monte_carlo_bench_model(const MonteCarloBench& bench) {
  if (bench.precision == Precision::both_single) return StripModel<float>{bench.seed};
  return StripModel<double>{bench.seed};
}

Result<json::Value> bench_monte_carlo(const MonteCarloBench& bench) {
  const unsigned threads = bench.threads > 0 ? bench.threads : std::max(1u, std::thread::hardware_concurrency());
  uncertainty::PropagationOptions options;
  options.trials = bench.trials;
  options.threads = threads;
  const auto begin = std::chrono::steady_clock::now();
  AXIOMETRY_TRY(const auto result,
                uncertainty::propagate(monte_carlo_bench_model(bench), std::size(iso230_2::parameters), options));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  json::Value value = json::Value::object();
  value.add("trials", result.trials);
  value.add("threads", std::size_t{threads});
  value.add("seed", static_cast<std::size_t>(bench.seed));
  value.add("precision", bench.precision == Precision::both_single ? "single" : "double");
  value.add("instructions", numeric::vector_target_name(numeric::best_vector_target()));
  value.add("seconds", seconds);
  value.add("trials_per_second", static_cast<double>(result.trials) / seconds);
  for (std::size_t k = 0; k < result.outputs.size(); ++k)
    value.add(iso230_2::parameters[k].key, summary_json(result.outputs[k]));
  return value;
}

}  // namespace axiometry::app
