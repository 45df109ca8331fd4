// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>

/// How a client begins to speak TLS (RFC 8446, 4.1.2 and 5.1): what comes before a server must compute.
namespace axiometry::server {

/// Of a ClientHello: those of browsers have at most 2 KiB, with the keys of new methods.
inline constexpr std::size_t client_hello_bytes_max = std::size_t{16} << 10;

/// How many bytes must have come before one can tell more, given the first: no more than these where the message is
/// there whole, in however many records. Nothing where it is none, or a longer one.
std::optional<std::size_t> client_hello_wanted(std::string_view come);

/// Calls then, with whether a ClientHello has come whole, of which nothing is read. What it holds must hold the socket,
/// and close it where this takes too long.
void await_client_hello(boost::asio::ip::tcp::socket& socket, std::function<void(bool)> then);

}  // namespace axiometry::server
