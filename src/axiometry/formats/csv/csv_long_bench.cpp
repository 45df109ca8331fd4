// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>

#include "axiometry/formats/csv/fixed_point.h"
#include "axiometry/formats/format.h"
#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::formats {
namespace {

/// 300 kB to 300 MB of tests of 11 targets, 5 runs, both directions, as tools/make_big_csv.py writes them.
std::string many_tests(int test_count) {
  std::string text = "test,target_mm,direction,run,deviation_um\n";
  unsigned state = 1;
  for (int t = 0; t < test_count; ++t)
    for (int run = 1; run <= 5; ++run)
      for (int k = 0; k < 22; ++k) {
        const int i = k < 11 ? k : 21 - k;
        state = state * 1664525u + 1013904223u;
        const double x = static_cast<int>(state >> 20) / 256.0 - 8.0;
        fmt::format_to(std::back_inserter(text), "T{:06},{:.3f},{},{},{:.1f}\n", t + 1, 6.711 + 174.4 * i,
                       k < 11 ? "up" : "down", run, x);
      }
  return text;
}

class Memory : public ByteReader {
 public:
  explicit Memory(std::string_view text) : text_(text) {}
  Result<std::size_t> read(std::span<char> buffer) override {
    const std::size_t count = std::min(buffer.size(), text_.size());
    std::memcpy(buffer.data(), text_.data(), count);
    text_.remove_prefix(count);
    return count;
  }

 private:
  std::string_view text_;
};

void read_many(benchmark::State& state, bool evaluated) {
  const std::string text = many_tests(1000);
  const Format& format = *find_format("csv-long");
  for (auto _ : state) {
    Memory memory(text);
    double sum = 0.0;
    const auto done = format.read_many(memory, [&](NamedTest&& test) -> Result<void> {
      if (evaluated) {
        sum += iso230_2::evaluate(test.series).parameters.A->in_native();
      } else {
        sum += test.series.travel_native();
      }
      return {};
    });
    if (!done) state.SkipWithError(done.error().to_string().c_str());
    benchmark::DoNotOptimize(sum);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(text.size()));
}

void csv_long_many(benchmark::State& state) { read_many(state, false); }
void csv_long_many_evaluated(benchmark::State& state) { read_many(state, true); }
BENCHMARK(csv_long_many);
BENCHMARK(csv_long_many_evaluated);

void csv_long_one_test(benchmark::State& state) {
  std::string text = many_tests(1);
  std::string plain = "target_mm,direction,run,deviation_um\n";
  for (std::size_t k = text.find('\n') + 1; k < text.size(); k = text.find('\n', k) + 1)
    plain += text.substr(text.find(',', k) + 1, text.find('\n', k) - text.find(',', k));
  for (auto _ : state) benchmark::DoNotOptimize(find_format("csv-long")->read(plain));
}
BENCHMARK(csv_long_one_test);

constexpr std::string_view numbers = "-1.2,175.077,1055.890,0.35,-12.4375,6.711,";
constexpr std::string_view padding = "                                                        ";

void number_fixed_point(benchmark::State& state) {
  const std::string text = std::string(numbers) + std::string(padding);
  for (auto _ : state) {
    double sum = 0.0;
    for (const char* p = text.data(); *p != ' ';) {
      const FixedPoint number = read_fixed_point(p, '.');
      sum += number.value;
      p = number.end + 1;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * 6);
}
BENCHMARK(number_fixed_point);

void number_from_chars(benchmark::State& state) {
  for (auto _ : state) {
    double sum = 0.0;
    for (const char* p = numbers.data(); p < numbers.data() + numbers.size();) {
      double value = 0.0;
      p = std::from_chars(p, numbers.data() + numbers.size(), value).ptr + 1;
      sum += value;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * 6);
}
BENCHMARK(number_from_chars);

}  // namespace
}  // namespace axiometry::formats
