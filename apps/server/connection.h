// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <functional>
#include <unordered_set>

#include "limits.h"
#include "transport.h"
#include "worker_pool.h"

/// One client's connection: request after request, each with its deadlines (limits.h). Private to the transport.
namespace axiometry::server {

/// What the transport may ask of any connection.
class Hangable {
 public:
  virtual ~Hangable() = default;
  /// The server is to end: closes now when no request is in flight, else after its answer.
  virtual void hang_up() = 0;
};

/// What all connections share; used on the I/O thread alone.
struct ConnectionShare {
  ConnectionShare(const Limits& all, const Service& answers, WorkerPool& for_light, WorkerPool& for_heavy)
      : limits(all), service(answers), light(for_light), heavy(for_heavy) {}

  const Limits& limits;
  const Service& service;
  WorkerPool& light;
  WorkerPool& heavy;
  std::size_t bodies_bytes = 0;  ///< of all requests that are read or answered now
  bool ending = false;
  std::unordered_set<Hangable*> connections;
  std::function<void()> when_none;  ///< called when the last connection has gone
};

void serve_plain(boost::asio::ip::tcp::socket socket, ConnectionShare& share);
void serve_tls(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context& context, ConnectionShare& share);

}  // namespace axiometry::server
