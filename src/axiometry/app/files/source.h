// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/read_budget.h"
#include "axiometry/base/result.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/format.h"

namespace axiometry::app {

/// The whole of a file. Fails when it cannot be read and beyond the limit.
Result<std::string> file_bytes(const std::string& name, std::size_t limit = read_budget::file_bytes);

/// Those that are at hand; else as file_bytes().
Result<std::string> bytes_at_hand(std::optional<std::string_view> at_hand, const std::string& name,
                                  std::size_t limit = read_budget::file_bytes);

/// A file's name without its folders, which are nobody else's business; "standard input" for "-".
std::string base_name(const std::string& name);

/// Whether "-" brings what is in no file: a pipe, a socket, a terminal. What a shell redirects is a file.
bool standard_input_is_a_stream();

/// A file, for "-" the standard input, or bytes that are there already, read front to back. The beginning can be
/// looked at before.
class Source final : public formats::ByteReader {
 public:
  /// Fails when the file cannot be opened or is a folder, with the system's reason.
  static Result<Source> open(const std::string& name);
  /// Bytes that must outlive the source. `name` is what messages and provenance call them; no file of that name is
  /// looked for.
  static Source of_bytes(std::string name, std::string_view bytes);
  ~Source() override;
  Source(Source&&) noexcept;
  Source& operator=(Source&&) = delete;

  const std::string& name() const { return name_; }

  /// The first bytes, at most 64 KiB, without consuming them.
  Result<std::string_view> head();

  Result<std::size_t> read(std::span<char> buffer) override;

  /// All that is left. Fails when that is more than `limit` bytes, without reading further.
  Result<std::string> read_all(std::size_t limit);

  /// Hash of the whole file by a pass of its own; nothing for what cannot be read twice (a pipe).
  Result<std::optional<std::string>> whole_sha256() const;

  /// The same, before anything but the head is read. A file of at most 16 MiB is in memory from then on, so that it is
  /// read once and what follows is what was hashed.
  Result<std::optional<std::string>> sha256_ahead();

 private:
  Source(std::string name, int descriptor, std::optional<std::uint64_t> size)
      : name_(std::move(name)), descriptor_(descriptor), size_(size) {}
  Source(std::string name, std::string_view bytes)
      : name_(std::move(name)), bytes_(bytes), in_memory_(true), size_(bytes.size()) {}
  Result<std::size_t> read_file(std::span<char> buffer);

  std::string name_;
  int descriptor_ = -1;
  std::string_view bytes_;  // all bytes of a source in memory
  std::size_t bytes_consumed_ = 0;
  bool in_memory_ = false;
  std::optional<std::uint64_t> size_;  // bytes of a regular file or of a source in memory
  std::string head_;
  std::string ahead_;                   // what follows the head, where it was read ahead
  std::size_t beginning_consumed_ = 0;  // bytes of head_ and ahead_ that were read
  bool head_read_ = false;
  bool all_ahead_ = false;
};

}  // namespace axiometry::app
