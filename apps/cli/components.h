// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "axiometry/base/embedded_file.h"

namespace axiometry::cli {

/// What others wrote and the program holds or needs (licenses/components.json).
struct Component {
  std::string_view name;
  std::string_view version;  ///< version that the build has found
  std::string_view license;  ///< SPDX
  std::string_view use;      ///< "compiled in", "bundled in the page", "shared"
  std::string_view text;     ///< file among license_files(); empty where nothing of it is in the program
};

std::span<const Component> components();        ///< generated
std::span<const EmbeddedFile> license_files();  ///< generated

}  // namespace axiometry::cli
