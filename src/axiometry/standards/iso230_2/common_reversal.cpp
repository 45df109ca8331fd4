// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/common_reversal.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace axiometry::iso230_2 {
namespace {

/// The approaches from above moved by a distance: x̄_i, B_i and R_i follow, s_i do not change.
PositionResult with_shift_down(PositionResult position, double shift) {
  if (!position.mean_down) return position;
  const double down = position.mean_down->in_native() + shift;
  position.mean_down = Deviation::native(down);
  if (!position.mean_up) return position;
  const double up = position.mean_up->in_native();
  position.mean = Deviation::native((up + down) / 2.0);
  position.reversal = Deviation::native(up - down);
  return with_estimators(position, position.s_up, position.s_down);
}

}  // namespace

Deviation reversal_remainder(std::span<const PositionResult> positions, Deviation common) {
  double largest = 0.0;
  for (const PositionResult& position : positions) {
    if (!position.mean_up || !position.mean_down) continue;
    const double down = position.mean_down->in_native() + common.in_native();  // as with_shift_down() has it
    largest = std::max(largest, std::abs(position.mean_up->in_native() - down));
  }
  return Deviation::native(largest);
}

std::optional<CommonReversal> common_reversal(std::span<const PositionResult> positions) {
  const std::optional<Deviation> common = evaluate_axis(positions).B_mean;
  if (!common) return std::nullopt;
  std::vector<PositionResult> shifted;
  shifted.reserve(positions.size());
  for (const PositionResult& position : positions) shifted.push_back(with_shift_down(position, common->in_native()));
  const AxisParameters without = evaluate_axis(shifted);
  return CommonReversal{*without.B, without};
}

}  // namespace axiometry::iso230_2
