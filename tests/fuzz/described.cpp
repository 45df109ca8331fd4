// SPDX-License-Identifier: Apache-2.0
#include "described.h"

#include "axiometry/base/text/text.h"

namespace axiometry::fuzzing {

void check_error(const Error& error) {
  AXIOMETRY_CONTRACT(!error.message.empty());
  AXIOMETRY_CONTRACT(!text::invalid_utf8(error.message));
  AXIOMETRY_CONTRACT(error.message.find('\n') == std::string::npos);
  AXIOMETRY_CONTRACT(error.at.column == 0 || error.at.line > 0);
}

}  // namespace axiometry::fuzzing
