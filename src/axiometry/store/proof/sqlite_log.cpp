// SPDX-License-Identifier: Apache-2.0
// The log of changes that are not in the file yet: sqlite.org/fileformat2.html, 4 (The Write-Ahead Log).
#include "axiometry/store/proof/sqlite_log.h"

#include <array>
#include <fstream>
#include <istream>
#include <span>
#include <string>
#include <vector>

#include "axiometry/store/proof/problems.h"

namespace axiometry::store {
namespace {

constexpr std::size_t log_head_bytes = 32, page_head_bytes = 24;
constexpr std::size_t smallest_page = 512, largest_page = 65536;
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
  const bool is_page = head.page_bytes >= smallest_page && head.page_bytes <= largest_page &&
                       (head.page_bytes & (head.page_bytes - 1)) == 0;
  head.is_whole =
      (magic == magic_little || magic == magic_big) && is_page && summed_on({}, bytes.first(24), head.big) == head.sum;
  return head;
}

/// In so many bytes behind the head, by their size alone.
bool holds_a_page(std::istream& log) {
  std::vector<unsigned char> smallest(page_head_bytes + smallest_page);
  return read_bytes(log, smallest);
}

}  // namespace

LogState log_state(std::istream& log) {
  std::array<unsigned char, log_head_bytes> beginning{};
  LogState state;
  if (!read_bytes(log, beginning)) return state;
  const LogHead head = log_head(beginning);
  if (!head.is_whole) {  // none that is all zeros was written yet
    state.altered_head = !head.is_zero && holds_a_page(log);
    state.changes = state.altered_head ? 1 : 0;
    return state;
  }
  std::vector<unsigned char> bytes(page_head_bytes + head.page_bytes);
  LogSum sum = head.sum;
  for (bool whole = true; read_bytes(log, bytes);) {
    const std::span<const unsigned char> page = bytes;
    const LogSum salts{word_big(page.subspan(8, 4)), word_big(page.subspan(12, 4))};
    const LogSum stated{word_big(page.subspan(16, 4)), word_big(page.subspan(20, 4))};
    if (whole) {
      sum = summed_on(summed_on(sum, page.first(8), head.big), page.subspan(page_head_bytes), head.big);
      state.altered_salts = sum == stated && salts != head.salts;
      whole = sum == stated && salts == head.salts;
    }
    if (whole)
      ++state.pages;
    else if (salts == head.salts && word_big(page.subspan(4, 4)) != 0)  // the last page of a change
      ++state.changes;
  }
  return state;
}

Result<void> verify_sqlite_log(Connection& connection, Verification& found) {
  AXIOMETRY_TRY(const Rows databases, connection.query("PRAGMA database_list"));
  const std::string name = databases[0].text(2) + "-wal";
  const auto state_now = [&] {
    std::ifstream log(name, std::ios::binary);
    return log ? log_state(log) : LogState();
  };
  // Others may write while it is read: what they were about to write stands there when it is read again.
  constexpr int most_readings = 5;
  LogState state = state_now();
  for (int k = 1; k < most_readings && state.changes > 0; ++k) {
    const LogState again = state_now();
    if (again == state) break;
    state = again;
  }
  if (state.altered_head)
    add_problem(found.problems,
                "file: found the head of the log beside it (-wal) altered, expected it as it was written: the changes "
                "in the log are passed over");
  else if (state.is_damaged())
    add_problem(found.problems,
                "file: found page {} of the log beside it (-wal) altered, expected it as it was written: what changed "
                "from there on is passed over, {} finished changes behind it too",
                state.pages + 1, state.changes);
  else if (state.changes > 0)
    found.notes.push_back(fmt::format(
        "file: the last change in the log beside it (-wal), from page {} on, is not whole and is passed over: power "
        "was lost while it was written, or it was altered",
        state.pages + 1));
  return {};
}

}  // namespace axiometry::store
