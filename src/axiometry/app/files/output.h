// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"

namespace axiometry::app {

/// A file that appears whole or not at all: bytes go to a file without a name, which gets it on commit(), so
/// that even a killed process leaves nothing behind. Where the file system knows no such files it is a hidden
/// neighbour, removed without commit(). What commit() has named is on the disk. "-" is the standard output,
/// "/dev/…" and pipes are written directly.
class OutputFile {
 public:
  /// Fails when no file can be made there, with the system's reason.
  static Result<OutputFile> create(const std::string& name);
  /// Likewise of a new file that only its owner may read and write. Its commit() never replaces one, and fails with
  /// `conflict` where the name was taken meanwhile.
  static Result<OutputFile> create_secret(const std::string& name);
  ~OutputFile();
  OutputFile(OutputFile&&) noexcept;
  OutputFile& operator=(OutputFile&&) noexcept;

  Result<void> write(std::string_view bytes);
  Result<void> commit();

 private:
  OutputFile(std::string name, std::string neighbour, int descriptor)
      : name_(std::move(name)), neighbour_(std::move(neighbour)), descriptor_(descriptor) {}
  Result<void> flush();
  Result<void> name_neighbour();
  Result<void> take_free_name();

  std::string name_;
  std::string neighbour_;  // empty when written directly or without a name yet
  bool nameless_ = false;
  bool secret_ = false;
  int descriptor_ = -1;
  std::string buffer_;
};

/// Fails where a name ends in something else: a file that is called a table and is none misleads whoever opens it. "-"
/// and a name without an ending say nothing.
Result<void> check_ending(const std::string& name, std::initializer_list<std::string_view> endings);

/// Fails as OutputFile::create() does, before hours are spent on what is to be written; leaves nothing behind. A pipe
/// or a device is not opened.
Result<void> check_writable(const std::string& name);

/// The whole file in one step.
Result<void> write_file(const std::string& name, std::string_view bytes);
Result<void> write_secret_file(const std::string& name, std::string_view bytes);

}  // namespace axiometry::app
