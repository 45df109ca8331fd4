// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/result.h"
#include "axiometry/store/records.h"
#include "server/http/http.h"

namespace axiometry::server {

/// Which tests the query asks to be listed, and in what order. Fails on values that are none, and on too many words.
Result<store::TestFilter> test_filter_of(const Request& request);

}  // namespace axiometry::server
