// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/connection_pool.h"

#include <chrono>

namespace axiometry::store {
namespace {

/// Who has waited for so long for a connection that did not come spares the others that.
constexpr std::chrono::milliseconds long_wait{500};

}  // namespace

ConnectionPool::Lease::~Lease() {
  if (connection_) pool_->take_back(std::move(connection_));
}

Result<ConnectionPool::Lease> ConnectionPool::lease() {
  {
    std::unique_lock lock(mutex_);
    const bool free = returned_.wait_for(lock, std::chrono::seconds(10),
                                         [&] { return silent_ || !idle_.empty() || open_ < largest_; });
    if (!free)
      return fail(ErrorKind::unavailable,
                  "found all connections to the store busy for ten seconds, expected one to become free");
    if (silent_ && asked_) return fail_silent();
    asked_ = silent_;
    if (!idle_.empty()) {
      auto connection = std::move(idle_.back());
      idle_.pop_back();
      if (!silent_) return Lease(*this, std::move(connection));
    } else {
      ++open_;
    }
  }
  return connected();
}

Result<ConnectionPool::Lease> ConnectionPool::connected() {
  const auto begun = std::chrono::steady_clock::now();
  auto connection = place_->connect();
  const bool in_vain = !connection && std::chrono::steady_clock::now() - begun > long_wait;
  {
    const std::lock_guard lock(mutex_);
    silent_ = in_vain;
    times_silent_ += in_vain ? 1 : 0;
    asked_ = false;
  }
  if (!connection) {
    take_back(nullptr);
    return std::unexpected(std::move(connection).error());
  }
  return Lease(*this, *std::move(connection));
}

std::size_t ConnectionPool::times_silent() const {
  const std::lock_guard lock(mutex_);
  return times_silent_;
}

bool ConnectionPool::is_asked() const {
  const std::lock_guard lock(mutex_);
  return silent_ && asked_;
}

std::unexpected<Error> ConnectionPool::fail_silent() {
  return fail(ErrorKind::unavailable, "found the store's server silent, expected an answer: it is being asked again");
}

void ConnectionPool::forget_idle() {
  const std::lock_guard lock(mutex_);
  open_ -= idle_.size();
  idle_.clear();
  returned_.notify_all();
}

void ConnectionPool::take_back(std::unique_ptr<Connection> connection) {
  const std::lock_guard lock(mutex_);
  if (connection && connection->silent()) {
    silent_ = true;
    ++times_silent_;
    returned_.notify_all();
  }
  if (connection && connection->alive())
    idle_.push_back(std::move(connection));
  else
    --open_;
  returned_.notify_one();
}

}  // namespace axiometry::store
