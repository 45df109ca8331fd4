// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/standstill.h"

#include <benchmark/benchmark.h>

#include <cmath>

namespace axiometry::capture {
namespace {

/// 20 million samples at 100 kHz: 1 s of motion over 20 mm, 2 s of rest, and so on, with noise of 0.1 µm.
const std::vector<Sample>& recording() {
  static const std::vector<Sample> samples = [] {
    constexpr double rate_hz = 100'000.0;
    constexpr std::size_t count = 20'000'000;
    std::vector<Sample> made(count);
    unsigned state = 1;
    for (std::size_t k = 0; k < count; ++k) {
      const double t = static_cast<double>(k) / rate_hz;
      const double cycle = std::floor(t / 3.0);
      const double u = std::min(t - 3.0 * cycle, 1.0);
      const double up = std::fmod(cycle, 2.0) == 0.0 ? 1.0 : -1.0;
      state = state * 1664525u + 1013904223u;
      const double noise = 0.0003 * (static_cast<double>(state) / 4294967296.0 - 0.5);
      made[k] = {t, (up > 0 ? 0.0 : 20.0) + up * 20.0 * u * u * (3.0 - 2.0 * u) + noise};
    }
    return made;
  }();
  return samples;
}

void standstill_detection(benchmark::State& state) {
  const std::vector<Sample>& samples = recording();
  for (auto _ : state) {
    StandstillDetector detector({});
    std::size_t found = detector.push(samples).size() + detector.interrupt().size();
    if (found != 67) state.SkipWithError("not every standstill was found");
    benchmark::DoNotOptimize(found);
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(samples.size()));
}
BENCHMARK(standstill_detection)->Unit(benchmark::kMillisecond);

void cell_sums(benchmark::State& state) {
  const auto cell = std::span(recording()).first(12'500);
  for (auto _ : state) benchmark::DoNotOptimize(sums_of(cell));
  state.SetItemsProcessed(state.iterations() * 12'500);
}
BENCHMARK(cell_sums);

}  // namespace
}  // namespace axiometry::capture
