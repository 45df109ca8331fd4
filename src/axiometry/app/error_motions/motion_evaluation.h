// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/base/vector3.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/standards/error_motions/axis_motion.h"
#include "axiometry/standards/error_motions/squareness.h"

/// The use cases "from measured files to the straightness, the rotations and the squareness of axes".
namespace axiometry::app {

struct MotionRequest {
  std::string file;                     ///< name of the file, or "-"
  std::optional<MotionName> error{};    ///< what the file holds, where it does not say so itself
  bool error_by_senses = false;         ///< both senses of a squareness tell that
  std::optional<ReadingSense> sense{};  ///< likewise which way its readings are positive
  error_motions::MotionOptions options;
  std::optional<Plan> plan{};               ///< plan after which readings alone were taken, read_planned_motion()
  bool alone_with_plan = true;              ///< no other file is of the same plan: it may tell which error this is
  std::optional<std::string_view> bytes{};  ///< those of `file` where they are at hand; they must outlive the call
};

/// Of readings whose instrument nobody states; who knows it from elsewhere takes the remark away.
inline constexpr std::string_view no_instrument_remark =
    "no uncertainty of the instrument is stated: U does not hold it";
/// Of readings of which somebody states that their instrument has none.
inline constexpr std::string_view zero_instrument_remark =
    "the uncertainty of the instrument is stated as 0, which no instrument has: it counts as not stated, and U does "
    "not hold it";

/// One file, evaluated.
struct MeasuredMotion {
  std::string file;
  std::string sha256;
  std::optional<MotionName> error;
  std::optional<ReadingSense> sense;  ///< as read; readings of a negative one are turned, so that `motion` is positive
  Metadata metadata;
  std::vector<std::string> remarks;  ///< remarks on its reading, and what its figures lack
  error_motions::AxisMotion motion;
  std::optional<error_motions::InstrumentUncertainty> instrument{};  ///< its uncertainty, in the unit of `motion`

  /// Whether its numbers are stated to be those of the named error, in axes of the machine.
  bool in_axes() const { return error && sense; }
};

/// Where neither file nor request names the error, it is the only one of its kind that the plan is made for. Fails,
/// with the file's name, as reading, MotionSeries::make() and formats::check_error_of_plan() do, on readings of the
/// other kind, on an error or a sense that contradicts the file's, on a sense along another coordinate than that of the
/// error, on a file of another axis than the error's, on a gain or a reversed sign, which nobody applies here, and on
/// lengths in a column "deviation" of which neither error nor sense is named: they may be those of positions.
Result<MeasuredMotion> measure_straightness(const MotionRequest& request);
Result<MeasuredMotion> measure_angle(const MotionRequest& request);

/// Straightness of two axes.
struct SquarenessRequest {
  std::string first, second;
  std::array<std::optional<std::string_view>, 2> bytes{};  ///< likewise
  std::array<std::optional<Plan>, 2> plans{};              ///< likewise, of each line its own
  std::optional<std::array<ReadingSense, 2>> senses{};     ///< senses of both lines; they name the errors too
  error_motions::MotionOptions options;
  error_motions::SquarenessOptions square;  ///< whether readings are in axes is found out
};
struct SquarenessMeasurement {
  MeasuredMotion first, second;
  error_motions::SquarenessOptions square;
  error_motions::MeasuredSquareness result;
  std::optional<error_motions::LocationError> location;  ///< by name, where both lines are in axes of the machine
};
/// Fails also on files of different machines.
Result<SquarenessMeasurement> measure_squareness(const SquarenessRequest& request);

/// Rotations of one axis, and what they do at another point.
struct AnglesRequest {
  std::vector<MotionRequest> files;
  std::optional<Vector3> offset_mm{};  ///< (dx, dy, dz), abbe_offset.h
};
struct AbbeCourse {
  error_motions::PathKind kind = error_motions::PathKind::mean;
  std::vector<double> change_um;  ///< change at each position
};
struct AbbeComponent {
  std::string name;  ///< "EXX"
  std::vector<AbbeCourse>
      courses;          ///< those that all files have, the principal one last; none where an angle is missing
  std::string missing;  ///< "EBX, ECX"; empty where there are courses
};
struct AnglesMeasurement {
  std::vector<MeasuredMotion> angles;
  std::optional<Vector3> offset_mm;
  std::vector<AbbeComponent> abbe;  ///< three with an offset, none without
};
/// Fails on files of different machines; with an offset on an angle without a name, one twice, angles of several axes
/// and lists of positions that differ, and where no direction was measured of all of them.
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
