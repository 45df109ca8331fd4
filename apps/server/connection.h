// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <cstddef>
#include <functional>
#include <string>
#include <unordered_set>

#include "desk.h"
#include "limits.h"
#include "standing.h"
#include "transport.h"

/// One client's connection: request after request, each with its deadlines (limits.h). Private to the transport.
namespace axiometry::server {

/// What the transport may ask of any connection.
class Guest {
 public:
  virtual ~Guest() = default;
  /// The server is to end: closes now when no request is in flight, else after its answer.
  virtual void hang_up() = 0;
  /// Closes at once: another needs its place or its memory.
  virtual void give_way() = 0;
  virtual Standing standing() const = 0;
};

/// What all connections share; used on the I/O thread alone.
struct ConnectionShare {
  ConnectionShare(const Limits& all, const Service& answers, Desk& all_ask)
      : limits(all), service(answers), desk(all_ask) {}

  const Limits& limits;
  const Service& service;
  Desk& desk;
  bool ending = false;
  std::unordered_set<Guest*> connections;  ///< that are open
  std::function<void()> when_none;         ///< called when the last connection has gone

  /// Whether a new connection of that peer can come in, for which another may have to go.
  bool make_room(const std::string& peer);
  /// Whether this connection can hold so many bytes more, for which another may have to go.
  bool make_memory(const Guest& guest, std::size_t bytes);
};

/// The address; empty where it has gone already.
std::string peer_of(const boost::asio::ip::tcp::socket& socket);

void serve_plain(boost::asio::ip::tcp::socket socket, std::string peer, ConnectionShare& share);
void serve_tls(boost::asio::ip::tcp::socket socket, std::string peer, boost::asio::ssl::context& context,
               ConnectionShare& share);

}  // namespace axiometry::server
