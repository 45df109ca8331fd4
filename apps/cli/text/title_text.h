// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/model/axis.h"
#include "axiometry/report/report.h"

namespace axiometry::cli {

/// "Axis X of Mill 5", in the reader's language; the names are the user's.
std::string title_text(const Axis& axis, const std::string& machine, const report::Options& options);

}  // namespace axiometry::cli
