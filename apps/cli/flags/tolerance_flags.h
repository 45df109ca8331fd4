// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/evaluate/requirements.h"

namespace axiometry::cli {

class Verb;

/// --tolerance, --tolerance-table and --rule. The table is opened later: `table` takes its name as it was given.
void add_tolerance_flags(const Verb& verb, app::ToleranceOptions& tolerance, std::string& table);

}  // namespace axiometry::cli
