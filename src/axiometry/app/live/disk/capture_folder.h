// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/live/disk/capture_order.h"
#include "axiometry/base/result.h"
#include "axiometry/store/records.h"

/// Where captures keep what arrives until the store has it: for each an order (capture-7.json), the raw recording,
/// its times and what was said at its stops. What a program that was killed has left behind can be gone on with.
namespace axiometry::app {

/// An order with its files; while it exists, no other program takes them.
class HeldCapture {
 public:
  HeldCapture(HeldCapture&& other) noexcept;
  HeldCapture& operator=(HeldCapture&&) = delete;
  ~HeldCapture();

  store::Id id() const { return id_; }
  const CaptureOrder& order() const { return order_; }
  std::string raw() const;  ///< name of the raw recording; its times: times_name()

  /// SHA-256 of each test that it was about to become: any of them may be in the store, or still come there.
  const std::vector<std::string>& noted_tests() const { return noted_tests_; }
  /// On the disk before the store gets the test, so that one capture never becomes two.
  Result<void> note_test(const std::string& sha256);
  /// The store has all of it: that is noted, and its files go.
  void remove();

  /// The same of a table, which is found by its order: that stays, with what it came to. Fails as the disk does;
  /// then all files are there.
  Result<void> end(const TableEnd& end);
  const std::optional<TableEnd>& ended() const { return ended_; }

 private:
  friend class CaptureFolder;
  HeldCapture(std::string base, store::Id id, CaptureOrder order, int descriptor)
      : base_(std::move(base)), id_(id), order_(std::move(order)), descriptor_(descriptor) {}

  std::string base_;  ///< path without extension
  store::Id id_;
  CaptureOrder order_;
  int descriptor_;  ///< descriptor of the order, locked
  std::vector<std::string> noted_tests_{};
  std::optional<TableEnd> ended_{};
  bool kept_ = false;  ///< the store has all of it
};

class CaptureFolder {
 public:
  /// It is made, for nobody else to read, when the first capture needs it.
  explicit CaptureFolder(std::string path) : path_(std::move(path)) {}

  /// On the disk when it returns. Numbers are never used again, also not those of captures that are gone.
  /// Fails with the system's reason, of the kinds full, read_only and unavailable.
  Result<HeldCapture> add(CaptureOrder order);
  /// Fails with not_found, and with conflict where another program is at it.
  Result<HeldCapture> take(store::Id id);

  struct Left {
    store::Id id = 0;
    CaptureOrder order;
  };
  /// Whom nobody holds, the oldest first. Those that are in the store already, and those of which nothing came, are
  /// cleared away.
  std::vector<Left> left_behind();
  struct Ended {
    store::Id id = 0;
    EndedCapture capture;
  };
  /// Captures that became tables, the oldest first.
  std::vector<Ended> ended() const;
  /// One of those; nothing where it is none.
  std::optional<Ended> ended(store::Id id) const;
  /// Takes those whose order is not here, ended or not, which an archive brought along from elsewhere. Fails as add()
  /// does, after all that can be taken.
  Result<void> adopt(std::span<const EndedCapture> captures);
  /// Forgets one of those; the store keeps what it came to. Fails with not_found, and with conflict as take() does.
  /// `note` is told of it before, and nothing is forgotten where that fails.
  Result<void> discard(store::Id id, const std::function<Result<void>(const EndedCapture&)>& note = {});

  /// Recordings whose orders cannot be read: nobody can go on with them or keep them here, but a plan can play them.
  std::vector<std::string> without_order() const;

 private:
  Result<void> make() const;
  Result<void> count(store::Id id) const;
  Result<HeldCapture> hold(store::Id id) const;
  std::vector<store::Id> ids() const;
  std::string base(store::Id id) const;

  std::string path_;
};

}  // namespace axiometry::app
