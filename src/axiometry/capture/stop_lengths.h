// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/capture/beam_watch.h"
#include "axiometry/capture/expected_stops.h"
#include "axiometry/capture/standstill.h"
#include "axiometry/capture/stop_matcher.h"
#include "axiometry/model/recording.h"

/// From a continuous recording of a tracking interferometer, time and length, to the length at each stop of a list.
/// Derivation and limits: docs/theory/capture-lengths.md.
namespace axiometry::capture {

/// The length of one stop, as shown.
struct StopLength {
  double length_mm = 0.0;   ///< mean over the rest
  double scatter_mm = 0.0;  ///< standard deviation of its samples
  double drift_mm = 0.0;    ///< change of the length over the time averaged, mm
  double time_s = 0.0;      ///< middle of that time
  std::size_t samples = 0;  ///< averaged
  std::size_t segment = 0;  ///< lengths of one segment share a dead path; from 0, in the order of the recording
  std::vector<std::string> remarks{};  ///< "drifts by 1.2 µm while at rest"; mostly none
};

/// Why a stop has no length.
enum class StopLack {
  no_standstill,  ///< the reflector did not rest there, or the recording does not show it
  too_short,      ///< it rested, but for less than the shortest time
  signal_lost,    ///< the length stood still to the last digit and then jumped (Standstill::frozen_from_s)
  ambiguous,      ///< what was there may as well belong to another stop that has no length
  not_reached,    ///< the recording ended before
};
/// "no standstill", "too short", "signal lost", "ambiguous", "not reached".
std::string_view lack_name(StopLack lack);

struct StopOutcome {
  std::optional<StopLength> length;
  StopLack lack = StopLack::no_standstill;  ///< why there is no length, where there is none
};

/// A place where the dead path changed.
struct SegmentBegin {
  std::size_t segment = 0;  ///< the new one
  std::size_t stop = 0;     ///< first stop of that segment
  double time_s = 0.0;      ///< when it came to rest there
  bool untold = false;      ///< only the lengths tell: neither are samples missing nor is another station expected
  bool planned = false;     ///< the plan has another beam from there on, or from a stop before that was left out
};

struct StopLengths {
  std::vector<StopOutcome> stops;      ///< one for each that was expected
  std::vector<SegmentBegin> segments;  ///< all but the first
  std::vector<Standstill> unused;      ///< long enough, between first and last stop, and at none of them
  std::size_t standstills = 0;         ///< long enough, of the whole recording
  std::size_t found() const;           ///< stops with a length
};

struct StopOptions {
  StopDrive drive;
  StopMatcherOptions matcher;               ///< `turn_mm` and `shortest` follow from drive and rest
  std::optional<StandstillOptions> rest{};  ///< replaces standstill_options(drive)
  double fastest_mm_per_s = 500.0;          ///< speed of the reflector; a faster change of length is a broken beam
};

/// The same standstills, held against other stops: by cost() it can be told to which of both they rather belong.
StopMatcher matched_to(const StopMatcher& heard, std::vector<ExpectedStop> stops);

/// What every stop has. Fails where the standstills do not fit the stops: the other sign of the lengths fits far
/// better; less than half of the standstills between first and last stop belong to one; many do not, and as many stops
/// have none; or a fifth and more of the changes of length are none of the list.
/// The stations are learned from the lengths (station_refining.h) and the standstills matched once more from there.
Result<StopLengths> stop_lengths(const StopMatcher& matcher);

/// Listens to a recording, some samples at a time: finds standstills (standstill.h) and where the beam was broken, and
/// matches them. The result does not depend on how the recording is cut into pieces.
class StopListener {
 public:
  StopListener(std::vector<ExpectedStop> stops, const StopOptions& options);

  /// Needs finite samples in order of time (contract: readers refuse others).
  void push(std::span<const Sample> samples);
  /// Samples are missing here, or the recording ends.
  void interrupt();

  const StopMatcher& matcher() const { return matcher_; }
  std::optional<StandstillDetector::Whereabouts> now() const { return detector_.now(); }

  /// stop_lengths(), as far as the recording has come.
  Result<StopLengths> lengths() const { return stop_lengths(matcher_); }

 private:
  BeamWatch::Sink sink();
  void take(const std::vector<Standstill>& found);

  StopMatcher matcher_;
  std::deque<double> missing_s_;  // times at which samples were missing on ways whose standstill has not come yet
  BeamWatch watch_;
  StandstillDetector detector_;
};

/// The same for a recording at hand. Time grows with the number of samples.
Result<StopLengths> lengths_at_stops(std::span<const Sample> samples, std::vector<ExpectedStop> stops,
                                     const StopOptions& options);

}  // namespace axiometry::capture
