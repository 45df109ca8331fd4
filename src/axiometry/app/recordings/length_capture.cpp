// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/length_capture.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "axiometry/app/recordings/read_recording.h"
#include "axiometry/base/number_text.h"
#include "axiometry/capture/capture_result.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"

namespace axiometry::app {
namespace {

using capture::StopLack;

constexpr std::size_t most_named = 6;

/// What a person must know of a recording of lengths.
class LengthNotes {
 public:
  LengthNotes(const TrackingPlan& plan, const std::vector<capture::LineStop>& approaches,
              const capture::StopLengths& lengths)
      : plan_(plan), approaches_(approaches), lengths_(lengths) {}

  std::vector<std::string> run() {
    tell_lacks();
    tell_segments();
    tell_unused();
    tell_remarks();
    return std::move(notes_);
  }

 private:
  std::string name(std::size_t stop) const { return capture::approach_name(approaches_[stop].approach); }
  const std::string& line(std::size_t stop) const { return plan_.lines[approaches_[stop].line].id; }

  static std::string_view lack_text(StopLack lack) {
    switch (lack) {
      case StopLack::no_standstill: return "no standstill";
      case StopLack::too_short: return "the rest was too short";
      case StopLack::ambiguous: return "what was there may as well belong to another approach that was not heard";
      case StopLack::not_reached: return "the recording ended before";
    }
    return "";
  }

  void tell_lacks() {
    std::map<std::pair<std::size_t, StopLack>, std::vector<std::size_t>> lacking;
    for (std::size_t k = 0; k < lengths_.stops.size(); ++k)
      if (!lengths_.stops[k].length) lacking[{approaches_[k].line, lengths_.stops[k].lack}].push_back(k);
    for (const auto& [what, stops] : lacking) {
      std::string names;
      for (std::size_t k = 0; k < std::min(stops.size(), most_named); ++k)
        names += fmt::format("{}{}", k == 0 ? "" : ", ", name(stops[k]));
      if (stops.size() > most_named) names += fmt::format(" and {} others", stops.size() - most_named);
      notes_.push_back(
          fmt::format("line {}: no length for {}: {}", plan_.lines[what.first].id, names, lack_text(what.second)));
    }
  }

  void tell_segments() {
    for (const capture::SegmentBegin& begin : lengths_.segments) {
      const std::string where = fmt::format("line {}: before {} (at {} s)", line(begin.stop), name(begin.stop),
                                            format_fixed(begin.time_s, 1));
      notes_.push_back(begin.untold ? where +
                                          " the lengths jump as no line of the plan does: the beam was broken, and "
                                          "the lengths from there on have another dead path"
                                    : where +
                                          " samples are missing or the length jumped: the lengths from there on "
                                          "have another dead path");
    }
  }

  void tell_unused() {
    if (lengths_.unused.empty()) return;
    notes_.push_back(
        fmt::format("the reflector rested where no approach of the plan was due, first at {} s; not used ({} in all)",
                    format_fixed(lengths_.unused.front().begin_s, 1), lengths_.unused.size()));
  }

  void tell_remarks() {
    std::size_t told = 0, others = 0;
    for (std::size_t k = 0; k < lengths_.stops.size(); ++k) {
      if (!lengths_.stops[k].length) continue;
      for (const std::string& remark : lengths_.stops[k].length->remarks) {
        if (told++ < most_named)
          notes_.push_back(fmt::format("line {}: {}: {}", line(k), name(k), remark));
        else
          ++others;
      }
    }
    if (others > 0) notes_.push_back(fmt::format("{} further remarks of that kind on readings", others));
  }

  const TrackingPlan& plan_;
  const std::vector<capture::LineStop>& approaches_;
  const capture::StopLengths& lengths_;
  std::vector<std::string> notes_;
};

}  // namespace

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
    return fail(fmt::format("found no length for any of the {} approaches of the plan in {} standstills",
                            approaches.size(), found.standstills));
  lengths.approaches = approaches.size();
  lengths.samples = session.samples();
  lengths.layout = session.layout();
  lengths.notes.push_back(fmt::format("a continuous recording of {} samples gave {} of the {} lengths of the plan",
                                      session.samples(), lengths.readings.size(), approaches.size()));
  std::ranges::move(LengthNotes(plan, approaches, found).run(), std::back_inserter(lengths.notes));
  if (session.lost() > 0)
    lengths.notes.push_back(
        fmt::format("the stream shows {} lost of {} samples", session.lost(), session.samples() + session.lost()));
  std::ranges::move(session.remarks(), std::back_inserter(lengths.notes));
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
  std::string text;
  for (const std::string& note : lengths.notes) text += fmt::format("# {}\n", note);
  return text + formats::write_tracking_lengths(lengths.readings, lengths.times_s);
}

}  // namespace axiometry::app
