// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <string>

#include "axiometry/app/bench_monte_carlo.h"
#include "commands.h"

namespace axiometry::cli {
namespace {

int print_monte_carlo(const app::MonteCarloBench& bench) {
  const auto result = app::bench_monte_carlo(bench);
  if (!result) {
    fmt::print(stderr, "axiometry: {}\n", result.error().to_string());
    return exit_bad_input;
  }
  fmt::print("{}\n", json::dump(*result));
  return exit_done;
}

}  // namespace

void add_bench(CLI::App& program, int& exit_code) {
  CLI::App* verb = program.add_subcommand("bench", "Measure how fast this machine computes, as JSON");
  auto what = std::make_shared<std::string>();
  auto bench = std::make_shared<app::MonteCarloBench>();
  auto precision = std::make_shared<std::string>("double");
  verb->add_option("WHAT", *what, "monte-carlo: trials of a whole test a second (docs/performance.md)")
      ->required()
      ->check(CLI::IsMember({"monte-carlo"}));
  verb->add_option("--trials", bench->trials, "Number of trials (1000000)");
  verb->add_option("--threads", bench->threads, "Number of threads, 0 for all of the machine (1)")
      ->check(CLI::Range(0, 1024).description(""));
  verb->add_option("--seed", bench->seed, "Seed of the random numbers, up to 2^53 (1)")
      ->check(CLI::Range(0.0, 9007199254740992.0).description(""));
  verb->add_option("--precision", *precision, "Of the draws and the evaluation: double or single (double)")
      ->check(CLI::IsMember({"double", "single"}));
  verb->callback([what, bench, precision, &exit_code] {
    bench->precision = *precision == "single" ? app::Precision::both_single : app::Precision::both_double;
    exit_code = print_monte_carlo(*bench);
  });
}

}  // namespace axiometry::cli
