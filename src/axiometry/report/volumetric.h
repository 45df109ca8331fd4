// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/volumetric/identify/identification.h"

/// Reports of volumetric calibrations.
namespace axiometry::report {

struct VolumetricSubject {
  const volumetric::MachineModel& machine;
  const volumetric::VolumetricLengths& lengths;
  const volumetric::Identification& found;
  std::string lengths_file, lengths_sha256;
  std::string machine_file, machine_sha256;
};

/// Findings, squareness, how large each of the 18 functions is and how well it is known, stations, residuals, method.
Document compose(const VolumetricSubject& subject, const Options& options);

}  // namespace axiometry::report
