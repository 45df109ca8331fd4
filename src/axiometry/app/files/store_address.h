// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/base/result.h"

namespace axiometry::app {

/// XDG_DATA_HOME or ~/.local/share (the XDG Base Directory Specification). Fails where not even a home is known.
Result<std::string> user_data_folder();

/// Where the archive is when the user does not say: the environment's AXIOMETRY_STORE, else axiometry/axiometry.db
/// among the user's data.
Result<std::string> default_store_address();

/// `asked`, or the default where it is empty.
Result<std::string> store_address(const std::string& asked);

}  // namespace axiometry::app
