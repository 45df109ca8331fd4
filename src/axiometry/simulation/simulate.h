// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/model/recording.h"
#include "axiometry/model/test.h"
#include "axiometry/simulation/timeline.h"
#include "axiometry/simulation/virtual_axis.h"

/// Readings and recordings of an axis whose truth is known: for teaching what a fault looks like, and for proving what
/// is computed from them. The same plan, axis, departures and seed give the same bits on any system.
///
/// Deliberately absent: jerk, the dynamics of the structure, an overshoot that takes up play (play follows the
/// command).
namespace axiometry::simulation {

struct Request {
  Plan plan;
  VirtualAxis axis;
  Departures departures;
  std::uint64_t seed = 1;
  std::string fault;  ///< what was chosen, for the comment of the test: "backlash"; may be empty
};

/// What happened in one approach, at the end of its dwell.
struct TrueReading {
  Approach approach;
  bool extra = false;    ///< a second time; not in the series
  Duration time;         ///< time of the reading since the beginning of the test
  Deviation deviation;   ///< true: actual minus target position of the table
  Deviation instrument;  ///< what noise and all faults of the instrument add to it; the reading is the sum
  bool outlier = false;
};

/// What the axis does from one direction at one target over many tests like this one: the expectation over stick-slip
/// and hunting, its mean over the runs that were made, and the standard deviation that s_i estimates (the variance of
/// both, and of the expectation from run to run, as by thermal growth).
struct ExpectedCell {
  std::size_t target = 0;
  Direction direction = Direction::up;
  std::size_t runs = 0;  ///< how many runs were made
  Deviation mean;
  Deviation spread;
};

struct SimulatedTest {
  Test test;                           ///< readings with times; the comment says that they are no measurement
  std::vector<TrueReading> readings;   ///< readings in the order in which they were taken
  std::vector<ExpectedCell> expected;  ///< ↑ then ↓, by target; only where a reading was made
};

/// One reading of every approach that is made. Fails as check_sound() and Timeline::make() do, and as Series::make()
/// when no approach to some target is left.
Result<SimulatedTest> simulate(const Request& request);

/// Samples that do not arrive.
struct Gap {
  Duration begin;
  Duration length;
};

struct RecordingRequest {
  double rate = 1000.0;               ///< samples a second, 0.001 to 1e7
  std::vector<Gap> gaps{};            ///< nothing is recorded from begin (included) to begin + length
  double drop_out_probability = 0.0;  ///< probability that a single sample is lost, below 1
};

/// Where the table stood while the axis was told to rest on a target.
struct TrueStandstill {
  Approach approach;
  bool extra = false;
  Duration begin;                 ///< the servo is within 0.01 µm or ″; `end` when it never was
  Duration end;                   ///< the next move begins
  std::size_t samples = 0;        ///< recorded in between
  std::optional<Deviation> mean;  ///< true deviation (no instrument) over these samples; absent without one
};

struct TrueRecording {
  std::vector<TrueStandstill> standstills;  ///< standstills in the order of the recording
  Duration duration;
  std::size_t samples = 0;  ///< handed to the sink
  std::size_t lost = 0;     ///< samples that were lost in gaps and drop-outs
};

/// How many samples record() hands on.
Result<std::size_t> count_samples(const Request& request, const RecordingRequest& recording);

/// What the instrument shows all the time, from 2 s before the first move to 2 s after the last: sample k at k/rate.
/// Memory does not grow with the rate. Fails as simulate() does, on a rate, gap or probability outside its range, on
/// more than 1e12 samples, and as the sink does.
Result<TrueRecording> record(const Request& request, const RecordingRequest& recording, const SampleSink& sink);

}  // namespace axiometry::simulation
