// SPDX-License-Identifier: Apache-2.0
#pragma once

/// What a test's metadata may choose about its uncertainty.
namespace axiometry {

/// How the two parts of a calibration's U = a and b·L make one: certificates state either.
enum class CalibrationSum {
  linear,     ///< a + b·L, the larger; when a certificate does not say
  quadratic,  ///< √(a² + (b·L)²)
};

/// How the environment moves what the instrument shows, in the range E_VE over the time of a test (A.2.5).
enum class EnvironmentKind {
  unknown,      ///< any of the others, as far as the readings do not refute it
  white,        ///< independent from reading to reading
  drift,        ///< slow and smooth: a trend, a swing of the hall's temperature
  random_walk,  ///< steps that add up
};

/// The method that an uncertainty comes from.
enum class UncertaintyMethod { annex_a, gum, monte_carlo };

/// Which of two questions the uncertainty answers; named in every result.
enum class Measurand {
  this_test,     ///< what the same approaches would have given with perfect instruments at 20 °C
  this_machine,  ///< what the axis does in the long run: the sampling of n approaches counts too
};

}  // namespace axiometry
