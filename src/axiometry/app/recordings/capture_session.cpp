// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/capture_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/model/simulated.h"

namespace axiometry::app {
namespace {

constexpr std::size_t plan_limit = std::size_t{64} << 20;
constexpr std::size_t lines_to_recognise = 4;  // start-up text, a header and two samples
constexpr std::size_t most_to_recognise = std::size_t{64} << 10;

capture::StandstillOptions rest_options(capture::StandstillOptions rest, const CaptureOptions& options) {
  if (options.rest_window) {
    // What a window may move by at most grows with it; what is made of windows follows.
    const double ratio = options.rest_window->in_s() / rest.window.in_s();
    rest.greatest = Position::native(rest.greatest.in_native() * ratio);
    rest.window = rest.settling = *options.rest_window;
    rest.shortest = std::max(rest.shortest, Duration(2.0 * rest.window));
  }
  if (options.settling) rest.settling = *options.settling;
  if (options.shortest_rest) rest.shortest = *options.shortest_rest;
  rest.threshold = options.rest_threshold;
  return rest;
}

Result<formats::RecordingOptions> recording_options(AxisKind kind, const CaptureOptions& options) {
  formats::RecordingOptions recording = options.recording;
  recording.kind = kind;
  if (options.wavelength_nm.has_value() != options.counts_per_wavelength.has_value())
    return fail("found only one of the wavelength and the counts per wavelength, expected both or neither");
  if (!options.wavelength_nm) return recording;
  if (recording.units_per_count) return fail("found a length per count and a wavelength, expected one of them");
  AXIOMETRY_TRY(recording.units_per_count,
                formats::mm_per_count(Length::nm(*options.wavelength_nm), *options.counts_per_wavelength));
  return recording;
}

/// Whether a layout without lines is known for sure. It is looked whenever the beginning has doubled, so that all looks
/// cost no more than the last one.
bool is_certain(std::string_view head, std::size_t before) {
  constexpr std::size_t first_look = 64;  // bytes: three frames
  constexpr int sure = 100;
  if (std::bit_width(head.size() / first_look) == std::bit_width(before / first_look)) return false;
  return std::ranges::any_of(formats::recording_table(), [head](const auto* r) { return r->recognise(head) == sure; });
}

/// Deviations are told from positions; what is read after another plan is none of them.
Result<Plan> of_positions(Plan plan) {
  if (measures_positions(plan)) return plan;
  return fail(
      fmt::format("found a plan made for {}, expected one of positions; one of other errors is captured where it is "
                  "stated what tells the stops",
                  errors_text(plan)));
}

Result<void> check_settling(const CaptureOptions& options, Duration dwell) {
  if (!options.settling || *options.settling < dwell) return {};
  return fail(fmt::format("found {} s of settling, expected less than the {} s the plan dwells at a target",
                          format_exact(options.settling->in_s()), format_exact(dwell.in_s())));
}

}  // namespace

Result<Plan> load_any_plan(const std::string& file) {
  AXIOMETRY_TRY(Source source, Source::open(file));
  AXIOMETRY_TRY(const std::string bytes, source.read_all(plan_limit));
  return in_file(formats::read_plan(bytes), file);
}

Result<Plan> load_plan(const std::string& file, std::size_t part) {
  AXIOMETRY_TRY(Plan plan, load_any_plan(file));
  if (part == 1) return in_file(of_positions(std::move(plan)), file);
  if (part == 0 || part > plan.further.size() + 1)
    return std::unexpected(
        Error{fmt::format("found part {} asked for, expected 1 to {}: the plan and those that belong "
                          "to it",
                          part, plan.further.size() + 1),
              file,
              {}});
  return in_file(of_positions(std::move(plan.further[part - 2])), file);
}

Result<CaptureSession> CaptureSession::open(Plan plan, const CaptureOptions& options) {
  CaptureSession session;
  if (!options.motion) AXIOMETRY_TRY_VOID(of_positions(plan));
  AXIOMETRY_TRY_VOID(session.open_stream(options, plan.axis.kind));
  const capture::StandstillOptions rest = rest_options(capture::standstill_options(plan), options);
  AXIOMETRY_TRY_VOID(check_settling(options, plan.dwell));
  if (options.motion) {
    AXIOMETRY_TRY(MotionListener motion, MotionListener::make(std::move(plan), *options.motion, rest, options.matcher));
    session.motion_ = std::make_unique<MotionListener>(std::move(motion));
    return session;
  }
  session.detector_ = std::make_unique<capture::StandstillDetector>(rest);
  if (plan.axis.kind == AxisKind::rotary) session.turns_.emplace(capture::fastest_turn(plan.feed));
  capture::MatcherOptions matcher = options.matcher;
  matcher.shortest = rest.shortest;
  AXIOMETRY_TRY(capture::TargetMatcher made, capture::TargetMatcher::make(std::move(plan), matcher));
  session.matcher_.emplace(std::move(made));
  return session;
}

Result<CaptureSession> CaptureSession::open(const TrackingPlan& plan, const CaptureOptions& options) {
  if (options.part || options.matcher.zero_at_first_target || options.matcher.datum != Position{})
    return fail(
        "found a part, a datum or a zero for a plan of lines, expected none: lengths have a dead path that is not "
        "known");
  for (const TrackingLine& line : plan.lines)
    if (const auto sound = check_sound(line.plan); !sound || !spatial_line(line.plan.axis))
      return fail(
          fmt::format("the line {}: {}", text::quoted(line.id),
                      sound ? "found no place in space, expected its origin and direction" : sound.error().message));
  capture::StopList list = capture::line_stops(plan).list;
  if (list.stops.empty()) return fail("found a plan without lines, expected at least one");
  return open(std::move(list), options);
}

Result<CaptureSession> CaptureSession::open(capture::StopList list, const CaptureOptions& options) {
  CaptureSession session;
  AXIOMETRY_TRY_VOID(session.open_stream(options, AxisKind::linear));
  AXIOMETRY_TRY_VOID(check_settling(options, list.drive.dwell));
  capture::StopOptions stops{.drive = list.drive, .matcher = {}};
  stops.rest = rest_options(capture::standstill_options(list.drive), options);
  stops.matcher.tolerance_mm = options.matcher.window ? options.matcher.window->in_native() : list.tolerance_mm;
  stops.matcher.station_error_mm = list.station_error_mm;
  stops.matcher.direction_counts = list.direction_counts;
  stops.matcher.reversed = options.matcher.reversed;
  stops.fastest_mm_per_s = capture::fastest_motion(list.drive.feed);
  session.stops_ = std::make_unique<capture::StopListener>(std::move(list.stops), stops);
  return session;
}

Result<void> CaptureSession::open_stream(const CaptureOptions& options, AxisKind kind) {
  options_ = options;
  AXIOMETRY_TRY(options_.recording, recording_options(kind, options));
  arrival_s_ = std::make_shared<double>(0.0);
  if (options.stream.empty()) return {};
  layout_ = formats::find_recording(options.stream);
  if (layout_ != nullptr) return {};
  std::string ids;
  for (const formats::Recording* r : formats::recording_table())
    ids += fmt::format("{}{}", ids.empty() ? "" : ", ", r->id);
  return fail(fmt::format("found the unknown stream {}, expected one of {}", text::quoted(options.stream), ids));
}

/// False while too little has come to know the layout.
Result<bool> CaptureSession::begin(bool whole) {
  if (layout_ == nullptr) {
    const auto lines = static_cast<std::size_t>(std::ranges::count(head_, '\n'));
    const bool enough = whole || lines >= lines_to_recognise || head_.size() >= most_to_recognise;
    if (!enough) return false;
    AXIOMETRY_TRY(layout_, formats::recognise_recording(std::string_view(head_).substr(0, most_to_recognise)));
  }
  formats::RecordingOptions recording = options_.recording;
  if (recording.arrival_s) recording.arrival_s = [arrival = arrival_s_] { return *arrival; };
  if (motion_) {
    AXIOMETRY_TRY_VOID(motion_->check_layout(*layout_));
    if (const auto beside = motion_->beside(recording)) {
      AXIOMETRY_TRY(beside_, layout_->open(*beside));
    }
    recording.meaning = formats::ChannelMeaning::value;
  }
  AXIOMETRY_TRY(reader_, layout_->open(recording));
  return true;
}

Result<std::vector<capture::CapturedReading>> CaptureSession::feed(std::string_view bytes,
                                                                   std::optional<double> arrival_s) {
  if (rest_refused_) return found_before();
  auto readings = take(bytes, arrival_s);
  if (readings || !matcher_ || !matcher_->complete()) return readings;
  rest_refused_ = true;
  leave_out_rest(readings.error());
  return found_before();
}

Result<std::vector<capture::CapturedReading>> CaptureSession::take(std::string_view bytes,
                                                                   std::optional<double> arrival_s) {
  if (arrival_s) {
    *arrival_s_ = *arrival_s;
    // Any function says that arrivals are known; the reader gets one of ours.
    if (!reader_) options_.recording.arrival_s = [] { return 0.0; };
  }
  if (beginning_.size() < simulated_head_most) beginning_ += bytes.substr(0, simulated_head_most - beginning_.size());
  if (reader_) return read(bytes);
  const std::size_t before = head_.size();
  head_ += bytes;
  const auto begun = begin(layout_ == nullptr && is_certain(head_, before));
  if (!begun) head_.clear();  // what comes behind it may be recognised
  if (!begun) return std::unexpected(begun.error());
  if (!*begun) return found_before();
  const std::string head = std::exchange(head_, {});
  return read(head);
}

SampleSink CaptureSession::sink() {
  return [this](std::span<const Sample> samples) -> Result<void> {
    samples_ += samples.size();
    if (motion_) return motion_->push(samples, reader_->unit(), reader_->name());
    stops_ ? stops_->push(samples) : take_positions(samples);
    return {};
  };
}

void CaptureSession::take_positions(std::span<const Sample> samples) {
  if (!turns_) return match(detector_->push(samples));
  samples = turns_->follow(samples);
  if (const auto rolls = turns_->rolls_from_s()) matcher_->rolls_from(*rolls);
  match(detector_->push(samples));
}

SampleSink CaptureSession::sink_beside() {
  return [this](std::span<const Sample> samples) -> Result<void> {
    motion_->push_beside(samples);
    return {};
  };
}

/// Of both channels in the order that ValueListener asks for, also where one fails: what stood before in the other
/// counts.
Result<void> CaptureSession::for_channels(
    const std::function<Result<void>(formats::RecordingReader&, const SampleSink&)>& call) {
  const bool first = beside_ && motion_->beside_comes_first();
  auto beside = first ? call(*beside_, sink_beside()) : Result<void>{};
  auto read = call(*reader_, sink());
  if (!first && beside_) beside = call(*beside_, sink_beside());
  return read ? beside : read;
}

Result<std::vector<capture::CapturedReading>> CaptureSession::read(std::string_view bytes) {
  AXIOMETRY_TRY_VOID(for_channels([bytes](auto& reader, const auto& to) { return reader.feed(bytes, to); }));
  return found_before();
}

/// Samples are missing, or the recording ends.
void CaptureSession::interrupt() {
  if (motion_) return motion_->interrupt();
  stops_ ? stops_->interrupt() : match(detector_->interrupt());
}

void CaptureSession::match(const std::vector<capture::Standstill>& standstills) {
  for (const capture::Standstill& standstill : standstills)
    std::ranges::move(matcher_->take(standstill), std::back_inserter(found_));
}

Result<std::vector<capture::CapturedReading>> CaptureSession::interrupted() {
  if (!reader_) {
    head_.erase(head_.rfind('\n') + 1);  // npos + 1 is 0
    return found_before();
  }
  AXIOMETRY_TRY_VOID(for_channels([](auto& reader, const auto& to) { return reader.interrupted(to); }));
  interrupt();
  return found_before();
}

Result<std::vector<capture::CapturedReading>> CaptureSession::finish(End end) {
  if (!reader_) {
    AXIOMETRY_TRY([[maybe_unused]] const bool begun, begin(true));
    AXIOMETRY_TRY(found_, read(std::exchange(head_, {})));
  }
  const auto read_out = rest_refused_ ? Result<void>{} : for_channels([end](auto& reader, const auto& to) {
    const auto cut = end == End::of_file ? Result<void>{} : reader.interrupted(to);  // no part of a line
    return cut ? reader.finish(to) : cut;
  });
  if (!read_out && samples_ == 0) return std::unexpected(read_out.error());
  if (!read_out) remark(fmt::format("left out the end of the recording: {}", read_out.error().message));
  if (motion_) AXIOMETRY_TRY_VOID(motion_->finish());
  if (motion_) return found_before();
  interrupt();
  if (matcher_) AXIOMETRY_TRY_VOID(matcher_->finish());
  return found_before();
}

bool CaptureSession::complete() const {
  if (motion_) return motion_->values().complete();
  return stops_ ? stops_->matcher().complete() : matcher_->complete();
}

std::size_t CaptureSession::taken() const {
  if (motion_) return motion_->values().taken();
  return stops_ ? stops_->matcher().matched() : matcher_->result().readings.size();
}

std::size_t CaptureSession::expected() const {
  if (motion_) return motion_->values().expected();
  return stops_ ? stops_->matcher().stops().size() : matcher_->result().approaches;
}

std::optional<capture::StandstillDetector::Whereabouts> CaptureSession::now() const {
  if (motion_) return axis_;
  if (stops_) return stops_->now();
  auto now = detector_->now();
  if (now && turns_) now->position = Position::native(turns_->shown_deg(now->position.in_native()));
  return now;
}

std::vector<std::string> CaptureSession::remarks() const {
  std::vector<std::string> all = remarks_;
  if (reader_) std::ranges::move(reader_->remarks(), std::back_inserter(all));
  return all;
}

bool CaptureSession::simulated() const { return says_simulated(beginning_); }

void CaptureSession::leave_out_rest(const Error& refused) {
  rest_left_out_ = fmt::format("left out the rest of the recording: {}", refused.to_string());
  remark(rest_left_out_);
}

Result<Test> CaptureSession::test() const {
  auto captured = capture::captured_test(matcher_->plan(), matcher_->result());
  if (!captured && !rest_left_out_.empty()) captured.error().message += "; " + rest_left_out_;
  AXIOMETRY_TRY(Test test, std::move(captured));
  if (reader_) test.metadata.environment = reader_->environment();
  if (reader_ && reader_->lost() > 0)
    test.provenance.remarks.push_back(
        {false, fmt::format("the stream shows {} lost of {} samples", reader_->lost(), samples_ + reader_->lost())});
  for (std::string& text : remarks()) test.provenance.remarks.push_back({false, std::move(text)});
  test.provenance.format = layout();
  if (!simulated()) return test;
  test.metadata.machine.name = simulated_machine(test.metadata.machine.name);
  test.metadata.conditions.purpose = simulation_purpose;
  test.metadata.conditions.comment = simulated_note;
  return test;
}

}  // namespace axiometry::app
