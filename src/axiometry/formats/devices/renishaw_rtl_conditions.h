// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/formats/text/text_lines.h"
#include "axiometry/model/test.h"

namespace axiometry::formats {

/// What stands beside the readings of a file in the layout of Renishaw's laser software.
struct RtlConditions {
  std::span<const TextLine> user_text;
  std::span<const TextLine> equipment;
  std::span<const TextLine> environment;
};

/// Puts machine, date, inspector, axis, equipment, air, material temperatures and expansion coefficient into the
/// metadata. Returns a remark for every value that has a place but could not be understood. Fails on more sensors or
/// components than read_budget::records.
Result<std::vector<SourceRemark>> add_conditions(Metadata& metadata, const RtlConditions& conditions);

}  // namespace axiometry::formats
