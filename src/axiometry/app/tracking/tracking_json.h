// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/app/tracking/tracking_locate.h"
#include "axiometry/base/json.h"

/// Results of station locations as machines read them, and what results of tracking tests have in common;
/// docs/howto/find-the-station.md tells their members.
namespace axiometry::app {

json::Value to_json(const Located& located);
json::Value to_json(const PlannedLocation& planned);

/// [{"severity": "serious" or "note", "message": …}].
json::Value tracking_findings_to_json(std::span<const tracking::Finding> findings);

}  // namespace axiometry::app
