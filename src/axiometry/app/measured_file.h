// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"

/// A file of measured tests, read from bytes.
namespace axiometry::app {

struct MeasuredTest {
  std::string name;  ///< of one among many; else empty
  Test test;         ///< as it was measured
};

struct MeasuredFile {
  std::string sha256;
  std::size_t size = 0;
  std::string format;               ///< id
  std::vector<MeasuredTest> tests;  ///< never empty

  /// nullptr when there is none of that name.
  const Test* find(std::string_view name) const;
};

/// Whatever `axiometry evaluate` reads, recognised by its content and not by the name. Fails as the format does, with
/// the name and the place; on a recording, a plan or a file of lines in space, saying what to do with it; and on more
/// than 2000 tests.
Result<MeasuredFile> read_measured(std::string_view bytes, const std::string& name);

}  // namespace axiometry::app
