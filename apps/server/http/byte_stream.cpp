// SPDX-License-Identifier: Apache-2.0
#include "server/http/byte_stream.h"

#include <openssl/ssl.h>

#include <boost/asio/ssl/host_name_verification.hpp>
#include <string>
#include <utility>
#include <vector>

namespace axiometry::server {

namespace asio = boost::asio;
namespace ssl = boost::asio::ssl;

void ByteStream::greet_client(Ended ended) { tls_->async_handshake(ssl::stream_base::server, std::move(ended)); }

void ByteStream::greet_server(const std::string& host, Ended ended) {
  tls_->set_verify_callback(ssl::host_name_verification(host));
  SSL_set_tlsext_host_name(tls_->native_handle(), host.c_str());
  tls_->async_handshake(ssl::stream_base::client, std::move(ended));
}

void ByteStream::say_goodbye(Ended ended) {
  if (!tls_) return ended({});
  tls_->async_shutdown(std::move(ended));
}

void ByteStream::read_some(std::vector<asio::mutable_buffer> buffers, Counted counted) {
  if (!tls_) return socket_.async_read_some(buffers, std::move(counted));
  tls_->async_read_some(buffers, std::move(counted));
}

void ByteStream::write_some(std::vector<asio::const_buffer> buffers, Counted counted) {
  if (!tls_) return socket_.async_write_some(buffers, std::move(counted));
  tls_->async_write_some(buffers, std::move(counted));
}

}  // namespace axiometry::server
