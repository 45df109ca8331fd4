// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace axiometry {

/// "1 station", "2 stations": a number with the word for its things, whose plural ends in "s" ("approaches": give the
/// whole plural).
inline std::string counted(std::size_t n, std::string_view one, std::string_view many = {}) {
  return std::to_string(n) + " " +
         (n == 1         ? std::string(one)
          : many.empty() ? std::string(one) + "s"
                         : std::string(many));
}

}  // namespace axiometry
