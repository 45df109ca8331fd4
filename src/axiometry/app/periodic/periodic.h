// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json.h"
#include "axiometry/standards/iso230_2/periodic/periodic.h"

/// The use case "from a measured file to its periodic error" (Annex C).
namespace axiometry::app {

struct EvaluatedPeriodic {
  Test test;
  iso230_2::PeriodicError result;
};

/// Reads the only test of a file, prepares it as evaluate_test() does (metadata, artefact, expansion) and finds its
/// periodic error. Errors carry the file's name.
Result<EvaluatedPeriodic> evaluate_periodic(const std::string& file, const EvaluateOptions& reading,
                                            const iso230_2::PeriodicOptions& options);

/// Everything, as docs/results.md describes it.
json::Value to_json(const EvaluatedPeriodic& evaluated);

/// Writes JSON and reports. Fails when an output is the input or cannot be written.
Result<void> write_outputs(const EvaluatedPeriodic& evaluated, const OutputNames& names,
                           const report::Options& options);

}  // namespace axiometry::app
