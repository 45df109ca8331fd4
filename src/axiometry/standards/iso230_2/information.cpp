// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/information.h"

namespace axiometry::iso230_2 {

std::optional<SmallerRepeatability> smaller_repeatability(const Metadata& metadata, const AxisParameters& parameters) {
  const auto &up = parameters.R_up, &down = parameters.R_down;
  if (metadata.conditions.smaller_repeatability != true || !up || !down) return std::nullopt;
  const bool down_is_smaller = down->in_native() < up->in_native();
  return SmallerRepeatability{down_is_smaller ? *down : *up, find_parameter(down_is_smaller ? "R_down" : "R_up")};
}

}  // namespace axiometry::iso230_2
