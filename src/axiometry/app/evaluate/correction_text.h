// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/standards/readings/reading_correction.h"

namespace axiometry::app {

/// "sign,air=ciddor,drift": adds the named corrections to the request. "air" alone is Ciddor's equation. Fails on an
/// empty or unknown name (the message names the nearest) and where the air is asked for by two equations.
Result<void> choose_corrections(std::string_view list, CorrectionRequest& request);

/// "ciddor" or "edlen". Fails on another word.
Result<AirEquation> parse_air_equation(std::string_view word);

}  // namespace axiometry::app
