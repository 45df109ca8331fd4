// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/model/named_finding.h"

namespace axiometry::app {

/// [{"id", "severity": "serious" or "note", "message"}], in order: docs/results.md, "findings".
json::Value findings_value(std::span<const NamedFinding> findings);

/// "serious" or "note".
std::string_view severity_word(const NamedFinding& finding);

/// A finding as a result that was kept tells it.
struct KeptFinding {
  std::string id;
  std::string severity;  ///< "serious" or "note"
  std::string message;
};
/// Of the member `name`; what is of another kind is left out.
std::vector<KeptFinding> kept_findings(const json::Value& result, std::string_view name = "findings");

}  // namespace axiometry::app
