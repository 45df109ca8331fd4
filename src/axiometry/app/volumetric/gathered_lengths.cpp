// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/gathered_lengths.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/recordings/recording_members.h"
#include "axiometry/app/volumetric/part_lengths.h"
#include "axiometry/app/volumetric/planned_points.h"
#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/text/simulated_note.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"

namespace axiometry::app {
namespace {

using volumetric::CalibrationPlan;
using volumetric::VolumetricLengths;
using volumetric::VolumetricReading;

/// 100 million readings of 40 bytes.
constexpr std::size_t lengths_most_bytes = std::size_t{4} << 30;

/// Numbers of names over all files.
class GatheredNames {
 public:
  explicit GatheredNames(std::vector<std::string>& names) : names_(names) {}
  std::size_t number(const std::string& name) {
    const auto [at, is_new] = numbers_.emplace(name, names_.size());
    if (is_new) names_.push_back(name);
    return at->second;
  }

 private:
  std::vector<std::string>& names_;
  std::map<std::string, std::size_t> numbers_;
};

class Gathering {
 public:
  Gathering(const LengthsRequest& request, const CalibrationPlan* plan)
      : request_(request),
        plan_(plan),
        stations_(all_.lengths.stations),
        tools_(all_.lengths.tools),
        segments_(all_.lengths.segments) {
    for (const PartRange& parts : request.parts)
      for (std::size_t part = parts.first; plan != nullptr && part <= std::min(parts.last, plan->runs.size()); ++part)
        ++times_said_[part - 1];
  }

  Result<GatheredLengths> run() {
    for (std::size_t k = 0; k < request_.files.size(); ++k) AXIOMETRY_TRY_VOID(in_file(take(k), request_.files[k]));
    if (recordings_ < request_.parts.size())
      return fail(fmt::format("found parts for {} recordings and {} recordings, expected as many",
                              request_.parts.size(), recordings_));
    if (recordings_ == 0 && request_.recording.matcher.reversed)
      return fail("found reversed lengths in tables alone, expected them of a continuous recording");
    if (recordings_ == 0) AXIOMETRY_TRY_VOID(check_no_recording_stated(request_.recording));
    if (plan_ != nullptr) tell_missing_parts();
    return std::move(all_);
  }

 private:
  Result<Source> opened(std::size_t k) const {
    if (request_.given.empty()) return Source::open(request_.files[k]);
    return Source::of_bytes(request_.given[k].name, request_.given[k].bytes);
  }

  Result<void> take(std::size_t k) {
    const std::string& file = request_.files[k];
    AXIOMETRY_TRY(Source source, opened(k));
    AXIOMETRY_TRY(const std::string_view head, source.head());
    if (!request_.recording.stream.empty() || formats::is_volumetric_recording(head)) return take_recording(source);
    AXIOMETRY_TRY(const std::string bytes, source.read_all(lengths_most_bytes));
    AXIOMETRY_TRY(VolumetricLengths table, formats::read_volumetric_lengths(bytes));
    if (plan_ != nullptr) {
      AXIOMETRY_TRY(auto findings, check_planned(*plan_, table));
      std::ranges::move(findings, std::back_inserter(all_.findings));
    }
    for (std::string& remark : table.remarks) {
      const bool simulated = remark == formats::simulated_lengths;
      tell(simulated ? "volumetric-simulated" : "volumetric-passed-over", std::move(remark));
    }
    AXIOMETRY_TRY_VOID(check_own(table));
    all_.files.push_back({base_name(file), sha256(bytes), table.readings.size()});
    add(table, {});
    return {};
  }

  /// Each station with each tool out of one table, or of recordings.
  Result<void> check_own(const VolumetricLengths& table) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (const VolumetricReading& r : table.readings) pairs.emplace(table.stations[r.station], table.tools[r.tool]);
    for (const auto& pair : pairs)
      if (const auto [at, is_new] = from_.emplace(pair, all_.files.size()); !is_new)
        return fail(
            fmt::format("found lengths of station {} with tool {} again, which {} has too, expected each "
                        "station with each tool in one file",
                        text::quoted(pair.first), text::quoted(pair.second), name_of(at->second)));
    return {};
  }

  Result<void> take_recording(Source& source) {
    if (plan_ == nullptr)
      return fail(
          "found a continuous recording, expected the plan that was driven beside it, or a table of "
          "lengths");
    std::optional<PartRange> said;
    if (!request_.parts.empty()) {
      if (recordings_ >= request_.parts.size())
        return fail(fmt::format("found parts for {} recordings and one more recording, expected as many",
                                request_.parts.size()));
      said = request_.parts[recordings_];
    }
    ++recordings_;
    AXIOMETRY_TRY(PartLengths part,
                  read_part_recording(source, *plan_, said, request_.files.size() == 1, request_.recording));
    AXIOMETRY_TRY_VOID(check_stops(part));
    all_.files.push_back(
        {base_name(source.name()), part.sha256, part.lengths.readings.size(), part.layout, part.parts, part.planned});
    for (std::string& note : part.notes)
      tell("volumetric-recording", all_.files.size() == 1 && request_.files.size() == 1
                                       ? std::move(note)
                                       : fmt::format("recording {}: {}", base_name(source.name()), note));
    add(part.lengths, part.places);
    return {};
  }

  /// A part that was recorded twice may be one that was mistaken for another.
  Result<void> check_stops(const PartLengths& part) {
    const std::size_t file = all_.files.size();
    std::set<std::size_t> runs;
    for (const PartStop& place : part.places) {
      runs.insert(place.run);
      if (const auto [at, is_new] = stops_.emplace(std::pair(place.run, place.stop), file); !is_new)
        return fail(fmt::format("found a length at point {} of {} again, which {} has too, expected each once",
                                place.stop + 1, part_text(*plan_, {place.run + 1, place.run + 1}),
                                name_of(at->second)));
    }
    for (const std::size_t run : runs) {
      const auto& station = plan_->machine.stations[plan_->runs[run].station].name;
      const auto& tool = plan_->machine.tools[plan_->runs[run].tool].name;
      const auto [at, is_new] = from_.emplace(std::pair(station, tool), file);
      if (is_new || times_said_[run] > 1) continue;
      return fail(
          fmt::format("found lengths of {}, which {} has too, expected each part in one file; where a "
                      "recording goes on with a part that another began, say the part of each",
                      part_text(*plan_, {run + 1, run + 1}), name_of(at->second)));
    }
    return {};
  }

  /// Of recordings, which may go on with a part, segments are told apart by the file.
  void add(const VolumetricLengths& some, const std::vector<PartStop>& places) {
    const bool several = request_.files.size() > 1;
    for (const VolumetricReading& r : some.readings) {
      const std::string& segment = some.segments[r.segment];
      VolumetricReading& added = all_.lengths.readings.emplace_back(r);
      added.station = stations_.number(some.stations[r.station]);
      added.tool = tools_.number(some.tools[r.tool]);
      added.segment = segments_.number(
          !places.empty() && goes_on(r, some) ? fmt::format("{}/{}", all_.files.size(), segment) : segment);
      if (several) added.line = 0;  // of which file nobody could tell
    }
  }

  bool goes_on(const VolumetricReading& r, const VolumetricLengths& some) const {
    const auto from = from_.find({some.stations[r.station], some.tools[r.tool]});
    return from != from_.end() && from->second + 1 != all_.files.size();
  }

  /// Of a file that was read, quoted.
  std::string name_of(std::size_t file) const { return text::quoted(all_.files[file].file); }

  void tell_missing_parts() {
    for (std::size_t run = 0; run < plan_->runs.size(); ++run) {
      const auto& station = plan_->machine.stations[plan_->runs[run].station].name;
      const auto& tool = plan_->machine.tools[plan_->runs[run].tool].name;
      if (plan_->runs[run].stops.empty() || from_.contains({station, tool})) continue;
      tell("volumetric-part-missing",
           fmt::format("no lengths of {}, which the plan has", part_text(*plan_, {run + 1, run + 1})));
    }
  }

  void tell(std::string id, std::string message) {
    all_.findings.push_back({std::move(id), false, std::move(message)});
  }

  const LengthsRequest& request_;
  const CalibrationPlan* plan_;
  GatheredLengths all_;
  GatheredNames stations_, tools_, segments_;
  std::map<std::pair<std::string, std::string>, std::size_t> from_;   // file of a station and tool, the first
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> stops_;  // file of a run's stop
  std::map<std::size_t, std::size_t> times_said_;                     // how often each run was said
  std::size_t recordings_ = 0;
};

}  // namespace

Result<GatheredLengths> gather_lengths(const LengthsRequest& request, const CalibrationPlan* plan) {
  if (request.files.empty()) return fail("found no file of lengths, expected at least one");
  return Gathering(request, plan).run();
}

}  // namespace axiometry::app
