// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/text/number_text.h"
#include "axiometry/language/language.h"

namespace axiometry::app {

/// How a reader wants texts and numbers.
struct Reader {
  language::Language language = language::Language::english;
  NumberStyle numbers{};
};

}  // namespace axiometry::app
