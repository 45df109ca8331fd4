// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "axiometry/app/live/sources/capture_source.h"

namespace axiometry::testing_support {

/// Where somebody may connect on 127.0.0.1.
class LoopbackListener {
 public:
  LoopbackListener() {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    EXPECT_EQ(::listen(listener_, 4), 0);
    port_ = ntohs(address.sin_port);
  }
  ~LoopbackListener() { ::close(listener_); }
  LoopbackListener(const LoopbackListener&) = delete;
  LoopbackListener& operator=(const LoopbackListener&) = delete;

  app::CaptureSource source() const {
    return *app::parse_capture_source("laser=tcp://127.0.0.1:" + std::to_string(port_));
  }
  int accept() const { return ::accept(listener_, nullptr, nullptr); }  ///< -1 after shut_down()
  void shut_down() const { ::shutdown(listener_, SHUT_RDWR); }

 private:
  int listener_ = -1;
  unsigned port_ = 0;
};

/// False where the other side has gone.
inline bool send_all(int peer, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(peer, bytes.data(), std::min<std::size_t>(1000, bytes.size()), MSG_NOSIGNAL);
    if (sent < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

/// Serves pieces of a stream on 127.0.0.1, one for each who connects.
class PieceServer {
 public:
  explicit PieceServer(std::vector<std::string> pieces) : pieces_(std::move(pieces)) {
    thread_ = std::jthread([this] { serve(); });
  }
  ~PieceServer() {
    listener_.shut_down();
    thread_.join();
  }
  app::CaptureSource source() const { return listener_.source(); }

 private:
  void serve() {
    for (const std::string& piece : pieces_) {
      const int peer = listener_.accept();
      if (peer < 0) return;
      send_all(peer, piece);
      ::close(peer);
    }
  }

  LoopbackListener listener_;
  std::vector<std::string> pieces_;
  std::jthread thread_;
};

/// Serves what a test has it send, to the one who connected last.
class FedServer {
 public:
  FedServer() = default;
  ~FedServer() { hang_up(); }
  FedServer(const FedServer&) = delete;
  FedServer& operator=(const FedServer&) = delete;

  app::CaptureSource source() const { return listener_.source(); }
  /// Waits for somebody to connect where nobody is.
  void send(std::string_view bytes) {
    if (peer_ < 0) peer_ = listener_.accept();
    EXPECT_TRUE(send_all(peer_, bytes));
  }
  void hang_up() {
    if (peer_ >= 0) ::close(std::exchange(peer_, -1));
  }

 private:
  LoopbackListener listener_;
  int peer_ = -1;
};

}  // namespace axiometry::testing_support
