// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/disk_room.h"

#include <sys/statvfs.h>

#include <filesystem>

namespace axiometry::app {
namespace {

constexpr std::uint64_t ask_every_bytes = std::uint64_t{1} << 20;
constexpr auto ask_every_s = std::chrono::seconds(1);

}  // namespace

std::optional<std::uint64_t> free_bytes(const std::string& file) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  struct statvfs status {};
  if (::statvfs(folder.empty() ? "." : folder.c_str(), &status) != 0 || status.f_blocks == 0) return std::nullopt;
  return std::uint64_t{status.f_bavail} * status.f_frsize;
}

DiskRoom::Answer DiskRoom::before(std::uint64_t bytes) {
  const auto now = std::chrono::steady_clock::now();
  const bool due = since_asked_ >= ask_every_bytes || now - asked_ >= ask_every_s;
  since_asked_ = due ? bytes : since_asked_ + bytes;
  if (!due) return {.enough = enough_};
  asked_ = now;
  const auto free = ask_(file_);
  enough_ = !free || *free >= least + ask_every_bytes + bytes;
  Answer answer{.enough = enough_};
  if (free && *free < little && !warned_) answer.warn = free;
  warned_ = warned_ || answer.warn;
  return answer;
}

}  // namespace axiometry::app
