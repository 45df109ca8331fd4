// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <span>

/// A figure of an error motion with its uncertainty, and how the parts of that come together.
namespace axiometry::error_motions {

/// Expanded uncertainty (k = 2) of one reading at the distance L from the lowest position: U = a + b·L, from the
/// certificate or the data sheet of the instrument, in µm, µrad or ″ as the series has it, b per metre. Nothing is
/// assumed of how the instrument's errors at different positions go together: an estimate Σ c_i y_i has at most
/// Σ |c_i| u_i of it, whatever their correlation. It therefore does not fall with more positions or runs. An error of
/// the instrument's gain (a share of the reading) and of its own reference (the straightness of an optic) must be in a
/// and b.
struct InstrumentUncertainty {
  double a = 0.0;
  double b_per_m = 0.0;
  double standard(double distance_mm) const { return (a + 1e-3 * b_per_m * distance_mm) / 2.0; }
};

inline constexpr double rounding = 1e-9;  ///< share of a value, or of its unit: what is smaller is none

struct MotionEstimate {
  enum class Scatter {
    none,       ///< one run: it cannot be told from the shape of the way
    runs,       ///< scatter of the runs' own estimates, s/√n with n − 1 degrees of freedom
    noise,      ///< noise within the runs, s_w √(Σ c²/n), where few runs happen to agree better than that
    residuals,  ///< one run, of the rest about the least-squares line, m − 2 degrees: the shape of the way is in it
  };

  double value = 0.0;
  Scatter scatter = Scatter::none;
  double scatter_u = 0.0;                                            ///< standard uncertainty; 0 for none
  double scatter_degrees = std::numeric_limits<double>::infinity();  ///< ν of it
  std::optional<double> instrument_u;                                ///< absent where none is stated
  std::optional<double> other_u;                                     ///< standard uncertainty of an optical square

  /// GUM 5.1, 6 and G.4 over these parts; absent where neither is known.
  std::optional<double> u;  ///< √(scatter² + instrument² + other²)
  double k = 2.0;           ///< Student's t for 95.45 % and ν_eff, cut to a whole number (G.6.4)
  double U() const { return u ? k * *u : 0.0; }
  bool U_is_rounding() const;

  /// Runs that agree in a figure to its last digit tell nothing of how far it is from the truth: without an instrument
  /// or a square whose U is stated there is none then, and not 0.
  bool tells_U() const { return u && (instrument_u || other_u || !U_is_rounding()); }
};

/// The parts of a sum of independent quantities of type A: its u and ν_eff (GUM G.2b).
struct ScatterPart {
  double u = 0.0;
  double degrees = std::numeric_limits<double>::infinity();
};
ScatterPart combined_scatter(std::span<const ScatterPart> parts);

/// k of Student's t for 95.45 %; 2 for infinite degrees of freedom.
double coverage_of(double degrees);

/// With u and k from the parts that are there.
MotionEstimate combined(MotionEstimate parts);

}  // namespace axiometry::error_motions
