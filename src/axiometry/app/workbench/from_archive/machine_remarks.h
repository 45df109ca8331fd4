// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/store/records.h"
#include "axiometry/store/transaction.h"

/// What is to be told of the machines that tests state, before the archive takes them in.
namespace axiometry::app {

/// For each test of a file, but of each machine once: that it takes over the serial number that the test states, that
/// it has a number and the test states none, or that several are called so and nothing tells them apart.
Result<std::vector<std::vector<std::string>>> machine_remarks(const store::Transaction& archive,
                                                              std::span<const store::NewTest> tests);

}  // namespace axiometry::app
