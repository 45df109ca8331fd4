// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include "cli/failure.h"
#include "cli/flags/verb.h"

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/studies/bench_monte_carlo.h"
#include "axiometry/app/studies/bench_volumetric.h"
#include "axiometry/base/text/text.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

struct Range {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};

/// A flag for a whole number; CLI11 itself would take −5 for 2⁶⁴ − 5.
template <typename Number>
void add_whole_number(const Verb& verb, const std::string& name, Number& target, Range range, const std::string& help) {
  verb.add_option_function<std::string>(
          name,
          [name, &target, range](const std::string& word) {
            std::uint64_t number = 0;
            const char* const end = word.data() + word.size();
            const auto [rest, fault] = std::from_chars(word.data(), end, number);
            if (fault != std::errc() || rest != end || number < range.first || number > range.last)
              throw UsageError(name, fmt::format("found {}, expected a whole number from {} to {}", text::quoted(word),
                                                 range.first, range.last));
            target = static_cast<Number>(number);
          },
          help)
      ->type_name("N");
}

int print_result(const Result<json::Value>& result) {
  if (!result) return failed(result.error());
  fmt::print("{}\n", json::dump(*result));
  return exit_done;
}

app::Precision precision_of(const std::string& word) {
  if (word == "double") return app::Precision::both_double;
  if (word == "single") return app::Precision::both_single;
  throw UsageError("--precision", fmt::format("found {}, expected double or single", text::quoted(word)));
}

}  // namespace

void add_bench(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("bench", "Measure how fast this machine computes, as JSON");
  auto what = std::make_shared<std::string>();
  auto bench = std::make_shared<app::MonteCarloBench>();
  auto volumetric = std::make_shared<app::VolumetricBench>();
  verb->add_option(
          "WHAT", *what,
          "monte-carlo: trials of a whole test a second; volumetric: 21 errors from lengths (docs/performance.md)")
      ->required();
  add_whole_number(*verb, "--trials", bench->trials, {100, 4'000'000'000}, "Number of trials (1000000)");
  add_whole_number(*verb, "--threads", bench->threads, {0, 1024}, "Number of threads, 0 for all of the machine (1)");
  add_whole_number(*verb, "--seed", bench->seed, {0, app::seed_limit - 1}, "Seed of the random numbers (1)");
  verb->add_option_function<std::string>(
          "--precision", [bench](const std::string& word) { bench->precision = precision_of(word); },
          "Of the draws and the evaluation: double or single (double)")
      ->type_name("KIND");
  add_whole_number(*verb, "--observations", volumetric->observations, {400, 10'000'000},
                   "Lengths of the volumetric calibration (2000)");
  verb->callback([what, bench, volumetric, &exit_code] {
    volumetric->threads = bench->threads;
    volumetric->seed = bench->seed;
    if (*what == "monte-carlo")
      exit_code = print_result(app::bench_monte_carlo(*bench));
    else if (*what == "volumetric")
      exit_code = print_result(app::bench_volumetric(*volumetric));
    else
      throw UsageError("WHAT", fmt::format("found {}, expected monte-carlo or volumetric", text::quoted(*what)));
  });
}

}  // namespace axiometry::cli
