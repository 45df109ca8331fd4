// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/recordings/raw_log.h"

namespace axiometry::app {

/// What a capture writes and tells while readings come in: first the file of its result, then the people.
class CaptureTelling {
 public:
  /// Both must outlive it.
  CaptureTelling(const CaptureRun& run, const CaptureObserver& observer) : run_(run), observer_(observer) {}

  struct Moment {
    bool last = false;
    std::optional<ArrivalNs> first_arrival{};
  };
  /// Whether there is a reading that was not told.
  bool is_new(const CaptureSession& session, const std::vector<capture::CapturedReading>& readings) const;
  /// `readings` are those that the session has just handed on.
  Result<void> tell(const CaptureSession& session, const std::vector<capture::CapturedReading>& readings,
                    const Moment& moment);
  /// Puts the file back that was there before it wrote one, or else removes what it wrote: the recording has proved to
  /// belong to another plan.
  void take_back();

 private:
  Result<void> tell_values(const CaptureSession& session, const Moment& moment);
  void tell_events(const std::vector<capture::CaptureEvent>& events, double until_s);
  std::string recording_sha256() const;
  Result<void> write_test(const CaptureSession& session, const Moment& moment);
  Result<void> write_table(const CaptureSession& session, const Moment& moment);
  Result<void> put(const Result<std::string>& result, const Moment& moment);

  const CaptureRun& run_;
  const CaptureObserver& observer_;
  std::size_t events_told_ = 0, values_told_ = 0;
  bool wrote_ = false;
  std::optional<std::string> before_;  // what the file held before
};

}  // namespace axiometry::app
