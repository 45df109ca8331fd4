// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/studies/lee_tables.h"
#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"
#include "axiometry/simulation/tracked_machine.h"
#include "axiometry/tracking/station/station.h"

/// The experiments of Lee et al., Sensors 16 (2016) 482, 2.2 to 2.4, on a simulated machine: points are driven to with
/// an error, and the estimators of tracking/station/station.h are told where they should have been.
namespace axiometry::app::lee {

/// What is the same in all of them.
struct Set {
  Vector3 station_mm = lee::station_mm;
  std::vector<Vector3> points_mm = lee::points_mm();
  Length noise = {};  ///< standard deviation of a length
  std::uint64_t seed = 1;
};

/// A station, located by both estimators.
struct BothEstimates {
  Vector3 linear_mm;  ///< eq. 14
  Vector3 refined_mm;
  double largest_residual_mm = 0.0;  ///< of the refined fit: what the sixth equation says
};

/// By how much the station was found elsewhere with an error than without.
struct Shift {
  std::string name;
  Vector3 printed_mm;  ///< figure printed in the paper
  Vector3 linear_mm;
  Vector3 refined_mm;
  double largest_residual_mm = 0.0;
};

/// 2.2, Table 2: all points displaced by the same amount.
struct CoordinateOffset {
  Set set;
  double offset_mm = 1.0;
  BothEstimates baseline;
  std::vector<Shift> shifts;
  double worst_linear_mm = 0.0;  ///< largest |shift + offset| of a coordinate
  double worst_refined_mm = 0.0;
  double worst_printed_mm = 0.0;  ///< largest of the paper's figures
};
/// Fails as simulate_location() and locate_station() do, and where eq. 14 has no solution.
Result<CoordinateOffset> coordinate_offset(const Set& set, double offset_mm);

/// 2.3, Table 3: a scale error of one or two axes.
struct ProportionalError {
  Fixture fixture;
  std::vector<Shift> shifts;
  double rms_mm = 0.0;  ///< of shown estimator − printed table (misprint corrected), over all 36
  double largest_mm = 0.0;
  double misprinted_mm = 0.0;        ///< what the experiment finds where the paper prints 0.40
  double oddness_mm = 0.0;           ///< largest |shift(+) + shift(−)|
  double additivity_mm = 0.0;        ///< largest |shift(two axes) − shift(one) − shift(other)|
  double estimators_apart_mm = 0.0;  ///< largest |refined − linear|

  /// Of the estimator that the fixture belongs to.
  Vector3 shown_mm(std::size_t row) const { return fixture.refined ? shifts[row].refined_mm : shifts[row].linear_mm; }
};
Result<ProportionalError> proportional_error(const Fixture& fixture, Length noise, std::uint64_t seed);

/// 2.4: the slope of seven lines before and after a scale error is given to an axis, by the whole way from six points
/// over the station to the lengths.
struct SlopeRequest {
  Set set;
  std::size_t axis = 1;                                    ///< 0 to 2
  RelativeLength base = RelativeLength::um_per_m(-30.0);   ///< slope of that axis before
  RelativeLength added = RelativeLength::um_per_m(100.0);  ///< "100.01 %": (1 + base)(1 + added)
  Vector3 origin_mm = {};                                  ///< origin of the scale
  Vector3 offset_mm = {};                                  ///< constant displacement, added with the error
  std::vector<double> distances_mm = {300, 400, 500, 600, 700, 800, 900, 1000, 1100};
};
struct LineSlopes {
  std::string id;
  Vector3 direction;
  double before_um_per_m = 0.0;
  double after_um_per_m = 0.0;
  double expected_change_um_per_m = 0.0;  ///< e·u_a², e as added to the base
};
struct Slopes {
  SlopeRequest request;
  BothEstimates before, after;
  std::vector<LineSlopes> lines;
};
/// Fails also on fewer than two distances.
Result<Slopes> slopes(const SlopeRequest& request);

}  // namespace axiometry::app::lee
