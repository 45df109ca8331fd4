// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace axiometry::app {

/// What a recording gave where a capture becomes a table and no test.
struct FoundTable {
  std::string table;  ///< as `tracking evaluate`, `volumetric identify` or `straightness` reads it, notes above it
  std::size_t found = 0;
  std::size_t planned = 0;
  std::vector<std::string> notes;  ///< sentences: what could not be matched or used, where the beam was broken, …
};

}  // namespace axiometry::app
