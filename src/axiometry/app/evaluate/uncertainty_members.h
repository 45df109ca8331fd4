// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/text/json_members.h"

/// The methods of uncertainty as a request says them, and the archive keeps them.
namespace axiometry::app {

inline constexpr double trials_max_workbench = 1e7;  ///< a minute or so; the command line takes more

/// "methods": a list of gum, monte-carlo and annex-a; "trials": a number, or null until two digits are stable; "seed":
/// a number, or text above 2⁵³; "coverage". What is absent stays as it is. Each fails, with line and column, on what is
/// of another kind, on an unknown method, on trials outside 100 to 10 million and on a coverage outside 0.5 to 0.9999.
Result<void> take_uncertainty(formats::JsonMembers& members, UncertaintyOptions& options);

}  // namespace axiometry::app
