// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "axiometry/app/workbench/calibrations/calibrations.h"
#include "axiometry/base/result.h"
#include "cli/flags/verb.h"

/// What is said of a calibration beside its files when it is kept.
namespace axiometry::cli {

struct AboutCalibration {
  std::string title, measured_on, notes;
  std::int64_t machine_id = 0, instrument_id = 0;  ///< 0: not said
};

/// --title, --measured-on, --notes, --of-machine, and the instrument by its own name, which differs where --instrument
/// is an uncertainty.
void add_about_flags(const Verb& verb, AboutCalibration& about, const std::string& instrument_name);

/// Checked as a request would be; without kind, files and options.
Result<app::NewCalibration> new_calibration(const AboutCalibration& about);

/// Its number and title, and that the same files are kept already.
void print_kept_calibration(const app::KeptCalibration& kept);

}  // namespace axiometry::cli
