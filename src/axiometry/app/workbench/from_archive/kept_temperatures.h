// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/temperatures/evaluated_temperatures.h"
#include "axiometry/app/workbench/test_options.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"

/// A log of temperatures among the options of a test's evaluation: KeptTemperatures of apps/server/openapi.json.
namespace axiometry::app {

json::Value to_json(const KeptTemperatures& kept);

/// Fails, with line and column, on an unknown member, a value of another kind, a hash that is none, an unknown role, a
/// limit outside −60 … 100 °C or 0 … 100 °C/h and °C, and on texts as given_line() does.
Result<KeptTemperatures> kept_temperatures_from(const json::Value& value);

/// What evaluate_test() is asked for; the bytes are those of the archive.
LogWithTest log_with_test(const KeptTemperatures& kept, std::string bytes);

}  // namespace axiometry::app
