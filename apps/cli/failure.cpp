// SPDX-License-Identifier: Apache-2.0
#include "cli/failure.h"

#include <fmt/format.h>

#include <cstdio>

#include "axiometry/report/drawing/utf8.h"

namespace axiometry::cli {

int failed(const Error& error, ExitCode code) {
  fmt::print(stderr, "axiometry: {}\n", report::printable(error.to_string()));
  return code;
}

}  // namespace axiometry::cli
