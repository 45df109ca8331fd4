// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/settled_trials.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace axiometry::iso230_2 {
namespace {

constexpr double first_share = 0.97;  // 20 000 trials know u to 1 %, of heavy tails to 2 %

/// What is stated has the digits of the largest u and of half the widest interval of all hypotheses: none needs to be
/// known better. `share` of both sizes counts.
void widen(uncertainty::LeastTolerance& tolerance, const uncertainty::OutputSummary& own, int digits,
           double share = 1.0) {
  const double half = 0.5 * (own.symmetric.upper - own.symmetric.lower);
  tolerance.u = std::max(tolerance.u, uncertainty::numerical_tolerance(share * own.sd, digits));
  tolerance.ends = std::max(tolerance.ends, uncertainty::numerical_tolerance(share * half, digits));
}

/// That of every output, from no more trials than tell how large it is, and of a little less: what is found in the end
/// may be just below a power of ten that these trials were above.
Result<std::vector<uncertainty::LeastTolerance>> stated_tolerances(std::span<const SettledTrials> models,
                                                                   uncertainty::PropagationOptions options) {
  options.trials = 2 * uncertainty::block_size;
  std::vector<uncertainty::LeastTolerance> tolerances(models.front().trials().output_count());
  for (const SettledTrials& model : models) {
    AXIOMETRY_TRY(const auto own, uncertainty::propagate(std::cref(model), tolerances.size(), options));
    for (std::size_t k = 0; k < tolerances.size(); ++k)
      widen(tolerances[k], own.outputs[k], options.digits, first_share);
  }
  return tolerances;
}

/// Whether all of them are known as well as that, after however many trials.
bool is_stable(std::span<const uncertainty::OutputSummary> hypotheses, int digits) {
  uncertainty::LeastTolerance tolerance;
  for (const uncertainty::OutputSummary& own : hypotheses) widen(tolerance, own, digits);
  return std::ranges::all_of(hypotheses, [&](const uncertainty::OutputSummary& own) {
    return own.sd == 0.0 || (2 * std::max(own.mean_error, own.sd_error) <= tolerance.u &&
                             2 * std::max(own.symmetric_error.lower, own.symmetric_error.upper) <= tolerance.ends);
  });
}

}  // namespace

void find_envelope(ParameterDistribution& d) {
  d.low = d.by_hypothesis.front().symmetric.lower;
  d.high = d.by_hypothesis.front().symmetric.upper;
  for (std::size_t h = 1; h < d.by_hypothesis.size(); ++h) {
    const uncertainty::OutputSummary& own = d.by_hypothesis[h];
    const double low = own.symmetric.lower + std::min(0.0, d.shift_of(h));
    const double high = own.symmetric.upper + std::max(0.0, d.shift_of(h));
    if (low < d.low) {
      d.low = low;
      d.low_from = h;
    }
    if (high > d.high) {
      d.high = high;
      d.high_from = h;
    }
    if (own.sd > d.by_hypothesis[d.summary_from].sd) d.summary_from = h;
  }
  d.summary = d.by_hypothesis[d.summary_from];
}

SettledTrials::SettledTrials(TrialModel model, const Series& series, std::vector<double> measured)
    : model_(std::move(model)), measured_(std::move(measured)) {
  double largest = 0.0;  // errors of length grow with the position: 1 µm at 1 mm is far beyond any of them
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    largest = std::max(largest, std::abs(series.targets()[i].in_native()));
    for (Direction direction : {Direction::up, Direction::down})
      for (double x : series.cell(i, direction))
        if (!std::isnan(x)) largest = std::max(largest, std::abs(x));
  }
  slack_ = rounding * largest;
}

void SettledTrials::operator()(std::uint64_t block, uncertainty::BlockOutputs outputs) const {
  model_(block, outputs);
  for (std::size_t k = 0; k < measured_.size(); ++k) {
    const auto row = outputs.row(k);
    const auto settled = [&](double x) { return std::abs(x - measured_[k]) <= slack_; };
    if (std::ranges::all_of(row, settled)) std::ranges::fill(row, measured_[k]);
  }
}

Result<HypothesesRun> run_hypotheses(std::span<const SettledTrials> models, std::span<const double> measured,
                                     uncertainty::PropagationOptions propagation) {
  if (!propagation.trials && models.size() > 1) {
    AXIOMETRY_TRY(propagation.least_tolerances, stated_tolerances(models, propagation));
  }
  HypothesesRun run;
  run.distributions.resize(measured.size());
  for (const SettledTrials& model : models) {
    AXIOMETRY_TRY(auto own, uncertainty::propagate(std::cref(model), measured.size(), propagation));
    run.trials = std::max(run.trials, own.trials);
    run.adaptive = own.adaptive;
    for (std::size_t k = 0; k < measured.size(); ++k)
      run.distributions[k].by_hypothesis.push_back(std::move(own.outputs[k]));
  }
  for (std::size_t k = 0; k < measured.size(); ++k) {
    ParameterDistribution& d = run.distributions[k];
    d.value = measured[k];
    find_envelope(d);
    if (d.by_hypothesis.size() > 1) d.summary.stable = is_stable(d.by_hypothesis, propagation.digits);
  }
  return run;
}

}  // namespace axiometry::iso230_2
