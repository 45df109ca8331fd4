// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/experiment.h"
#include "axiometry/compensation/expectation.h"
#include "axiometry/compensation/fit.h"
#include "axiometry/compensation/grid.h"
#include "axiometry/compensation/prediction.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/nc/axis_table.h"

/// The use case "from a measured test to the table by which the control corrects the axis".
namespace axiometry::app {

struct CompensateRequest {
  std::string file;         ///< the test as it was measured
  EvaluateOptions reading;  ///< how it is read
  std::string control;      ///< id of an nc::AxisTable
  std::string axis;         ///< as the control names it; empty: as the test does
  nc::AxisTableOptions table;
  compensation::GridRequest grid;
  std::optional<TableCurves> curves;  ///< fewer than the control has
  compensation::Method method = compensation::Method::least_squares;
  bool smooth = false;
  bool hold_ends = false;
  std::string existing;  ///< file of the table that was active while the test was measured; empty: none was
  std::string retest;    ///< file of a test with the new table active; empty: none yet
};

struct Retest {
  Test test;
  iso230_2::Evaluation evaluation;
  std::optional<compensation::Effect> effect;
};

struct CompensatedAxis {
  Test test;
  const nc::AxisTable* control = nullptr;
  nc::AxisTableOptions options;
  std::string text;        ///< the file for the control
  AxisCorrection applied;  ///< what the control adds with it, as its own rule reads it
  std::optional<AxisCorrection> existing;
  double smoothing = 0.0;  ///< λ; 0 without
  iso230_2::Evaluation before, predicted;
  iso230_2::AxisParameters interpolated;  ///< with nodes interpolated instead, unrounded
  iso230_2::AxisParameters fitted;        ///< with the nodes of the fit, unrounded
  iso230_2::AxisParameters scatter;       ///< what no table removes
  std::optional<compensation::ExpectedRetest> expected;
  std::optional<Retest> retest;
  std::vector<NamedFinding> findings;
};

/// Fails as the file does and on a series that no axis makes; where the control cannot hold the table; and where the
/// table, read back by the control's own rule, would not reduce E and the root mean square of the mean deviations, of
/// these readings, or E of the re-tests that are to be expected: nothing is written then.
Result<CompensatedAxis> compensate(const CompensateRequest& request);

/// A table of a control as a file, read by its rule. Fails as the file and the table.
Result<AxisCorrection> read_axis_table(const std::string& file, const nc::AxisTable& control,
                                       const nc::AxisTableOptions& options);

/// What a control takes, for lists.
json::Value control_to_json(const nc::AxisTable& control);

/// Report and JSON; keys: docs/results.md.
Experiment present(const CompensatedAxis& done, const report::Options& options);

}  // namespace axiometry::app
