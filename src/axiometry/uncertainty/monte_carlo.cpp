// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/monte_carlo.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "axiometry/base/contract.h"
#include "axiometry/base/counted.h"
#include "axiometry/uncertainty/fine_counts.h"

namespace axiometry::uncertainty {
namespace {

constexpr std::size_t first_blocks = 10;    // blocks with which an adaptive run begins
constexpr std::size_t round_blocks = 1024;  // blocks of a round; their figures are held until they are added in order

/// What one block says about one output.
struct BlockFigures {
  ValueMoments moments;
  Interval symmetric;  // computed only in adaptive runs
};

/// A value that no figure can be made from.
struct Spoiled {
  std::size_t block = 0;
  std::size_t output = 0;
  std::size_t trial = 0;
  double value = 0.0;
};

/// Mean and scatter of a figure over the blocks, in their order.
struct Scatter {
  double count = 0.0, mean = 0.0, squares = 0.0;

  void add(double x) {
    count += 1.0;
    const double difference = x - mean;
    mean += difference / count;
    squares += difference * (x - mean);
  }
  double sd() const { return std::sqrt(squares / (count - 1.0)); }
};

struct OutputScatter {
  Scatter mean, sd, lower, upper;
};

/// Everything that one thread counts.
struct Tally {
  std::vector<FineCounts> counts;  // one per output
  std::vector<double> values;
  FineCounts block{CoreLayout{}};
};

class Run {
 public:
  Run(const BlockModel& model, std::size_t outputs, const PropagationOptions& options)
      : model_(model), outputs_(outputs), options_(options), adaptive_(!options.trials) {
    AXIOMETRY_CONTRACT(options.least_tolerances.empty() || options.least_tolerances.size() == outputs);
    trials_end_ = adaptive_ ? options.trials_max : *options.trials;
    const std::size_t wanted =
        options.threads != 0 ? options.threads : std::max(1u, std::thread::hardware_concurrency());
    threads_ = std::min(wanted, std::max<std::size_t>(1, (trials_end_ + block_size - 1) / block_size));
  }

  Result<MonteCarloResult> carry_out() {
    const std::size_t all_blocks = (trials_end_ + block_size - 1) / block_size;
    std::size_t wanted = adaptive_ ? std::min(first_blocks, all_blocks) : all_blocks;
    lay_out();
    while (!spoiled_) {
      while (done_ < wanted && !spoiled_) AXIOMETRY_TRY_VOID(round(std::min(wanted, done_ + round_blocks), wanted));
      if (spoiled_ || !adaptive_ || done_ == all_blocks) break;
      const std::size_t needed = blocks_needed();
      if (needed <= done_) break;
      wanted = std::min({needed, 4 * done_, all_blocks});
    }
    if (spoiled_) return refuse();
    return summarise();
  }

 private:
  std::size_t trials_of(std::size_t block) const { return std::min(block_size, trials_end_ - block * block_size); }
  std::size_t trials_in(std::size_t blocks) const { return std::min(blocks * block_size, trials_end_); }

  /// Lays the cells out from the values of the first block and counts them.
  void lay_out() {
    tallies_.resize(1);
    tallies_[0].values.resize(outputs_ * block_size);
    const BlockOutputs values = computed(tallies_[0], 0);
    for (std::size_t k = 0; k < outputs_; ++k) {
      const auto row = values.row(k);
      const bool usable = std::isfinite(ValueMoments::of(row, row[0]).squares);
      layouts_.push_back(usable ? CoreLayout::from_first(row, options_.coverage) : CoreLayout{});
    }
    for (std::size_t t = 1; t < threads_; ++t) tallies_.emplace_back().values.resize(outputs_ * block_size);
    for (Tally& tally : tallies_) {
      tally.counts.reserve(outputs_);  // counts are large, and are not moved then
      for (const CoreLayout& layout : layouts_) tally.counts.emplace_back(layout);
    }
    moments_.resize(outputs_);
    scatter_.resize(outputs_);
    slots_.resize(outputs_);
    count(tallies_[0], 0, values);
    if (!spoiled_) add_slots(1);
  }

  BlockOutputs computed(Tally& tally, std::size_t block) const {
    const std::size_t n = trials_of(block);
    BlockOutputs outputs{std::span(tally.values).first(outputs_ * n), n};
    model_(block, outputs);
    return outputs;
  }

  void count(Tally& tally, std::size_t block, const BlockOutputs& values) {
    const auto n = static_cast<double>(values.trials);
    for (std::size_t k = 0; k < outputs_; ++k) {
      const auto row = values.row(k);
      BlockFigures figures;
      if (adaptive_) {
        tally.block.clear(layouts_[k]);
        figures.moments = tally.block.add(row);
      } else {
        figures.moments = tally.counts[k].add(row);
      }
      if (!std::isfinite(figures.moments.squares)) return spoil(block, k, row);
      if (adaptive_) {
        const Interval extremes{figures.moments.min, figures.moments.max};
        figures.symmetric = {tally.block.quantile(n * (1.0 - options_.coverage) / 2, extremes),
                             tally.block.quantile(n * (1.0 + options_.coverage) / 2, extremes)};
        tally.counts[k].add(tally.block);
      }
      slots_[(block - done_) * outputs_ + k] = figures;
    }
  }

  /// Blocks are given out in order, so every one before the first spoiled one is completed as well, and the value that
  /// is reported does not depend on the number of threads.
  void spoil(std::size_t block, std::size_t output, std::span<const double> row) {
    const auto too_large = [](double x) { return !(std::abs(x) <= 1e150); };
    const auto at = std::ranges::find_if(row, too_large);
    const std::lock_guard lock(mutex_);
    if (!spoiled_ || block < spoiled_->block)
      spoiled_ = Spoiled{block, output, static_cast<std::size_t>(at - row.begin()),
                         at == row.end()   ? row[0]
                         : std::isnan(*at) ? std::abs(*at)
                                           : *at};
    stop_ = true;
  }

  /// The blocks up to `end` on all threads; the calling thread watches.
  Result<void> round(std::size_t end, std::size_t wanted) {
    slots_.resize((end - done_) * outputs_);
    next_ = done_;
    finished_ = 0;
    working_ = std::min(threads_, end - done_);
    bool stopped = false;
    {
      std::vector<std::jthread> threads;
      for (std::size_t t = 0, n = working_; t < n; ++t)
        threads.emplace_back([this, t, end] { work(tallies_[t], end); });
      std::unique_lock lock(mutex_);
      while (!all_left_.wait_for(lock, std::chrono::milliseconds(100), [this] { return working_ == 0; })) {
        if (!options_.on_progress || stopped) continue;
        const Progress progress{trials_in(done_ + finished_), trials_in(wanted)};
        lock.unlock();
        if (!options_.on_progress(progress)) stopped = stop_ = true;
        lock.lock();
      }
    }
    if (thrown_) std::rethrow_exception(thrown_);
    if (stopped) return fail(fmt::format("stopped after {} trials", trials_in(done_ + finished_)));
    if (!spoiled_) add_slots(end - done_);
    if (options_.on_progress && !spoiled_ && !options_.on_progress({trials_in(done_), trials_in(wanted)}))
      return fail(fmt::format("stopped after {} trials", trials_in(done_)));
    return {};
  }

  void work(Tally& tally, std::size_t end) {
    try {
      while (!stop_) {
        const std::size_t block = next_++;
        if (block >= end) break;
        count(tally, block, computed(tally, block));
        ++finished_;
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
      stop_ = true;
    }
    const std::lock_guard lock(mutex_);
    if (--working_ == 0) all_left_.notify_one();
  }

  /// Adds the figures of the blocks of a round in their order.
  void add_slots(std::size_t blocks) {
    for (std::size_t b = 0; b < blocks; ++b)
      for (std::size_t k = 0; k < outputs_; ++k) {
        const BlockFigures& figures = slots_[b * outputs_ + k];
        moments_[k].add(figures.moments);
        if (trials_of(done_ + b) < block_size) continue;  // a short block scatters more
        scatter_[k].mean.add(figures.moments.mean);
        scatter_[k].sd.add(figures.moments.sd());
        scatter_[k].lower.add(figures.symmetric.lower);
        scatter_[k].upper.add(figures.symmetric.upper);
      }
    done_ += blocks;
  }

  bool by_blocks() const { return adaptive_ && scatter_[0].mean.count >= static_cast<double>(first_blocks); }

  LeastTolerance tolerance_of(std::size_t k) const {
    const double own = numerical_tolerance(moments_[k].sd(), options_.digits);
    if (options_.least_tolerances.empty()) return {own, own};
    const LeastTolerance least = options_.least_tolerances[k];
    return {std::max(own, least.u), std::max(own, least.ends)};
  }

  /// 7.9.4: as many as make twice the standard error of every figure of every output at most δ.
  std::size_t blocks_needed() const {
    double needed = 0.0;
    for (std::size_t k = 0; k < outputs_; ++k) {
      const OutputScatter& s = scatter_[k];
      const LeastTolerance tolerance = tolerance_of(k);
      const auto need = [&](double sd, double enough) {
        if (sd > 0.0) needed = std::max(needed, 4.0 * sd * sd / (enough * enough));
      };
      need(std::max(s.mean.sd(), s.sd.sd()), tolerance.u);
      need(std::max(s.lower.sd(), s.upper.sd()), tolerance.ends);
    }
    return needed < 1e9 ? static_cast<std::size_t>(std::ceil(needed)) : std::size_t{1'000'000'000};
  }

  std::unexpected<Error> refuse() const {
    return fail(fmt::format("found the value {} of output {} in trial {}, expected a finite one of at most 1e150",
                            spoiled_->value, spoiled_->output + 1, spoiled_->block * block_size + spoiled_->trial + 1));
  }

  MonteCarloResult summarise() {
    MonteCarloResult result{{}, trials_in(done_), adaptive_};
    for (std::size_t k = 0; k < outputs_; ++k) {
      FineCounts& counts = tallies_[0].counts[k];
      for (std::size_t t = 1; t < tallies_.size(); ++t) counts.add(tallies_[t].counts[k]);
      result.outputs.push_back(summary(k, counts));
    }
    return result;
  }

  OutputSummary summary(std::size_t k, const FineCounts& counts) const {
    const ValueMoments& moments = moments_[k];
    OutputSummary out;
    out.mean = moments.mean;
    out.sd = moments.sd();
    out.distribution = counts.distribution({moments.min, moments.max});
    out.symmetric = out.distribution.symmetric_interval(options_.coverage);
    out.shortest = out.distribution.shortest_interval(options_.coverage);
    out.histogram = counts.histogram(out.distribution);
    out.tolerance = numerical_tolerance(out.sd, options_.digits);
    if (by_blocks()) {
      const OutputScatter& s = scatter_[k];
      const double root = std::sqrt(moments.count / static_cast<double>(block_size));
      out.mean_error = s.mean.sd() / root;
      out.sd_error = s.sd.sd() / root;
      out.symmetric_error = {s.lower.sd() / root, s.upper.sd() / root};
    } else {
      const double variance = out.sd * out.sd, root = std::sqrt(moments.count);
      const double spread = out.distribution.fourth_moment(out.mean) - variance * variance;
      out.mean_error = out.sd / root;
      out.sd_error = out.sd > 0.0 ? std::sqrt(std::max(spread, 0.0)) / (2 * out.sd * root) : 0.0;
      out.symmetric_error = {out.distribution.quantile_error((1.0 - options_.coverage) / 2),
                             out.distribution.quantile_error((1.0 + options_.coverage) / 2)};
    }
    const LeastTolerance tolerance = tolerance_of(k);
    out.stable = 2 * std::max(out.mean_error, out.sd_error) <= tolerance.u &&
                 2 * std::max(out.symmetric_error.lower, out.symmetric_error.upper) <= tolerance.ends;
    return out;
  }

  const BlockModel& model_;
  const std::size_t outputs_;
  const PropagationOptions& options_;
  const bool adaptive_;
  std::size_t trials_end_ = 0;
  std::size_t threads_ = 1;

  std::size_t done_ = 0;  // blocks whose figures are added
  std::vector<CoreLayout> layouts_;
  std::vector<Tally> tallies_;
  std::vector<ValueMoments> moments_;
  std::vector<OutputScatter> scatter_;
  std::vector<BlockFigures> slots_;  // of the blocks of a round

  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> finished_ = 0;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;  // guards the members that follow
  std::condition_variable all_left_;
  std::size_t working_ = 0;
  std::optional<Spoiled> spoiled_;
  std::exception_ptr thrown_;
};

Result<void> check_options(const PropagationOptions& options) {
  const std::size_t trials = options.trials.value_or(options.trials_max);
  if (trials < 100) return fail(fmt::format("found {}, expected at least 100", counted(trials, "trial")));
  if (trials > 4'000'000'000) return fail(fmt::format("found {} trials, expected at most 4000000000", trials));
  if (!(options.coverage > 0.0 && 0.5 + 0.5 * options.coverage < 1.0))
    return fail(fmt::format("found the coverage probability {}, expected one between 0 and 1", options.coverage));
  if (options.digits < 1 || options.digits > 4)
    return fail(fmt::format("found {} significant digits, expected 1 to 4", options.digits));
  return {};
}

}  // namespace

double numerical_tolerance(double standard_uncertainty, int digits) {
  if (!(standard_uncertainty > 0.0)) return 0.0;
  int exponent = static_cast<int>(std::floor(std::log10(standard_uncertainty))) - digits + 1;
  // 9.96 with two digits is 10, whose last digit is a whole one.
  if (std::round(standard_uncertainty / std::pow(10.0, exponent)) >= std::pow(10.0, digits)) ++exponent;
  return 0.5 * std::pow(10.0, exponent);
}

Result<MonteCarloResult> propagate(const BlockModel& model, std::size_t outputs, const PropagationOptions& options) {
  AXIOMETRY_CONTRACT(outputs > 0);
  AXIOMETRY_TRY_VOID(check_options(options));
  return Run(model, outputs, options).carry_out();
}

}  // namespace axiometry::uncertainty
