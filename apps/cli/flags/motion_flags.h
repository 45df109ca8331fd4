// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/error_motions/motion_choices.h"
#include "cli/flags/verb.h"

/// How straightness, angles and squareness are evaluated: the flags of these verbs, which those of the same names below
/// `store` have too.
namespace axiometry::cli {

/// Names of files: of readings, and of --plan.
struct MotionFiles {
  std::vector<std::string> readings;
  std::vector<std::string> plans;
};

/// The files and all flags that `kind` has a use for ("straightness", "angles", "squareness").
void add_motion_flags(const Verb& verb, std::string_view kind, MotionFiles& files, app::MotionChoices& choices);

/// Those of --plan, read; none where that was not given.
Result<std::vector<Plan>> plans_of_motion(const std::vector<std::string>& files);

/// Throws UsageError on flags that do not fit the number of files, and on the standard input twice.
void check_motion_flags(std::string_view kind, const MotionFiles& files, const app::MotionChoices& choices);

/// The files read and evaluated.
Result<app::EvaluatedMotion> evaluated_motion(std::string_view kind, const std::vector<std::string>& files,
                                              const app::MotionChoices& choices);

}  // namespace axiometry::cli
