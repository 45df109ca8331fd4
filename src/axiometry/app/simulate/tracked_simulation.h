// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/simulate/tracked_machine_text.h"

/// The use case "measurements of a machine whose errors are known, with a tracking interferometer".
namespace axiometry::app {

struct TrackedSimulation {
  TrackedTruth truth;
  std::optional<Vector3> station_mm = {};        ///< true; that of the plan when absent
  std::vector<Vector3> location_points_mm = {};  ///< points of the reflector; chosen for the plan's set-up when empty
  std::vector<Vector3> stations_mm = {};         ///< stations of a multilateration; the machine's alone when empty
  std::array<std::size_t, 3> grid = {5, 5, 5};   ///< points of a multilateration, over the plan's travels
  std::uint64_t seed = 1;
  double rate = 100.0;  ///< rate of a continuous recording, samples a second
};

/// Empty names are not written; "-" is the standard output.
struct TrackedFiles {
  std::string plan;         ///< read: a tracking plan
  std::string points;       ///< CSV for `tracking locate`
  std::string lengths;      ///< CSV for `tracking evaluate`
  std::string recording{};  ///< what the instrument shows all the time along the lines: .csv, .txt or .npy
  std::string ranges;       ///< CSV for `tracking multilaterate`
  std::string truth;        ///< JSON
};

struct TrackedSummary {
  Vector3 station_mm;
  std::size_t points = 0;
  std::size_t lengths = 0;
  std::size_t lines = 0;
  std::size_t ranges = 0;
  std::size_t samples = 0;  ///< samples of the recording
  Duration duration;
};

/// Locates first, then walks the lines of the plan as it stands; both with one dead path unless the beam breaks. Writes
/// all files or none. Fails on no output, on a name given twice or that is the plan's, without a plan where one is
/// needed, and as the parts do.
Result<TrackedSummary> run_tracked_simulation(const TrackedSimulation& request, const TrackedFiles& files);

}  // namespace axiometry::app
