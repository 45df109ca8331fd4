// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/uncertainty/sampled_distribution.h"

/// Propagation of distributions by the Monte Carlo method (JCGM 101:2008, clauses 7 and 8): runs a model block
/// by block, on any number of threads with the same result to the bit, in memory that does not grow with the
/// number of trials. Knows nothing of what the outputs mean.
///
/// Adaptive runs follow 7.9 with two changes. They begin with ten blocks, not two: the standard deviation of two
/// values is too erratic to stop by. Then they look again after as many blocks as the tolerance is expected to need
/// (at most four times as many as before), so that the number of trials does not depend on the number of threads.
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
  std::size_t trials = 0;         ///< trials that are done
  std::optional<std::size_t> of;  ///< how much there is to do, where that is known
};

/// What δ of an output is at least.
struct LeastTolerance {
  double u = 0.0;     ///< tolerance of mean and standard uncertainty
  double ends = 0.0;  ///< tolerance of the ends of the interval
};

struct PropagationOptions {
  /// Rounded up to whole blocks only in the work, never in the result. Absent: adaptive (7.9), at least ten
  /// blocks, until the numerical tolerance of every output is met.
  std::optional<std::size_t> trials = std::nullopt;
  std::size_t trials_max = 20'000'000;  ///< adaptive runs end here, unstable outputs marked
  int digits = 2;                       ///< significant digits of u(y) that shall be stable (7.9.2)
  /// Of every output; empty: what its own u says. For one of several models of the same outputs, of whose figures those
  /// of the others may be the ones that are stated.
  std::vector<LeastTolerance> least_tolerances = {};
  double coverage = 0.95;  ///< p
  unsigned threads = 0;    ///< 0: as many as the machine has
  /// Called about ten times a second from the calling thread; returning false stops within a block per thread.
  std::function<bool(const Progress&)> on_progress = {};
};

/// What is known about one output.
struct OutputSummary {
  double mean = 0.0;         ///< y, 7.6
  double sd = 0.0;           ///< u(y), 7.6
  Interval symmetric;        ///< probabilistically symmetric coverage interval, 7.7
  Interval shortest;         ///< 7.7
  double mean_error = 0.0;   ///< standard error of y from the finite number of trials
  double sd_error = 0.0;     ///< standard error of u(y)
  Interval symmetric_error;  ///< standard errors of the end points of the symmetric interval
  double tolerance = 0.0;    ///< δ, numerical tolerance of u(y), 7.9.2
  bool stable = false;       ///< twice each standard error is at most δ, 7.9.4, or what was asked for
  Histogram histogram;
  SampledDistribution distribution;  ///< P(output ≤ x), quantiles
};

struct MonteCarloResult {
  std::vector<OutputSummary> outputs;
  std::size_t trials = 0;
  bool adaptive = false;
};

/// δ of 7.9.2: half a unit of the last of `digits` significant digits of u; 0 for u = 0.
double numerical_tolerance(double standard_uncertainty, int digits);

/// Standard errors come from the scatter of blocks in an adaptive run (7.9.4), else from the moments and ranks of all
/// trials. Fails when on_progress stopped it, when an output is not finite or is beyond 1e150, and on options that
/// make no sense (trials below 100 or above 4e9, coverage outside 0 to 1, digits outside 1 to 4). Contract: least
/// tolerances of all outputs or none. What the model throws is thrown here.
Result<MonteCarloResult> propagate(const BlockModel& model, std::size_t outputs, const PropagationOptions& options);

}  // namespace axiometry::uncertainty
