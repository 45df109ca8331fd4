// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "axiometry/app/temperatures/evaluated_temperatures.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/finding.h"

/// Whether a log of temperatures and a test tell of the same hours.
namespace axiometry::app {

/// Temperatures of another day than that of the test are not those about it. The date is that of a clock at the place,
/// which a moment with a zone may be half a day and more away from. A date that names no day is a note. Nothing where
/// nobody says when the test began.
std::optional<iso230_2::Finding> other_day(const Test& test, const EvaluatedTemperatures& found);

/// Temperatures that were stated and that the log tells otherwise: one of both is not of this test, and what was
/// computed from those stated is not of it either. The air is one; of machine and equipment only the temperatures of
/// one place, by its name, are compared.
std::vector<iso230_2::Finding> contradicted_temperatures(const Test& test, const EvaluatedTemperatures& found);

}  // namespace axiometry::app
