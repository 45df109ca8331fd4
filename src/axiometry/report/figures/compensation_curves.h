// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/model/axis_correction.h"
#include "axiometry/report/compensation.h"
#include "axiometry/report/drawing/figure.h"

namespace axiometry::report {

/// Mean deviations before and as predicted, and of the re-test as dots, over each other.
Figure before_and_predicted_figure(const CompensationSubject& subject, const Options& options);

/// What the control adds to the commanded position, with its positions, and with a table that was there before.
Figure correction_figure(const CompensationSubject& subject, const Options& options);

/// Displacements of the tool point at the positions of a line, and the standard uncertainty of each, µm.
struct DisplacementsOfLine {
  std::span<const double> values_um;
  std::span<const double> u_um;
};

/// A line through the volume of a machine, and what a table along it adds; as many displacements as positions.
struct CorrectedLine {
  std::span<const double> positions_mm;
  DisplacementsOfLine up, down;
  bool has_directions;  ///< else `up` stands for both
  const AxisCorrection& applied;
};

/// Displacements without the table, and with it in the band ±U (k = 2) of what was identified.
Figure corrected_line_figure(const CorrectedLine& line, const Options& options);

/// correction_figure() of such a table.
Figure line_correction_figure(const CorrectedLine& line, const Options& options);

}  // namespace axiometry::report
