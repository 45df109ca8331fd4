// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "axiometry/base/result.h"

/// Where live streams come from: TCP servers and serial ports.
namespace axiometry::app {

/// "tcp://host:port" or "serial:///dev/ttyACM0?baud=2000000", "…?baud=3000000&ask=hpi-3d", or "simulator://?seed=7", to
/// which nothing can be connected: simulated_motion.h.
struct LiveAddress {
  enum class Kind { tcp, serial, simulator } kind = Kind::tcp;
  std::string host;  ///< host, or the device of a serial port, or what stands behind "simulator://?"
  std::string port;  ///< port of TCP, a number
  unsigned baud = 115'200;
  std::string request{};  ///< bytes that make an instrument at a serial port begin; empty: nothing is sent to it
};

/// Nothing when the name is that of a file. Fails on "tcp://" and "serial://" without all that they need, on a baud
/// rate that is not 50 to 20 000 000, and on an instrument to ask that is not known. What the simulator is told is not
/// looked at.
Result<std::optional<LiveAddress>> parse_live(const std::string& name);

/// Bytes as they come.
class LiveStream {
 public:
  enum class State {
    data,
    idle,
    closed,  ///< the other side may come back
    over,    ///< there is no more
  };
  struct Got {
    State state = State::idle;
    std::size_t count = 0;
    std::string reason{};  ///< reason of the end: "connection reset by peer"
  };

  LiveStream() = default;
  virtual ~LiveStream() = default;
  LiveStream(const LiveStream&) = delete;
  LiveStream& operator=(const LiveStream&) = delete;

  /// Waits for bytes at most that long; a signal ends the wait.
  virtual Got read(std::span<char> buffer, std::chrono::milliseconds longest) = 0;
};

/// Begins a stream, or goes on with it after it was closed.
using Connect = std::function<Result<std::unique_ptr<LiveStream>>()>;

/// To a TCP server or a serial port, where the request is sent, and again after five seconds without a byte. Fails with
/// the system's reason, for TCP after at most five seconds for each address that the host's name stands for.
Result<std::unique_ptr<LiveStream>> connect_to(const LiveAddress& address);

/// Opens a serial port: raw bytes, 8 data bits, no parity, one stop bit, no flow control, any baud rate that the driver
/// can do. The descriptor, or the system's reason.
Result<int> open_serial(const std::string& device, unsigned baud);

}  // namespace axiometry::app
