// SPDX-License-Identifier: Apache-2.0
#include "failure.h"

#include <fmt/format.h>

#include <cstdio>

#include "axiometry/report/utf8.h"

namespace axiometry::cli {

int failed(const Error& error, ExitCode code) {
  fmt::print(stderr, "axiometry: {}\n", report::printable(error.to_string()));
  return code;
}

}  // namespace axiometry::cli
