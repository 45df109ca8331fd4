// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/volumetric/field/tool_fields.h"
#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/plan/planner.h"

/// Reports of volumetric calibrations.
namespace axiometry::report {

/// A file from which lengths came.
struct VolumetricLengthsFile {
  std::string file, sha256;
  std::size_t lengths = 0;
  std::string parts = {};   ///< parts of a continuous recording, "3" or "3–5"; empty for a table
  std::size_t planned = 0;  ///< stops of the parts of a recording
};

struct VolumetricSubject {
  const volumetric::MachineModel& machine;
  const volumetric::VolumetricLengths& lengths;
  const volumetric::Identification& found;
  std::span<const VolumetricLengthsFile> lengths_files;
  std::string machine_file, machine_sha256;  ///< the plan where the machine stands in it
  std::string plan_file, plan_sha256;        ///< empty without one
};

/// Findings, squareness, how large each of the 18 functions is and how well it is known, with their curves, the error
/// of the tool point over the volume, diagonals, stations, residuals, method.
Document compose(const VolumetricSubject& subject, const Options& options);

struct VolumeFieldSubject {
  const volumetric::ErrorModel& model;
  std::span<const volumetric::ToolField> fields;
  std::span<const volumetric::VolumetricFinding> findings;  ///< those of the result too that speak against it
  SourceFile result;
};
/// The volume, its diagonals, and what speaks against them.
Document compose(const VolumeFieldSubject& subject, const Options& options);

/// A test of one line as it is predicted, and beside it what was measured.
struct PredictedTestSubject {
  const volumetric::ErrorModel& model;
  const volumetric::PredictedLine& predicted;
  const std::optional<volumetric::LineComparison>& comparison;
  std::span<const volumetric::VolumetricFinding> findings;
  std::string tool;
  std::span<const SourceFile> sources;  ///< the result first, then the measured test where there is one
};
Document compose(const PredictedTestSubject& subject, const Options& options);

/// The sheet to take to the machine: what the plan will tell, set-up, runs in their order.
Document calibration_sheet(const volumetric::PlannedCalibration& planned, const Options& options);

}  // namespace axiometry::report
