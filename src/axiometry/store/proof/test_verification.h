// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/proof/attested.h"

/// Private to this folder: the part of verify() that reads tests and the lists of them.
namespace axiometry::store {

struct VerifiedTests {
  std::int64_t tests = 0;
  std::int64_t without_format = 0;  ///< tests of whose format the trail tells nothing: received before it did
};

/// All tests in all versions against what the trail attests, and the lists against the latest versions.
Result<VerifiedTests> verify_tests(Connection& connection, const Attested& attested,
                                   std::vector<std::string>& problems);

}  // namespace axiometry::store
