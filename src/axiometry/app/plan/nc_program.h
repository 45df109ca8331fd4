// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/model/tracking.h"
#include "axiometry/nc/dialect.h"
#include "axiometry/volumetric/plan/calibration_plan.h"

/// From the file of a plan, or of a measurement with a tracking interferometer, to the part program that walks it.
namespace axiometry::app {

struct NcRequest {
  std::string plan = {};     ///< file, "-" for the standard input
  std::string dialect = {};  ///< id of the dialect
  /// 1 is the plan itself, 2 and more its further ones; of a volumetric plan its runs.
  std::size_t part = 1;
  std::string line = {};  ///< id of one line of a tracking plan; empty: all of them in one program
  nc::ProgramOptions options = {};
};

/// Fails, naming those there are, when no dialect has that id.
Result<const nc::Dialect*> dialect_of(std::string_view id);

/// The text of the program. Fails on an unknown dialect, a plan that cannot be read (formats/plan/plan_json.h,
/// tracking_plan_json.h), a part or a line that it does not have, a tracking plan that has no line, and as the dialect
/// does.
Result<std::string> nc_program(const NcRequest& request);

/// The same of a plan that is at hand; request.plan says nothing.
Result<std::string> nc_program_of(const Plan& plan, const NcRequest& request);

/// The same of a tracking plan: all lines in one program, or request.line alone.
Result<std::string> nc_program_of(const TrackingPlan& plan, const NcRequest& request);

/// The same of one run of a volumetric plan: request.part.
Result<std::string> nc_program_of(const volumetric::CalibrationPlan& plan, const NcRequest& request);

/// Options from texts, by the names of the members of nc::ProgramOptions but `duration` and `title`: unit=inch,
/// trigger_m_code=27, …; what is on or off is "1" or "0" ("" is on). Fails, naming it, on an option that there is not
/// and on a text that does not fit.
Result<nc::ProgramOptions> nc_options(std::span<const std::pair<std::string, std::string>> texts);

/// As a file, or for "-" the standard output. Fails also when it cannot be written, or would take the plan's place.
Result<void> write_nc_program(const NcRequest& request, const std::string& output);

}  // namespace axiometry::app
