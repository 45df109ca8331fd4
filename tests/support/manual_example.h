// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace axiometry::testing_support {

/// The first fenced block of a format's manual.
inline std::string manual_example(std::string_view manual) {
  const std::size_t fence = manual.find("```");
  const std::size_t begin = manual.find('\n', fence) + 1;
  return std::string(manual.substr(begin, manual.find("```", begin) - begin));
}

}  // namespace axiometry::testing_support
