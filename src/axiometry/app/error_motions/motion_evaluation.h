// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/base/vector3.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/standards/error_motions/axis_motion.h"
#include "axiometry/standards/error_motions/squareness.h"

/// The use cases "from measured files to the straightness, the rotations and the squareness of axes".
namespace axiometry::app {

struct MotionRequest {
  std::string file;                   ///< or "-"
  std::optional<MotionName> error{};  ///< what the file holds, where it does not say so itself
  error_motions::MotionOptions options;
};

/// One file, evaluated.
struct MeasuredMotion {
  std::string file;
  std::string sha256;
  std::optional<MotionName> error;
  Metadata metadata;
  std::vector<std::string> remarks;  ///< of its reading, and what its figures lack
  error_motions::AxisMotion motion;
  bool instrument_stated = false;
};

/// Fails, with the file's name, as reading and MotionSeries::make() do, on readings of the other kind, and on an error
/// that contradicts the file's.
Result<MeasuredMotion> measure_straightness(const MotionRequest& request);
Result<MeasuredMotion> measure_angle(const MotionRequest& request);

/// Straightness of two axes.
struct SquarenessRequest {
  std::string first, second;
  error_motions::MotionOptions options;
  error_motions::SquarenessOptions square;
};
struct SquarenessMeasurement {
  MeasuredMotion first, second;
  error_motions::SquarenessOptions square;
  error_motions::MeasuredSquareness result;
};
Result<SquarenessMeasurement> measure_squareness(const SquarenessRequest& request);

/// Rotations of one axis, and what they do at another point.
struct AnglesRequest {
  std::vector<MotionRequest> files;
  std::optional<Vector3> offset_mm{};  ///< (dx, dy, dz), abbe_offset.h
};
struct AbbeComponent {
  std::string name;                              ///< "EXX"
  std::optional<std::vector<double>> change_um;  ///< at each position
  std::string missing;                           ///< "EBX, ECX"; empty where change_um is there
};
struct AnglesMeasurement {
  std::vector<MeasuredMotion> angles;
  std::optional<Vector3> offset_mm;
  std::vector<AbbeComponent> abbe;  ///< three with an offset, none without
};
/// Fails with an offset on an angle without a name, one twice, angles of several axes and lists of positions that
/// differ.
Result<AnglesMeasurement> measure_angles(const AnglesRequest& request);

/// What is made of a result besides its figures in a terminal: each costs memory for every position.
struct MotionOutputs {
  bool report = true;  ///< tables of positions and diagrams
  bool json = true;
};
Experiment present(const MeasuredMotion& straightness, const report::Options& options, MotionOutputs outputs);
Experiment present(const SquarenessMeasurement& squareness, const report::Options& options, MotionOutputs outputs);
Experiment present(const AnglesMeasurement& angles, const report::Options& options, MotionOutputs outputs);

}  // namespace axiometry::app
