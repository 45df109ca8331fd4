// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/trigger.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace axiometry::nc {
namespace {

struct Meaning {
  MCodes codes;
  std::string_view does;
};

/// On most controls (RS-274-D, ISO 6983-1 and their relatives); why one is refused, never why one is taken.
constexpr Meaning meanings[] = {
    {{0, 1}, "stops the program"},
    {{2, 2}, "ends the program"},
    {{3, 5}, "steers the spindle"},
    {{6, 6}, "changes the tool"},
    {{10, 11}, "steers clamps"},
    {{13, 14}, "steers the spindle"},
    {{15, 16}, "moves the machine"},
    {{17, 17}, "ends the program"},
    {{18, 19}, "steers the spindle"},
    {{29, 29}, "steers the spindle (rigid tapping)"},
    {{30, 30}, "ends the program"},
    {{31, 31}, "bypasses interlocks"},
    {{36, 45}, "steers feed, spindle or gears"},
    {{48, 49}, "steers the overrides"},
    {{60, 60}, "changes the workpiece"},
    {{68, 69}, "steers clamps"},
    {{70, 70}, "steers the spindle"},
    {{96, 99}, "calls or ends programs"},
    {{198, 198}, "calls programs"},
};

std::string_view meaning_of(unsigned code) {
  for (const auto& [codes, does] : meanings)
    if (code >= codes.first && code <= codes.last) return does;
  return "may steer anything on this control";
}

}  // namespace

Result<void> check_trigger(std::optional<unsigned> code, const TriggerCodes& allowed) {
  if (!code) return {};
  std::vector<std::string> ranges;
  std::string_view does = meaning_of(*code);
  for (const auto& [first, last, off, last_off] : allowed) {
    if (*code >= first && *code <= last) return {};
    if (off > 0 && *code >= off && *code <= last_off) does = "only switches an output off";
    if (first <= last)
      ranges.push_back(first == last ? fmt::format("M{}", first) : fmt::format("M{}…M{}", first, last));
  }
  return fail(fmt::format("found M{} as trigger, which {}, expected one of {}", *code, does, fmt::join(ranges, ", ")));
}

std::optional<unsigned> off_code(unsigned trigger, const TriggerCodes& allowed) {
  for (const auto& [first, last, off, last_off] : allowed)
    if (off > 0 && trigger >= first && trigger <= last) return std::min(off + (trigger - first), last_off);
  return std::nullopt;
}

}  // namespace axiometry::nc
