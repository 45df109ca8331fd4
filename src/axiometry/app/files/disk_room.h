// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

/// What is left on the disk on which a recording grows.
namespace axiometry::app {

/// Bytes that may still be written beside this file; nothing when the system does not say.
using FreeBytes = std::function<std::optional<std::uint64_t>(const std::string&)>;
std::optional<std::uint64_t> free_bytes(const std::string& file);

/// Asked before every piece, it asks the system once a second and once every MiB.
class DiskRoom {
 public:
  static constexpr std::uint64_t little = std::uint64_t{256} << 20;  ///< bytes left at which people are told
  static constexpr std::uint64_t least = std::uint64_t{16}
                                         << 20;  ///< for the test and what else the disk is needed for

  DiskRoom(std::string file, FreeBytes ask) : file_(std::move(file)), ask_(std::move(ask)) {}

  struct Answer {
    bool enough = true;                   ///< whether there is room for these bytes, and for `least` beside them
    std::optional<std::uint64_t> warn{};  ///< once: so little is left
  };
  Answer before(std::uint64_t bytes);

 private:
  std::string file_;
  FreeBytes ask_;
  bool warned_ = false;
  bool enough_ = true;
  std::uint64_t since_asked_ = UINT64_MAX;
  std::chrono::steady_clock::time_point asked_;
};

}  // namespace axiometry::app
