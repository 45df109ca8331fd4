// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/app/workbench/from_archive/from_archive.h"
#include "axiometry/base/json/json.h"
#include "axiometry/standards/iso230_2/finding.h"
#include "axiometry/store/records.h"

/// Limits of an axis, which a version keeps as they were on its day, beside those that the axis has by now.
namespace axiometry::app {

/// A note of what has changed since, "A 12 → 5 µm"; nothing where the limits are still the same, or none were taken.
std::optional<iso230_2::Finding> changed_limits(const FromArchive& taken, const std::optional<store::AxisRecord>& now);

/// The result that a version keeps, with that note among its findings.
json::Value with_finding(json::Value result, const std::optional<iso230_2::Finding>& finding);

}  // namespace axiometry::app
