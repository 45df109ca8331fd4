// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/sqlite_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include "axiometry/base/text/text.h"
#include "axiometry/store/database/system_error.h"

namespace axiometry::store {

std::optional<FileStamp> file_stamp(const std::string& path) {
  struct stat file {};
  struct stat log {};
  if (::stat(path.c_str(), &file) != 0) return std::nullopt;
  const bool has_log = ::stat((path + "-wal").c_str(), &log) == 0;
  return FileStamp{.device = file.st_dev,
                   .number = file.st_ino,
                   .size = static_cast<std::uint64_t>(file.st_size),
                   .changed_s = file.st_mtim.tv_sec,
                   .changed_ns = file.st_mtim.tv_nsec,
                   .size_of_log = has_log ? static_cast<std::uint64_t>(log.st_size) : 0};
}

Result<void> make_file(const std::string& file, const std::string& path) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::filesystem::create_directories(folder, error);
  if (error) {
    errno = error.value();
    return std::unexpected(system_error(file, fmt::format("make the folder {}", text::quoted(folder.string()))));
  }
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0 && errno != EEXIST) return std::unexpected(system_error(file, "make the store"));
  if (descriptor >= 0) ::close(descriptor);
  return {};
}

std::string obstacle_to_writing(const std::string& path) {
  const auto said = [](std::string_view what) {
    return errno == EROFS ? std::string("its file system is mounted read-only")
                          : fmt::format("{} cannot be written: {}", what, std::strerror(errno));
  };
  if (::access(path.c_str(), W_OK) != 0) return said("the file");
  if (::access(std::filesystem::path(path).parent_path().c_str(), W_OK) != 0) return said("its folder");
  return "";
}

bool begins_as_database(const std::string& path) {
  constexpr std::string_view magic("SQLite format 3\0", 16);
  std::array<char, magic.size()> head{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), head.size());
  return stream.gcount() == static_cast<std::streamsize>(head.size()) &&
         std::string_view(head.data(), head.size()) == magic;
}

std::uint32_t application_mark(const std::string& path) {
  std::array<unsigned char, 72> head{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(reinterpret_cast<char*>(head.data()), head.size());
  return std::uint32_t{head[68]} << 24 | std::uint32_t{head[69]} << 16 | std::uint32_t{head[70]} << 8 | head[71];
}

}  // namespace axiometry::store
