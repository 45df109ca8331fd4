// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "axiometry/app/volumetric/part_stops.h"
#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"
#include "axiometry/simulation/reflector_way.h"
#include "axiometry/volumetric/simulate/simulated_lengths.h"

/// What a tracking interferometer shows all the time while parts of a volumetric plan are driven: the continuous
/// recording that belongs to simulated lengths.
namespace axiometry::app {

struct RecordingNoise {
  Length sigma = Length::um(0.1);  ///< σ of each sample, beside what a length of a stop is off by
  double rate = 100.0;             ///< samples a second
};

/// At every stop the reflector rests for the dwell and shows the simulated length; on the way it goes straight along
/// the ways of the programs. What a length is off by changes on the last way before its stop. A break that is told, and
/// one that the plan expects, takes the samples of three fifths of the longest way before its stop; one that is not
/// lets the length jump in the middle of that way. At a stop whose length is lost the reflector does not rest. Between
/// parts the instrument is moved for a minute in which nothing is seen.
///
/// Deliberately absent: growth while the reflector rests, play on the way, corners that are rounded.
class PartsRecording {
 public:
  /// `simulated` are the lengths of the visits of the plan (visits_of()) with these errors. Fails as
  /// ReflectorWay::count() does.
  static Result<PartsRecording> make(const volumetric::CalibrationPlan& plan, PartRange parts,
                                     const volumetric::TrueErrors& errors,
                                     const volumetric::SimulatedLengths& simulated, const RecordingNoise& noise,
                                     std::uint64_t seed);

  std::size_t samples() const { return count_.arrived; }
  Result<void> record(const SampleSink& sink) const;

 private:
  /// What the length is off the distance to the station by, on a leg.
  struct LegError {
    Vector3 station_mm;
    double from_mm = 0.0, to_mm = 0.0;
    double jump_mm = 0.0;  // what of it comes at once in the middle of the way; the rest changes evenly
  };

  PartsRecording(const RecordingNoise& noise, std::uint64_t seed) : noise_(noise), seed_(seed) {}
  void drive(const volumetric::CalibrationPlan& plan, std::size_t run, const volumetric::TrueErrors& errors,
             const volumetric::SimulatedLengths& simulated, std::size_t& reading);
  void arrive(std::size_t first_leg, double error_mm, double jump_mm, bool is_lost);

  RecordingNoise noise_;
  std::uint64_t seed_;
  simulation::ReflectorWay way_;
  std::vector<LegError> errors_;  // error of each leg
  simulation::ReflectorWay::Count count_;
};

}  // namespace axiometry::app
