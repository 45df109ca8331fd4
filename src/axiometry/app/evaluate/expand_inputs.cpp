// SPDX-License-Identifier: Apache-2.0

// Files and folders that a user names, as the files that are in them.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "axiometry/app/evaluate/evaluate.h"

namespace axiometry::app {

Result<std::vector<InputFile>> expand_inputs(const std::vector<std::string>& names) {
  namespace fs = std::filesystem;
  std::vector<InputFile> inputs;
  for (const std::string& name : names) {
    std::error_code error;
    if (name == "-" || !fs::is_directory(name, error)) {
      inputs.push_back({name, false});
      continue;
    }
    std::vector<InputFile> found;
    for (fs::recursive_directory_iterator it(name, error), end; !error && it != end; it.increment(error)) {
      const bool hidden = it->path().filename().string().starts_with('.');
      std::error_code dangling;  // a link to nowhere or to itself is no file
      if (hidden && it->is_directory(dangling)) it.disable_recursion_pending();
      if (!hidden && it->is_regular_file(dangling)) found.push_back({it->path().string(), true});
    }
    if (error) return std::unexpected(Error{fmt::format("cannot read: {}", error.message()), name, {}});
    std::ranges::sort(found, {}, &InputFile::name);
    inputs.insert(inputs.end(), found.begin(), found.end());
  }
  return inputs;
}

}  // namespace axiometry::app
