// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/ranging_flag.h"

#include "axiometry/app/tracking/tracking_text.h"
#include "cli/flags/option_text.h"

namespace axiometry::cli {

Flag add_ranging(const Verb& verb, std::function<void(const RangingUncertainty&)> put) {
  return add_read(verb,
                  {"--ranging", "U",
                   "Expanded uncertainty (k = 2) of lengths, U = a + b L, or an instrument's name (0.2um+0.3um/m)"},
                  [put = std::move(put)](const std::string& text) -> Result<void> {
                    AXIOMETRY_TRY(const RangingUncertainty ranging, app::parse_ranging(text));
                    put(ranging);
                    return {};
                  });
}

}  // namespace axiometry::cli
