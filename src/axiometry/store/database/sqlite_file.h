// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "axiometry/base/result.h"

/// What the file system says of the file of an archive, beside what SQLite says of what is in it.
namespace axiometry::store {

/// What tells a file from another one that has taken its name, and from itself as it was before it was written.
struct FileStamp {
  std::uint64_t device = 0;
  std::uint64_t number = 0;
  std::uint64_t size = 0;
  std::int64_t changed_s = 0;
  std::int64_t changed_ns = 0;
  std::uint64_t size_of_log = 0;  ///< bytes of SQLite's "-wal" beside it; 0 without one

  bool is_same_file(const FileStamp& other) const { return device == other.device && number == other.number; }
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Nothing where there is no such file.
std::optional<FileStamp> file_stamp(const std::string& path);

/// New for its owner only, in a folder that is made if need be; one that is there already stays. `file` is the name by
/// which the user knows it.
Result<void> make_file(const std::string& file, const std::string& path);

/// Why the file cannot be written, or nothing.
std::string obstacle_to_writing(const std::string& path);

/// By its first sixteen bytes, the name of the format.
bool begins_as_database(const std::string& path);

/// The application's mark as it stands in the file, whatever is still to be merged or taken back; 0 in a shorter one.
std::uint32_t application_mark(const std::string& path);

}  // namespace axiometry::store
