// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/experiment.h"
#include "axiometry/compensation/compensated_positions.h"
#include "axiometry/compensation/expectation.h"
#include "axiometry/compensation/fit.h"
#include "axiometry/compensation/grid.h"
#include "axiometry/compensation/periodic_part.h"
#include "axiometry/compensation/prediction.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/nc/axis_table.h"

/// The use case "from a measured test to the table by which the control corrects the axis".
namespace axiometry::app {

/// What a table depends on beside the readings.
struct CompensateRequest {
  std::string control;  ///< id of an nc::AxisTable
  std::string axis;     ///< as the control names it; empty: as the test does
  nc::AxisTableOptions table;
  bool resolution_said = false;  ///< table.resolution was stated, though it is as usual
  compensation::GridRequest grid;
  std::optional<TableCurves> curves;  ///< fewer than the control has
  compensation::Method method = compensation::Method::least_squares;
  bool smooth = false;
  bool hold_ends = false;
  compensation::Periodic periodic = compensation::Periodic::keep;
  std::optional<double> period{};          ///< of the periodic part, mm or °; nothing: the one that the test expects
  std::optional<bool> existing_in_inch{};  ///< the unit of the table that was active; nothing: that of the new one
};

/// Fails on what no control has: a resolution outside 0.000001 to 10 000 µm or ″, a magnification outside 1 to 1 000, a
/// largest number or a number above 99 999, steps per unit not above 0 or above 10 000 000, a step below 0.
Result<void> check_table_options(const nc::AxisTableOptions& options);

/// Likewise; on an unknown control, an option or curves that it has no use for, smoothing with interpolation, and a
/// step or a period that is not above 0.
Result<void> check_request(const CompensateRequest& request);

/// A test, ready to be evaluated, under the name that messages call it by.
struct NamedTest {
  std::string name;
  Test test;
};

/// A table of a control, likewise.
struct NamedTable {
  std::string name;
  std::string text;
};

/// What is known of the axis.
struct MeasuredAxis {
  NamedTest measured;
  std::optional<NamedTable> existing{};  ///< the table that was active while the test was measured
  std::optional<NamedTest> retest{};     ///< a test with the new table active
  bool is_kept = false;  ///< its table was made before: a test that none is made of is told, not refused
};

struct CompensateFiles {
  std::string test;
  EvaluateOptions reading;  ///< how both tests are read, the first one and the re-test
  std::string existing;     ///< empty: no table was active
  std::string retest;       ///< empty: none yet
};

/// Fails as the files do.
Result<MeasuredAxis> read_measured_axis(const CompensateFiles& files);

struct Retest {
  Test test;
  iso230_2::Evaluation evaluation;
  std::optional<compensation::RetestEffect> effect;
};

struct CompensatedAxis {
  Test test;
  const nc::AxisTable* control = nullptr;
  nc::AxisTableOptions options;
  std::string text;        ///< the file for the control
  AxisCorrection applied;  ///< what the control adds with it, as its own rule reads it
  std::optional<AxisCorrection> existing;
  compensation::Periodic periodic_choice = compensation::Periodic::keep;
  std::optional<compensation::PeriodicPart> periodic;  ///< found in the readings; nothing where no period is known
  double smoothing = 0.0;                              ///< λ; 0 without
  iso230_2::Evaluation before, predicted;
  iso230_2::AxisParameters interpolated;  ///< parameters predicted with interpolated nodes instead, unrounded
  iso230_2::AxisParameters fitted;        ///< parameters predicted with fitted nodes, unrounded
  iso230_2::AxisParameters scatter;       ///< what no table removes; empty where nothing tells it
  std::optional<compensation::ExpectedRetest> expected;
  compensation::CompensatedPositions known;  ///< positions at which the axis stands with the table, and to within what
  std::optional<Retest> retest;
  std::vector<NamedFinding> findings;
};

/// Fails as check_request() does; on a test of a reversed sign or along a line of several axes, of a table that is not
/// kept; on a periodic part to
/// leave without a period that anybody knows; on an existing table that fits the targets in the other unit of length
/// alone, or goes beyond them where nobody says what to do there; on a series that no axis makes, on a table that the
/// control would not take, and on a re-test of another kind of axis or that is the test itself; where the control
/// cannot hold the table; and where the table, read back by the control's own rule, would not reduce E and the root
/// mean square of the mean deviations, of these readings, or E of the re-tests that are to be expected: nothing is
/// written then; on inputs of the uncertainty as gum() does.
Result<CompensatedAxis> compensate(MeasuredAxis axis, const CompensateRequest& request);

/// Positions with what the control adds there in each direction: [{"position", "up", "down"}].
json::Value nodes_to_json(const AxisCorrection& correction);

/// What a control takes, for lists.
json::Value control_to_json(const nc::AxisTable& control);

/// Report, with notes where there are any, and JSON; keys: docs/results.md.
Experiment present(const CompensatedAxis& done, const report::Options& options, std::string_view notes = {});

}  // namespace axiometry::app
