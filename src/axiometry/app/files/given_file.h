// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace axiometry::app {

/// Bytes that are at hand, under the name by which messages and reports call them.
struct GivenFile {
  std::string name;
  std::string_view bytes;
};

}  // namespace axiometry::app
