// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "axiometry/base/result.h"

/// Small files that are read at once.
namespace axiometry::app {

/// The error with the name of its file, "(standard input)" for "-"; one that names another file keeps that.
Error in_file(Error error, const std::string& file);

/// The same result, so that an error of what is inside a file names it.
template <typename T>
Result<T> in_file(Result<T> result, const std::string& file) {
  if (!result) return std::unexpected(in_file(std::move(result).error(), file));
  return result;
}

/// All bytes of a file, or for "-" of the standard input. Fails, with its name, when it cannot be read and beyond
/// 64 MiB.
Result<std::string> whole_file(const std::string& name);

/// Whether it is a file: not the standard input, nor a pipe, which are empty after the first time.
bool can_be_read_twice(const std::string& name);

}  // namespace axiometry::app
