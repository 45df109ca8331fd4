// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/capture/stop_matcher.h"

namespace axiometry::capture {

/// The stops of a matcher as they are seen from stations that its matches tell better: of each station least squares of
/// the changes of length from match to match, robust (Huber, 0.2 mm), so that a jump is one outlier and no more; with
/// what is known of s before (`station_error_mm` taken as two standard uncertainties) and 0.1 mm for what machine and
/// instrument add to a length. Each stop then has the covariance of its station. Stations with less than eight matches
/// stay as they are. Derivation: docs/theory/capture-lengths.md.
std::vector<ExpectedStop> refined_stops(const StopMatcher& matcher);

}  // namespace axiometry::capture
