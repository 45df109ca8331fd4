// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/capture/values/still_values.h"
#include "axiometry/model/plan.h"

/// Readings that come in the order of a plan, and which approach each of them belongs to where nothing but order and
/// time tells it.
namespace axiometry::capture {

/// One approach with what was read there.
struct PlannedValue {
  Approach approach;
  StillValue still;
  std::vector<std::string> remarks{};  ///< "2 outliers left out"; empty when nothing is to be said
};

/// Whether a reading may be that of the approach that is due, by the time since the one before.
enum class Timing {
  fits,
  doubled,  ///< sooner than the axis can be there at twice the plan's feed: the approach before was read twice
  doubtful  ///< so late that an approach may have been passed without a reading
};

/// What of a plan is done: each approach in its order has a reading or was left without one.
class PlanProgress {
 public:
  /// Needs a sound plan.
  explicit PlanProgress(const Plan& plan);

  bool complete() const { return done_.size() == approaches_.size(); }
  /// The approach that is due; nothing when all are done.
  std::optional<Approach> due() const;
  std::size_t expected() const { return approaches_.size(); }
  std::size_t remaining() const { return approaches_.size() - done_.size(); }
  std::size_t taken() const;
  std::vector<PlannedValue> values() const;  ///< values in the order of the plan

  /// Of a reading that came at that time. Motion and dwell of the plan need L seconds from one stop to the next, at
  /// twice its feed still L/2: what is sooner is doubled. The program goes through the plan at a pace p of its own,
  /// the middle one of what was seen, 1 at first. What comes later than p (L + L'/2), with L' of the way behind, is
  /// doubtful: it may be the reading of the stop behind.
  Timing timing(double time_s) const;
  /// What timing() holds a reading against, s since the one before: the plan's own time for the approach that is due.
  double planned_s() const;

  void put(PlannedValue value, double time_s);  ///< keeps the value of the approach that is due, which it names
  void pass(std::optional<double> time_s);      ///< it has no reading; the time is that of one that was no good
  /// Takes the last approach back, which is due again. False when there is none.
  bool undo();

 private:
  struct PassedStop {
    std::optional<double> time_s;
    std::optional<PlannedValue> value;
    double pace = 0.0;  // 0 where none was seen
  };
  std::optional<double> last_time_s() const;
  double planned_since_last_s() const;
  double pace() const;
  double pace_at(double time_s) const;

  std::vector<Approach> approaches_;
  std::vector<double> planned_s_;  // time from the stop before to this one
  std::vector<PassedStop> done_;
};

}  // namespace axiometry::capture
