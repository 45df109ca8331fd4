// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "axiometry/model/test.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/readings/drift.h"

/// Corrections of readings and their drift in words, the same in reports and in the terminal.
namespace axiometry::report {

/// "Readings corrected by this program: refractive index of air (Ciddor 1996), drift"; empty without a correction.
std::string correction_statement(std::span<const AppliedCorrection> corrections);

/// "−24.76 to 0.00 µm": what was added to single readings.
std::string correction_extent(const AppliedCorrection& correction, AxisKind kind, const Options& options);

/// The value of a detail, whose numbers have a decimal point, with a true minus sign and the decimal mark asked for.
std::string detail_value(const AppliedCorrection::Detail& detail, const Options& options);

/// "0.42 µm/h, standard uncertainty 0.05 µm/h, that is 0.3 µm over the test"; per reading where no times are known.
std::string drift_statement(const Drift& drift, AxisKind kind, const Options& options);

}  // namespace axiometry::report
