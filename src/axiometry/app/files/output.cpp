// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/output.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "axiometry/app/files/fail_system.h"
#include "axiometry/app/files/synced.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 18;

mode_t usual_permissions() {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return static_cast<mode_t>(0666) & ~mask;
}

/// A file that no name leads to; -1 where there is no such thing or no way to name it later.
int open_nameless(const std::filesystem::path& folder, mode_t mode) {
  if (::access("/proc/self/fd", X_OK) != 0) return -1;
  return ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, mode);
}

std::string neighbour_of(const std::string& name, std::string_view suffix) {
  const std::filesystem::path path(name);
  return (path.parent_path() / fmt::format(".{}.{}", path.filename().string(), suffix)).string();
}

/// A link stays a link: what it points to is written.
std::string behind_link(const std::string& name) {
  std::error_code error;
  if (!std::filesystem::is_symlink(name, error)) return name;
  const auto target = std::filesystem::canonical(name, error);
  return error ? name : target.string();
}

}  // namespace

Result<OutputFile> OutputFile::create(const std::string& asked) {
  if (asked == "-") return OutputFile(asked, "", STDOUT_FILENO);
  const std::string name = behind_link(asked);
  struct stat status {};
  const bool exists = ::stat(name.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    return fail_system(name, "write");
  }
  if (exists && !S_ISREG(status.st_mode)) {
    const int direct = ::open(name.c_str(), O_WRONLY | O_CLOEXEC);
    if (direct < 0) return fail_system(name, "write");
    return OutputFile(name, "", direct);
  }
  if (const int nameless = open_nameless(std::filesystem::path(name).parent_path(), 0666); nameless >= 0) {
    if (exists) ::fchmod(nameless, status.st_mode & 0777);
    OutputFile file(name, "", nameless);
    file.nameless_ = true;
    return file;
  }
  std::string neighbour = neighbour_of(name, "XXXXXX");
  const int descriptor = ::mkstemp(neighbour.data());
  if (descriptor < 0) return fail_system(name, "write");
  ::fchmod(descriptor, exists ? status.st_mode & 0777 : usual_permissions());
  return OutputFile(name, neighbour, descriptor);
}

Result<OutputFile> OutputFile::create_secret(const std::string& name) {
  constexpr mode_t owner_only = 0600;  // mkstemp()'s, too
  const int nameless = open_nameless(std::filesystem::path(name).parent_path(), owner_only);
  std::string neighbour = nameless >= 0 ? "" : neighbour_of(name, "XXXXXX");
  const int descriptor = nameless >= 0 ? nameless : ::mkstemp(neighbour.data());
  if (descriptor < 0) return fail_system(name, "write");
  OutputFile file(name, neighbour, descriptor);
  file.nameless_ = nameless >= 0;
  file.secret_ = true;
  return file;
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : name_(std::move(other.name_)),
      neighbour_(std::exchange(other.neighbour_, {})),
      nameless_(other.nameless_),
      secret_(other.secret_),
      descriptor_(std::exchange(other.descriptor_, -1)),
      buffer_(std::move(other.buffer_)) {}

OutputFile& OutputFile::operator=(OutputFile&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(neighbour_, other.neighbour_);
  std::swap(nameless_, other.nameless_);
  std::swap(secret_, other.secret_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(buffer_, other.buffer_);
  return *this;
}

OutputFile::~OutputFile() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  if (!neighbour_.empty()) ::unlink(neighbour_.c_str());
}

Result<void> OutputFile::flush() {
  if (!written_all(descriptor_, buffer_)) return fail_system(name_, "write");
  buffer_.clear();
  return {};
}

Result<void> OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  return buffer_.size() >= buffer_size ? flush() : Result<void>{};
}

/// The last step before rename(), which alone can take the place of an existing file.
Result<void> OutputFile::name_neighbour() {
  constexpr int attempts = 100;
  const std::string nameless = fmt::format("/proc/self/fd/{}", descriptor_);
  for (int k = 0; k < attempts; ++k) {
    const std::string neighbour = neighbour_of(name_, fmt::format("{}-{}", ::getpid(), k));
    if (::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, neighbour.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      neighbour_ = neighbour;
      return {};
    }
    if (errno != EEXIST) break;
  }
  return fail_system(name_, "write");
}

/// The last step where nothing may be replaced. Some file systems know no links.
Result<void> OutputFile::take_free_name() {
  if (!nameless_ && ::renameat2(AT_FDCWD, neighbour_.c_str(), AT_FDCWD, name_.c_str(), RENAME_NOREPLACE) == 0) {
    neighbour_.clear();
    return {};
  }
  const std::string from = nameless_ ? fmt::format("/proc/self/fd/{}", descriptor_) : neighbour_;
  if (::linkat(AT_FDCWD, from.c_str(), AT_FDCWD, name_.c_str(), AT_SYMLINK_FOLLOW) == 0) return {};
  const bool taken = errno == EEXIST;
  auto failed = fail_system(name_, "write");
  if (taken) failed.error().kind = ErrorKind::conflict;
  return failed;
}

/// First the bytes, then the name, then the folder that holds the name: whatever happens in between, the file is the
/// old one or the new one.
Result<void> OutputFile::commit() {
  AXIOMETRY_TRY_VOID(flush());
  if (!nameless_ && neighbour_.empty()) return {};
  if (!synced(descriptor_)) return fail_system(name_, "write");
  if (secret_) {
    AXIOMETRY_TRY_VOID(take_free_name());
    return folder_synced(name_) ? Result<void>() : fail_system(name_, "write");
  }
  if (nameless_) AXIOMETRY_TRY_VOID(name_neighbour());
  if (::close(std::exchange(descriptor_, -1)) != 0 || std::rename(neighbour_.c_str(), name_.c_str()) != 0)
    return fail_system(name_, "write");
  neighbour_.clear();
  return folder_synced(name_) ? Result<void>() : fail_system(name_, "write");
}

Result<void> check_ending(const std::string& name, std::initializer_list<std::string_view> endings) {
  const std::string ending = std::filesystem::path(name).extension().string();
  if (ending.empty() || text::is_one_of(ending, endings)) return {};
  return fail(
      fmt::format("found the output {}, expected a file ending in {}", text::quoted(name), fmt::join(endings, ", ")));
}

Result<void> check_writable(const std::string& name) {
  struct stat status {};
  if (name == "-" || (::stat(name.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)))
    return {};
  AXIOMETRY_TRY([[maybe_unused]] const OutputFile file, OutputFile::create(name));
  return {};
}

Result<void> write_file(const std::string& name, std::string_view bytes) {
  AXIOMETRY_TRY(OutputFile file, OutputFile::create(name));
  AXIOMETRY_TRY_VOID(file.write(bytes));
  return file.commit();
}

Result<void> write_secret_file(const std::string& name, std::string_view bytes) {
  AXIOMETRY_TRY(OutputFile file, OutputFile::create_secret(name));
  AXIOMETRY_TRY_VOID(file.write(bytes));
  return file.commit();
}

}  // namespace axiometry::app
