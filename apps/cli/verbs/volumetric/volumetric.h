// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/base/result.h"

namespace axiometry::cli {

class Verb;

/// The verbs of `axiometry volumetric`, a file for each.
void add_volumetric_identify(const Verb& volumetric, int& exit_code);
void add_volumetric_assemble(const Verb& volumetric, int& exit_code);
void add_volumetric_field(const Verb& volumetric, int& exit_code);
void add_volumetric_simulate(const Verb& volumetric, int& exit_code);
void add_volumetric_plan(const Verb& volumetric, int& exit_code);
void add_volumetric_predict(const Verb& volumetric, int& exit_code);
void add_volumetric_export(const Verb& volumetric, int& exit_code);
void add_volumetric_compensate(const Verb& volumetric, int& exit_code);

/// As failed(), naming --tool where none was given and the error asks for one.
int failed_for_tool(Error error, const std::string& tool);

}  // namespace axiometry::cli
