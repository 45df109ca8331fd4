// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/work_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::nc {
namespace {

bool has_machine(const FrameWords& words) { return !words.machine_start.empty() || !words.machine_move.empty(); }

std::string name_of(const WorkOffsets& offsets, unsigned number) {
  return fmt::format(fmt::runtime(offsets.word), number);
}

/// In capitals, without blanks.
std::string bare(std::string_view text) {
  std::string result;
  for (char c : text)
    if (c != ' ') result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return result;
}

/// The control's words for an offset; "" when it has no such one.
std::string offset_of(std::string_view asked, const FrameWords& words) {
  for (const WorkOffsets& offsets : words.offsets) {
    const std::string before = bare(offsets.word.substr(0, offsets.word.find('{')));
    if (offsets.last < offsets.first || !asked.starts_with(before)) continue;
    const std::string_view digits = asked.substr(before.size());
    const auto number = digits.starts_with('0') ? std::nullopt : parse_count(digits);
    if (number && *number >= offsets.first && *number <= offsets.last)
      return name_of(offsets, static_cast<unsigned>(*number));
  }
  return {};
}

std::string choices(const FrameWords& words) {
  std::vector<std::string> list = {"active"};
  if (has_machine(words)) list.emplace_back("machine");
  for (const WorkOffsets& offsets : words.offsets) {
    if (offsets.last < offsets.first) continue;
    list.push_back(name_of(offsets, offsets.first));
    if (offsets.last > offsets.first) list.back() += "…" + name_of(offsets, offsets.last);
  }
  return fmt::format("one of {}", fmt::join(list, ", "));
}

WorkFrame machine_frame(const FrameWords& words) {
  const bool each = !words.machine_move.empty();
  return {.start = std::string(words.machine_start),
          .of_move = std::string(words.machine_move),
          .remark = fmt::format("POSITIONS IN THE COORDINATES OF THE MACHINE, BY {}{}",
                                each ? words.machine_move : words.machine_start, each ? " WHERE ABSOLUTE" : "")};
}

}  // namespace

Result<WorkFrame> work_frame(std::string_view asked, const FrameWords& words) {
  const std::string name = bare(asked);
  if (name == "ACTIVE") return WorkFrame{"", "", "POSITIONS IN THE WORK OFFSET THAT IS ACTIVE"};
  if (name == "MACHINE" && has_machine(words)) return machine_frame(words);
  if (name == "MACHINE")
    return fail(
        fmt::format("found the coordinates of the machine asked for, expected {}: G53 may drive at rapid there; put a "
                    "work offset at zero instead",
                    choices(words)));
  const std::string offset = offset_of(name, words);
  if (!offset.empty())
    return WorkFrame{offset, "", fmt::format("POSITIONS IN THE WORK OFFSET {}, OTHER SHIFTS MUST BE OFF", offset)};
  return fail(fmt::format("found the frame {}, expected {}", text::quoted(asked), choices(words)));
}

}  // namespace axiometry::nc
