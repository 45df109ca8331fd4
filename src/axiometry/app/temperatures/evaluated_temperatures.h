// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/temperatures/temperature_log.h"
#include "axiometry/standards/environment/environment.h"

/// From a temperature log to what clauses 4.1 and 7 ask of the surroundings of a test: the one judgement, whether the
/// log is looked at alone or with its test.
namespace axiometry::app {

struct TemperatureRequest {
  std::string began{};  ///< moment of the first reading of the test; empty: not told
  std::string ended{};
  formats::SensorRoles roles{};
  iso230_2::AgreedEnvironment agreed{};

  /// Whether nobody says anything that only a log makes sense of.
  bool about_log_empty() const;
};

using EvaluatedTemperatures = iso230_2::LoggedEnvironment;

/// "-" is the standard input. Fails as read_temperature_log() does, with the file's name; on a moment that is none, an
/// end without a beginning or before it, on a beginning for a log without dates, where only one of two moments tells
/// its time zone, on a log that has nothing of the test or of the twelve hours before it, and on an agreed lowest
/// temperature above the highest.
Result<EvaluatedTemperatures> evaluate_temperatures(const std::string& file, const TemperatureRequest& request);

/// The same of bytes; errors have no file's name.
Result<EvaluatedTemperatures> evaluate_temperatures(std::string_view bytes, const std::string& name,
                                                    const TemperatureRequest& request);

/// What is asked for beside a test, and what the test states where that says nothing.
iso230_2::AgreedEnvironment agreed_of(iso230_2::AgreedEnvironment asked, const iso230_2::AgreedEnvironment& stated);

/// A log that goes with a test.
struct LogWithTest {
  std::string file;                    ///< its name; opened where there are no bytes
  std::optional<std::string> bytes{};  ///< as the archive keeps them
  TemperatureRequest request{};
};

/// The request with the end of a test whose beginning is told and its end is not: that of its readings, where they have
/// times (`duration`).
TemperatureRequest with_end_of_readings(TemperatureRequest request, const std::optional<Duration>& duration);

/// As evaluate_temperatures(), of a test that lasted `duration` where its readings have times: LoggedEnvironment keeps
/// the end that they tell apart from what was asked. What was agreed and the request does not say is as the test
/// states.
Result<EvaluatedTemperatures> evaluate_log_with_test(const LogWithTest& log, const std::optional<Duration>& duration,
                                                     const iso230_2::AgreedEnvironment& stated = {});

}  // namespace axiometry::app
