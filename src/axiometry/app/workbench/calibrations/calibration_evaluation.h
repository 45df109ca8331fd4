// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/app/error_motions/motion_choices.h"
#include "axiometry/app/tracking/tracking_evaluate.h"
#include "axiometry/app/volumetric/identify_lengths.h"
#include "axiometry/base/json/json.h"
#include "axiometry/report/document.h"
#include "axiometry/store/records.h"

/// A calibration out of the bytes it is evaluated from: the lines of a plan, the 21 errors of a machine, or
/// straightness, angles and squareness of its axes.
namespace axiometry::app {

/// A file under what it is for. The bytes must outlive the call.
struct CalibrationSource {
  /// Of lines "lengths", "plan" and perhaps "station" and "tolerances" (of evaluate --tolerance-table); of the 21
  /// errors "lengths", of several "lengths-2" and so on, "machine", and "plan", which may stand for the machine. Of
  /// straightness "readings", of several angles and the two lines of a squareness "readings-2" and so on too, and
  /// perhaps the "plan" of readings alone, of a squareness "plan-2" for its second line.
  std::string role;
  std::string name;
  std::string_view bytes;
};

using EvaluatedCalibration = std::variant<EvaluatedLines, IdentifiedMachine, EvaluatedMotion>;

/// "lengths" of the first file of lengths, "lengths-2" of the second.
std::string lengths_role(std::size_t number);
/// Likewise "readings", "readings-2", and "plan", "plan-2".
std::string readings_role(std::size_t number);
std::string plan_role(std::size_t number);

/// What the files are of where nobody says it: "squareness" of two files of straightness, else as the first says or its
/// columns do; "straightness" of what cannot be read, which evaluate_calibration() then refuses.
std::string motion_kind_of_files(std::span<const CalibrationSource> files);

/// Options as evaluate_options_from() has them of lines, identify_choices_from() of the 21 errors,
/// motion_choices_from() of the others. The 21 errors end, as unavailable, once nobody waits. Fails as these and as
/// evaluate_presentable(), identify_lengths() and evaluate_motion() do, on another kind, and on files that are missing,
/// of no use or there twice.
Result<EvaluatedCalibration> evaluate_calibration(std::string_view kind, std::span<const CalibrationSource> files,
                                                  const json::Value& options, const std::stop_token& stop = {});

/// As the verbs print it (docs/results.md).
json::Value result_of(const EvaluatedCalibration& evaluated);
report::Document document_of(const EvaluatedCalibration& evaluated, const report::Options& options);

/// Of lines A, E, R and B of each; of the 21 errors, with each tool, the size of the error of the tool point over the
/// volume without rigid motion, then χ²/ν, rank, and how many of the errors the lengths do not tell; of straightness
/// and angles, with the name of each error, its range ("straightness", "angle_range"), over both directions
/// ("…_both"), the largest reversal and the repeatability; of squareness C0Y, B0Z or A0Z where its sign is known, and
/// S.
std::vector<store::KeptFigure> figures_of(const EvaluatedCalibration& evaluated);

/// What the files suggest where nobody says it; empty where they say nothing.
struct SuggestedText {
  std::string title;
  std::string machine;
  std::string measured_on;
};
SuggestedText suggested(const EvaluatedCalibration& evaluated);

/// Everything that the archive keeps of it but texts, links and the contents' hashes.
store::CalibrationRecord calibration_of(std::string_view kind, const EvaluatedCalibration& evaluated);

}  // namespace axiometry::app
