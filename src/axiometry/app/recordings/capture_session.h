// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/recordings/motion_listener.h"
#include "axiometry/base/result.h"
#include "axiometry/capture/full_turns.h"
#include "axiometry/capture/stop_lengths.h"
#include "axiometry/capture/target_matcher.h"
#include "axiometry/formats/recording.h"
#include "axiometry/model/plan.h"
#include "axiometry/model/test.h"
#include "axiometry/model/tracking.h"

/// The use case "from the bytes of a recording to the readings of a plan".
namespace axiometry::app {

/// What a recording does not say itself.
struct CaptureOptions {
  std::string plan;  ///< file of the plan
  std::optional<std::size_t>
      part;            ///< 1 is the plan itself, 2 the first of its further plans; of a volumetric plan a run
  std::string stream;  ///< id of the layout; empty: recognised by content
  formats::RecordingOptions recording;
  capture::MatcherOptions matcher;
  std::optional<Duration> rest_window;  ///< replaces what capture::standstill_options() derives from the plan
  std::optional<Duration> settling;
  std::optional<Duration> shortest_rest;
  std::optional<Position> rest_threshold;
  std::optional<double> wavelength_nm;  ///< nm, beside counts_per_wavelength; in place of recording.units_per_count
  std::optional<double> counts_per_wavelength;
  std::optional<MotionStatement> motion{};  ///< readings of a straightness or a rotation, in place of positions
  std::string stated;  ///< name of an option that was stated, for what can use none; empty: none was
};

/// The plan of a file, or one of those that belong to it. Fails as formats::read_plan() does, on a part that does not
/// exist, and on a plan made for other errors than those of positions.
Result<Plan> load_plan(const std::string& file, std::size_t part);

/// The plan of a file, whatever is to be read at its stops.
Result<Plan> load_any_plan(const std::string& file);

/// One recording on its way to readings: of a plan, or (of_lines()) to the lengths at the stops of a tracking plan,
/// which capture/stop_lengths.h finds. The result depends on the bytes, their arrival and the places where the
/// connection broke, not on when it is asked for.
class CaptureSession {
 public:
  /// With options.motion of readings that do not show the stops: motion() knows them, none are handed on. Fails on
  /// options that contradict the plan or each other, without options.motion on a plan of other errors than those of
  /// positions, with it as MotionListener::make() does.
  static Result<CaptureSession> open(Plan plan, const CaptureOptions& options);
  /// Lengths of the lines of a plan: `target_window` is how far a change of length may be from the expected one; zero,
  /// datum and part are refused. Readings are not handed on as they come: stops() knows them.
  static Result<CaptureSession> open(const TrackingPlan& plan, const CaptureOptions& options);
  /// The same of any stops: no datum and no zero are looked at, since lengths have none.
  static Result<CaptureSession> open(capture::StopList list, const CaptureOptions& options);

  /// Fails as the reader of the layout does; readings of what stood before that are made, and handed on by
  /// found_before(). What is refused behind the last approach of a plan of positions is left out with all that follows,
  /// and remarked. `arrival_s` is nothing when it is never known, NaN when that of these bytes is not.
  Result<std::vector<capture::CapturedReading>> feed(std::string_view bytes, std::optional<double> arrival_s = {});
  /// Those made before the last call failed; once.
  std::vector<capture::CapturedReading> found_before() { return std::exchange(found_, {}); }
  /// The connection broke here.
  Result<std::vector<capture::CapturedReading>> interrupted();
  /// The recording ends here: a file that was read to its end, or else a stream that may have ended within a line, or
  /// what was read no further because the plan was complete. An end that is no sample is left out and remarked.
  enum class End { of_file, of_reading };
  Result<std::vector<capture::CapturedReading>> finish(End end);

  /// What is to be known of the recording beside its samples: a remark of the test.
  void remark(std::string text) { remarks_.push_back(std::move(text)); }

  /// The reader refused to go on: a remark, and the reason beside that of a test which cannot be made of the beginning.
  void leave_out_rest(const Error& refused);
  /// Those, and what the reader says of the order of its lines.
  std::vector<std::string> remarks() const;
  std::size_t unfinished() const { return reader_ ? reader_->unfinished() : head_.size() - head_.rfind('\n') - 1; }
  std::uint64_t without_break() const { return reader_ ? reader_->without_break() : 0; }

  /// Whether the recording says that nobody measured it; the test says it then too.
  bool simulated() const;

  /// The test as far as it has come; fails while there is none yet (capture::captured_test()).
  Result<Test> test() const;

  const capture::TargetMatcher& matcher() const { return *matcher_; }  ///< needs a plan of positions of one axis
  const capture::StopListener* stops() const { return stops_.get(); }  ///< nullptr for a plan of one axis
  const MotionListener* motion() const { return motion_.get(); }       ///< nullptr but for straightness and rotations
  /// What a person says at a stop; the time at which it counts in the recording. Needs motion().
  double press(capture::StopKey key) { return motion_->press(key); }
  bool complete() const;
  std::size_t taken() const;
  std::size_t expected() const;
  std::string_view layout() const { return layout_ == nullptr ? std::string_view() : layout_->id; }
  std::size_t samples() const { return samples_; }
  std::size_t lost() const { return reader_ ? reader_->lost() : 0; }
  Environment environment() const { return reader_ ? reader_->environment() : Environment{}; }
  /// Where the axis is; nothing of readings that do not tell it, unless somebody else does.
  std::optional<capture::StandstillDetector::Whereabouts> now() const;
  void tell_axis(capture::StandstillDetector::Whereabouts now) { axis_ = now; }  ///< where a simulated axis stands

 private:
  CaptureSession() = default;
  Result<void> open_stream(const CaptureOptions& options, AxisKind kind);
  void interrupt();
  Result<bool> begin(bool whole);
  Result<std::vector<capture::CapturedReading>> take(std::string_view bytes, std::optional<double> arrival_s);
  Result<std::vector<capture::CapturedReading>> read(std::string_view bytes);
  void take_positions(std::span<const Sample> samples);
  void match(const std::vector<capture::Standstill>& standstills);
  SampleSink sink();
  SampleSink sink_beside();
  Result<void> for_channels(const std::function<Result<void>(formats::RecordingReader&, const SampleSink&)>& call);

  CaptureOptions options_;
  std::optional<capture::TargetMatcher> matcher_;
  std::unique_ptr<capture::StandstillDetector> detector_;
  std::optional<capture::FullTurns> turns_;       // of a rotary axis
  std::unique_ptr<capture::StopListener> stops_;  // in place of both others, where lengths are captured
  std::unique_ptr<MotionListener> motion_;        // likewise
  std::optional<capture::StandstillDetector::Whereabouts> axis_;
  const formats::Recording* layout_ = nullptr;
  std::unique_ptr<formats::RecordingReader> reader_;
  std::unique_ptr<formats::RecordingReader> beside_;  // reader of what tells the stops of motion_, in the same bytes
  std::string head_;                                  // the first bytes, until the layout is known
  std::string beginning_;                             // as much as says_simulated() looks at
  std::shared_ptr<double> arrival_s_;
  std::size_t samples_ = 0;
  std::vector<std::string> remarks_;
  bool rest_refused_ = false;                    // behind the last approach
  std::string rest_left_out_;                    // the remark of that; empty while nothing is
  std::vector<capture::CapturedReading> found_;  // readings that were not handed on yet
};

}  // namespace axiometry::app
