// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <source_location>

namespace axiometry {

/// Reports a broken contract (a fault of the program, never of its input) and ends the process.
[[noreturn]] void contract_broken(const char* condition, std::source_location where);

}  // namespace axiometry

/// Checks what must hold if the program is right. On in every build: a wrong micrometre is worse than a crash.
#define AXIOMETRY_CONTRACT(condition)                  \
  (static_cast<bool>(condition) ? static_cast<void>(0) \
                                : ::axiometry::contract_broken(#condition, std::source_location::current()))
