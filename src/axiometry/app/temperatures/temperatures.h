// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/results/outputs.h"
#include "axiometry/app/temperatures/evaluated_temperatures.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/report/report.h"

/// The use case "a temperature log by itself".
namespace axiometry::app {

/// Everything, as docs/results.md describes it.
json::Value to_json(const EvaluatedTemperatures& evaluated);

/// Of it what stands in the result of a test.
json::Value environment_to_json(const EvaluatedTemperatures& evaluated);

/// The same of a test without a log: what only a log tells is null or empty.
json::Value environment_to_json(const iso230_2::TestEnvironment& stated);

/// Writes JSON and reports. Fails when an output is the input or cannot be written.
Result<void> write_outputs(const EvaluatedTemperatures& evaluated, const OutputNames& names,
                           const report::Options& options);

}  // namespace axiometry::app
