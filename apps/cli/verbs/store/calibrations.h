// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/flags/verb.h"

namespace axiometry::cli {

/// The verbs below `store` for lines and the 21 errors that are kept.
void add_store_calibrations(const Verb& store, int& exit_code);
void add_store_calibrate(const Verb& store, int& exit_code);  ///< the one that keeps
void add_store_motions(const Verb& store, int& exit_code);    ///< those that keep straightness, angles, squareness

}  // namespace axiometry::cli
