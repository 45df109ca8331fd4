// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// What the verbs of `axiometry tracking` ask alike about the uncertainty of lengths.
namespace axiometry::cli {

/// --ranging: U = a + b·L of the instrument.
CLI::Option* add_ranging(CLI::App& verb, std::function<void(const RangingUncertainty&)> put);

/// A standard uncertainty with its unit, "0.5um"; 0 or more.
Result<Length> sigma_of(const std::string& text);

}  // namespace axiometry::cli
