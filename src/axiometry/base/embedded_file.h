// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace axiometry {

/// A file that was built into the program (axiometry_embed() in cmake/AxiometryHelpers.cmake).
struct EmbeddedFile {
  std::string_view name;  ///< name without folders
  std::string_view bytes;
};

}  // namespace axiometry
