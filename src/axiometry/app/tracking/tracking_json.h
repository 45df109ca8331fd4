// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/tracking/tracking_locate.h"
#include "axiometry/base/json/json.h"

/// Results of station locations as machines read them; docs/howto/find-the-station.md tells their members.
namespace axiometry::app {

json::Value to_json(const Located& located);
json::Value to_json(const PlannedLocation& planned);

}  // namespace axiometry::app
