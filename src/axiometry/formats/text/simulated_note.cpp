// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/simulated_note.h"

#include "axiometry/base/text/text.h"
#include "axiometry/model/simulated.h"

namespace axiometry::formats {

bool is_simulated_note(std::string_view comment) {
  return comment.starts_with('#') && text::trim(comment.substr(1)).starts_with(simulated_note);
}

}  // namespace axiometry::formats
