// SPDX-License-Identifier: Apache-2.0
#include "server/http/client_hello.h"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "server/http/disconnect.h"

namespace axiometry::server {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr auto pause_of_greetings = std::chrono::milliseconds(20);
constexpr std::size_t record_head = 5;  // content type, version, length
constexpr std::size_t hello_head = 4;   // type of handshake, length
constexpr unsigned char handshake_record = 22;
constexpr unsigned char client_hello = 1;

std::size_t number_of(std::string_view bytes) {
  std::size_t number = 0;
  for (const char byte : bytes) number = number << 8 | static_cast<unsigned char>(byte);
  return number;
}

/// What is there, without taking it away or waiting for more.
std::string_view peeked(tcp::socket& socket, std::array<char, client_hello_bytes_max>& into) {
  const auto count = ::recv(socket.native_handle(), into.data(), into.size(), MSG_PEEK | MSG_DONTWAIT);
  return {into.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
}

void await_more(tcp::socket& socket, std::function<void(bool)> then) {
  const auto pause = std::make_shared<asio::steady_timer>(socket.get_executor(), pause_of_greetings);
  pause->async_wait([&socket, then = std::move(then), pause](error_code) mutable {
    if (!socket.is_open()) return then(false);
    await_client_hello(socket, std::move(then));
  });
}

}  // namespace

std::optional<std::size_t> client_hello_wanted(std::string_view come) {
  std::string hello;  // head of the handshake message
  std::size_t records = 0;
  std::size_t payload = 0;
  while (true) {
    const std::string_view record = come.substr(records);
    if (!record.empty() && static_cast<unsigned char>(record[0]) != handshake_record) return {};
    if (record.size() < record_head) return records + record_head;
    const std::size_t length = number_of(record.substr(3, 2));
    const std::size_t end = records + record_head + length;
    if (length == 0 || end > client_hello_bytes_max) return {};
    if (come.size() < end) return end;
    hello += record.substr(record_head, std::min(length, hello_head - hello.size()));
    payload += length;
    records = end;
    if (hello.size() < hello_head) continue;
    if (static_cast<unsigned char>(hello[0]) != client_hello) return {};
    if (payload >= hello_head + number_of(std::string_view(hello).substr(1))) return records;
  }
}

/// The system wakes who waits when as much as is wanted has come; where it does so before, a pause keeps from asking
/// without end.
void await_client_hello(tcp::socket& socket, std::function<void(bool)> then) {
  socket.async_wait(tcp::socket::wait_read, [&socket, then = std::move(then)](error_code code) mutable {
    if (code) return then(false);
    std::array<char, client_hello_bytes_max> buffer;
    const std::string_view come = peeked(socket, buffer);
    const auto wanted = client_hello_wanted(come);
    if (!wanted) return then(false);
    const bool has_come = *wanted <= come.size();
    error_code ignored;
    socket.set_option(tcp::socket::receive_low_watermark(has_come ? 1 : static_cast<int>(*wanted)), ignored);
    if (has_come) return then(true);
    if (has_left(socket.native_handle())) return then(false);
    await_more(socket, std::move(then));
  });
}

}  // namespace axiometry::server
