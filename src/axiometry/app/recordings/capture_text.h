// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/base/result.h"

/// What a recording does not say itself, as people say it: by flags of the command line, or by their names in a request
/// to the workbench.
namespace axiometry::app {

/// One flag. One row makes the flag of the command line and the option of a request.
struct CaptureOption {
  std::string_view name;    ///< "--rate"
  std::string_view values;  ///< "HZ"; empty for one that is on or off, with the texts "1" and "0"
  std::string_view help;

  /// Puts it into the options. Fails on a text that is not of the form of `values`.
  Result<void> (*apply)(const std::string& text, CaptureOptions& options);
};

/// In the order of the help. The plan is not among them.
std::span<const CaptureOption> capture_options();

/// Options by names without dashes, "rate". Fails, naming it, on one that there is not or whose text does not fit, and
/// on datum beside zero.
Result<CaptureOptions> capture_options_from(std::span<const std::pair<std::string, std::string>> texts);

}  // namespace axiometry::app
