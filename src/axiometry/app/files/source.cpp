// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <vector>

#include "axiometry/app/files/fail_system.h"
#include "axiometry/base/contract.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 20;

}  // namespace

Result<Source> Source::open(const std::string& name) {
  if (name == "-") return Source(name, STDIN_FILENO, std::nullopt);
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return fail_system(name, "open");
  struct stat status {};
  if (::fstat(descriptor, &status) != 0 || S_ISDIR(status.st_mode)) {
    if (S_ISDIR(status.st_mode)) errno = EISDIR;
    auto error = fail_system(name, "read");
    ::close(descriptor);
    return error;
  }
  std::optional<std::uint64_t> size;
  if (S_ISREG(status.st_mode)) size = static_cast<std::uint64_t>(status.st_size);
  return Source(name, descriptor, size);
}

Source Source::of_bytes(std::string name, std::string_view bytes) { return {std::move(name), bytes}; }

Source::~Source() {
  if (descriptor_ > STDIN_FILENO) ::close(descriptor_);
}

Source::Source(Source&& other) noexcept
    : name_(std::move(other.name_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      bytes_(other.bytes_),
      bytes_consumed_(other.bytes_consumed_),
      in_memory_(other.in_memory_),
      size_(other.size_),
      head_(std::move(other.head_)),
      ahead_(std::move(other.ahead_)),
      beginning_consumed_(other.beginning_consumed_),
      head_read_(other.head_read_),
      all_ahead_(other.all_ahead_) {}

Result<std::size_t> Source::read_file(std::span<char> buffer) {
  if (in_memory_) {
    const std::size_t count = bytes_.copy(buffer.data(), buffer.size(), bytes_consumed_);
    bytes_consumed_ += count;
    return count;
  }
  while (true) {
    const ssize_t got = ::read(descriptor_, buffer.data(), buffer.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno != EINTR) return fail_system(name_, "read");
  }
}

Result<std::string_view> Source::head() {
  if (!head_read_) {
    head_.resize(read_budget::head_bytes);
    std::size_t filled = 0;
    while (filled < read_budget::head_bytes) {
      AXIOMETRY_TRY(const std::size_t got, read_file(std::span(head_).subspan(filled)));
      if (got == 0) break;
      filled += got;
    }
    head_.resize(filled);
    head_read_ = true;
  }
  return std::string_view(head_);
}

Result<std::size_t> Source::read(std::span<char> buffer) {
  for (const std::string* const part : {&head_, &ahead_}) {
    const std::size_t before = part == &head_ ? 0 : head_.size();
    if (beginning_consumed_ >= before + part->size()) continue;
    const std::size_t count = part->copy(buffer.data(), buffer.size(), beginning_consumed_ - before);
    beginning_consumed_ += count;
    return count;
  }
  if (all_ahead_) return 0;
  return read_file(buffer);
}

Result<std::string> Source::read_all(std::size_t limit) {
  const auto too_large = [&](std::string_view found) {
    return std::unexpected(
        Error{fmt::format("found a file of {}, expected at most {} MiB for one test", found, limit >> 20), name_, {}});
  };
  if (size_ && *size_ > limit) return too_large(fmt::format("{} MiB", *size_ >> 20));
  std::string bytes;
  constexpr std::size_t step = 4096;
  if (size_) bytes.reserve(*size_ + 2 * step);  // a look for more behind the end must not move a large file
  std::size_t filled = 0;
  while (true) {
    bytes.resize(size_ ? std::max(static_cast<std::size_t>(*size_) + 1, filled + step) : filled + block_size);
    AXIOMETRY_TRY(const std::size_t got, read(std::span(bytes).subspan(filled)));
    filled += got;
    if (filled > limit) return too_large(fmt::format("more than {} MiB", limit >> 20));
    if (got == 0) break;
  }
  bytes.resize(filled);
  return bytes;
}

Result<std::optional<std::string>> Source::whole_sha256() const {
  if (!size_) return std::optional<std::string>();
  if (in_memory_) return std::optional(sha256(bytes_));
  AXIOMETRY_TRY(Source again, open(name_));
  Sha256 hash;
  std::vector<char> block(block_size);
  while (true) {
    AXIOMETRY_TRY(const std::size_t got, again.read(block));
    if (got == 0) break;
    hash.update(std::string_view(block.data(), got));
  }
  return std::optional(hash.finish());
}

Result<std::optional<std::string>> Source::sha256_ahead() {
  constexpr std::uint64_t most_ahead = std::uint64_t{16} << 20;
  AXIOMETRY_CONTRACT(beginning_consumed_ == 0);
  if (!size_ || in_memory_ || *size_ > most_ahead) return whole_sha256();
  AXIOMETRY_TRY_VOID(head());
  ahead_.reserve(*size_);
  std::vector<char> block(block_size);
  while (true) {
    AXIOMETRY_TRY(const std::size_t got, read_file(block));
    if (got == 0) break;
    ahead_.append(block.data(), got);
  }
  all_ahead_ = true;
  Sha256 hash;
  hash.update(head_);
  hash.update(ahead_);
  return std::optional(hash.finish());
}

Result<std::string> file_bytes(const std::string& name, std::size_t limit) {
  AXIOMETRY_TRY(Source source, Source::open(name));
  return source.read_all(limit);
}

Result<std::string> bytes_at_hand(std::optional<std::string_view> at_hand, const std::string& name, std::size_t limit) {
  if (at_hand) return std::string(*at_hand);
  return file_bytes(name, limit);
}

std::string base_name(const std::string& name) {
  return std::string(name == "-" ? "standard input" : text::without_folders(name));
}

bool standard_input_is_a_stream() {
  struct stat status {};
  return ::fstat(STDIN_FILENO, &status) == 0 && !S_ISREG(status.st_mode);
}

}  // namespace axiometry::app
