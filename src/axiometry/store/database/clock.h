// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/store/records.h"

namespace axiometry::store {

/// Now, RFC 3339 in UTC with milliseconds: "2026-11-22T09:30:00.123Z".
std::string now_text();

/// `by` at this moment.
Change change_now(const By& by);

}  // namespace axiometry::store
