// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/result.h"

/// Private to this folder.
namespace axiometry::store {

/// What errno says of a file: "cannot make the store: Permission denied". A full disk is `full`, what may not be
/// written `read_only`, anything else `unavailable`.
Error system_error(const std::string& file, std::string_view doing);

}  // namespace axiometry::store
