// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "axiometry/report/figures/figures_test_support.h"
#include "axiometry/report/writer.h"

namespace axiometry::report {
namespace {

/// The whole page for the worked example of ISO 230-2:2014, figures included.
void html_report(benchmark::State& state) {
  const auto example = testing::table_2();
  for (auto _ : state) benchmark::DoNotOptimize(find_writer("html")->write(example.subject(), example.options));
}
BENCHMARK(html_report)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace axiometry::report
