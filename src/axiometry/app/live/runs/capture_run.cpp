// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/runs/capture_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/live/disk/stop_marks.h"
#include "axiometry/app/live/runs/capture_date.h"
#include "axiometry/app/live/runs/capture_telling.h"
#include "axiometry/app/live/runs/plan_end.h"
#include "axiometry/app/live/runs/recording_room.h"
#include "axiometry/app/live/runs/recording_spared.h"
#include "axiometry/app/live/sources/outage.h"
#include "axiometry/app/recordings/piped_log.h"
#include "axiometry/app/recordings/raw_log.h"
#include "axiometry/app/recordings/raw_playing.h"
#include "axiometry/base/text/number_text.h"

namespace axiometry::app {
namespace {

using namespace std::chrono_literals;
using Clock = Outage::Clock;

constexpr std::size_t live_block = std::size_t{64} << 10;
constexpr std::size_t file_block = std::size_t{256} << 10;
constexpr auto poll_time = 100ms;
constexpr auto show_every = 100ms;
constexpr auto sound_connection = 5s;  // data came for so long: it is sound, though they gave no sample yet
constexpr std::uint64_t longest_without_break = std::uint64_t{1} << 20;

/// One run from begin to end.
class Run {
 public:
  Run(const CaptureRun& run, const CaptureObserver& observer, CaptureSession session)
      : run_(run), observer_(observer), session_(std::move(session)), piped_(run.raw), telling_(run, observer) {}

  void listen(const LiveCapture& live) {
    connect_ = live.connect, room_ = live.raw_limit, live_ = live;
    end_of_plan_ = PlanEnd(live.for_undo);
  }

  Result<CaptureOutcome> operator()() {
    AXIOMETRY_TRY_VOID(hear());
    AXIOMETRY_TRY(Test test, dated_test(session_, run_.from, first_arrival_));
    return CaptureOutcome{session_.complete(),         stopped_,           std::move(test),
                          session_.matcher().result(), session_.samples(), session_.lost()};
  }

  /// All that came, whatever is to be made of it.
  HeardLive heard() {
    auto done = hear();
    const bool on_disk = done || !connect_ || log_is_sound_;
    return {{session_.complete(), stopped_, arrival_date(first_arrival_), std::move(session_)},
            done ? std::nullopt : std::optional(std::move(done).error()),
            on_disk};
  }

 private:
  bool stop(bool reads_on = false) {
    stopped_ = stopped_ || (observer_.stopped && observer_.stopped());
    return stopped_ || over(reads_on);
  }

  Result<void> hear() {
    auto read = read_all();
    if (abandoned_) return fail("the capture was left, to be gone on with later");
    if (!read) {
      keep_what_came();
      return std::unexpected(std::move(read).error());
    }
    const auto last = session_.finish(end_);
    if (!last) telling_.take_back();
    if (!last) return std::unexpected(last.error());
    AXIOMETRY_TRY_VOID(settle(*last, true));
    for (const std::string& remark : session_.remarks()) notice(remark);
    return {};
  }

  /// Nothing more is to be read, not even of a recording that is gone on with.
  bool over(bool reads_on = false) {
    abandoned_ = abandoned_ || (observer_.abandoned && observer_.abandoned());
    return abandoned_ || (!reads_on && end_of_plan_.has_come(session_));
  }

  void notice(const std::string& text) const {
    if (observer_.notice) observer_.notice(text);
  }

  /// Before a failure. Of a live stream that is its end; but where its log fails, or was not opened, nobody knows how
  /// much of the last bytes is there.
  void keep_what_came() {
    if (connect_ && !log_is_sound_) return;
    const auto last =
        connect_ ? session_.finish(end_) : Result<std::vector<capture::CapturedReading>>(session_.found_before());
    static_cast<void>(settle(last ? *last : session_.found_before(), true));
  }

  Result<void> read_all() {
    if (connect_) return read_live();
    if (run_.resume.empty()) return read_file();
    AXIOMETRY_TRY_VOID(hold(run_.resume));
    return play_samples(run_.resume);
  }

  /// What is played to be kept, or to go on with, is on the disk, and nobody else writes behind it.
  Result<void> hold(const std::string& raw) {
    AXIOMETRY_TRY(RawHold held, RawHold::take(raw));
    hold_.emplace(std::move(held));
    return sync_raw(raw);
  }

  Result<void> read_file() {
    if (is_raw(run_.from)) return play_samples(run_.from);
    AXIOMETRY_TRY(Source source, Source::open(run_.from));
    std::vector<char> block(file_block);
    while (!stop(reads_behind_plan(session_, run_.from))) {
      AXIOMETRY_TRY(const std::size_t got, source.read(block));
      if (got == 0) {
        end_ = CaptureSession::End::of_file;
        break;
      }
      AXIOMETRY_TRY(log_, piped_.append({block.data(), got}));
      AXIOMETRY_TRY(const auto readings, session_.feed({block.data(), got}));
      AXIOMETRY_TRY_VOID(settle(readings, false));
    }
    return log_ != nullptr ? log_->sync() : Result<void>{};
  }

  /// Of a recording that is to hold some.
  Result<void> play_samples(const std::string& raw) {
    AXIOMETRY_TRY(auto none, play_raw(raw));
    return none ? std::unexpected(*std::move(none)) : Result<void>{};
  }

  Result<std::optional<Error>> play_raw(const std::string& raw) {
    const PlayHooks hooks{.wants =
                              [this](const RawPiece& piece) {
                                if (run_.resume.empty() ? stop() : over()) return false;
                                if (!first_arrival_) first_arrival_ = piece.arrival;
                                room_ -= std::min<std::uint64_t>(room_, piece.bytes.size());
                                show();
                                return true;
                              },
                          .readings = [this](const auto& readings) { return settle(readings, false); },
                          .goes_on = connect_ != nullptr};
    return play_into(session_, raw, hooks);
  }

  /// A connection behind the one before: first in the log, then for the readings that the break cuts off.
  Result<void> begin_another(RawLog& log) {
    AXIOMETRY_TRY_VOID(sound(log.begin_connection()));
    AXIOMETRY_TRY(const auto readings, session_.interrupted());
    return settle(readings, false);
  }

  Result<void> take(std::string_view bytes, ArrivalNs arrival) {
    AXIOMETRY_TRY(const auto readings, session_.feed(bytes, static_cast<double>(arrival - *first_arrival_) * 1e-9));
    return settle(readings, false);
  }

  Result<void> read_live() {
    AXIOMETRY_TRY(auto stream, first_connection());
    if (!stream && run_.resume.empty()) return {};  // stopped meanwhile: nothing has come
    if (!run_.resume.empty()) {
      AXIOMETRY_TRY_VOID(hold(run_.resume));
      AXIOMETRY_TRY(auto none, play_raw(run_.resume));
      if (session_.samples() == 0 && !has_times(run_.resume))
        return std::unexpected(
            Error{"found no sample and no times beside it, expected a recording to go on with", run_.resume, {}});
      if (none) notice(none->to_string());
      notice(fmt::format("{}: played again, {} of {} approaches are done", base_name(run_.resume), session_.taken(),
                         session_.expected()));
      if (!stream || stop()) return {};
    }
    AXIOMETRY_TRY(RawLog log, run_.resume.empty() ? RawLog::create(run_.raw) : RawLog::resume(run_.resume));
    if (!hold_) AXIOMETRY_TRY_VOID(hold(run_.raw));
    log_ = &log;
    log_is_sound_ = true;
    auto begun = run_.resume.empty() ? Result<void>{} : begin_another(log);
    auto listened = begun ? listen_to(std::move(stream), log) : std::move(begun);
    auto synced = sound(log_->sync());
    log_ = nullptr;
    return listened ? synced : listened;
  }

  Result<void> listen_to(std::unique_ptr<LiveStream> stream, RawLog& log) {
    std::vector<char> block(live_block);
    DiskRoom disk(run_.raw.empty() ? run_.resume : run_.raw, live_.free);
    if (live_.beside) live_.beside(session_);
    while (!stop()) {
      const LiveStream::Got got = stream->read(block, poll_time);
      if (got.state == LiveStream::State::data) {
        stopped_ = !has_room(disk, {room_, got.count}, [this](const std::string& text) { notice(text); });
        if (stopped_) break;
        AXIOMETRY_TRY_VOID(keep_and_take({block.data(), got.count}, log));
        note_return();
      } else if (got.state == LiveStream::State::closed) {
        AXIOMETRY_TRY(stream, reconnect(got.reason));
        if (!stream) break;
        drop_keys();
        AXIOMETRY_TRY_VOID(begin_another(log));
      } else if (got.state == LiveStream::State::over) {
        break;
      } else {
        AXIOMETRY_TRY_VOID(sound(log.sync_when_due()));
      }
      AXIOMETRY_TRY_VOID(take_keys(log));
      if (live_.beside) live_.beside(session_);
      show();
    }
    return {};
  }

  /// First the disk, with all the readings that were seen when it was said.
  Result<void> take_keys(RawLog& log) {
    if (session_.motion() == nullptr || !observer_.keys) return {};
    for (const capture::StopKey key : observer_.keys()) {
      AXIOMETRY_TRY_VOID(sound(log.sync()));
      const double time_s = session_.press(key);
      AXIOMETRY_TRY_VOID(append_mark(run_.raw.empty() ? run_.resume : run_.raw, {key, time_s}));
      AXIOMETRY_TRY_VOID(settle({}, false));
    }
    return {};
  }

  /// What was said while nothing came was said of a reading that nobody has.
  void drop_keys() const {
    if (session_.motion() == nullptr || !observer_.keys || observer_.keys().empty()) return;
    notice("what was said while the connection was away is not used");
  }

  Result<void> keep_and_take(std::string_view bytes, RawLog& log) {
    room_ -= bytes.size();
    const ArrivalNs arrival = log.stamp();
    if (!first_arrival_) first_arrival_ = arrival;
    if (auto kept = sound(log.append(bytes, arrival)); !kept) {
      kept.error().message +=
          fmt::format("; {} bytes and {} are kept", log.size(), counted(session_.taken(), "reading"));
      return kept;
    }
    AXIOMETRY_TRY_VOID(take(bytes, arrival));
    if (session_.without_break() <= longest_without_break) return {};
    return fail(
        fmt::format("found {} bytes without a line break, expected one sample a line: the capture ends here; {} kept",
                    session_.without_break(), counted(session_.taken(), "reading is", "readings are")));
  }

  /// An outage ends when samples come again, not with a connection: a source may take each and close it at once.
  void note_return() {
    if (!outage_) return;
    if (session_.samples() == outage_->samples() && Clock::now() - connected_ < sound_connection) return;
    notice(fmt::format("connected again after {} s and {}; samples are missing",
                       format_fixed(outage_->lasted_s(connected_), 1), outage_->attempts_text()));
    outage_.reset();
  }

  /// Nothing when it was stopped, or when the other side has not come back in time. The first attempt follows at once
  /// where the connection had lasted.
  Result<std::unique_ptr<LiveStream>> reconnect(const std::string& reason) {
    const bool at_once = !outage_ && Clock::now() - connected_ >= first_pause;
    if (!outage_) {
      notice(fmt::format("connection lost ({}), trying again for {} s", reason, format_fixed(run_.give_up.in_s(), 0)));
      outage_.emplace(session_.samples(), run_.give_up);
    }
    Outage::Result found = try_again(at_once);
    if (found.given_up)
      notice(fmt::format("the connection did not come back in {}: the recording ends here", outage_->attempts_text()));
    return std::move(found.stream);
  }

  /// A source may be switched on later than the program. Nothing when it was stopped meanwhile.
  Result<std::unique_ptr<LiveStream>> first_connection() {
    auto stream = connect_();
    connected_ = Clock::now();
    if (stream || run_.give_up.in_s() <= 0.0) return stream;
    const std::string seconds = format_fixed(run_.give_up.in_s(), 0);
    notice(fmt::format("{}, trying again for {} s", stream.error().to_string(), seconds));
    outage_.emplace(0, run_.give_up, 1);
    Outage::Result found = try_again(false);
    const std::string attempts = std::exchange(outage_, std::nullopt)->attempts_text();
    if (found.given_up) stream.error().message += fmt::format(" ({} in {} s)", attempts, seconds);
    if (found.given_up) return stream;
    if (found.stream) notice(fmt::format("connected after {}", attempts));
    return std::move(found.stream);
  }

  Outage::Result try_again(bool at_once) {
    Outage::Result found = outage_->try_again(at_once, connect_, [this](auto until) { return wait_until(until); });
    if (found.stream) connected_ = Clock::now();
    return found;
  }

  /// False when it was stopped meanwhile.
  bool wait_until(Clock::time_point until) {
    while (Clock::now() < until) {
      show();
      if (stop()) return false;
      std::this_thread::sleep_for(std::min<Clock::duration>(poll_time, until - Clock::now()));
    }
    return true;
  }

  /// What was done to the log, which holds nothing for sure from its first failure on.
  Result<void> sound(Result<void> done) {
    log_is_sound_ = log_is_sound_ && done;
    return done;
  }

  /// First the disk, then the people.
  Result<void> settle(const std::vector<capture::CapturedReading>& readings, bool last) {
    if (log_ != nullptr && telling_.is_new(session_, readings)) AXIOMETRY_TRY_VOID(sound(log_->sync()));
    return telling_.tell(session_, readings, {.last = last, .first_arrival = first_arrival_});
  }

  void show() {
    if (!observer_.now || Clock::now() - shown_ < show_every) return;
    shown_ = Clock::now();
    observer_.now(session_);
  }

  const CaptureRun& run_;
  const CaptureObserver& observer_;
  CaptureSession session_;
  Connect connect_;
  LiveCapture live_{.name = {}, .connect = {}, .raw = {}};
  Clock::time_point connected_, shown_;
  std::optional<Outage> outage_;
  std::uint64_t room_ = UINT64_MAX;  // how many bytes may still come
  PipedLog piped_;
  RawLog* log_ = nullptr;
  std::optional<RawHold> hold_;
  std::optional<ArrivalNs> first_arrival_;
  CaptureSession::End end_ = CaptureSession::End::of_reading;
  CaptureTelling telling_;
  bool stopped_ = false, abandoned_ = false, log_is_sound_ = false;
  PlanEnd end_of_plan_{Duration::s(0)};
};

/// Listens where the run says and has the reading end as `outcome` does; an error names the source.
template <typename Outcome>
auto from_source(const CaptureRun& run, const CaptureObserver& observer, CaptureSession session, Outcome outcome)
    -> std::invoke_result_t<Outcome, Run&> {
  AXIOMETRY_TRY(const auto live, parse_live(run.from));
  if (live && live->kind == LiveAddress::Kind::simulator && !run.connect)
    return fail("found the simulator as source of positions or lengths, expected it for straightness or rotations");
  Run reading(run, observer, std::move(session));
  LiveCapture source{.name = {}, .connect = run.connect, .raw = {}, .beside = run.beside};
  if (live && !run.connect) source.connect = [address = *live] { return connect_to(address); };
  if (source.connect) reading.listen(source);
  auto result = outcome(reading);
  if (!result && result.error().file.empty()) result.error().file = run.from == "-" ? "(standard input)" : run.from;
  return result;
}

template <typename Outcome>
auto from_stream(const LiveCapture& capture, const CaptureObserver& observer, CaptureSession session, Outcome outcome)
    -> std::invoke_result_t<Outcome, Run&> {
  const CaptureRun run{
      .from = capture.name, .raw = capture.raw, .resume = capture.resume, .out = {}, .give_up = capture.give_up};
  Run reading(run, observer, std::move(session));
  reading.listen(capture);
  return outcome(reading);
}

}  // namespace

Result<CaptureOutcome> run_capture(const CaptureRun& run, const CaptureOptions& options,
                                   const CaptureObserver& observer) {
  AXIOMETRY_TRY_VOID(check_recording_spared(run, options.plan));
  AXIOMETRY_TRY_VOID(check_ending(run.out, {".json"}));
  AXIOMETRY_TRY(Plan plan, load_plan(options.plan, options.part.value_or(1)));
  AXIOMETRY_TRY(CaptureSession session, CaptureSession::open(std::move(plan), options));
  return from_source(run, observer, std::move(session), [](Run& reading) { return reading(); });
}

Result<HeardSource> hear_source(const CaptureRun& run, CaptureSession session, const CaptureObserver& observer) {
  return from_source(run, observer, std::move(session), [](Run& reading) -> Result<HeardSource> {
    HeardLive all = reading.heard();
    return all.trouble ? Result<HeardSource>(std::unexpected(*std::move(all.trouble))) : std::move(all.heard);
  });
}

Result<CaptureOutcome> run_live_capture(CaptureSession session, const LiveCapture& capture,
                                        const CaptureObserver& observer) {
  return from_stream(capture, observer, std::move(session), [](Run& reading) { return reading(); });
}

HeardLive hear_live(CaptureSession session, const LiveCapture& capture, const CaptureObserver& observer) {
  return from_stream(capture, observer, std::move(session), [](Run& reading) { return reading.heard(); });
}

}  // namespace axiometry::app
