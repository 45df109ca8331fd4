// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "server/http/http.h"
#include "server/limits.h"
#include "server/work/job.h"

/// HTTP/1.1 (RFC 9112) over TCP and TLS: one thread for all connections, some for the answers. Slow and idle clients
/// cost a few kilobytes, no thread.
namespace axiometry::server {

/// What answers.
struct Service {
  /// With the head, before any of the body is read; the request has everything but its body. A response is sent at once
  /// and nothing further is read of this request. On the I/O thread: must be quick.
  std::function<std::optional<Response>(const Request&)> refused;
  /// Whose share of the server it takes, of a request that was not refused; empty: all of an address have one. On the
  /// I/O thread: must be quick.
  std::function<std::string(const Request&)> peer_of{};
  /// In which queue a request waits to be read: heavy where that alone may take its time. On the I/O thread: must be
  /// quick, and so looks at the route and at the size of the body alone.
  std::function<Load(const Request&)> queue_of;
  /// Whether it may keep something: then its work is done to the end whoever leaves, and its answer told. On the I/O
  /// thread: must be quick; empty: none does.
  std::function<bool(const Request&)> keeps{};
  /// Bytes that its body may have, where that is less than any may. On the I/O thread: must be quick; may be empty.
  std::function<std::size_t(const Request&)> body_max{};
  /// Reads it, on one of several threads. Must not throw.
  std::function<Job(std::shared_ptr<Request>)> read;
  /// Of every response, also of those that the transport makes itself: headers that all carry.
  std::function<void(Response&)> finish;
  /// Told of every answer with a SecurityEvent, before it is held back; of a connection that found no room with the
  /// status 0 and a request that has a peer alone. On the I/O thread; may be empty.
  std::function<void(const Request&, const Response&)> secured{};
  /// Told of every answer; may be empty.
  struct Answered {
    const Request& request;
    int status = 0;
    std::size_t bytes = 0;
    double milliseconds = 0.0;
  };
  std::function<void(const Answered&)> answered{};
};

struct TransportOptions {
  std::string listen = "127.0.0.1";  ///< address of IPv4 or IPv6
  unsigned port = 0;                 ///< 0: a free one
  std::string certificate{};         ///< PEM files of TLS; both or none
  std::string key{};
  Limits limits{};
};

class Transport {
 public:
  /// Binds and listens; connections are answered once run() is called. Fails when the address is none, the port is in
  /// use, or certificate and key cannot be read or do not fit each other.
  static Result<std::unique_ptr<Transport>> listen(const TransportOptions& options);
  ~Transport();
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  unsigned port() const;

  struct End {
    int signal = 0;            ///< SIGINT or SIGTERM
    bool all_answered = true;  ///< false: requests were still being answered after Limits::shutdown
  };
  /// Answers until SIGINT or SIGTERM comes, then finishes the requests in flight. A second signal ends at once. `ready`
  /// is called when the first connection would be answered. Once only; `service` must live as long as this. Where not
  /// all was answered, the destructor would wait for the rest.
  End run(const Service& service, const std::function<void()>& ready);

 private:
  struct State;
  explicit Transport(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Whether an address is reached from this machine alone: 127.0.0.0/8 and ::1. Fails on what is no address.
Result<bool> is_loopback(const std::string& address);

}  // namespace axiometry::server
