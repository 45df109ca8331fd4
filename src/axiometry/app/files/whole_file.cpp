// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/whole_file.h"

#include <filesystem>
#include <system_error>

#include "axiometry/app/files/source.h"

namespace axiometry::app {

Error in_file(Error error, const std::string& file) {
  if (error.file.empty() || error.file == file) error.file = file == "-" ? "(standard input)" : file;
  return error;
}

Result<std::string> whole_file(const std::string& name) { return in_file(file_bytes(name), name); }

bool can_be_read_twice(const std::string& name) {
  std::error_code not_there;
  return name != "-" && std::filesystem::is_regular_file(name, not_there);
}

}  // namespace axiometry::app
