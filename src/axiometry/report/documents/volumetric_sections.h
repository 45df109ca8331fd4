// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/volumetric/field/tool_fields.h"
#include "axiometry/volumetric/identify/identification.h"

/// Sections that reports of volumetric calibrations have in common.
namespace axiometry::report {

/// How large the error of the tool point is with each tool, as found and without a rigid motion, and the planes of one.
/// Serious ones first, as they are given; not called without one.
Table finding_table(std::span<const volumetric::VolumetricFinding> findings);

Section volume_section(const volumetric::ErrorModel& model, std::span<const volumetric::ToolField> fields,
                       const Options& options);

/// What ISO 230-6 would show.
Section diagonals_section(const volumetric::ErrorModel& model, std::span<const volumetric::ToolField> fields,
                          const Options& options);

}  // namespace axiometry::report
