// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/curve_nodes.h"

namespace axiometry::volumetric {

std::vector<CurveNode> curve_nodes(const ErrorModel& model, ErrorMotion error, std::size_t count) {
  const double from = model.observed().lowest_mm[error.axis], to = model.observed().highest_mm[error.axis];
  std::vector<CurveNode> nodes;
  for (std::size_t k = 0; k < count; ++k) {
    const double position =
        k + 1 == count ? to : from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
    const auto mean = model.motion(error, position);
    if (!mean) return {};
    CurveNode node{position, *mean};
    if (model.coefficients().reversal() != Reversal::none) {
      node.up = model.motion(error, position, 1.0);
      node.down = model.motion(error, position, -1.0);
    }
    nodes.push_back(node);
  }
  return nodes;
}

}  // namespace axiometry::volumetric
