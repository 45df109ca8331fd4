// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "axiometry/report/drawing/svg.h"
#include "axiometry/report/figures/figures_test_support.h"

namespace axiometry::report {
namespace {

/// All figures of the worked example of ISO 230-2:2014 as SVG.
void figures_to_svg(benchmark::State& state) {
  const auto example = testing::table_2();
  for (auto _ : state) {
    for (const Figure& figure : example.draw()) benchmark::DoNotOptimize(to_svg(figure));
  }
}
BENCHMARK(figures_to_svg)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace axiometry::report
