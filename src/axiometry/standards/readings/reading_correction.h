// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/readings/air_refraction.h"

/// Corrections of readings for what the instrument did not take into account. Derivations, signs and figures:
/// docs/theory/reading-corrections.md.
namespace axiometry {

/// Which corrections are made. None is made unasked.
struct CorrectionRequest {
  bool sign = false;
  bool gain = false;
  std::optional<AirEquation> air{};
  bool dead_path = false;
  bool expansion = false;  ///< nde_correction.h
  bool drift = false;

  bool any() const { return sign || gain || air || dead_path || expansion || drift; }
};

/// The test with its readings corrected, in this order whatever the order of asking. D is the displayed length from the
/// datum (`nde.datum`, else the first target): target plus deviation less datum.
///
/// 1. `sign`: D → −D where the displayed positions fall while the targets rise, so that the sensor counted the other
///    way; x → −x where they rise together, so that only the deviations had their sign reversed.
/// 2. `gain`: D → g D, with `instrument.gain`.
/// 3. `air`: D → D n_0/n, with the index n_0 that the instrument assumed (`instrument.refractive_index`) and n of the
///    air, whose temperature, pressure and humidity are interpolated over the course of the test (test_course.h).
/// 4. `dead-path`: D → D − L_d (n − n_s)/n, with `instrument.dead_path` L_d and the n_s of the start, when the
///    instrument was set to zero. n by the equation of `air`, Ciddor's when that was not asked for.
/// 5. `nde`: expansion, by correct_expansion().
/// 6. `drift`: x → x − b τ, with the drift b of drift_of() and the share τ of the course of the test.
///
/// `as_measured` keeps the readings of the source, and provenance has each correction with all that it takes to do it
/// again.
///
/// Fails, naming what was found and everything that is missing: `sign` where the metadata say that it is not reversed,
/// or the displayed positions neither rise nor fall; `gain` without a gain other than 0; `air` and `dead-path` on a
/// rotary axis, without temperature, pressure or humidity of the air, outside the range of the equation, or a second
/// time; `air` without n_0, `dead-path` without L_d; `nde` as correct_expansion() does; `drift` without two readings
/// from one direction at any target.
Result<Test> correct_readings(Test test, const CorrectionRequest& request);

/// Whether this program has made the correction with this id ("air", as in CorrectionRequest) already.
bool was_corrected(const Test& test, std::string_view id);

/// What must be known of the readings beside the provenance: that the sensor counts the other way or has a gain other
/// than 1 and was not corrected for it, or that a drift was taken out which was estimated from the readings themselves.
/// Notes for the assessment.
std::vector<SourceRemark> remarks_on_readings(const Test& test);

}  // namespace axiometry
