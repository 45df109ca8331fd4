// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/seal_key.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>

#include "axiometry/app/files/fail_system.h"
#include "axiometry/app/files/output.h"
#include "axiometry/app/files/store_address.h"
#include "axiometry/app/files/synced.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/digest/sha256.h"

namespace axiometry::app {
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
  if (std::filesystem::create_directories(folder, error) && !folder_synced(folder.string()))
    return fail_system(file, "make the folder of the key");
  const SigningKey key = SigningKey::make();
  const auto written = write_secret_file(file, key.pem());
  if (!written && written.error().kind == ErrorKind::conflict) return read_key(file);  // somebody else's, just made
  if (!written) return std::unexpected(written.error());
  return key;
}

}  // namespace axiometry::app
