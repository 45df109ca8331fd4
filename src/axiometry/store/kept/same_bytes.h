// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/records.h"

/// One measurement that was kept more than once: the same bytes of a file, under whatever names it came.
namespace axiometry::store {

/// Of an axis, tests that are not withdrawn and stand at the same place in a file of the same bytes: by the one that
/// counts, which is the one with the most versions, of equals the first that came, the others.
Result<std::map<Id, std::vector<Id>>> repeated_tests(Connection& connection, Id axis);

}  // namespace axiometry::store
