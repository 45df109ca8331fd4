// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/values/plan_progress.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/capture/plan_pace.h"

namespace axiometry::capture {
namespace {

constexpr double soonest_share = 0.5;   // twice the feed is the most that an override of a control allows
constexpr std::size_t paces_kept = 15;  // number of latest paces that are kept

}  // namespace

PlanProgress::PlanProgress(const Plan& plan) : approaches_(approaches(plan)), planned_s_(planned_times_s(plan)) {
  AXIOMETRY_CONTRACT(approaches_.size() == planned_s_.size());
}

std::optional<Approach> PlanProgress::due() const {
  return complete() ? std::nullopt : std::optional(approaches_[done_.size()]);
}

std::size_t PlanProgress::taken() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(done_, [](const PassedStop& d) { return d.value.has_value(); }));
}

std::vector<PlannedValue> PlanProgress::values() const {
  std::vector<PlannedValue> list;
  for (const PassedStop& done : done_)
    if (done.value) list.push_back(*done.value);
  return list;
}

std::optional<double> PlanProgress::last_time_s() const {
  for (std::size_t k = done_.size(); k > 0; --k)
    if (done_[k - 1].time_s) return done_[k - 1].time_s;
  return std::nullopt;
}

/// From the last stop of which a time is known to the one that is due.
double PlanProgress::planned_since_last_s() const {
  double sum = planned_s_[done_.size()];
  for (std::size_t k = done_.size(); k > 0 && !done_[k - 1].time_s; --k) sum += planned_s_[k - 1];
  return sum;
}

double PlanProgress::planned_s() const { return complete() ? 0.0 : planned_since_last_s(); }

double PlanProgress::pace_at(double time_s) const {
  const auto last = last_time_s();
  if (!last || complete()) return 0.0;
  const double planned = planned_since_last_s();
  return planned > 0.0 ? (time_s - *last) / planned : 0.0;
}

/// The lower one of the middle two, so that one rest of the program does not become its pace.
double PlanProgress::pace() const {
  std::vector<double> paces;
  for (std::size_t k = done_.size(); k > 0 && paces.size() < paces_kept; --k)
    if (done_[k - 1].pace > 0.0) paces.push_back(done_[k - 1].pace);
  if (paces.empty()) return 1.0;
  const auto middle = paces.begin() + static_cast<std::ptrdiff_t>((paces.size() - 1) / 2);
  std::ranges::nth_element(paces, middle);
  return *middle;
}

Timing PlanProgress::timing(double time_s) const {
  const auto last = last_time_s();
  if (!last || complete()) return Timing::fits;
  const double since = time_s - *last, planned = planned_since_last_s();
  if (since < soonest_share * planned) return Timing::doubled;
  const double behind = done_.size() + 1 < planned_s_.size() ? planned_s_[done_.size() + 1] : planned;
  return since > pace() * (planned + 0.5 * behind) ? Timing::doubtful : Timing::fits;
}

void PlanProgress::put(PlannedValue value, double time_s) {
  AXIOMETRY_CONTRACT(!complete() && value.approach == approaches_[done_.size()]);
  done_.push_back({time_s, std::move(value), pace_at(time_s)});
}

void PlanProgress::pass(std::optional<double> time_s) {
  AXIOMETRY_CONTRACT(!complete());
  done_.push_back({time_s, std::nullopt, time_s ? pace_at(*time_s) : 0.0});
}

bool PlanProgress::undo() {
  if (done_.empty()) return false;
  done_.pop_back();
  return true;
}

}  // namespace axiometry::capture
