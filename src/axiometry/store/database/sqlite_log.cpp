// SPDX-License-Identifier: Apache-2.0
// The log of changes that are not in the file yet: sqlite.org/fileformat2.html, 4 (The Write-Ahead Log).
#include "axiometry/store/database/sqlite_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <istream>
#include <span>
#include <thread>
#include <vector>

namespace axiometry::store {
namespace {

constexpr std::size_t log_head_bytes = 32, page_head_bytes = 24;
constexpr std::size_t least_page_bytes = 512, most_page_bytes = 65536;
constexpr std::uint32_t magic_little = 0x377f0682, magic_big = 0x377f0683;  // by the order of bytes in which is summed

using LogSum = std::array<std::uint32_t, 2>;

std::uint32_t word_big(std::span<const unsigned char> b) {
  return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3];
}

std::uint32_t word_little(std::span<const unsigned char> b) {
  return std::uint32_t{b[3]} << 24 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[1]} << 8 | b[0];
}

LogSum summed_on(LogSum sum, std::span<const unsigned char> bytes, bool big) {
  const auto word = big ? word_big : word_little;
  for (std::size_t k = 0; k + 8 <= bytes.size(); k += 8) {
    sum[0] += word(bytes.subspan(k, 4)) + sum[1];
    sum[1] += word(bytes.subspan(k + 4, 4)) + sum[0];
  }
  return sum;
}

/// What the sum was before these bytes.
LogSum summed_back(LogSum sum, std::span<const unsigned char> bytes, bool big) {
  const auto word = big ? word_big : word_little;
  for (std::size_t k = bytes.size(); k >= 8; k -= 8) {
    sum[1] -= word(bytes.subspan(k - 4, 4)) + sum[0];
    sum[0] -= word(bytes.subspan(k - 8, 4)) + sum[1];
  }
  return sum;
}

/// Whether the last page of a change lost no more than what says so, the size of the file behind its number: the sum of
/// what is in front of the page and that of what follows in it tell the size that was written.
bool lost_its_size(LogSum before, LogSum stated, std::span<const unsigned char> page, bool big) {
  const LogSum behind = summed_back(stated, page.subspan(page_head_bytes), big);
  const auto word = big ? word_big : word_little;
  const bool has_its_number = behind[0] == before[0] + word(page.first(4)) + before[1];
  return has_its_number && behind[1] != before[1] + behind[0];
}

bool read_bytes(std::istream& log, std::span<unsigned char> bytes) {
  log.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return log.gcount() == static_cast<std::streamsize>(bytes.size());
}

struct LogHead {
  bool big = true, is_zero = true, is_whole = false;
  std::size_t page_bytes = 0;
  LogSum salts{}, sum{};
};

LogHead log_head(std::span<const unsigned char> bytes) {
  LogHead head;
  for (const unsigned char byte : bytes) head.is_zero &= byte == 0;
  const std::uint32_t magic = word_big(bytes);
  head.big = magic != magic_little;
  head.page_bytes = word_big(bytes.subspan(8, 4));
  head.salts = {word_big(bytes.subspan(16, 4)), word_big(bytes.subspan(20, 4))};
  head.sum = {word_big(bytes.subspan(24, 4)), word_big(bytes.subspan(28, 4))};
  const bool is_page = head.page_bytes >= least_page_bytes && head.page_bytes <= most_page_bytes &&
                       (head.page_bytes & (head.page_bytes - 1)) == 0;
  head.is_whole =
      (magic == magic_little || magic == magic_big) && is_page && summed_on({}, bytes.first(24), head.big) == head.sum;
  return head;
}

/// In so many bytes behind the head, by their size alone; behind a head of zeros only what is not zero as well: a file
/// system may have kept no more of a log than its size.
bool holds_a_page(std::istream& log, bool head_is_zero) {
  std::vector<unsigned char> bytes(page_head_bytes + least_page_bytes);
  if (!read_bytes(log, bytes)) return false;
  const auto is_zero = [](unsigned char byte) { return byte == 0; };
  while (head_is_zero && std::ranges::all_of(bytes, is_zero))
    if (!read_bytes(log, bytes)) return false;
  return true;
}

}  // namespace

LogState log_state(std::istream& log) {
  std::array<unsigned char, log_head_bytes> beginning{};
  LogState state;
  if (!read_bytes(log, beginning)) return state;
  const LogHead head = log_head(beginning);
  if (!head.is_whole) {
    state.altered_head = holds_a_page(log, head.is_zero);
    return state;
  }
  std::vector<unsigned char> bytes(page_head_bytes + head.page_bytes);
  LogSum sum = head.sum;
  for (bool whole = true; read_bytes(log, bytes);) {
    const std::span<const unsigned char> page = bytes;
    const LogSum salts{word_big(page.subspan(8, 4)), word_big(page.subspan(12, 4))};
    const LogSum stated{word_big(page.subspan(16, 4)), word_big(page.subspan(20, 4))};
    bool ends_a_change = word_big(page.subspan(4, 4)) != 0;
    bool is_ours = salts == head.salts;
    if (whole) {
      ends_a_change |= lost_its_size(sum, stated, page, head.big);
      sum = summed_on(summed_on(sum, page.first(8), head.big), page.subspan(page_head_bytes), head.big);
      state.altered_salts = sum == stated && !is_ours;
      whole = sum == stated && is_ours;
      is_ours |= state.altered_salts;
    }
    if (whole) {
      ++state.pages;
      if (ends_a_change) state.kept = state.pages;
    } else if (is_ours && ends_a_change) {
      if (state.is_finished) ++state.behind;
      state.is_finished = true;
    }
  }
  return state;
}

LogState log_beside(const std::string& file) {
  const auto state_now = [&] {
    std::ifstream log(file + "-wal", std::ios::binary);
    return log ? log_state(log) : LogState();
  };
  // Others may write while it is read: what they were about to write stands there when it is read again. A log that
  // does not come to rest is in use, and whole to whom it serves.
  constexpr int most_readings = 5;
  constexpr std::chrono::milliseconds between{5};
  LogState state = state_now();
  for (int k = 1; state.is_damaged() || state.is_undecided(); ++k) {
    std::this_thread::sleep_for(between);
    const LogState again = state_now();
    if (again == state) break;
    state = k < most_readings ? again : LogState();
  }
  return state;
}

Result<void> check_log_beside(const std::string& file) {
  constexpr std::string_view way_out =
      "copy both aside and see what 'axiometry store verify' says of them, then restore a backup into a new file, or "
      "move the log away to go on without anything that is in it";
  const LogState state = log_beside(file);
  if (state.altered_head)
    return fail(ErrorKind::damaged,
                fmt::format("found the head of the log beside it (-wal) altered, expected it as it was written: to use "
                            "the file would destroy the changes in the log; {}",
                            way_out));
  if (state.is_damaged())
    return fail(ErrorKind::damaged,
                fmt::format("found page {} of the log beside it (-wal) altered, expected it as it was written: to use "
                            "the file would destroy what changed from page {} on; {}",
                            state.pages + 1, state.kept + 1, way_out));
  return {};
}

std::string note_of_log(const LogState& state) {
  return fmt::format(
      "file: the last change in the log beside it (-wal), from page {} on, is not whole and is passed over: power was "
      "lost while it was written, or it was altered",
      state.kept + 1);
}

}  // namespace axiometry::store
