// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/system_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace axiometry::store {

Error system_error(const std::string& file, std::string_view doing) {
  const int code = errno;
  const ErrorKind kind = code == EROFS || code == EACCES || code == EPERM ? ErrorKind::read_only
                         : code == ENOSPC || code == EDQUOT               ? ErrorKind::full
                                                                          : ErrorKind::unavailable;
  return {fmt::format("cannot {}: {}", doing, std::strerror(code)), file, {}, kind};
}

}  // namespace axiometry::store
