// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/app/results/experiment.h"
#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/volumetric/field/error_model.h"
#include "axiometry/volumetric/field/table_effect.h"

/// The use case "from the 21 errors of a machine to a table of one axis for a control": the axis' positioning, or,
/// where the control moves another axis by it (a cross table), straightness with squareness.
namespace axiometry::app {

struct VolumeCompensationRequest {
  std::string result;         ///< file of `axiometry volumetric identify --out`
  std::string tool;           ///< may be empty where the machine has one
  std::size_t along = 0;      ///< the axis at whose positions the table stands, 0 to 2
  std::size_t component = 0;  ///< the direction in which the tool point is moved, 0 to 2
  CompensateRequest how;      ///< control, positions, curves
};

/// Displacements of the tool point along one direction while one axis moves through the middle of the volume.
struct LineOfVolume {
  std::vector<double> positions_mm;
  std::vector<double> up_um, down_um;
  std::vector<double> up_u_um, down_u_um;  ///< standard uncertainty of each
  double largest_u_um = 0.0;               ///< the largest of them
  /// Errors whose directions nothing tells apart, for which both are the mean; in the order of error_names().
  std::vector<std::size_t> untold_reversals = {};
};

/// What is moved and what of it: of `along` = `component` EXX with what rotations do on the line, of Y and X EXY with
/// C0Y, of X and Y EYX.
struct VolumeCompensation {
  const nc::AxisTable* control = nullptr;
  nc::AxisTableOptions options;
  std::string text;           ///< the file for the control
  AxisCorrection applied;     ///< what the control adds with it, as its own rule reads it, µm along `component`
  std::string errors;         ///< "EXY, C0Y"
  std::string machine, tool;  ///< names; may be empty
  std::size_t along = 0, component = 0;  ///< as they were asked for
  LineOfVolume line;
  double line_before_um = 0.0, line_after_um = 0.0;  ///< range of the displacements on the line
  volumetric::TableEffect effect;                    ///< effect on the error of the tool point over the volume
  std::vector<NamedFinding> findings;
  std::string result = {}, result_sha256 = {};  ///< the file it was made from; empty of one that is at hand
};

/// On the line of `along` through the middle of the volume that was observed: levers grow in proportion to the other
/// axes' positions, so that no other function of that axis alone leaves less (as axis_tables.h). Fails as the result
/// file; on a control that cannot move another axis where it must; where the lengths do not tell the displacement;
/// where the control cannot hold the table; and where the table, read back by the control's rule, would not reduce the
/// range on the line: nothing is written then.
Result<VolumeCompensation> compensate_volume(const VolumeCompensationRequest& request);
Result<VolumeCompensation> compensate_volume(const KeptModel& kept, const VolumeCompensationRequest& request);
Result<VolumeCompensation> compensate_volume(const volumetric::ErrorModel& model,
                                             const VolumeCompensationRequest& request);

json::Value to_json(const VolumeCompensation& made);

/// Report and JSON; keys: docs/results.md.
Experiment present(const VolumeCompensation& made, const report::Options& options);

}  // namespace axiometry::app
