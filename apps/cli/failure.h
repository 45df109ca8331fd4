// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/result.h"
#include "cli/exit_code.h"

namespace axiometry::cli {

/// Says on the standard error what is wrong, without what a terminal would obey; returns `code`.
int failed(const Error& error, ExitCode code = exit_bad_input);

}  // namespace axiometry::cli
