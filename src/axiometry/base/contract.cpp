// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/contract.h"

#include <cstdio>
#include <cstdlib>

namespace axiometry {

void contract_broken(const char* condition, std::source_location where) {
  std::fprintf(stderr, "%s:%u: %s: contract broken: %s\n", where.file_name(), where.line(), where.function_name(),
               condition);
  std::abort();
}

}  // namespace axiometry
