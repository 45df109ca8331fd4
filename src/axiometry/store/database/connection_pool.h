// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/place.h"

namespace axiometry::store {

/// Connections that many threads share: each is lent to one at a time. Who finds none waits for up to ten seconds. Once
/// a server did not answer, one thread at a time asks it for a new connection, and the others are told at once.
class ConnectionPool {
 public:
  ConnectionPool(std::unique_ptr<Place> place, std::size_t largest) : place_(std::move(place)), largest_(largest) {}

  /// Comes back to the pool when it goes out of scope, if it can still be used.
  class Lease {
   public:
    Lease(ConnectionPool& pool, std::unique_ptr<Connection> connection)
        : pool_(&pool), connection_(std::move(connection)) {}
    ~Lease();
    Lease(Lease&&) noexcept = default;
    Lease& operator=(Lease&&) = delete;
    Connection& operator*() const { return *connection_; }
    Connection* operator->() const { return connection_.get(); }

   private:
    ConnectionPool* pool_;
    std::unique_ptr<Connection> connection_;
  };

  Result<Lease> lease();
  /// Closes what is idle: after a connection was lost the others are, too.
  void forget_idle();
  const Place& place() const { return *place_; }

  /// How often the server was found silent: who waited for something else meanwhile need not ask it once more.
  std::size_t times_silent() const;
  /// Whether somebody is asking it again just now.
  bool is_asked() const;
  static std::unexpected<Error> fail_silent();

 private:
  Result<Lease> connected();
  void take_back(std::unique_ptr<Connection> connection);

  std::unique_ptr<Place> place_;
  std::size_t largest_;
  mutable std::mutex mutex_;
  std::condition_variable returned_;
  std::vector<std::unique_ptr<Connection>> idle_;
  std::size_t open_ = 0;
  std::size_t times_silent_ = 0;
  bool silent_ = false;  // whether it did not answer when it was asked last
  bool asked_ = false;   // whether somebody is asking it again
};

}  // namespace axiometry::store
