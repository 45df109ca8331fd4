// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/plan_pace.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/median.h"

namespace axiometry::capture {
namespace {

constexpr double a_minute_s = 60.0;
constexpr std::size_t paces_to_trust = 3;
constexpr double surely_nearer = 0.25;  // of the time between two approaches

}  // namespace

std::vector<double> planned_times_s(const Plan& plan) {
  std::vector<double> times;
  double way = 0.0;
  std::optional<double> at;
  for (const PlannedMove& move : moves(plan)) {
    const double to = move.to.in_native();
    if (at) way += std::abs(to - *at);
    at = to;
    if (!move.approach) continue;
    times.push_back(plan.dwell.in_s() + way / plan.feed * a_minute_s);
    way = 0.0;
  }
  return times;
}

PlanPace::PlanPace(const Plan& plan) {
  double sum = 0.0;
  for (const double time : planned_times_s(plan)) until_s_.push_back(sum += time);
}

void PlanPace::read(std::size_t approach, double time_s, bool seen) {
  if (last_ && seen && approach == last_->approach + 1)
    paces_.push_back((time_s - last_->time_s) / (until_s_[approach] - until_s_[last_->approach]));
  last_ = Last{approach, time_s};
}

void PlanPace::forget() {
  last_.reset();
  paces_.clear();
}

PlanPace::Placed PlanPace::place(std::span<const std::size_t> approaches, double time_s) const {
  AXIOMETRY_CONTRACT(!approaches.empty());
  if (!last_ || approaches.size() == 1) return {approaches.front(), true};
  const double pace = paces_.size() < paces_to_trust ? 1.0 : numeric::median(paces_);
  const auto off_s = [&](std::size_t approach) {
    return time_s - (last_->time_s + pace * (until_s_[approach] - until_s_[last_->approach]));
  };
  // A clock may stand still while nothing comes, but what is due cannot come sooner.
  if (off_s(approaches.front()) <= 0.0) return {approaches.front(), true};
  const auto next = std::ranges::min_element(approaches, {}, [&](std::size_t k) { return std::abs(off_s(k)); });
  const std::size_t beside = next + 1 == approaches.end() ? *(next - 1) : *(next + 1);
  const double apart_s = pace * std::abs(until_s_[beside] - until_s_[*next]);
  if (std::abs(off_s(*next)) > surely_nearer * apart_s) return {approaches.front(), false};
  return {*next, true};
}

void FullWays::go(double place) {
  if (from_ && std::min(*from_, place) <= lowest_ && std::max(*from_, place) >= highest_) ++count_;
  from_ = place;
}

}  // namespace axiometry::capture
