// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/flags/verb.h"

#include "axiometry/app/evaluate/evaluate.h"

namespace axiometry::cli {

/// --uncertainty, --trials, --seed, --type-a, --coverage, --threads.
void add_method_flags(const Verb& verb, app::UncertaintyOptions& options);

/// The same without --threads, on which no result depends: what the archive keeps.
void add_kept_method_flags(const Verb& verb, app::UncertaintyOptions& options);

/// Refuses flags of the Monte Carlo method where that was not asked for; --threads too, unless it bounds other work.
void check_method_flags(const Verb& verb, const app::UncertaintyOptions& options, bool other_work_has_threads = false);

}  // namespace axiometry::cli
