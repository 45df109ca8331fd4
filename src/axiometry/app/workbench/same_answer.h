// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/app/workbench/from_archive/from_archive.h"

/// Private to app/.
namespace axiometry::app {

/// Whether an evaluation takes the same from the archive: of the same things the same versions and values.
bool same(const FromArchive& a, const FromArchive& b);

}  // namespace axiometry::app
