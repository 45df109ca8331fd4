// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/flags/verb.h"

namespace axiometry::cli {

/// 'store compensate', 'store compensations' and 'store compensation'.
void add_store_compensations(const Verb& store, int& exit_code);

}  // namespace axiometry::cli
