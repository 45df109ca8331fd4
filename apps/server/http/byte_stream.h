// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/system/error_code.hpp>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace axiometry::server {

/// Bytes to and from a peer over TCP, in the clear or within TLS. One type for both and for every handler, so that what
/// reads and writes HTTP is compiled once. An AsyncStream of Boost.Beast; used on one thread.
class ByteStream {
 public:
  using Socket = boost::asio::ip::tcp::socket;
  using executor_type = Socket::executor_type;
  using ErrorCode = boost::system::error_code;
  using Counted = std::move_only_function<void(ErrorCode, std::size_t)>;
  using Ended = std::move_only_function<void(ErrorCode)>;

  /// Within TLS, once its handshake is done, where there is a context of it.
  ByteStream(Socket socket, boost::asio::ssl::context* context) : socket_(std::move(socket)) {
    if (context) tls_.emplace(socket_, *context);
  }
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;

  executor_type get_executor() { return socket_.get_executor(); }
  Socket& socket() { return socket_; }
  bool is_tls() const { return tls_.has_value(); }

  /// As the server that was called. Of TLS alone.
  void greet_client(Ended ended);
  /// As the client, who expects a certificate for that host. Of TLS alone.
  void greet_server(const std::string& host, Ended ended);
  /// Says that nothing more is sent, as TLS wants it said; in the clear it has ended at once.
  void say_goodbye(Ended ended);

  template <typename Buffers, typename Handler>
  void async_read_some(const Buffers& buffers, Handler&& handler) {
    read_some({boost::asio::buffer_sequence_begin(buffers), boost::asio::buffer_sequence_end(buffers)},
              std::forward<Handler>(handler));
  }

  template <typename Buffers, typename Handler>
  void async_write_some(const Buffers& buffers, Handler&& handler) {
    write_some({boost::asio::buffer_sequence_begin(buffers), boost::asio::buffer_sequence_end(buffers)},
               std::forward<Handler>(handler));
  }

 private:
  void read_some(std::vector<boost::asio::mutable_buffer> buffers, Counted counted);
  void write_some(std::vector<boost::asio::const_buffer> buffers, Counted counted);

  Socket socket_;
  std::optional<boost::asio::ssl::stream<Socket&>> tls_;
};

}  // namespace axiometry::server
