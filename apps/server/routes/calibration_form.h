// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "axiometry/app/workbench/calibrations/calibrations.h"
#include "server/http/http.h"

/// What is sent of lines, the 21 errors, straightness, angles and squareness, to be kept or only looked at.
namespace axiometry::server {

inline constexpr std::size_t calibration_bytes_max = std::size_t{16} << 20;  // as of lengths that are only looked at

/// The parts kind, about and options, and the files by what they are for.
struct CalibrationForm {
  std::string kind;
  json::Value about, options;
  std::vector<app::CalibrationSource> files;
};

/// Fails on a body that is no such form.
Result<CalibrationForm> calibration_form_of(const Request& request);

}  // namespace axiometry::server
