// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/context.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <unordered_set>
#include <utility>

#include "server/http/fair_queue.h"
#include "server/http/transport.h"
#include "server/limits.h"
#include "server/work/dispatcher.h"
#include "server/work/eviction.h"

/// One client's connection: request after request, each with its deadlines (limits.h). Private to the transport.
namespace axiometry::server {

/// What the transport may ask of any connection.
class Guest {
 public:
  virtual ~Guest() = default;
  /// The server is to end: closes now when no request is in flight or its answer is only held back, else after it.
  virtual void hang_up() = 0;
  /// Closes at once: another needs its place or its memory.
  virtual void make_room() = 0;
  virtual ConnectionState state() const = 0;
};

/// What all connections share; used on the I/O thread alone.
struct ConnectionShare {
  ConnectionShare(const Limits& all, const Service& answers, Dispatcher& all_ask, boost::asio::io_context& io)
      : limits(all),
        service(answers),
        dispatcher(all_ask),
        fair_queue([&io](FairQueue::Step step) { boost::asio::post(io, std::move(step)); }) {}

  const Limits& limits;
  const Service& service;
  Dispatcher& dispatcher;
  FairQueue fair_queue;  ///< lets handshakes of TLS begin, which compute
  bool ending = false;
  std::unordered_set<Guest*> connections;  ///< connections that are open
  std::function<void()> when_none;         ///< called when the last connection has gone

  /// Whether a new connection of that peer can come in, for which another may have to go.
  bool make_room(const std::string& peer);
  /// Whether this connection can hold so many bytes more of what it receives, else of an answer, for which another may
  /// have to go; nobody does where that would not be enough.
  bool make_memory(const Guest& guest, std::size_t bytes);
  /// What can be held until this connection has read it: the response, or 503, or of what was kept a receipt.
  std::shared_ptr<const Response> as_fits(const Guest& guest, std::shared_ptr<const Response> response,
                                          const Request& request);
  void tell_of_answer(const Request& request, const Response& response, std::chrono::nanoseconds took) const;
  void tell_of_event(const Request& request, const Response& response) const;  ///< if it has any
};

/// Whom its address stands for (peer.h); empty where it has gone already.
std::string peer_of(const boost::asio::ip::tcp::socket& socket);

/// Serves the client until it goes or is sent away; within TLS where there is a context of it.
void serve(boost::asio::ip::tcp::socket socket, boost::asio::ssl::context* context, std::string peer,
           ConnectionShare& share);

}  // namespace axiometry::server
