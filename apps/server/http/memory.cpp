// SPDX-License-Identifier: Apache-2.0
#include "server/http/memory.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace axiometry::server {

void give_back_memory() {
#ifdef __GLIBC__
  static_cast<void>(::malloc_trim(0));
#endif
}

}  // namespace axiometry::server
