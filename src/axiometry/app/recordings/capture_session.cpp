// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/capture_session.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/app/files/source.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/plan/plan_json.h"

namespace axiometry::app {
namespace {

constexpr std::size_t plan_limit = std::size_t{64} << 20;
constexpr std::size_t lines_to_recognise = 4;  // start-up text, a header and two samples
constexpr std::size_t most_to_recognise = std::size_t{64} << 10;

capture::StandstillOptions rest_options(const Plan& plan, const CaptureOptions& options) {
  capture::StandstillOptions rest = capture::standstill_options(plan);
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

Result<formats::RecordingOptions> recording_options(const Plan& plan, const CaptureOptions& options) {
  formats::RecordingOptions recording = options.recording;
  recording.kind = plan.axis.kind;
  if (options.wavelength_nm.has_value() != options.counts_per_wavelength.has_value())
    return fail("found only one of the wavelength and the counts per wavelength, expected both or neither");
  if (!options.wavelength_nm) return recording;
  if (recording.units_per_count) return fail("found a length per count and a wavelength, expected one of them");
  AXIOMETRY_TRY(recording.units_per_count,
                formats::mm_per_count(Length::nm(*options.wavelength_nm), *options.counts_per_wavelength));
  return recording;
}

}  // namespace

Result<Plan> load_plan(const std::string& file, std::size_t part) {
  AXIOMETRY_TRY(Source source, Source::open(file));
  AXIOMETRY_TRY(const std::string bytes, source.read_all(plan_limit));
  auto plan = formats::read_plan(bytes);
  if (!plan) {
    plan.error().file = file;
    return plan;
  }
  if (part == 1) return plan;
  if (part == 0 || part > plan->further.size() + 1)
    return std::unexpected(
        Error{fmt::format("found part {} asked for, expected 1 to {}: the plan and those that belong "
                          "to it",
                          part, plan->further.size() + 1),
              file,
              {}});
  return plan->further[part - 2];
}

Result<CaptureSession> CaptureSession::open(Plan plan, const CaptureOptions& options) {
  CaptureSession session;
  session.options_ = options;
  AXIOMETRY_TRY(session.options_.recording, recording_options(plan, options));
  session.arrival_s_ = std::make_shared<double>(0.0);
  const capture::StandstillOptions rest = rest_options(plan, options);
  if (options.settling && *options.settling >= plan.dwell)
    return fail(fmt::format("found {} s of settling, expected less than the {} s the plan dwells at a target",
                            format_exact(options.settling->in_s()), format_exact(plan.dwell.in_s())));
  session.detector_ = std::make_unique<capture::StandstillDetector>(rest);
  capture::MatcherOptions matcher = options.matcher;
  matcher.shortest = rest.shortest;
  AXIOMETRY_TRY(capture::TargetMatcher made, capture::TargetMatcher::make(std::move(plan), matcher));
  session.matcher_.emplace(std::move(made));
  if (options.stream.empty()) return session;
  session.layout_ = formats::find_recording(options.stream);
  if (session.layout_ == nullptr) {
    std::string ids;
    for (const formats::Recording* r : formats::recording_table())
      ids += fmt::format("{}{}", ids.empty() ? "" : ", ", r->id);
    return fail(fmt::format("found the unknown stream {}, expected one of {}", text::quoted(options.stream), ids));
  }
  return session;
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
  AXIOMETRY_TRY(reader_, layout_->open(recording));
  return true;
}

Result<std::vector<capture::CapturedReading>> CaptureSession::feed(std::string_view bytes,
                                                                   std::optional<double> arrival_s) {
  if (arrival_s) {
    *arrival_s_ = *arrival_s;
    // Any function says that arrivals are known; the reader gets one of ours.
    if (!reader_) options_.recording.arrival_s = [] { return 0.0; };
  }
  if (reader_) return read(bytes);
  head_ += bytes;
  const auto begun = begin(false);
  if (!begun) head_.clear();  // what comes behind it may be recognised
  if (!begun) return std::unexpected(begun.error());
  if (!*begun) return found_before();
  const std::string head = std::exchange(head_, {});
  return read(head);
}

SampleSink CaptureSession::sink() {
  return [this](std::span<const Sample> samples) -> Result<void> {
    samples_ += samples.size();
    match(detector_->push(samples));
    return {};
  };
}

Result<std::vector<capture::CapturedReading>> CaptureSession::read(std::string_view bytes) {
  AXIOMETRY_TRY_VOID(reader_->feed(bytes, sink()));
  return found_before();
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
  AXIOMETRY_TRY_VOID(reader_->interrupted(sink()));
  match(detector_->interrupt());
  return found_before();
}

Result<std::vector<capture::CapturedReading>> CaptureSession::finish(End end) {
  if (!reader_) {
    AXIOMETRY_TRY([[maybe_unused]] const bool begun, begin(true));
    AXIOMETRY_TRY(found_, read(std::exchange(head_, {})));
  }
  auto read_out = end == End::of_file ? Result<void>{} : reader_->interrupted(sink());  // no part of a line
  if (read_out) read_out = reader_->finish(sink());
  if (!read_out && samples_ == 0) return std::unexpected(std::move(read_out).error());
  if (!read_out) remark(fmt::format("left out the end of the recording: {}", read_out.error().message));
  match(detector_->interrupt());
  AXIOMETRY_TRY_VOID(matcher_->finish());
  return found_before();
}

std::vector<std::string> CaptureSession::remarks() const {
  std::vector<std::string> all = remarks_;
  if (reader_) std::ranges::move(reader_->remarks(), std::back_inserter(all));
  return all;
}

Result<Test> CaptureSession::test() const {
  AXIOMETRY_TRY(Test test, capture::captured_test(matcher_->plan(), matcher_->result()));
  if (reader_) test.metadata.environment = reader_->environment();
  if (reader_ && reader_->lost() > 0)
    test.provenance.remarks.push_back(
        {false, fmt::format("the stream shows {} lost of {} samples", reader_->lost(), samples_ + reader_->lost())});
  for (std::string& text : remarks()) test.provenance.remarks.push_back({false, std::move(text)});
  test.provenance.format = layout();
  return test;
}

}  // namespace axiometry::app
