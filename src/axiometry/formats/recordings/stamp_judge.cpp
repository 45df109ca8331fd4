// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/stamp_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/counted.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t lines_against_one = 2;  // that show that the one which waits had run ahead
constexpr std::size_t lines_of_a_clock = 5;   // that show that it was set
constexpr double least_leap_s = 10.0;
constexpr double faster_than_any_stream = 100.0;  // than its samples were taken

}  // namespace

bool StampJudge::follows(const StampedLine& line, const StampedLine& before) const {
  return kind_ == Kind::times ? line.stamp >= before.stamp : line.stamp > before.stamp;
}

void StampJudge::settle(const StampedLine& line) {
  if (last_ && kind_ == Kind::times && line.stamp - last_->stamp >= least_leap_s &&
      (line.arrival_s - last_->arrival_s) * faster_than_any_stream < line.stamp - last_->stamp && leaps_++ == 0)
    first_leap_ = line.line;
  settled_.push_back(line);
  last_ = line;
  rejected_in_a_row_ = 0;
}

void StampJudge::reject(const StampedLine& line) {
  if (rejected_++ == 0) first_rejected_ = line.line;
  ++rejected_in_a_row_;
}

void StampJudge::reject_doubtful() {
  for (const StampedLine& line : doubtful_) reject(line);
  doubtful_.clear();
}

std::span<const StampedLine> StampJudge::push(StampedLine line) {
  settled_.clear();
  line.stamp += shift_;
  const StampedLine* const before = waiting_ ? &*waiting_ : base();
  if (before != nullptr && !follows(line, *before)) {
    doubt(line);
    return settled_;
  }
  reject_doubtful();
  if (waiting_) settle(*waiting_);
  waiting_ = line;
  return settled_;
}

/// Of a line that runs back.
void StampJudge::doubt(const StampedLine& line) {
  if (!doubtful_.empty() && !follows(line, doubtful_.back())) reject_doubtful();
  doubtful_.push_back(line);
  const bool behind_last = waiting_ && (!last_ || follows(doubtful_.front(), *last_));
  if (behind_last && doubtful_.size() >= lines_against_one) {
    reject(*waiting_);
    waiting_.reset();
    take_doubtful(0.0);
  } else if (!behind_last && doubtful_.size() >= lines_of_a_clock) {
    if (clocks_++ == 0) first_clock_ = doubtful_.front().line;
    const double shift = shift_of_new_clock();
    if (kind_ == Kind::times) shift_ += shift;
    if (waiting_) settle(*waiting_);
    take_doubtful(shift);
  }
}

void StampJudge::take_doubtful(double shift) {
  for (StampedLine& line : doubtful_) line.stamp += shift;
  for (std::size_t k = 0; k + 1 < doubtful_.size(); ++k) settle(doubtful_[k]);
  waiting_ = doubtful_.back();
  doubtful_.clear();
}

/// The first line of the new clock lies behind the last one of the old by the time between their arrivals, or a step.
double StampJudge::shift_of_new_clock() const {
  const StampedLine& before = waiting_ ? *waiting_ : *last_;
  const StampedLine& first = doubtful_.front();
  const double step = kind_ == Kind::times ? doubtful_[1].stamp - first.stamp : 1.0;
  const double pause = kind_ == Kind::times ? first.arrival_s - before.arrival_s : 0.0;
  return before.stamp + (pause > step ? pause : step) - first.stamp;
}

std::span<const StampedLine> StampJudge::flush() {
  settled_.clear();
  if (waiting_) settle(*waiting_);
  waiting_.reset();
  reject_doubtful();
  rejected_in_a_row_ = 0;
  return settled_;
}

std::vector<std::string> StampJudge::remarks() const {
  std::vector<std::string> remarks;
  const bool times = kind_ == Kind::times;
  if (rejected_ > 0)
    remarks.push_back(fmt::format("left out {} whose {} is out of order, the first is line {}",
                                  counted(rejected_, "line"), times ? "time" : "counter", first_rejected_));
  if (clocks_ > 0)
    remarks.push_back(fmt::format("the {} of the samples was set back {}, first in line {}; it was taken on",
                                  times ? "clock" : "counter", counted(clocks_, "time"), first_clock_));
  if (leaps_ > 0)
    remarks.push_back(
        fmt::format("the clock of the samples was set ahead {}, first in line {}; it was taken as a gap",
                    counted(leaps_, "time"), first_leap_));
  return remarks;
}

}  // namespace axiometry::formats
