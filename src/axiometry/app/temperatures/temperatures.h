// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/temperatures/temperature_log.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/environment/environment.h"

/// The use case "from a temperature log to what clauses 4.1 and 7 ask of the surroundings of a test".
namespace axiometry::app {

struct TemperatureRequest {
  std::string began;  ///< moment of the first reading of the test; empty: not told
  std::string ended;
  formats::SensorRoles roles;
  iso230_2::AgreedEnvironment agreed;
};

struct EvaluatedTemperatures {
  std::string file;  ///< as the user gave it
  std::string sha256;
  std::string began;  ///< as asked
  std::string ended;
  TemperatureLog log;
  std::optional<TimeStretch> test;  ///< within the log; absent: all of it counts as the test
  iso230_2::TestEnvironment environment;
};

/// "-" is the standard input. Fails as read_temperature_log() does, with the file's name; on a moment that is none, an
/// end without a beginning or before it, on a beginning for a log without dates, where only one of two moments tells
/// its time zone, on a log that has nothing of the test or of the twelve hours before it, and on an agreed lowest
/// temperature above the highest.
Result<EvaluatedTemperatures> evaluate_temperatures(const std::string& file, const TemperatureRequest& request);

/// Everything, as docs/results.md describes it.
json::Value to_json(const EvaluatedTemperatures& evaluated);

/// Writes JSON and reports. Fails when an output is the input or cannot be written.
Result<void> write_outputs(const EvaluatedTemperatures& evaluated, const OutputNames& names,
                           const report::Options& options);

}  // namespace axiometry::app
