// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/capture_telling.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/live/runs/capture_date.h"
#include "axiometry/app/recordings/motion_table.h"
#include "axiometry/formats/format.h"

namespace axiometry::app {

bool CaptureTelling::is_new(const CaptureSession& session,
                            const std::vector<capture::CapturedReading>& readings) const {
  return !readings.empty() || (session.motion() != nullptr && session.motion()->values().given().size() > values_told_);
}

Result<void> CaptureTelling::tell(const CaptureSession& session, const std::vector<capture::CapturedReading>& readings,
                                  const Moment& moment) {
  if (session.motion() != nullptr) return tell_values(session, moment);
  if (!readings.empty() || moment.last) AXIOMETRY_TRY_VOID(write_test(session, moment));
  if (session.stops() != nullptr) return {};
  const auto& events = session.matcher().result().events;
  events_told_ = std::min(events_told_, events.size());  // setting the zero begins a new list
  for (const capture::CapturedReading& reading : readings) {
    tell_events(events, reading.standstill.begin_s);
    if (observer_.reading) observer_.reading(reading);
  }
  tell_events(events, std::numeric_limits<double>::max());
  return {};
}

/// Nothing is ever taken off these lists.
Result<void> CaptureTelling::tell_values(const CaptureSession& session, const Moment& moment) {
  const MotionListener& motion = *session.motion();
  const auto& given = motion.values().given();
  const auto& events = motion.values().events();
  const bool changed = given.size() > values_told_ || events.size() > events_told_;
  if (changed || moment.last) AXIOMETRY_TRY_VOID(write_table(session, moment));
  for (; values_told_ < given.size(); ++values_told_) {
    tell_events(events, given[values_told_].still.from_s);
    if (observer_.value) observer_.value(given[values_told_], motion);
  }
  tell_events(events, std::numeric_limits<double>::max());
  return {};
}

/// Those up to a time that were not told yet.
void CaptureTelling::tell_events(const std::vector<capture::CaptureEvent>& events, double until_s) {
  for (; events_told_ < events.size() && events[events_told_].time_s <= until_s; ++events_told_)
    if (observer_.event) observer_.event(events[events_told_]);
}

/// Of what was read, where it stays in a file; empty where nobody can read it again.
std::string CaptureTelling::recording_sha256() const {
  std::string recording = run_.resume.empty() ? run_.raw : run_.resume;
  if (recording.empty()) recording = run_.from;
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(recording, unknown)) return {};
  const auto source = Source::open(recording);
  if (!source) return {};
  const auto sha256 = source->whole_sha256();
  return sha256 ? sha256->value_or("") : "";
}

/// A test needs two targets, so there is no file before them; and none of a recording that does not fit.
Result<void> CaptureTelling::write_test(const CaptureSession& session, const Moment& moment) {
  if (run_.out.empty() || session.stops() != nullptr || (run_.out == "-" && !moment.last)) return {};
  static const formats::Format* const json = formats::find_format("json");
  auto test = dated_test(session, run_.from, moment.first_arrival);
  if (test && moment.last) test->provenance.sha256 = recording_sha256();
  return put(test ? Result<std::string>(json->write(*test)) : std::unexpected(test.error()), moment);
}

/// There is no table without a reading.
Result<void> CaptureTelling::write_table(const CaptureSession& session, const Moment& moment) {
  if (run_.out.empty() || (run_.out == "-" && !moment.last)) return {};
  return put(motion_table(session, {run_.from, run_.raw.empty() ? run_.resume : run_.raw,
                                    arrival_date(moment.first_arrival), run_.simulated}),
             moment);
}

/// A result that there was may only seem to be none until more has come.
Result<void> CaptureTelling::put(const Result<std::string>& result, const Moment& moment) {
  if (!result && moment.last) take_back();
  if (!result) return {};
  std::error_code unknown;
  if (!wrote_ && std::filesystem::is_regular_file(run_.out, unknown)) {
    AXIOMETRY_TRY(before_, whole_file(run_.out));
  }
  AXIOMETRY_TRY_VOID(write_file(run_.out, *result));
  wrote_ = run_.out != "-";
  return {};
}

/// A link stays a link, and what is no file, such as a device, stays.
void CaptureTelling::take_back() {
  std::error_code unknown;
  if (!std::exchange(wrote_, false) || !std::filesystem::is_regular_file(run_.out, unknown)) return;
  const auto file = std::filesystem::canonical(run_.out, unknown);
  if (unknown) return;
  const auto notice = [&](const std::string& text) {
    if (observer_.notice) observer_.notice(text);
  };
  if (before_) {
    const auto put_back = write_file(run_.out, *before_);
    return notice(put_back ? fmt::format("{}: holds again what it held before, since what this capture wrote there "
                                         "does not hold",
                                         run_.out)
                           : put_back.error().to_string());
  }
  if (!std::filesystem::remove(file, unknown)) return;
  notice(fmt::format("{}: removed, what was written there does not hold", run_.out));
}

}  // namespace axiometry::app
