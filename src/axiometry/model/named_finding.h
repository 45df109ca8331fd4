// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace axiometry {

/// What the user should know of a result, with the numbers, by a name that programs can rely on.
struct NamedFinding {
  std::string id;        ///< stable: "compensation-outlier"
  bool serious = false;  ///< the result should not be used as it is
  std::string message;   ///< a sentence without full stop
};

}  // namespace axiometry
