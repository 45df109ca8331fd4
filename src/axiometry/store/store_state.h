// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>

#include "axiometry/store/database/connection_pool.h"
#include "axiometry/store/store.h"

namespace axiometry::store {

/// Whose turn it is to write: who waits for another thread does not keep a connection from readers.
class WritingTurn {
 public:
  /// Whether it came within that time; then it is over with pass().
  bool wait_for(std::chrono::seconds longest) {
    std::unique_lock lock(mutex_);
    ++waiting_;
    const bool came = passed_.wait_for(lock, longest, [&] { return !taken_; });
    --waiting_;
    taken_ = taken_ || came;
    return came;
  }
  void pass() {
    const std::lock_guard lock(mutex_);
    taken_ = false;
    passed_.notify_one();
  }
  std::size_t waiting() const {
    const std::lock_guard lock(mutex_);
    return waiting_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable passed_;
  std::size_t waiting_ = 0;
  bool taken_ = false;
};

/// What a Store is made of, and how a call becomes one transaction.
struct Store::State {
  State(std::unique_ptr<Place> place, std::size_t connections)
      : pool(std::move(place), connections), info(pool.place().info()) {}

  ConnectionPool pool;
  Info info;
  WritingTurn turn;

  /// What `function(connection)` reads is of one moment. Once more where the connection turns out to be lost.
  template <typename Function>
  auto read(Function function) -> std::invoke_result_t<Function, Connection&> {
    bool lost = false;
    auto result = read_once(function, lost);
    if (lost) {
      pool.forget_idle();
      result = read_once(function, lost);
    }
    return result;
  }

  /// All that `function(connection)` writes, or nothing when it fails.
  template <typename Function>
  auto write(Function function) -> std::invoke_result_t<Function, Connection&> {
    if (!info.writable)
      return fail(ErrorKind::read_only,
                  fmt::format("found a store that can only be read ({}), expected to write", info.why_not));
    if (pool.is_asked()) return ConnectionPool::fail_silent();  // perhaps by whoever has the turn
    const std::size_t silent_before = pool.times_silent();
    if (!turn.wait_for(std::chrono::seconds(10)))
      return fail(ErrorKind::unavailable,
                  "found the store busy with another change for ten seconds, expected it to become free");
    const std::unique_ptr<WritingTurn, void (*)(WritingTurn*)> passing(&turn,
                                                                       [](WritingTurn* taken) { taken->pass(); });
    if (pool.times_silent() != silent_before) return ConnectionPool::fail_silent();
    AXIOMETRY_TRY(const ConnectionPool::Lease connection, begun());
    Rollback rollback(*connection);
    auto result = guarded(function, *connection);
    if (!result) return result;
    AXIOMETRY_TRY_VOID(connection->commit());
    rollback.release();
    return result;
  }

 private:
  template <typename Function>
  static auto guarded(Function& function, Connection& connection) -> std::invoke_result_t<Function, Connection&> {
    try {
      return function(connection);
    } catch (const DamagedCell&) {
      return fail(ErrorKind::damaged, "found a value of another type than was written, expected the store unchanged");
    }
  }

  template <typename Function>
  auto read_once(Function& function, bool& lost) -> std::invoke_result_t<Function, Connection&> {
    lost = false;
    AXIOMETRY_TRY(const ConnectionPool::Lease connection, pool.lease());
    if (const auto begun = connection->begin_read(); !begun) {
      lost = !connection->alive() && !connection->silent();
      return std::unexpected(begun.error());
    }
    const Rollback rollback(*connection);  // nothing was written: this ends it as well as commit() does
    auto result = guarded(function, *connection);
    lost = !result && !connection->alive() && !connection->silent();
    return result;
  }

  /// A connection that has begun to write; nothing is written yet, so it may be tried again where it was lost.
  Result<ConnectionPool::Lease> begun() {
    {
      AXIOMETRY_TRY(ConnectionPool::Lease connection, pool.lease());
      const auto begun = connection->begin_write();
      if (begun) return connection;
      if (connection->alive() || connection->silent()) return std::unexpected(begun.error());
    }
    pool.forget_idle();
    AXIOMETRY_TRY(ConnectionPool::Lease connection, pool.lease());
    AXIOMETRY_TRY_VOID(connection->begin_write());
    return connection;
  }
};

}  // namespace axiometry::store
