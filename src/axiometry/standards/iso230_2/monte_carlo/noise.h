// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/model/metadata.h"
#include "axiometry/standards/iso230_2/inputs/inputs.h"
#include "axiometry/standards/iso230_2/monte_carlo/drift_posterior.h"
#include "axiometry/standards/iso230_2/monte_carlo/posterior.h"
#include "axiometry/standards/readings/test_course.h"

/// What the noise of the measurement may have been: E_VE is one number, and may be white noise, a slow drift, a random
/// walk or hardly there at all. Each is a model of its own, from which whole tests are drawn; what is stated in the end
/// holds for every one that the readings do not refute. Derivation: docs/theory/monte-carlo.md.
namespace axiometry::iso230_2 {

struct NoiseHypothesis {
  /// "none", "white", "drift", "random-walk", "recording", of the last three also with "-beside-runs";
  /// "trend-beside-runs", "single-errors"
  std::string key;
  std::string title;  ///< "white noise from reading to reading"
  bool refuted = false;
  std::optional<double> p;  ///< probability of these readings, were noise of the stated size there; small: it was not
  std::string reason;       ///< what p tests, and what follows
};

/// A model of the noise. Trials take the shares in turn: each is equally likely.
struct NoiseModel {
  NoiseHypothesis hypothesis;
  std::vector<ReadingNoise> shares;             ///< what is independent, beside the drift
  std::shared_ptr<const DriftPosterior> drift;  ///< nullptr where there is none
};

/// What is asked of the noise of a test.
struct NoiseQuestion {
  const Metadata& metadata;
  const Series& series;
  const TestCourse& course;
  const UncertaintyInputs& inputs;
  bool drifts = true;                       ///< whether slow variations are modelled; else E_VE counts as white
  std::optional<std::size_t> only_input{};  ///< the noise of this input alone
  double step = 0.0;                        ///< what readings are rounded to, as they were taken
};

/// What readings tell about independent noise: scatter within runs, beside shifts of runs and slow drift.
struct WithinRuns {
  double squares = 0.0;
  double degrees_of_freedom = 0.0;

  double sd() const;
  /// P(as little scatter, or less), were there noise of this standard deviation and nothing else.
  double probability_of(double noise_sd) const;
  /// Upper limit of its standard deviation, 97.5 %; infinite without a degree of freedom.
  double upper_sd() const;
};
WithinRuns within_runs(const Series& series, const TestCourse& course);

/// Whether E_VE is stated as white noise, which the readings refute.
bool refutes_stated_white(const Test& test);

/// Below this probability of what the readings show noise of a stated size was not there.
inline constexpr double refuted_below = 0.001;

struct NoiseModels {
  std::vector<NoiseModel> models;           ///< "none" first; those not refuted
  std::vector<NoiseHypothesis> hypotheses;  ///< all that were considered, in the same order
  std::vector<std::string> notes;           ///< what was stated and the readings contradict
};

/// - none: nothing of the noise is in the readings. Always there, so that a value beyond its limit is never accepted.
/// - white: E_VE/√12 in each reading, and five times as much where the kind is open (unknown, or refuted); but no more
/// than the upper
///   limit of the scatter within runs. Refuted where that scatter is too small for noise of the stated size
///   (p < 0.001).
/// - drift, random_walk: slow, of a size that the readings tell (DriftPosterior), and beside it white noise of none,
///   half or all of what `white` has.
/// - recording: as the recording of A.2.5 has it.
///
/// Of what is slow each stands twice: once for a machine whose runs do not shift, so that every shift of a run is the
/// variation's, and once for one whose runs may shift by any amount, so that none of it need be. With a drift also
///
/// - trend-beside-runs: a straight trend, which shifts of the runs may hide: of up to five times of what is stated
///   where the kind is open, as far as the means of the runs leave room.
///
/// Where noise of single readings is stated (E_VE, or an input of them), and readings depart from the others by what
/// one test in ten has, but none by so much that no interval is stated, also
///
/// - single-errors: each of these readings has an error of its own, so wide that it tells nothing of the machine.
///
/// A stated kind stands with `none` alone; unknown means all. A stated kind that is refuted gives a note, and all
/// others take its place. Stated noise of readings and runs acts in all but `none`.
NoiseModels noise_models(const NoiseQuestion& question);

/// The kinds of E_VE that count, of white, drift and random_walk: as stated, or all that are not refuted.
std::vector<EnvironmentKind> environment_kinds(const NoiseQuestion& question);

}  // namespace axiometry::iso230_2
