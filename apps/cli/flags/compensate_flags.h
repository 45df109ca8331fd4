// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/compensate/compensate.h"
#include "cli/flags/verb.h"

namespace axiometry::cli {

/// What a table is for and how it is made, beside the readings: --for, its positions, its values.
void add_compensate_flags(const Verb& verb, app::CompensateRequest& request);

/// Throws where --for names no control that is known.
void check_control_named(const app::CompensateRequest& request);

/// What only a measured test has: a periodic part, and a table that was active.
void add_measured_flags(const Verb& verb, app::CompensateRequest& request);

}  // namespace axiometry::cli
