// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/model/plan.h"
#include "axiometry/standards/iso230_2/finding.h"

/// What the tests that belong to another one must be for the two to be a test after clause 5.3. Private to plan/.
namespace axiometry::iso230_2 {

/// Whether among the further tests of the plan there is the one that its clause asks for beside it: over the whole of a
/// long travel the one with five approaches over 2 000 mm or 360°, and the other way round. Sound plans.
bool has_additional_test(const Plan& plan);

/// A further test of another axis than the test that it belongs to.
std::optional<Finding> of_another_axis(const Plan& whole, const Plan& part);

/// The part with the axis of the whole, of which alone the travel need be told.
Plan on_the_same_axis(const Plan& whole, Plan part);

}  // namespace axiometry::iso230_2
