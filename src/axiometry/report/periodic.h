// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/iso230_2/periodic/periodic.h"

/// The report of a periodic positioning error (Annex C): its figures, its numbers as people read them, the whole
/// document.
namespace axiometry::report {

struct PeriodicSubject {
  const Test& test;
  const iso230_2::PeriodicError& result;
};

/// A result as it is shown. U to Options::uncertainty_digits significant digits, the value to its last place; without
/// U as many digits as say something.
struct PeriodicRow {
  std::string title;   ///< "Amplitude"
  std::string symbol;  ///< as document.h's symbol() reads it: "A_1"; may be empty
  std::string value;
  std::string U;  ///< expanded; empty where there is none
  std::string unit;
};

/// Period, amplitude, phase, peak to valley, line, residuals, significance, in this order.
std::vector<PeriodicRow> periodic_rows(const iso230_2::PeriodicDirection& direction, AxisKind kind,
                                       const Options& options);

/// Every harmonic: its amplitude, phase and whether it is part of the curve.
Table harmonic_table(const iso230_2::PeriodicDirection& direction, AxisKind kind, const Options& options);

/// Of each direction four figures of 500 points width: the deviations and the line that is removed; what is left with
/// the curve; the same folded into one period; the spectrum with the period marked.
std::vector<Figure> periodic_figures(const PeriodicSubject& subject, const Options& options);

/// Results, figures, findings, identification of the test, method, provenance.
Document compose(const PeriodicSubject& subject, const Options& options);

}  // namespace axiometry::report
