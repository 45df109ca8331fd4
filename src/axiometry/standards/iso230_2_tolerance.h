// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/standards/iso230_2_assessment.h"

namespace axiometry::iso230_2 {

/// A limit for one parameter, in its deviation unit.
struct Tolerance {
  const ParameterInfo* parameter = nullptr;
  Deviation limit;
};

enum class Verdict {
  within,  ///< |value| ≤ limit (simple acceptance: the uncertainty is not taken into account)
  exceeded,
  not_applicable,  ///< the parameter does not exist (6.2): no verdict
};

struct Judgement {
  Tolerance tolerance;
  Verdict verdict = Verdict::not_applicable;
};

/// Compares each limit with the magnitude of its parameter (B̄ is signed).
std::vector<Judgement> judge(const AxisParameters& measured, std::span<const Tolerance> tolerances);

}  // namespace axiometry::iso230_2
