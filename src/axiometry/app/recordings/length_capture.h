// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/app/files/source.h"
#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// The use case "from a continuous recording of a tracking interferometer to the lengths along the lines of a plan".
namespace axiometry::app {

struct CapturedLengths {
  std::vector<LengthReading> readings;  ///< readings in the order of measurement, as shown
  std::vector<double> times_s;          ///< time of each, s since some beginning of the recording
  std::size_t approaches = 0;           ///< approaches of the plan
  std::size_t samples = 0;
  std::vector<std::string> notes;  ///< what could not be matched, where the beam was broken, …; sentences
  std::string layout;              ///< layout of the recording
  std::string sha256;              ///< hash of its file; empty for a live one
  bool simulated = false;          ///< as the recording says
};

/// What a session that was opened with this plan has found. Fails as StopListener::lengths() does, and without any
/// length.
Result<CapturedLengths> captured_lengths(const TrackingPlan& plan, const CaptureSession& session);

/// A whole recording. Fails as CaptureSession and captured_lengths() do.
Result<CapturedLengths> read_length_recording(Source& source, const TrackingPlan& plan, const CaptureOptions& options);

/// The table of them, as `tracking evaluate` reads it: what was noted stands above it as comments.
std::string length_capture_table(const CapturedLengths& lengths);

}  // namespace axiometry::app
