// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/iso230_2/periodic/correlated_noise.h"

/// Periodic positioning error (ISO 230-2:2014, Annex C). The text of the annex was not at hand: what is done follows
/// general knowledge of the test and docs/theory/periodic-error.md, where the formulas are derived.
///
/// The deviations of one direction (means over its runs, each target counting once) are taken for
///
///     x(P) = a + b (P − P_1) + Σ_h A_h sin(2π h (P − P_1)/λ + φ_h),   h = 1 and those of 2, 3, 4 that count
///
/// by least squares, line and curve at once (numeric/harmonic_fit.h). The period λ is known, or that of the highest
/// peak of the spectrum, refined with all harmonics. Targets may be spaced unevenly. Standard uncertainties u are those
/// of the fit, from the residuals, and larger where these go on from target to target; expanded ones are U = k u with k
/// of Student's t for the degrees of freedom. What is removed is the line, in this view alone: the readings stay as
/// they are.
namespace axiometry::iso230_2 {

/// A result of the fit with its standard uncertainty.
template <typename Quantity>
struct Estimate {
  Quantity value{};
  Quantity u{};
};

struct PeriodicOptions {
  std::optional<Position> period{};    ///< λ, when it is known; else it is searched
  std::optional<Position> shortest{};  ///< shortest period searched; 2.1 times the mean spacing when not given
  std::optional<Position> longest{};   ///< half the measured travel when not given, so that two periods are covered
  /// How many periods may be searched: 10⁷ take half a minute and 600 MB, 3·10⁵ a second.
  double lines_most = 1e7;
};

/// One sinusoid of the curve.
struct PeriodicHarmonic {
  std::size_t order = 1;          ///< h; 1 is the fundamental
  Estimate<Deviation> amplitude;  ///< A_h ≥ 0; noise alone gives about 1.3 times its u
  Estimate<Angle> phase;          ///< φ_h in (−180°, 180°], at the first target P_1; u at most 104° (anything)
  double chance = 1.0;            ///< probability that noise alone makes this harmonic as large
  bool significant = false;       ///< chance below 1 %; then, and the fundamental always, it is part of the curve
};

/// The deviation at one target and its parts: deviation = line + curve + residual (and insignificant harmonics).
struct PeriodicPoint {
  Position target;
  Deviation deviation;   ///< mean over the runs of this direction
  Deviation line;        ///< the straight line that is removed
  Deviation curve;       ///< the fundamental and the significant harmonics
  double phase_deg = 0;  ///< place within the period, 0 to 360, counted from P_1
};

/// A sinusoid of the searched band, for figures.
struct PeriodicSpectrumLine {
  Position period;
  Deviation amplitude;
};

/// Another period that stands out when the curve is taken away.
struct FurtherPeriod {
  Position period;
  Deviation amplitude;
  double false_alarm = 1.0;
};

inline constexpr double periodic_significance = 0.01;  ///< level of what counts as no chance

struct PeriodicDirection {
  Direction direction = Direction::up;
  std::size_t runs = 0;     ///< runs with readings
  std::size_t missing = 0;  ///< readings that are missing in runs and at targets that have some
  Position origin;          ///< P_1, the first target with a reading
  std::vector<PeriodicPoint> points;

  Estimate<Deviation> offset;     ///< a, at P_1
  Estimate<double> slope_native;  ///< b: µm/mm or ″/°

  bool period_known = false;                ///< then it has no uncertainty here
  Estimate<Position> period;                ///< λ
  std::vector<PeriodicHarmonic> harmonics;  ///< as many of four as the targets can tell, the fundamental first
  Estimate<Angle> phase_at_zero;  ///< phase of the fundamental at position 0, with what λ is uncertain on the way

  Estimate<Deviation> peak_to_valley;  ///< range of `curve` over one period; not inflated by the residuals
  Deviation range_about_line;          ///< range of the deviations less the line: what a reader of the raw data sees
  Deviation range_of_residuals;        ///< range of what the curve leaves
  Deviation residual_sd;  ///< standard deviation of the residuals, with n − parameters degrees of freedom
  std::size_t degrees_of_freedom = 0;
  std::optional<Deviation> scatter_of_means;  ///< s/√n pooled over the targets: what the runs let expect as
                                              ///< residual_sd; where readings are missing, without what runs are
                                              ///< shifted by, and absent where nothing is left to tell it
  double coverage_factor = 2.0;               ///< k for a probability of 95.45 %

  double false_alarm = 1.0;  ///< probability of such a peak by white noise alone: in the band, or at the known period
  NoiseCorrelation residual_correlation{};
  double curve_times = 1.0;  ///< as uncertain as by white noise are λ, amplitudes, phases and peak to valley
  double line_times = 1.0;   ///< the same of offset and slope, as of a period of twice the travel
  /// The same of noise that is as correlated from target to target as the residuals let be possible; about, and not
  /// below false_alarm.
  double false_alarm_correlated = 1.0;
  bool significant = false;  ///< false_alarm_correlated below 1 %
  double periods_covered = 0.0;
  double targets_per_period = 0.0;
  std::optional<FurtherPeriod> further;
  std::vector<PeriodicSpectrumLine> spectrum;  ///< lines from long to short periods; also where the period is known
  Deviation noise_level;                       ///< amplitude that noise like the residuals exceeds in 1 % of such bands
  bool peak_at_end = false;                    ///< the highest peak stands at an end of the searched band
  bool beyond_band = false;  ///< a period outside of it fits better: that of the end is told, and not refined

  /// Whether U of period, amplitudes and phases holds the truth as often as it says.
  bool tells_U() const { return significant && !beyond_band; }

  double line_native(double position) const {
    return offset.value.in_native() + slope_native.value * (position - origin.in_native());
  }
  /// The fundamental and the significant harmonics, µm or ″.
  double curve_native(double position) const;
};

struct PeriodicError {
  std::vector<PeriodicDirection> directions;  ///< one or two
  std::vector<Finding> findings;              ///< departures from the test first
  std::string label;                          ///< of cycles that do not serve the standard: must stand with the results

  /// Whether nothing departs from the test of Annex C.
  bool conforming() const;
};

/// A period of so many mm or degrees as it is told: "10.003 mm", "2.5°"; four decimals at most, without zeros at the
/// end.
std::string period_text(double native, AxisKind kind);

/// The periodic error of each direction that was measured. Findings: fewer than two periods, targets further apart than
/// a quarter period, periods that equal spacing cannot tell apart, both directions measured, no significant error, a
/// peak at the end of the band, an expected period that is not the one found, a further period, correlated residuals.
///
/// Fails on a period or band that is not positive, finite and in order, a band without room, more than lines_most
/// periods to search or 10¹¹ steps for it, fewer than 7 targets with readings in a direction (6 with a known period),
/// runs with missing readings that share too few targets, and targets that cannot show the known period (every half
/// period of it, or a part of one that looks straight).
Result<PeriodicError> periodic_error(const Test& test, const PeriodicOptions& options = {});

}  // namespace axiometry::iso230_2
