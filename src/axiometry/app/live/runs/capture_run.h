// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/files/disk_room.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/live/sources/live_source.h"
#include "axiometry/app/recordings/capture_session.h"

/// The use case "wait for the readings of a plan and keep them".
namespace axiometry::app {

/// Where a recording comes from and where it goes.
struct CaptureRun {
  std::string from;    ///< file, "-", "tcp://…", "serial://…", or of a motion "simulator://…"
  std::string raw;     ///< file of all bytes that came of a live source or a pipe; must not exist
  std::string resume;  ///< instead: such a file, which is played first and goes on
  std::string out;     ///< test file (.json) or table (.csv, .txt), rewritten after every reading; "-": once, at the
                       ///< end; may be empty
  Duration give_up = Duration::s(60);  ///< how long a source is tried, at first and again, until samples come
  std::string keys{};                  ///< file of what was said at the stops of a finished recording, stop_marks.h
  std::string simulated{};             ///< what a table says of readings that nobody measured
  Connect connect{};                   ///< in place of `from`, which then only names it, where the stream is at hand
  std::function<void(CaptureSession&)> beside{};  ///< then: as that of LiveCapture
};

/// What happens, for people who watch. Any may be empty.
struct CaptureObserver {
  std::function<void(const capture::CapturedReading&)> reading;  ///< it is on the disk when this is called
  std::function<void(const capture::CaptureEvent&)> event;
  std::function<void(const std::string&)> notice;  ///< "connection lost: …, trying again in 1 s"
  std::function<void(const CaptureSession&)> now;  ///< several times a second
  std::function<bool()> stopped;                   ///< asked several times a second: ends it with all that was recorded
  std::function<bool()> abandoned;                 ///< ends it as if the program were killed, to be gone on with later
  /// Of a straightness or a rotation: as reading(), and what was said since the last call, asked as often as stopped().
  std::function<void(const capture::PlannedValue&, const MotionListener&)> value{};
  std::function<std::vector<capture::StopKey>()> keys{};
};

struct CaptureOutcome {
  bool complete = false;  ///< every approach has come or was missed
  bool stopped = false;   ///< whether the observer stopped it
  Test test;
  capture::CaptureResult result;
  std::size_t samples = 0;
  std::size_t lost = 0;
};

/// Reads until the plan is complete, the stream ends or the observer stops it. Every byte of a live source, or of a
/// pipe for which a raw file is named, goes to that file before it is used; the test file is whole at every moment.
/// Fails as CaptureSession does, on a MiB without a line break from a live source, on a source that cannot be opened
/// and on files that cannot be written; the files hold then what has come so far. Of a raw recording what is sound is
/// played (play_into()). Fails at once when the test file would take the place of the recording or the plan, or
/// has a name that ends as that of something else.
Result<CaptureOutcome> run_capture(const CaptureRun& run, const CaptureOptions& options,
                                   const CaptureObserver& observer);

/// What a source gave to a session.
struct HeardSource {
  bool complete = false;  ///< the last stop of the plan has come
  bool stopped = false;   ///< whether the observer stopped it
  std::string date;       ///< day on which the first bytes of a live source arrived
  CaptureSession session;
};

/// The same for stops of a tracking interferometer, without a file at its end; what came is in the raw file. Readings
/// and events are not told while they come, because a later standstill may show that one belongs elsewhere; the
/// observer's now() can ask how many there are.
Result<HeardSource> hear_source(const CaptureRun& run, CaptureSession session, const CaptureObserver& observer);

/// A live capture whose plan and stream are at hand.
struct LiveCapture {
  std::string name;                      ///< name of the source, as the test tells it
  Connect connect;                       ///< none: what was recorded is played, and that is all
  std::string raw;                       ///< file of all bytes that come; must not exist
  std::string resume{};                  ///< instead: such a file, which is played first and goes on
  Duration give_up = Duration::s(60);    ///< how long a source is tried, at first and again, until samples come
  std::uint64_t raw_limit = UINT64_MAX;  ///< bytes that come at most; then the capture stops
  FreeBytes free = free_bytes;           ///< room on the disk of the raw file; DiskRoom says when the capture stops
  std::function<void(CaptureSession&)> beside{};  ///< what source and capture tell each other between its pieces
  Duration for_undo = Duration::s(0);             ///< heard behind the last reading that a key took, to take it back
};

/// The same as run_capture(), without a file for the test.
Result<CaptureOutcome> run_live_capture(CaptureSession session, const LiveCapture& capture,
                                        const CaptureObserver& observer);

/// What a live source gave, also where it ended in trouble.
struct HeardLive {
  HeardSource heard;
  std::optional<Error> trouble;
  bool on_disk = true;  ///< all that the session has seen is in the raw file
};

/// The same as hear_source().
HeardLive hear_live(CaptureSession session, const LiveCapture& capture, const CaptureObserver& observer);

}  // namespace axiometry::app
