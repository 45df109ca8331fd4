// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/model/plan.h"

namespace axiometry::nc {

/// Consecutive moves that are driven `times` times over. Read one after another, stretches are the moves of the plan.
struct RepeatedMoves {
  std::size_t times = 1;
  std::vector<PlannedMove> moves;  ///< moves of the first time; later times have other runs, nothing else
  std::size_t last_run = 0;        ///< index of the run of the last reading of the last time
};

/// moves(plan) with what repeats folded into stretches of several times: runs of the standard and the unidirectional
/// cycle and warm-up runs whole; of the step and pilgrim cycles the runs at a target, but mostly not the last of them,
/// which ends elsewhere; of a user-defined cycle what happens to repeat likewise. The first move, from wherever the
/// axis stands, is a stretch of its own. At most `loop_limit` stretches have more than one time; 0 folds nothing. Needs
/// a sound plan.
std::vector<RepeatedMoves> walk(const Plan& plan, std::size_t loop_limit);

}  // namespace axiometry::nc
