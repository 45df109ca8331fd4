// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/base/json.h"
#include "axiometry/model/named_finding.h"

namespace axiometry::app {

/// [{"id", "severity": "serious" or "note", "message"}], in order: docs/results.md, "findings".
json::Value findings_value(std::span<const NamedFinding> findings);

}  // namespace axiometry::app
