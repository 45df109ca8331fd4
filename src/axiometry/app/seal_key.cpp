// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/seal_key.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "axiometry/app/fail_system.h"
#include "axiometry/app/store_address.h"
#include "axiometry/app/whole_file.h"
#include "axiometry/digest/sha256.h"

namespace axiometry::app {
namespace {

/// On the disk when this returns: a seal whose key is lost could never be followed by another of the same key.
Result<void> write_new_key(const std::string& file, const std::string& pem) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) return fail_system(file, "make the key");
  const bool written =
      ::write(descriptor, pem.data(), pem.size()) == static_cast<ssize_t>(pem.size()) && ::fsync(descriptor) == 0;
  auto failed = fail_system(file, "write the key");
  ::close(descriptor);
  if (written) return {};
  ::unlink(file.c_str());
  return failed;
}

}  // namespace

Result<std::string> default_key_file(const store::Info& archive) {
  if (archive.kind == "sqlite") return archive.location + ".key";
  AXIOMETRY_TRY(const std::string folder, user_data_folder());
  return fmt::format("{}/axiometry/key-{}", folder, sha256(archive.location).substr(0, 16));
}

Result<SigningKey> read_key(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return fail_system(file, "read the key");
  if ((status.st_mode & 077) != 0)
    return std::unexpected(Error{fmt::format("found a key that others may read or write (mode {:o}), expected one for "
                                             "its owner only (600)",
                                             status.st_mode & 0777),
                                 file,
                                 {}});
  AXIOMETRY_TRY(const std::string text, whole_file(file));
  auto key = SigningKey::from_pem(text);
  if (!key) return std::unexpected(Error{"found no Ed25519 key in PEM, expected that of an archive", file, {}});
  return *std::move(key);
}

Result<SigningKey> key_in(const std::string& file) {
  std::error_code error;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, error))) return read_key(file);
  const std::filesystem::path folder = std::filesystem::absolute(file, error).parent_path();
  std::filesystem::create_directories(folder, error);
  const SigningKey key = SigningKey::make();
  AXIOMETRY_TRY_VOID(write_new_key(file, key.pem()));
  return key;
}

}  // namespace axiometry::app
