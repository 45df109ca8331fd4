// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/app/live/sources/live_source.h"
#include "axiometry/model/plan.h"
#include "axiometry/model/test.h"

/// What the workbench may listen to. Sources are named when the server is started; no request ever names a host or a
/// device.
namespace axiometry::app {

struct CaptureSource {
  std::string id;  ///< "laser"
  enum class Kind { simulator, tcp, serial } kind = Kind::simulator;
  std::string title;    ///< name that people read
  LiveAddress address;  ///< address of tcp and serial
};

std::string_view kind_name(CaptureSource::Kind kind);  ///< "simulator", "tcp", "serial"

/// There always, so that a capture can be tried without a machine.
CaptureSource simulator_source();

/// "NAME=tcp://host:port" or "NAME=serial:///dev/ttyACM0?baud=2000000". Fails on a name that is not 1 to 40 letters,
/// digits, '-', '_' or '.', on "simulator", and as parse_live() does.
Result<CaptureSource> parse_capture_source(std::string_view text);

/// How the simulator plays a plan.
struct SimulatedCapture {
  Plan plan;
  std::string preset = "good";  ///< simulation::presets()
  std::uint64_t seed = 1;
  double speed = 1.0;      ///< seconds of the machine in a second
  std::uint64_t skip = 0;  ///< bytes that have been heard already: the same run goes on behind them
};

/// Speeds that can be asked for.
std::span<const double> simulation_speeds();

/// The first call begins the stream, which ends with the plan. Fails on an unknown preset, and when called, as
/// simulation::record() does.
Result<Connect> simulated_source(const SimulatedCapture& capture);

/// States in the test that it is no measurement.
void mark_simulated(Test& test, const SimulatedCapture& capture);

}  // namespace axiometry::app
