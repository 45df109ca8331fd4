// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/json/json.h"
#include "axiometry/volumetric/identify/identification.h"

namespace axiometry::app {

/// What a set-up tells, of a plan and of a result alike: docs/results.md, "rank".
json::Value to_json(const volumetric::VolumetricRank& rank);

}  // namespace axiometry::app
