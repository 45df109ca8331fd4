// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json/json.h"
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

/// The same of a test that is read and prepared already.
Result<EvaluatedPeriodic> periodic_error_of(Test test, const iso230_2::PeriodicOptions& options);

/// A period as it is typed, in the unit of positions. Fails on text that is no number above 0.
Result<Position> parsed_period(std::string_view text);

/// Everything, as docs/results.md describes it.
json::Value to_json(const EvaluatedPeriodic& evaluated);

/// The same for a reader, with the report's sections under "document" (document_json.h).
json::Value to_json(const EvaluatedPeriodic& evaluated, const report::Options& options, bool dark);

/// Writes JSON and reports. Fails when an output is the input or cannot be written.
Result<void> write_outputs(const EvaluatedPeriodic& evaluated, const OutputNames& names,
                           const report::Options& options);

}  // namespace axiometry::app
