// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"

/// The bytes of a live stream as they came, and when. They are on their way to the disk before anything is done with
/// them, so that a recording can be played again after whatever happened, with the same result.
namespace axiometry::app {

/// Nanoseconds since 1970-01-01 00:00 UTC.
using ArrivalNs = std::int64_t;

/// A file of exactly the bytes that arrived, and beside it FILE.times: 16 bytes "AXIOMETRYTIMES1\n", then for every
/// piece its offset in the file (64 bits, little-endian; the highest bit is set where a new connection begins) and its
/// arrival (64 bits, little-endian, nanoseconds since 1970). A piece ends where the next one begins.
class RawLog {
 public:
  /// Fails when the file exists: measured data are never overwritten.
  static Result<RawLog> create(const std::string& name);
  /// Goes on behind what the file holds. Fails when it or its times do not exist.
  static Result<RawLog> resume(const std::string& name);
  ~RawLog();
  RawLog(RawLog&& other) noexcept;
  RawLog& operator=(RawLog&&) = delete;

  /// Arrival of what comes next: now, but never before the piece before.
  ArrivalNs stamp();
  /// The time first, then the bytes, both by write(2): a process that is killed in between leaves a time without bytes,
  /// never bytes without a time. Calls fdatasync(2) when the last call was a second ago.
  Result<void> append(std::string_view bytes, ArrivalNs arrival);
  /// The next piece begins a new connection.
  void begin_connection() { connection_begins_ = true; }
  /// Onto the disk.
  Result<void> sync();

 private:
  RawLog(std::string name, int bytes, int times) : name_(std::move(name)), bytes_(bytes), times_(times) {}
  Result<void> put(int descriptor, std::string_view bytes) const;

  std::string name_;
  int bytes_ = -1;
  int times_ = -1;
  std::uint64_t size_ = 0;
  ArrivalNs last_ = 0;
  bool connection_begins_ = false;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

/// One piece of a raw file.
struct RawPiece {
  std::string_view bytes;
  ArrivalNs arrival = 0;
  bool begins_connection = false;
};

std::string times_name(const std::string& raw);

/// Whether the times of a raw file lie beside it.
bool has_times(const std::string& raw);

/// Plays a raw file piece by piece as it was received. Fails on times that are none, that run backwards or that begin
/// behind the bytes.
Result<void> play(const std::string& raw, const std::function<Result<void>(const RawPiece&)>& sink);

}  // namespace axiometry::app
