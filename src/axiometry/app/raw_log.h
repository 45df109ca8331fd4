// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/raw_times.h"
#include "axiometry/base/result.h"

/// The bytes of a live stream as they came, and when. They are on their way to the disk before anything is done with
/// them, so that a recording can be played again after whatever happened, with the same result.
namespace axiometry::app {

/// A file of exactly the bytes that arrived, and beside it their times (raw_times.h).
class RawLog {
 public:
  /// Fails when the file exists: measured data are never overwritten.
  static Result<RawLog> create(const std::string& name);
  /// Goes on behind what the file holds. Times that are not sound are written anew from what is sound of them, and the
  /// file as it was is kept as RAW.times.old; only an unfinished end, and what points beyond the bytes, is cut off.
  /// Fails when the raw file does not exist.
  static Result<RawLog> resume(const std::string& name);
  ~RawLog();
  RawLog(RawLog&& other) noexcept;
  RawLog& operator=(RawLog&&) = delete;

  /// Arrival of what comes next: now, but never before the piece before.
  ArrivalNs stamp();
  /// The bytes first, then their time, both by write(2): a process that is killed in between leaves bytes whose arrival
  /// is not known, never a time that points beyond the bytes. Calls fdatasync(2), in this order too, when the last call
  /// was a second ago.
  Result<void> append(std::string_view bytes, ArrivalNs arrival);
  /// The next piece begins a new connection.
  void begin_connection() { connection_begins_ = true; }
  /// Onto the disk.
  Result<void> sync();
  std::uint64_t size() const { return size_; }  ///< bytes that are kept with their time

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
  std::optional<ArrivalNs> arrival;  ///< nothing where it is not known
  bool begins_connection = false;
  bool timed = true;  ///< whether the arrival of any piece is known
};

/// Plays a raw file piece by piece as it was received, all bytes that are there whatever became of their times, and
/// says what was missing. Fails when the bytes cannot be read, and as the sink does.
Result<std::vector<std::string>> play(const std::string& raw, const std::function<Result<void>(const RawPiece&)>& sink);

}  // namespace axiometry::app
