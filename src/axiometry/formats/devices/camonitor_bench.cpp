// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <string>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

/// A test of 11 targets, 5 cycles, both directions, with `samples` lines of eight variables per point.
std::string recorded_test(int samples) {
  std::string text = "IOC:TestNumber            2026-01-31 08:00:00.000000 0\n";
  double seconds = 0.0;
  const auto say = [&](std::string_view name, double value, std::string_view severity) {
    seconds += 0.0125;
    const int whole = static_cast<int>(seconds);
    fmt::format_to(std::back_inserter(text), "{:<25} 2026-01-31 {:02}:{:02}:{:09.6f} {:.8f} {}\n", name,
                   9 + whole / 3600, whole / 60 % 60, seconds - whole / 60 * 60, value, severity);
  };
  unsigned state = 1;
  for (int run = 1; run <= 5; ++run)
    for (int k = 0; k < 22; ++k) {
      const bool up = k < 11;
      const int i = up ? k : 21 - k;
      const double target = 50.0 * i;
      say("IOC:X-PosSet", target + (up ? -1 : 1), "");
      say("IOC:X-PosSet", target, "");
      for (int s = 0; s < samples; ++s) {
        state = state * 1664525u + 1013904223u;
        const double noise = (state >> 20) * 1e-7;
        say("IOC:ILD_DownSample", target + noise, "");
        say("IOC:X-PosAct", target, "LOLO MAJOR");
        for (int t = 0; t < 6; ++t) say(t % 2 == 0 ? "IOC:ec0-s10-EL7201-PosAct" : "IOC:X-TempAct", 20 + noise, "");
      }
      fmt::format_to(std::back_inserter(text), "IOC:TestNumber            2026-01-31 10:00:00.000000 {}{}{:02}\n",
                     up ? 1 : 2, run, i + 1);
    }
  return text;
}

void camonitor_log(benchmark::State& state) {
  const std::string text = recorded_test(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const auto test = find_format("camonitor")->read(text);
    if (!test) state.SkipWithError(test.error().to_string().c_str());
    benchmark::DoNotOptimize(test);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(camonitor_log)->Arg(100)->Arg(4000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace axiometry::formats
