// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/length_capture.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/app/recordings/read_recording.h"
#include "axiometry/app/recordings/stop_notes.h"
#include "axiometry/base/counted.h"
#include "axiometry/capture/capture_result.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"
#include "axiometry/model/simulated.h"

namespace axiometry::app {
Result<CapturedLengths> captured_lengths(const TrackingPlan& plan, const CaptureSession& session) {
  AXIOMETRY_TRY(const capture::StopLengths found, session.stops()->lengths());
  const std::vector<capture::LineStop> approaches = capture::line_stops(plan).approaches;
  CapturedLengths lengths;
  for (std::size_t k = 0; k < approaches.size(); ++k) {
    const auto& length = found.stops[k].length;
    if (!length) continue;
    lengths.readings.push_back(
        {plan.lines[approaches[k].line].id, approaches[k].approach, length->length_mm, length->segment});
    lengths.times_s.push_back(length->time_s);
  }
  if (lengths.readings.empty())
    return fail(fmt::format("found no length for any of the {} approaches of the plan in {}", approaches.size(),
                            counted(found.standstills, "standstill")));
  lengths.approaches = approaches.size();
  lengths.samples = session.samples();
  lengths.simulated = session.simulated();
  lengths.layout = session.layout();
  lengths.notes.push_back(fmt::format("a continuous recording of {} samples gave {} of the {} lengths of the plan",
                                      session.samples(), lengths.readings.size(), approaches.size()));
  const StopNames names{.group = [&](std::size_t k) { return "line " + plan.lines[approaches[k].line].id; },
                        .name = [&](std::size_t k) { return capture::approach_name(approaches[k].approach); }};
  std::ranges::move(recording_notes(session, found, names), std::back_inserter(lengths.notes));
  return lengths;
}

Result<CapturedLengths> read_length_recording(Source& source, const TrackingPlan& plan, const CaptureOptions& options) {
  AXIOMETRY_TRY(CaptureSession session, CaptureSession::open(plan, options_of_source(source, options)));
  AXIOMETRY_TRY(std::string sha256, hear(source, session));
  AXIOMETRY_TRY(CapturedLengths lengths, captured_lengths(plan, session));
  lengths.sha256 = std::move(sha256);
  return lengths;
}

std::string length_capture_table(const CapturedLengths& lengths) {
  std::string text = lengths.simulated ? fmt::format("# {}\n", simulated_note) : "";
  for (const std::string& note : lengths.notes) text += fmt::format("# {}\n", note);
  return text + formats::write_tracking_lengths(lengths.readings, lengths.times_s);
}

}  // namespace axiometry::app
