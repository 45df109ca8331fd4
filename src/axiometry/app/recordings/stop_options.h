// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/app/recordings/capture_text.h"
#include "axiometry/base/result.h"

/// What a person says of readings that do not show where the axis stops: by flags of the command line, or by their
/// names in a request to the workbench.
namespace axiometry::app {

/// In the order of the help: --stops, and what says nothing without it. Each puts into options.motion.
std::span<const CaptureOption> stop_options();
inline constexpr std::string_view stops_option = "--stops", equipment_option = "--equipment";

/// "keys", "trigger", "readings", "position", as --stops has them.
std::string_view stop_sign_word(capture::StopSign sign);
std::optional<capture::StopSign> stop_sign(std::string_view word);

/// As capture_options_from(), with these among the names; options.motion is absent without "stops". Fails also on one
/// of them that needs "stops", and on a part beside it.
Result<CaptureOptions> live_options_from(std::span<const std::pair<std::string, std::string>> texts);

}  // namespace axiometry::app
