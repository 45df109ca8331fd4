// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/stop_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"

namespace axiometry::app {
namespace {

using capture::StopLack;

constexpr std::size_t most_named = 6;

std::string_view lack_text(StopLack lack) {
  switch (lack) {
    case StopLack::no_standstill: return "no standstill";
    case StopLack::too_short: return "the rest was too short";
    case StopLack::signal_lost:
      return "the length stood still to the last digit there and then jumped: the instrument may have lost its signal";
    case StopLack::ambiguous: return "what was there may as well belong to another stop that was not heard";
    case StopLack::not_reached: return "the recording ended before";
  }
  return "";
}

class StopNoting {
 public:
  StopNoting(const capture::StopLengths& lengths, const StopNames& names) : lengths_(lengths), names_(names) {}

  std::vector<std::string> run() {
    tell_lacks();
    tell_segments();
    tell_unused();
    tell_remarks();
    return std::move(notes_);
  }

 private:
  /// Stops without a length for one reason.
  struct Lacking {
    std::string group;
    StopLack lack;
    std::vector<std::size_t> stops;
  };

  /// Group by group, in each by reason.
  void tell_lacks() {
    std::vector<Lacking> lacking;
    std::size_t first_of_group = 0;
    for (std::size_t k = 0; k < lengths_.stops.size(); ++k) {
      if (lengths_.stops[k].length) continue;
      const std::string group = names_.group(k);
      if (lacking.empty() || lacking.back().group != group) first_of_group = lacking.size();
      const auto same = std::find_if(lacking.begin() + static_cast<std::ptrdiff_t>(first_of_group), lacking.end(),
                                     [&](const Lacking& l) { return l.lack == lengths_.stops[k].lack; });
      if (same == lacking.end())
        lacking.push_back({group, lengths_.stops[k].lack, {k}});
      else
        same->stops.push_back(k);
    }
    for (const Lacking& some : lacking) {
      std::string list;
      for (std::size_t k = 0; k < std::min(some.stops.size(), most_named); ++k)
        list += fmt::format("{}{}", k == 0 ? "" : ", ", names_.name(some.stops[k]));
      if (some.stops.size() > most_named) list += " and " + counted(some.stops.size() - most_named, "other");
      notes_.push_back(fmt::format("{}: no length for {}: {}", some.group, list, lack_text(some.lack)));
    }
  }

  void tell_segments() {
    for (const capture::SegmentBegin& begin : lengths_.segments) {
      if (begin.planned) continue;
      const std::string where = fmt::format("{}: before {} (at {} s)", names_.group(begin.stop),
                                            names_.name(begin.stop), format_fixed(begin.time_s, 1));
      notes_.push_back(begin.untold ? where +
                                          " the lengths jump as on no way of the plan: the beam was broken, and "
                                          "the lengths from there on have another dead path"
                                    : where +
                                          " samples are missing or the length jumped: the lengths from there on "
                                          "have another dead path");
    }
  }

  void tell_unused() {
    if (lengths_.unused.empty()) return;
    notes_.push_back(
        fmt::format("the reflector rested where no stop of the plan was due, first at {} s; not used ({} in all)",
                    format_fixed(lengths_.unused.front().begin_s, 1), lengths_.unused.size()));
  }

  void tell_remarks() {
    std::size_t told = 0, others = 0;
    for (std::size_t k = 0; k < lengths_.stops.size(); ++k) {
      if (!lengths_.stops[k].length) continue;
      for (const std::string& remark : lengths_.stops[k].length->remarks) {
        if (told++ < most_named)
          notes_.push_back(fmt::format("{}: {}: {}", names_.group(k), names_.name(k), remark));
        else
          ++others;
      }
    }
    if (others > 0) notes_.push_back(fmt::format("{} further remarks of that kind on readings", others));
  }

  const capture::StopLengths& lengths_;
  const StopNames& names_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> stop_notes(const capture::StopLengths& lengths, const StopNames& names) {
  return StopNoting(lengths, names).run();
}

std::vector<std::string> recording_notes(const CaptureSession& session, const capture::StopLengths& lengths,
                                         const StopNames& names) {
  std::vector<std::string> notes = stop_notes(lengths, names);
  if (session.lost() > 0)
    notes.push_back(
        fmt::format("the stream shows {} lost of {} samples", session.lost(), session.samples() + session.lost()));
  std::ranges::move(session.remarks(), std::back_inserter(notes));
  return notes;
}

}  // namespace axiometry::app
