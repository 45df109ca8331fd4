// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/model/metadata.h"

/// What the environment may do to the readings along the time of a test, as a sum of a few shapes: the deviation at
/// the share τ of the test is Σ c_k φ_k(τ) with independent standard normal c_k.
namespace axiometry {

/// The shapes at the places of the readings, dense as in Series::make_dense(); 0 where a reading has no time.
struct EnvironmentModes {
  std::size_t places = 0;
  std::vector<double> values;  ///< one shape after the other

  std::size_t count() const { return places == 0 ? 0 : values.size() / places; }
  std::span<const double> mode(std::size_t k) const { return std::span(values).subspan(k * places, places); }
};

/// For E_VE = 1, the range over the test. Contract: `kind` is drift or random_walk.
///
/// - drift: a trend, and swings of any phase, from half a period over the test to one in each run; slower ones are
///   larger. Each alone would have a range whose square is 1 on average, together they have weights that add up to 1.
/// - random walk: the principal axes of Brownian motion, √2 sin((k − ½)πτ)/((k − ½)π); its range over the test is
///   √(8/π) σ on average, so that σ = 0.627. What is left out of the variance is below 1 %.
EnvironmentModes environment_modes(EnvironmentKind kind, std::span<const double> shares, std::size_t runs);

/// A straight trend over the test, of the range 1.
EnvironmentModes trend_mode(std::span<const double> shares);

/// An error of its own in each of these readings.
EnvironmentModes single_errors(std::span<const std::size_t> readings, std::size_t places);

/// The shapes of a process whose covariance at a lag is known, in the order of their size: principal axes on equal
/// steps of the test, between which they are interpolated. `covariance` from lag 0 to the length of the test in equal
/// steps, at least two values. Negative eigenvalues, which an estimate may have, are left out.
EnvironmentModes modes_of_covariance(std::span<const double> covariance, std::span<const double> shares);

}  // namespace axiometry
