// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/plan.h"
#include "axiometry/standards/iso230_2/plan/plan.h"

/// How a plan is asked for on the command line.
namespace axiometry::app {

/// "-300:450", mm or °. Fails on anything else; which end is the lower is the planner's business.
Result<iso230_2::Stretch> parse_stretch(std::string_view text);

/// "1000:3000", or "1000" for a stretch of 2 000 mm or 360° from there.
Result<iso230_2::Stretch> parse_area(std::string_view text, AxisKind kind);

/// "0, 12.5, 40" or "0:500:50" (from, to, every; its end is one of them where the steps lead there) or both mixed, in
/// any order. Fails on steps that are not positive and on more than 10 000 positions, of which no plan has
/// more.
Result<std::vector<double>> parse_positions(std::string_view text);

/// "1+ 2+ 2- 1+": numbers of targets, from 1, with the direction of the approach (+ is ↑); separated by blanks, commas
/// or line breaks. The k-th time that a target comes from a direction is its run k. A line may end in a comment (#).
Result<std::vector<Approach>> parse_sequence(std::string_view text);

}  // namespace axiometry::app
