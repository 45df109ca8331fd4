// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/base/text/text.h"

/// Private to app/: a text of the command line that says something else than it should.
namespace axiometry::app {

inline std::unexpected<Error> unexpected_text(std::string_view found, std::string_view expected) {
  return fail(fmt::format("found {}, expected {}", text::quoted(found), expected));
}

}  // namespace axiometry::app
