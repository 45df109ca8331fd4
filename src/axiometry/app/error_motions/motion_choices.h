// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/files/given_file.h"
#include "axiometry/base/json/json.h"

/// How files of straightness, rotations or squareness are evaluated, as the archive keeps it and a request asks for it.
namespace axiometry::app {

/// What is absent is as the verbs have it.
struct MotionChoices {
  std::optional<error_motions::Reference> reference{};
  std::optional<error_motions::InstrumentUncertainty> instrument{};
  std::optional<MotionName> error{};        ///< error that a single file holds
  std::vector<ReadingSense> positive{};     ///< none, or one of each file
  std::optional<Vector3> offset_mm{};       ///< offset of a point that angles move, mm
  std::vector<Plan> plans{};                ///< none or one, of squareness one for each line; no options but files
  error_motions::SquarenessOptions square;  ///< how squareness is found; whether readings are in axes is found out
};

/// "reference": "least-squares", "end-points", "none"; "instrument": [A, B]; "error": "EYX"; "positive": ["+Y", "-X"];
/// "offset_mm": [DX, DY, DZ]; "square_error_arcsec", "square_uncertainty_arcsec". Fails on others, other kinds of
/// values, and numbers that no instrument or square has.
Result<MotionChoices> motion_choices_from(const json::Value& options);
json::Value to_json(const MotionChoices& choices);

/// Bounds of what is stated, also on the command line.
inline constexpr double largest_motion_uncertainty = 1e6;  ///< µm, µrad or ″; no instrument has more
inline constexpr double largest_square_arcsec = 3600.0;    ///< a degree
inline constexpr double largest_offset_mm = 1e5;           ///< 100 m; no machine has more

/// Fails on an offset of which a part is larger than that of any machine.
Result<void> check_offset(Vector3 offset_mm);

using EvaluatedMotion = std::variant<MeasuredMotion, AnglesMeasurement, SquarenessMeasurement>;

/// "straightness" of one file, "angles" of one to 18, "squareness" of two. Fails on another kind, on another number
/// of files, on choices that the kind has no use for, and as measure_straightness() and the others do.
Result<EvaluatedMotion> evaluate_motion(std::string_view kind, std::span<const GivenFile> files,
                                        const MotionChoices& choices);

bool is_motion_kind(std::string_view kind);

/// As present() of its kind.
Experiment present_motion(const EvaluatedMotion& evaluated, const report::Options& options, MotionOutputs outputs);

/// Of each file, in their order.
std::vector<const MeasuredMotion*> measured_files(const EvaluatedMotion& evaluated);

}  // namespace axiometry::app
