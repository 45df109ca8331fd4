// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/connection_pool.h"

#include <chrono>

namespace axiometry::store {

ConnectionPool::Lease::~Lease() {
  if (connection_) pool_->take_back(std::move(connection_));
}

Result<ConnectionPool::Lease> ConnectionPool::lease() {
  {
    std::unique_lock lock(mutex_);
    const bool free =
        returned_.wait_for(lock, std::chrono::seconds(10), [&] { return !idle_.empty() || open_ < largest_; });
    if (!free)
      return fail(ErrorKind::unavailable,
                  "found all connections to the store busy for ten seconds, expected one to become free");
    if (!idle_.empty()) {
      auto connection = std::move(idle_.back());
      idle_.pop_back();
      return Lease(*this, std::move(connection));
    }
    ++open_;
  }
  auto connection = place_->connect();
  if (!connection) {
    take_back(nullptr);
    return std::unexpected(std::move(connection).error());
  }
  return Lease(*this, *std::move(connection));
}

void ConnectionPool::forget_idle() {
  const std::lock_guard lock(mutex_);
  open_ -= idle_.size();
  idle_.clear();
  returned_.notify_all();
}

void ConnectionPool::take_back(std::unique_ptr<Connection> connection) {
  const std::lock_guard lock(mutex_);
  if (connection && connection->alive())
    idle_.push_back(std::move(connection));
  else
    --open_;
  returned_.notify_one();
}

}  // namespace axiometry::store
