// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/temperatures/evaluated_temperatures.h"
#include "cli/flags/verb.h"

namespace axiometry::cli {

/// --began, --ended, --sensor, and what the parties agreed on, its flags behind a prefix: "agreed-" makes
/// --agreed-lowest.
void add_temperature_flags(const Verb& verb, app::TemperatureRequest& request, const std::string& prefix,
                           const std::string& group);

}  // namespace axiometry::cli
