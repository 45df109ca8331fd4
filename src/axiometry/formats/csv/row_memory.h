// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace axiometry::formats {

/// The cells of a plain row as they stand, before units are converted.
struct PlainRow {
  double target = 0.0;
  double reading = 0.0;
  std::uint16_t run = 0;  ///< number of the run, from 0
  std::uint8_t direction = 0;
};

/// Equal bytes, eight at a time; both places must be readable for eight bytes. Names and keys of rows are short,
/// and a call of memcmp costs more than comparing them.
inline bool same_bytes(const char* a, const char* b, std::size_t size) {
  if (size < 8) return std::memcmp(a, b, size) == 0;
  const auto same_word = [&](std::size_t k) { return std::memcmp(a + k, b + k, 8) == 0; };
  for (std::size_t k = 0; k + 8 < size; k += 8)
    if (!same_word(k)) return false;
  return same_word(size - 8);
}

/// What the tests of one file have in common: row k of a test mostly has the target, direction and run of row k of the
/// test before, in the same bytes. Where the bytes agree, the numbers need not be read again.
class RowMemory {
 public:
  static constexpr std::size_t longest = 40;

  /// The row remembered at k when its bytes stand at `p`, of which `longest` must be readable; else null.
  const PlainRow* recall(std::size_t k, const char* p) const {
    if (k >= entries_.size()) return nullptr;
    const Entry& entry = entries_[k];
    return entry.size > 0 && same_bytes(p, entry.bytes, entry.size) ? &entry.row : nullptr;
  }
  std::size_t size_of(std::size_t k) const { return entries_[k].size; }

  /// Long rows and those far back in huge tests are not worth it.
  void remember(std::size_t k, std::string_view bytes, const PlainRow& row) {
    constexpr std::size_t most_rows = 4096;
    if (k >= most_rows || bytes.size() > longest) return;
    if (k >= entries_.size()) entries_.resize(k + 1);
    Entry& entry = entries_[k];
    std::memcpy(entry.bytes, bytes.data(), bytes.size());
    entry.size = static_cast<std::uint8_t>(bytes.size());
    entry.row = row;
  }

 private:
  struct Entry {
    char bytes[longest] = {};
    std::uint8_t size = 0;  // 0 while nothing is remembered: the first row of a test is no plain one
    PlainRow row;
  };
  std::vector<Entry> entries_;
};

}  // namespace axiometry::formats
