// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace axiometry::testing_support {

/// The bytes of a file of this repository; `path` from its root. A test that asks for a file that is not there fails.
inline std::string repository_file(const std::string& path) {
  std::ifstream stream(std::filesystem::path(AXIOMETRY_SOURCE_DIR) / path, std::ios::binary);
  EXPECT_TRUE(stream) << path;
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace axiometry::testing_support
