// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "axiometry/simulation/presets.h"
#include "axiometry/simulation/test_support.h"

namespace axiometry::simulation {
namespace {

void record_samples(benchmark::State& state, const Request& request) {
  std::size_t samples = 0;
  double sum = 0.0;
  for (auto _ : state) {
    const auto truth = record(request, {.rate = 20'000.0}, [&](std::span<const Sample> some) -> Result<void> {
      sum += some.back().position;
      return {};
    });
    samples += truth->samples;
  }
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(static_cast<std::int64_t>(samples));
}

/// Samples of an axis with play and a noisy instrument, which is what most recordings need.
void record_plain(benchmark::State& state) {
  VirtualAxis axis;
  axis.backlash.size = um(3.0);
  axis.instrument.noise = um(0.1);
  record_samples(state, request_of(axis));
}
BENCHMARK(record_plain);

/// Samples with every fault at once.
void record_mixed(benchmark::State& state) {
  Request request = request_of({});
  request.axis = find_preset("mixed")->make(request.plan);
  record_samples(state, request);
}
BENCHMARK(record_mixed);

/// One test of 4 targets × 3 runs × 2 directions with every fault: the unit of a study over seeds.
void simulate_mixed(benchmark::State& state) {
  Request request = request_of({});
  request.axis = find_preset("mixed")->make(request.plan);
  for (auto _ : state) benchmark::DoNotOptimize(simulate(request));
}
BENCHMARK(simulate_mixed);

}  // namespace
}  // namespace axiometry::simulation
