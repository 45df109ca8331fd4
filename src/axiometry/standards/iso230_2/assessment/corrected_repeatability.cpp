// SPDX-License-Identifier: Apache-2.0
//
// Formula (A.10). U_EVE is expanded, its half the standard uncertainty that the readings' scatter contains.
#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/uncertainty/annex_a.h"

namespace axiometry::iso230_2 {

CorrectedRepeatability corrected_repeatability(const Evaluation& evaluation, Deviation U_eve) {
  const double u = U_eve.in_native() / 2.0;
  CorrectedRepeatability result;
  for (std::size_t i = 0; i < evaluation.positions.size(); ++i) {
    const PositionResult& measured = evaluation.positions[i];
    bool floored = false;
    const auto without_environment = [&](std::optional<Deviation> s) -> std::optional<Deviation> {
      if (!s) return std::nullopt;
      const double variance = s->in_native() * s->in_native() - u * u;
      floored = floored || variance < 0.0;
      return Deviation::native(std::sqrt(std::max(variance, 0.0)));
    };
    const auto s_up = without_environment(measured.s_up);
    const auto s_down = without_environment(measured.s_down);
    result.positions.push_back(with_estimators(measured, s_up, s_down));
    if (floored) result.floored.push_back(i);
  }
  const AxisParameters corrected = evaluate_axis(result.positions);
  result.parameters = evaluation.parameters;
  result.parameters.R = corrected.R;
  result.parameters.R_up = corrected.R_up;
  result.parameters.R_down = corrected.R_down;
  return result;
}

}  // namespace axiometry::iso230_2
