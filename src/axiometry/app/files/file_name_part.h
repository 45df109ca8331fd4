// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace axiometry::app {

/// The name of a test as part of the name of a file: '/' and control characters become '_', so that no file (of a test
/// that names itself "../x") is written where nobody asked for it.
std::string file_name_part(std::string name);

}  // namespace axiometry::app
