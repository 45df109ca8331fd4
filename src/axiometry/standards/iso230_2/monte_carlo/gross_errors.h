// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/readings/test_course.h"

/// Readings that no scatter explains: what breaks every model of normal scatter and noise.
namespace axiometry::iso230_2 {

struct GrossError {
  std::size_t target = 0;
  Direction direction = Direction::up;
  std::size_t run = 0;
  Deviation departure;  ///< distance from the median of the other approaches of its target and direction
  double factor = 0.0;  ///< |departure| over its standard deviation
};

inline constexpr double one_test_in_a_hundred = 0.01;  ///< of those without an error: no scatter explains the reading
inline constexpr double one_test_in_ten = 0.1;         ///< the reading may be an error

/// Largest factor first. A reading departs from the median of the others of its cell, after what its neighbours in time
/// depart by in common and the slopes that runs have of their own have been taken out, by more than normal scatter
/// gives to the share `false_alarms` of tests: for N readings, beyond the quantile of false_alarms/2N of Student's t
/// (4.1 standard deviations for 110 readings and one test in a hundred). The scatter is that of all such departures but
/// those beyond three times their median, or that of the cells, which a tenth of outliers hardly moves; of a cell that
/// scatters more, its own. Where more readings than one test in a thousand has depart by over three standard
/// deviations, these are meant. `step`: what readings are rounded to (step_of() of them as they were taken); no scatter
/// is smaller than half of it, nor of 1e-4 of the native unit.
std::vector<GrossError> gross_errors(const Series& series, const TestCourse& course, double step,
                                     double false_alarms = one_test_in_a_hundred);

/// Of gross_errors() of the readings of `test` that `found` are: the worst of them and how many there are, a sentence
/// without full stop. Empty where there are none.
std::string reason_of(std::span<const GrossError> found, const Test& test);

}  // namespace axiometry::iso230_2
