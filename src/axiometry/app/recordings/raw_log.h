// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/recordings/raw_times.h"
#include "axiometry/base/result.h"

/// The bytes of a live stream as they came, and when. They are on their way to the disk before anything is done with
/// them, so that a recording can be played again after whatever happened, with the same result.
namespace axiometry::app {

/// A file of exactly the bytes that arrived, and beside it their times (raw_times.h).
class RawLog {
 public:
  /// Fails when the file exists: measured data are never overwritten. Of one that cannot be begun nothing stays.
  static Result<RawLog> create(const std::string& name);
  /// Goes on behind what the file holds. Times that are not sound are written anew from what is sound of them, and the
  /// file as it was is kept as RAW.times.old, .old2 and so on; only an unfinished end, and what points beyond the
  /// bytes, is cut off. Fails when the raw file does not exist.
  static Result<RawLog> resume(const std::string& name);
  ~RawLog();
  RawLog(RawLog&& other) noexcept;
  RawLog& operator=(RawLog&&) = delete;

  /// Arrival of what comes next: now, but never before the piece before.
  ArrivalNs stamp();
  /// The bytes first, then their time, both by write(2): a process that is killed in between leaves bytes whose arrival
  /// is not known, never a time that points beyond the bytes. Without an arrival it stays unknown, as of a pipe whose
  /// readings do not depend on it. Calls sync_when_due().
  Result<void> append(std::string_view bytes, std::optional<ArrivalNs> arrival);
  /// The next piece begins a new connection. That stands in the times before it comes, so that a reading which the
  /// break has cut off stays as it was told whatever becomes of that piece.
  Result<void> begin_connection();
  /// Onto the disk.
  Result<void> sync();
  /// Likewise where the last call was a second ago and something has come since: for a source that falls silent.
  Result<void> sync_when_due();
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
  bool is_synced_ = false;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

/// While it lives no other program writes to that recording, or plays it to go on with it.
class RawHold {
 public:
  /// Fails on what is no regular file, where somebody else holds it, and where nobody can say whether somebody does.
  static Result<RawHold> take(const std::string& raw);
  ~RawHold();
  RawHold(RawHold&& other) noexcept;
  RawHold& operator=(RawHold&&) = delete;

 private:
  explicit RawHold(int descriptor) : descriptor_(descriptor) {}
  int descriptor_;
};

/// Onto the disk with all that is there of it: a program that was killed may have written what is not there yet. Fails
/// when it cannot be read.
Result<void> sync_raw(const std::string& raw);

/// A raw file and all that lies beside it for it.
void remove_raw(const std::string& raw);

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
