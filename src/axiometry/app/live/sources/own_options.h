// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/live/sources/capture_source.h"
#include "axiometry/app/live/sources/simulated_motion.h"
#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"

namespace axiometry::app {

/// Options of a capture that are none of its recording.
struct OwnOptions {
  double speed = 1.0;
  std::string preset = "good";
  std::optional<std::uint64_t> seed;
  std::optional<double> size{};  ///< µm or µrad, of an error of motion
  Duration give_up = Duration::s(60);
  std::vector<std::pair<std::string, std::string>> others{};  ///< options of its recording: capture_options_from()
};

/// By the names of flags; empty texts are fields that were left empty. Fails, naming it, on one of the simulator with
/// another source, and on a text that does not fit.
Result<OwnOptions> own_options(const std::vector<std::pair<std::string, std::string>>& options,
                               CaptureSource::Kind kind);

/// Of an error of motion, as these options want it.
SimulatedMotionCapture simulated_motion_of(const OwnOptions& own, const SimulatedPace& pace);

/// In place of a seed that is there.
void put_seed(std::vector<std::pair<std::string, std::string>>& options, std::uint64_t seed);

}  // namespace axiometry::app
