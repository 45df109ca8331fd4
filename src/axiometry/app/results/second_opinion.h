// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/base/result.h"
#include "axiometry/report/report.h"

namespace axiometry::app {

/// Computes all that is said about a test once more by the second, independent way (verification/verify.h): its JSON
/// as it is written and read again, its report and its line in a table of many tests. Fails where a figure or a verdict
/// differs, naming what was printed and what is right; the result must then not be issued. `written`: the JSON that
/// goes out, where it was kept; empty: it is written anew.
Result<report::VerifiedFigures> second_opinion(const Evaluated& evaluated, const UncertaintyOptions& asked,
                                               const report::Options& options, std::string written = {});

}  // namespace axiometry::app
