// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "axiometry/capture/stop_lengths.h"

namespace axiometry::app {

class CaptureSession;

/// How a person calls the stops of a plan.
struct StopNames {
  std::function<std::string(std::size_t stop)> group;  ///< "line xy", "part 3"
  std::function<std::string(std::size_t stop)> name;   ///< name within it: "target 1↑ run 1", "point 17"
};

/// What a person must know of a recording of lengths, as sentences without full stop: stops without a length and why,
/// where the beam was broken though the plan does not expect it, rests that belong to no stop, and what is to be said
/// of single lengths.
std::vector<std::string> stop_notes(const capture::StopLengths& lengths, const StopNames& names);
/// These, then how many samples are lost, and what the session remarks itself.
std::vector<std::string> recording_notes(const CaptureSession& session, const capture::StopLengths& lengths,
                                         const StopNames& names);

}  // namespace axiometry::app
