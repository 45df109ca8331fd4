// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/part_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "axiometry/app/recordings/read_recording.h"
#include "axiometry/app/recordings/stop_notes.h"
#include "axiometry/base/counted.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"
#include "axiometry/model/simulated.h"

namespace axiometry::app {
namespace {

using capture::StopMatcher;
using volumetric::CalibrationPlan;

constexpr double far_better = 12.0;  // three changes of length that fit: docs/theory/capture-lengths.md

/// Parts, and what it costs to explain the standstills by them.
struct Explanation {
  PartRange parts;
  double cost = 0.0;
};

/// Of all parts that have stops, the cheapest first; of those that cost the same the fewest parts.
std::vector<Explanation> explanations(const CalibrationPlan& plan, bool with_all, const StopMatcher& heard) {
  std::vector<PartRange> candidates;
  for (std::size_t part = 1; part <= plan.runs.size(); ++part)
    if (!plan.runs[part - 1].stops.empty()) candidates.push_back({part, part});
  if (with_all && candidates.size() > 1) candidates.push_back({1, plan.runs.size()});
  std::vector<Explanation> all;
  for (const PartRange& parts : candidates)
    all.push_back({parts, capture::matched_to(heard, part_stops(plan, parts).list.stops).cost()});
  std::ranges::stable_sort(all, {}, &Explanation::cost);
  return all;
}

bool overlap(PartRange a, PartRange b) { return a.first <= b.last && b.first <= a.last; }

Result<PartRange> chosen_parts(const CalibrationPlan& plan, std::optional<PartRange> said, bool may_hold_all,
                               const StopMatcher& heard) {
  const std::vector<Explanation> all = explanations(plan, may_hold_all && !said, heard);
  const std::string fitting = counted(heard.standstills().size(), "standstill that fits", "standstills that fit");
  if (said) {
    const double own = capture::matched_to(heard, part_stops(plan, *said).list.stops).cost();
    const auto other = std::ranges::find_if(all, [&](const Explanation& e) { return !overlap(e.parts, *said); });
    if (other != all.end() && other->cost + far_better < own)
      return fail(fmt::format("found {} {} far better, expected those of {}", fitting, part_text(plan, other->parts),
                              part_text(plan, *said)));
    return *said;
  }
  const Explanation& best = all.front();
  const auto next = std::ranges::find_if(all, [&](const Explanation& e) { return !overlap(e.parts, best.parts); });
  if (next != all.end() && next->cost < best.cost + far_better)
    return fail(
        fmt::format("found {} {} about as well as {}, expected those of one: say which part it is, if it "
                    "is one of this plan at all",
                    fitting, part_text(plan, best.parts), part_text(plan, next->parts)));
  return best.parts;
}

/// Lengths and where they belong, out of what was found at the stops.
void take_lengths(const CalibrationPlan& plan, const capture::StopLengths& found, std::span<const PartStop> places,
                  PartLengths& lengths) {
  volumetric::VolumetricLengths& table = lengths.lengths;
  for (const volumetric::NamedStation& station : plan.machine.stations) table.stations.push_back(station.name);
  for (const volumetric::Tool& tool : plan.machine.tools) table.tools.push_back(tool.name);
  std::size_t run = std::numeric_limits<std::size_t>::max(), heard = 0, segment = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& length = found.stops[k].length;
    if (!length) continue;
    if (places[k].run != run)
      segment = 0;
    else if (length->segment != heard)
      ++segment;
    run = places[k].run;
    heard = length->segment;
    while (table.segments.size() <= segment) table.segments.push_back(fmt::format("{}", table.segments.size() + 1));
    table.readings.push_back({plan.runs[run].station, plan.runs[run].tool, segment,
                              plan.runs[run].stops[places[k].stop].axes_mm, length->length_mm});
    lengths.places.push_back(places[k]);
  }
}

}  // namespace

Result<PartLengths> part_lengths(const CalibrationPlan& plan, std::optional<PartRange> said, bool may_hold_all,
                                 const CaptureSession& session) {
  const StopMatcher& heard = session.stops()->matcher();
  if (heard.standstills().empty()) AXIOMETRY_TRY_VOID(capture::stop_lengths(heard));
  AXIOMETRY_TRY(const PartRange parts, chosen_parts(plan, said, may_hold_all, heard));
  const PartStops stops = part_stops(plan, parts);
  AXIOMETRY_TRY(const capture::StopLengths found, capture::stop_lengths(capture::matched_to(heard, stops.list.stops)));
  PartLengths lengths;
  lengths.parts = parts;
  take_lengths(plan, found, stops.places, lengths);
  if (lengths.places.empty())
    return fail(fmt::format("found no length for any of the {} points of {} in {}", stops.places.size(),
                            part_text(plan, parts), counted(found.standstills, "standstill")));
  lengths.planned = stops.places.size();
  lengths.samples = session.samples();
  lengths.simulated = session.simulated();
  lengths.layout = session.layout();
  lengths.notes.push_back(fmt::format("{}: a continuous recording of {} samples gave {} of {} lengths",
                                      part_text(plan, parts), session.samples(), lengths.places.size(),
                                      stops.places.size()));
  const StopNames names{.group = [&](std::size_t k) { return fmt::format("part {}", stops.places[k].run + 1); },
                        .name = [&](std::size_t k) { return fmt::format("point {}", stops.places[k].stop + 1); }};
  std::ranges::move(recording_notes(session, found, names), std::back_inserter(lengths.notes));
  return lengths;
}

Result<CaptureSession> open_parts(const CalibrationPlan& plan, PartRange parts, const CaptureOptions& options) {
  AXIOMETRY_TRY_VOID(check_parts(plan, parts));
  if (options.matcher.zero_at_first_target || options.matcher.datum != Position{})
    return fail("found a datum or a zero for lengths, expected none: their dead path is not known");
  return CaptureSession::open(part_stops(plan, parts).list, options);
}

Result<PartLengths> read_part_recording(Source& source, const CalibrationPlan& plan, std::optional<PartRange> said,
                                        bool may_hold_all, const CaptureOptions& options) {
  const auto usable = std::ranges::find_if(plan.runs, [](const auto& run) { return !run.stops.empty(); });
  if (usable == plan.runs.end()) return fail("found a plan without points, expected at least one");
  const std::size_t first = static_cast<std::size_t>(usable - plan.runs.begin()) + 1;
  AXIOMETRY_TRY(CaptureSession session,
                open_parts(plan, said.value_or(PartRange{first, first}), options_of_source(source, options)));
  AXIOMETRY_TRY(std::string sha256, hear(source, session));
  AXIOMETRY_TRY(PartLengths lengths, part_lengths(plan, said, may_hold_all, session));
  lengths.sha256 = std::move(sha256);
  return lengths;
}

std::string part_lengths_table(const PartLengths& lengths) {
  std::string text = lengths.simulated ? fmt::format("# {}\n", simulated_note) : "";
  for (const std::string& note : lengths.notes) text += fmt::format("# {}\n", note);
  return text + formats::write_volumetric_lengths(lengths.lengths);
}

}  // namespace axiometry::app
