// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/app/live/sources/played_source.h"
#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/base/result.h"

/// The simulator as a source of readings of a straightness or a rotation, so that a capture of them can be tried
/// without instrument and machine.
namespace axiometry::app {

/// What happens to the readings. The axis has a bow, a slope and another value on its way back.
struct MotionPreset {
  std::string_view id;     ///< "good"
  std::string_view title;  ///< what happens
  std::string_view sign;   ///< how it shows
};
std::span<const MotionPreset> motion_presets();  ///< `good` first

inline constexpr double usual_motion_size = 5.0, largest_motion_size = 1000.0;  ///< µm or µrad

struct SimulatedMotionCapture {
  std::string preset = "good";
  double size = usual_motion_size;  ///< size of the bow, above 0 up to largest_motion_size
  std::uint64_t seed = 1;
  SimulatedPace pace = {};
};

/// Says in the options what the simulator sends: text of time, reading and the trigger or the position, which stands in
/// the second column beside the time. Fails on options that say otherwise. Needs options.motion.
Result<void> hear_simulated_motion(CaptureOptions& options);

struct SimulatedMotion {
  Connect connect;
  /// What axis and capture tell each other between the pieces that are read, in the same thread: with keys the axis
  /// stands at the stop that is due until that has its reading or is left without one.
  std::function<void(CaptureSession&)> beside;
};

/// Of the session's plan, error, unit and way of telling the stops. With keys the axis waits; otherwise the stream ends
/// with the plan. Fails on an unknown preset, and as MotionWalk::make() does. Needs session.motion().
Result<SimulatedMotion> simulated_motion_source(const SimulatedMotionCapture& capture, const CaptureSession& session);

/// What a table of such readings states of itself: "Simulated, not measured: …; seed 7".
std::string simulated_motion_note(const SimulatedMotionCapture& capture, const MotionName& error);

}  // namespace axiometry::app
