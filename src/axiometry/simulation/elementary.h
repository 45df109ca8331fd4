// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Elementary functions of IEEE 754 additions, multiplications and divisions alone, so that a simulation gives the same
/// bits wherever it runs; those of the C library differ in the last place from one system to the next.
namespace axiometry::simulation {

/// Sine and cosine of one angle.
struct Wave {
  double sine = 0.0;
  double cosine = 1.0;
};

/// sin(2πt) and cos(2πt) of t in turns, |t| ≤ 2⁵²; within 4e-16 of the exact value for the t given. Whole and quarter
/// turns are exact.
Wave wave(double turns);

/// eˣ for |x| ≤ 700, within 4e-16 of itself; 0 below −700. Method: x = k ln 2 + r, |r| ≤ 0.35, Taylor's series of 14
/// terms.
double exponential(double x);

}  // namespace axiometry::simulation
