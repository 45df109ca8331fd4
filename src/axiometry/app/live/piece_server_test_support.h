// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "axiometry/app/live/capture_source.h"

namespace axiometry::testing_support {

/// Serves pieces of a stream on 127.0.0.1, one for each who connects.
class PieceServer {
 public:
  explicit PieceServer(std::vector<std::string> pieces) : pieces_(std::move(pieces)) {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    EXPECT_EQ(::listen(listener_, 4), 0);
    port_ = ntohs(address.sin_port);
    thread_ = std::jthread([this] { serve(); });
  }
  ~PieceServer() {
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
  }
  app::CaptureSource source() const {
    return *app::parse_capture_source("laser=tcp://127.0.0.1:" + std::to_string(port_));
  }

 private:
  void serve() {
    for (const std::string& piece : pieces_) {
      const int peer = ::accept(listener_, nullptr, nullptr);
      if (peer < 0) return;
      for (std::size_t at = 0; at < piece.size();) {
        const ssize_t sent =
            ::send(peer, piece.data() + at, std::min<std::size_t>(1000, piece.size() - at), MSG_NOSIGNAL);
        if (sent < 0) break;
        at += static_cast<std::size_t>(sent);
      }
      ::close(peer);
    }
  }

  std::vector<std::string> pieces_;
  int listener_ = -1;
  unsigned port_ = 0;
  std::jthread thread_;
};

}  // namespace axiometry::testing_support
