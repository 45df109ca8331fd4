// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/capture/expected_stops.h"
#include "axiometry/capture/standstill.h"

/// Which standstill of a recording of lengths belongs to which expected stop. By the change of length from stop to
/// stop, the direction of arrival and the way in between, never by counting. Derivation and costs:
/// docs/theory/capture-lengths.md.
namespace axiometry::capture {

struct StopMatcherOptions {
  double tolerance_mm = 0.5;             ///< how far a change of length may be from the expected one, beside the rest
  double station_error_mm = 5.0;         ///< how far a station may be from where it is said
  double scale = 1e-3;                   ///< share of a change of distance by which the machine may be off
  double turn_mm = 0.5;                  ///< turn_mm of the drive
  Duration shortest = Duration::s(1.0);  ///< shorter standstills give no length
  bool direction_counts = false;         ///< a stop reached from the other side is none: its reading says the side
  bool reversed = false;                 ///< the length shown falls where the reflector recedes
};

/// A standstill that was taken for a stop.
struct StopMatch {
  std::size_t stop = 0;
  std::size_t standstill = 0;   ///< number of those taken
  bool begins_segment = false;  ///< the dead path is another one than before
  bool untold = false;          ///< another dead path that nothing but the lengths tells
  bool planned = false;         ///< another dead path that the plan expects, there or at a stop left out before
};

/// Takes standstills in their order, keeps the likely explanations of all of them and tells the likeliest: one after
/// the other each is a stop or none, stops may be left out, and the length may jump. A missed stop, a standstill too
/// many or a jump cost; a change of length within the tolerance costs next to nothing; an arrival from the other side
/// costs, or is never taken. No time is spent on what costs much more than the best, so that time grows with the number
/// of standstills and the stops the time between them has room for (at most 256 explanations are kept).
class StopMatcher {
 public:
  StopMatcher(std::vector<ExpectedStop> stops, const StopMatcherOptions& options);

  void take(const Standstill& standstill);

  /// The likeliest explanation as far as it has come.
  std::vector<StopMatch> matches() const;
  std::size_t matched() const;  ///< how many matches that explanation has
  /// The stop that comes next in it; nothing when the last one has come.
  std::optional<std::size_t> due() const;
  bool complete() const { return !due(); }
  double cost() const { return best().cost; }  ///< cost of the likeliest one (docs/theory/capture-lengths.md)

  /// Whether a rest that is taken for a stop has a length: it was long enough, and the signal was not lost in it.
  bool gives_length(const Standstill& rest) const;

  std::span<const Standstill> standstills() const { return standstills_; }
  std::span<const ExpectedStop> stops() const { return stops_; }
  const StopMatcherOptions& options() const { return options_; }
  /// How far the change of length between two stops may be from the expected one.
  double tolerance_mm(std::size_t from, std::size_t to) const;

 private:
  static constexpr std::size_t none = SIZE_MAX;

  struct Link {
    std::size_t before = none;  // index in links_ of what came before
    StopMatch match;
    std::size_t depth = 0;
  };
  /// An explanation of all standstills so far.
  struct State {
    std::size_t stop = none;  // matched last
    std::size_t link = none;
    std::size_t standstill = none;  // the standstill that was matched to it
    double cost = 0.0;
    double lowest = 0.0, highest = 0.0;  // range of the distance on the way since then, mm
    bool broken = false;                 // samples are missing on it
    bool strayed = false;                // whether it came to a standstill that is no stop
  };
  struct Step {
    double cost = 0.0;
    bool begins_segment = false;
    bool untold = false;
    bool planned = false;
  };

  double length(const Standstill& s) const;
  void pass_over(State state, const Standstill& s, bool no_length);
  void try_stops(const State& state, const Standstill& s, bool no_length);
  std::optional<Step> step(const State& state, std::size_t stop, const Standstill& s) const;
  double way_cost(const State& state, std::size_t stop, const Standstill& s) const;
  void offer(State state, StopMatch match);
  void thin_out();
  void collect();
  const State& best() const;

  std::vector<ExpectedStop> stops_;
  StopMatcherOptions options_;
  std::vector<double> distances_;
  std::vector<Vector3> beams_;         // direction of each, from the station
  std::vector<std::size_t> segments_;  // how many stops up to each begin one
  std::vector<Standstill> standstills_;
  std::vector<State> states_, next_;
  std::vector<std::optional<StopMatch>> matches_;  // matches of next_, before they are links
  std::vector<std::size_t> place_;                 // per stop the place in next_ of what takes the standstill for it
  std::vector<Link> links_;
  std::size_t collect_at_;
  double cost_limit_ = 0.0;  // largest cost that is tried
};

}  // namespace axiometry::capture
