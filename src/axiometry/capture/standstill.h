// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/capture/cell.h"
#include "axiometry/capture/rest_scatter.h"
#include "axiometry/capture/travel.h"
#include "axiometry/capture/way_speed.h"
#include "axiometry/model/axis.h"
#include "axiometry/model/plan.h"
#include "axiometry/model/recording.h"

/// Finds where an axis stands still in a continuous recording: one pass, memory of one window. Derivations and what
/// disturbs: docs/theory/capture.md.
namespace axiometry::capture {

/// How a standstill is told from motion. Distances in mm or °.
///
/// The last window W is four cells. It is at rest when their means (without outliers) lie within
/// T = min(greatest, max(smallest, 1.5 q, 6 s)), rest_threshold(). Motion at a constant speed has
/// means that lie 10.4 s apart whatever the speed; noise of any size 1.2 s, vibration with a period up to 0.8 W 5.1 s.
struct StandstillOptions {
  Duration window = Duration::s(0.5);           ///< W
  Duration settling = Duration::s(0.5);         ///< time after the stop that is not averaged
  Duration shortest = Duration::s(1.0);         ///< shorter standstills are reported as such, not used
  Position smallest = Position::native(0.001);  ///< what a window may always move by
  Position greatest = Position::native(0.1);    ///< what it may never move by
  std::optional<Position> threshold{};          ///< T itself, instead of all that
  Position turn = Position::native(1.0);        ///< way back that counts as a change of direction
  double fastest_per_s = 500.0;                 ///< nothing that is measured is faster, mm/s or °/s
};

/// What nothing that is driven at a feed (per minute) is taken to exceed, per second: 500, ten feeds if that is more.
double fastest_motion(double feed);

/// What suits a plan: W = dwell/4 within 0.1 s to 1 s (0.25 s without dwell), settling W, shortest the larger of
/// dwell/2 and 2 W; smallest 1 µm or 1″; greatest 2 % of the way at the plan's feed in W; turn overrun/4; fastest as
/// fastest_motion() has it.
StandstillOptions standstill_options(const Plan& plan);

/// A stretch of the recording without samples.
struct MissingSamples {
  double from_s = 0.0;  ///< time of the last one before
  double to_s = 0.0;    ///< time of the first one behind
};

/// One stretch of rest.
struct Standstill {
  double begin_s = 0.0;      ///< first sample at rest
  double end_s = 0.0;        ///< last one
  double used_from_s = 0.0;  ///< beginning of what was averaged, s
  double used_to_s = 0.0;
  std::size_t count = 0;     ///< samples averaged
  std::size_t rejected = 0;  ///< outliers among them, left out
  Position position{};       ///< their mean, as the instrument shows it
  Position spread{};         ///< standard deviation s of these samples
  RestScatter scatter{};     ///< of the means of the cells among them, mm or °
  Position step{};           ///< step of the instrument as far as samples have shown it; 0 where they were all alike
  Position drift{};          ///< slope of a straight line through the means of the cells, times the time averaged
  Position threshold{};      ///< T when it stopped
  std::optional<Direction> arrival{};  ///< the way it came from; nothing when that was not seen
  Position lowest{};                   ///< lowest position between the standstill before and this one, both included
  Position highest{};
  Position beyond{};                      ///< how far beyond it the axis had been before it came back to it and stopped
  std::optional<Speed> speed{};           ///< of the way there since the standstill or the last turn before
  std::vector<Position> turns{};          ///< where it began to move and turned since the standstill before
  double edge_s = 0.0;                    ///< by how much it may have begun earlier, and ended later, s: a cell
  std::vector<MissingSamples> missing{};  ///< since the standstill before
  bool after_gap = false;                 ///< samples are missing between the standstill before and this one
  bool cut_off = false;                   ///< ended by missing samples or the end of the recording, not by motion
  /// From here on its value stood still to the last digit, and jumped then: the instrument may have lost its signal,
  /// and where the axis was meanwhile is not known.
  std::optional<double> frozen_from_s{};
};

/// The same where the instrument shows so much more, mm or °.
Standstill shifted(Standstill standstill, double by);

class StandstillDetector {
 public:
  explicit StandstillDetector(const StandstillOptions& options);

  /// The standstills that ended within these samples. Needs finite samples in order of time (contract: readers refuse
  /// others). The result does not depend on how a recording is cut into pieces. A step in time of more than W and ten
  /// usual steps counts as a gap; so does a value that stands still to the last digit for more than W and ten times
  /// what it usually does on the way, where it then jumps farther than anything moves between two samples, and stays.
  std::vector<Standstill> push(std::span<const Sample> samples);

  /// Samples are missing here, or the recording ends: the standstill that was going on, if there was one.
  std::vector<Standstill> interrupt();

  /// The same where the samples behind this place jump away, as who hands them on has seen.
  std::vector<Standstill> jumped();

  /// Where the axis is now, for people who watch; nothing before the first cell.
  struct Whereabouts {
    Position position;
    bool at_rest = false;
  };
  std::optional<Whereabouts> now() const;

 private:
  /// Sums over the cells of one standstill, as deviations from its first mean and its begin.
  struct Average {
    double count = 0.0, mean = 0.0, squares = 0.0;
    double weight = 0.0, t = 0.0, x = 0.0, tt = 0.0, tx = 0.0;
    std::size_t rejected = 0;
    double from_s = 0.0, to_s = 0.0;
    RestScatterSums scatter;
    void add(const SampleCell& cell, double origin_s, double origin);
    double slope() const;
  };

  /// One value, over and over.
  struct Frozen {
    double position = 0.0;
    double from_s = 0.0;
    double to_s = 0.0;
  };

  double cell_edge_s(const Sample& first) const;
  std::size_t take(std::span<const Sample> samples, bool more_come, std::vector<Standstill>& found);
  std::size_t take_piece(std::span<const Sample> samples, const CellSums& sums, bool more_come,
                         std::vector<Standstill>& found);
  void take_begun(std::vector<Standstill>& found);
  bool frozen_long() const;
  std::optional<std::size_t> leap_at(std::span<const Sample> samples) const;
  bool is_away(const Sample& sample, double step_s) const;
  bool stays_away(std::span<const Sample> behind) const;
  void watch_value(std::span<const Sample> samples, const CellSums& sums);
  void take_cell(std::span<const Sample> samples, const CellSums& sums, std::vector<Standstill>& found);
  void travel(std::span<const Sample> samples, const SampleCell& cell);
  void note_usual(std::span<const Sample> samples, const SampleCell& cell);
  void gap(std::vector<Standstill>& found);
  void end_frozen(std::vector<Standstill>& found);
  double threshold() const;
  bool settled(double threshold) const;
  void begin_rest(double threshold);
  void add_to_rest(const SampleCell& cell);
  Standstill end_rest(bool cut_off);

  StandstillOptions options_;
  CellMaker maker_;
  Travel travel_;
  WaySpeed way_;
  std::vector<Sample> begun_;  // a cell whose end has not come yet
  std::optional<Sample> last_;
  std::deque<SampleCell> window_;  // the last cells, no gap between them
  std::deque<double> noises_;      // standard deviations of the last cells
  double usual_step_s_ = 0.0;      // usual time between samples, s; 0 before the first cell
  double quantum_ = 0.0;           // q; 0 before two different samples were seen
  double finest_ = 0.0;            // smallest of the steps and of their differences: of rounded values a multiple of
                                   // what they were rounded to
  double usual_hold_s_ = 0.0;      // usual time between two changes of the value on the way, s; 0 before one was seen
  std::optional<Frozen> frozen_;
  std::vector<MissingSamples> missing_;
  std::optional<double> missing_from_s_;  // where samples are missing and none has come since
  bool gap_behind_ = true;                // nothing is known of the time before the recording
  std::optional<SampleCell> now_;

  bool at_rest_ = false;
  Standstill rest_;  // all but what is averaged
  double origin_ = 0.0;
  Average settling_, used_;
  std::optional<SampleCell> held_;  // the newest cell: at its end the axis may move already
};

}  // namespace axiometry::capture
