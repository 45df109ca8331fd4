// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/report/report.h"
#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"

/// The inputs of the uncertainty as resolved, in words for reports and the terminal.
namespace axiometry::report {

/// "Error range of the device"; of sensors and distributions with what they are of: "Temperature sensors (machine)".
std::string input_title(const iso230_2::ResolvedRow& row);

/// "1.751 mm", "a + b·L".
std::string input_value(const iso230_2::ResolvedRow& row, const Options& options);

/// "flag", "instrument LI-1 1234", "assumed".
std::string origin_text(const iso230_2::ResolvedRow& row);

/// "all methods", "GUM and Monte Carlo", "not used: …".
std::string use_text(const iso230_2::ResolvedRow& row);

}  // namespace axiometry::report
