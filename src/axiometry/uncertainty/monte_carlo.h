// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"

/// Propagation of distributions by the Monte Carlo method (JCGM 101:2008, clauses 7 and 8): runs a model block
/// by block, on any number of threads with the same result to the bit, in memory that does not grow with the
/// number of trials. Knows nothing of what the outputs mean.
namespace axiometry::uncertainty {

/// Trials that share one block of random numbers (numeric::RandomKey::block).
inline constexpr std::size_t block_size = 10'000;

/// The outputs of a block: one row per output, `trials` values each.
struct BlockOutputs {
  std::span<double> values;
  std::size_t trials = 0;
  std::span<double> row(std::size_t output) const { return values.subspan(output * trials, trials); }
};

/// Computes one block. Pure: the same block number gives the same values; called from several threads.
using BlockModel = std::function<void(std::uint64_t block, BlockOutputs outputs)>;

struct Progress {
  std::size_t trials = 0;         ///< done
  std::optional<std::size_t> of;  ///< to do, where it is known
};

struct MonteCarloOptions {
  /// Rounded up to whole blocks only in the work, never in the result. Absent: adaptive (7.9), at least ten
  /// blocks, until the numerical tolerance of every output is met.
  std::optional<std::size_t> trials;
  std::size_t trials_max = 20'000'000;  ///< adaptive runs end here, unstable outputs marked
  int digits = 2;                       ///< significant digits of u(y) that shall be stable (7.9.2)
  double coverage = 0.95;               ///< p
  unsigned threads = 0;                 ///< 0: as many as the machine has
  /// Called now and then from the calling thread; returning false stops cleanly.
  std::function<bool(const Progress&)> on_progress;
};

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

/// Equal bins over the interesting part of the distribution, for drawing.
struct Histogram {
  double lower = 0.0;
  double width = 0.0;  ///< of one bin
  std::vector<std::uint64_t> counts;
};

/// What is known about one output.
struct OutputSummary {
  double mean = 0.0;         ///< y, 7.6
  double sd = 0.0;           ///< u(y), 7.6
  Interval symmetric;        ///< probabilistically symmetric coverage interval, 7.7
  Interval shortest;         ///< 7.7
  double mean_error = 0.0;   ///< standard error of y from the finite number of trials
  double sd_error = 0.0;     ///< of u(y)
  Interval symmetric_error;  ///< of the end points of the symmetric interval
  double tolerance = 0.0;    ///< δ, numerical tolerance of u(y), 7.9.2
  bool stable = false;       ///< twice each standard error is at most δ, 7.9.4
  Histogram histogram;
  /// Estimate of P(output ≤ x), from the fine counts.
  std::function<double(double)> probability_below;
};

struct MonteCarloResult {
  std::vector<OutputSummary> outputs;
  std::size_t trials = 0;
  bool adaptive = false;
};

/// Fails when on_progress stopped it, when an output is not finite, and on options that make no sense
/// (fewer than 100 trials, coverage outside 0 to 1, digits outside 1 to 4).
Result<MonteCarloResult> propagate(const BlockModel& model, std::size_t outputs, const MonteCarloOptions& options);

}  // namespace axiometry::uncertainty
