// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/vector3.h"
#include "axiometry/model/axis.h"
#include "axiometry/report/report.h"

/// Numbers as reports show them. Absent values are not shown here: the caller says what stands there.
namespace axiometry::report {

/// How parameters and their uncertainties are shown on an axis: Options::unit, or the native unit
/// when it belongs to the other kind of axis (one set of options serves a folder of tests).
struct ParameterScale {
  std::string_view unit;     ///< "mm"
  double per_native = 1.0;   ///< size of 1 µm or 1″ in that unit: 0.001
  int further_decimals = 0;  ///< decimals on top of those of µm or ″: 3; negative for nm
};
ParameterScale parameter_scale(AxisKind kind, DisplayUnit unit);

/// Whether it is one of that kind of axis, as native always is.
bool is_unit_of(AxisKind kind, DisplayUnit unit);

/// Where an uncertainty of two digits ends, and what stands beside it; below a picometre, which is what rounding leaves
/// of none, where deviations do. Contract: deviation_decimals are chosen.
int uncertainty_decimals(Deviation uncertainty, const ParameterScale& scale, const Options& options);

/// Where the value of a parameter ends wherever it is shown to people: where the uncertainty beside it does, else with
/// the deviations. Negative for tens, hundreds.
int parameter_decimals(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                       const Options& options);

/// To Options::deviation_decimals (contract: chosen), in the native unit.
std::string shown_deviation(Deviation deviation, const Options& options);

/// A limit with every digit that it was stated with, in the unit of the scale: no value may seem to keep one that it
/// exceeds.
std::string shown_limit(Deviation limit, const ParameterScale& scale, const Options& options);

/// T − g in the unit shown, to so many decimals (negative: tens) and never above itself, and T + g never below: a value
/// that is held against what is printed must not be accepted, or rejected, where the decision is another.
double acceptance_limit_to(double limit, int decimals);
double rejection_limit_to(double limit, int decimals);

/// A contribution to the uncertainty to Options::uncertainty_digits, in the unit of the scale.
std::string shown_uncertainty(Deviation U, const ParameterScale& scale, const Options& options);

/// Shortest text that reads back the same, with the decimal mark and a true minus sign.
std::string shown_exact(double x, const Options& options);

/// A text in which the hyphens before numbers, "-500 to 0 mm" but not "2-3", are true minus signs.
std::string with_true_minus(std::string_view text);

/// So many significant digits at most, for numbers that were computed: 1744.209, and with three 1740. Written out below
/// 10⁹.
std::string shown_short(double x, const Options& options, int significant_digits = 7);

/// "(0.5, −1, 2)" to so many significant digits; separated by semicolons where the decimal mark is a comma.
std::string shown_vector(Vector3 v, const Options& options, int significant_digits);

/// Decimals that show every target fully, at most 4.
int position_decimals(std::span<const Position> targets);

}  // namespace axiometry::report
