// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/report/report.h"
#include "cli/text/terminal.h"

namespace axiometry::cli {

enum class Detail {
  summary,  ///< the methods side by side and what contributes most
  full,     ///< the same and both intervals, every contribution, the inputs and the notes
};

/// The uncertainty by the methods that were run beyond Annex A, in lines of 80 columns, ending in an empty one; nothing
/// where there is none. Begins with the question that is answered.
std::string method_tables(const app::Evaluated& evaluated, const report::Options& options, const Terminal& terminal,
                          Detail detail);

/// What was stated about the uncertainty, what counts of it and where it comes from; nothing where nothing was stated.
std::string resolved_inputs_text(const app::Evaluated& evaluated, const report::Options& options,
                                 const Terminal& terminal);

}  // namespace axiometry::cli
