// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/report/document.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

/// How reports of what was withdrawn say so, wherever their results stand.
namespace axiometry::app {

inline constexpr std::string_view withdrawn_label = "withdrawn, not to be used";

/// With the label, behind one that is there.
std::string labelled_withdrawn(std::string label);
iso230_2::Assessment labelled_withdrawn(iso230_2::Assessment assessment);
report::Document labelled_withdrawn(report::Document document);

}  // namespace axiometry::app
