// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2_tolerance.h"

#include <cmath>

#include "axiometry/base/contract.h"

namespace axiometry::iso230_2 {

std::vector<Judgement> judge(const AxisParameters& measured, std::span<const Tolerance> tolerances) {
  std::vector<Judgement> judgements;
  for (const Tolerance& tolerance : tolerances) {
    AXIOMETRY_CONTRACT(tolerance.parameter != nullptr);
    const std::optional<Deviation> value = measured.*(tolerance.parameter->member);
    Verdict verdict = Verdict::not_applicable;
    if (value) {
      const bool within = std::abs(value->in_native()) <= tolerance.limit.in_native();
      verdict = within ? Verdict::within : Verdict::exceeded;
    }
    judgements.push_back({tolerance, verdict});
  }
  return judgements;
}

}  // namespace axiometry::iso230_2
