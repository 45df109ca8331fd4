// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include "cli/flags/verb.h"

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// What the verbs of `axiometry tracking` ask alike about the uncertainty of lengths.
namespace axiometry::cli {

/// --ranging: U = a + b·L of the instrument.
Flag add_ranging(const Verb& verb, std::function<void(const RangingUncertainty&)> put);

}  // namespace axiometry::cli
