// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "axiometry/report/report.h"

namespace axiometry::report {

/// What the uncertainty of record assumes, in three sentences for the page with the results: what it is an uncertainty
/// of and in which sense, what the environmental variation counts as and what was held possible before the readings,
/// and what is done about the bias of extremes. Empty where no uncertainty is stated.
std::vector<std::string> interval_assumptions(const Subject& subject, const Options& options);

}  // namespace axiometry::report
