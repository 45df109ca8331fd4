// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/devices/camonitor_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <unordered_map>

#include "axiometry/base/counted.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/text.h"

namespace axiometry::formats {
namespace {

/// States that the events of a log of so many bytes may keep: half of what it may cost, and never more than 500 events
/// of a test among 8 000 variables (220 MB).
std::size_t most_states_of(std::size_t bytes) {
  constexpr std::size_t most = 4'000'000;
  return std::min(most, (read_budget::memory_bytes + read_budget::memory_per_byte * bytes) / 2 / sizeof(LogState));
}

bool is_test_number(std::string_view name) { return text::to_lower(name).contains("testnumber"); }

class Pass {
 public:
  Result<Log> read(std::string_view text) {
    states_most_ = most_states_of(text.size());
    const char* begin = text.data();
    const char* const end = begin + text.size();
    while (begin < end) {
      const auto* line_break =
          static_cast<const char*>(std::memchr(begin, '\n', static_cast<std::size_t>(end - begin)));
      const char* const line_end = line_break == nullptr ? end : line_break;
      ++log_.lines;
      AXIOMETRY_TRY_VOID(take(std::string_view(begin, line_end)));
      begin = line_end + 1;
    }
    return std::move(log_);
  }

 private:
  Result<void> take(std::string_view line) {
    if (const auto found = log_line(line)) return take_value(*found);
    const std::string_view content = text::trim(line);
    if (content.starts_with('#')) {
      take_directive(content, line);
    } else if (!content.empty()) {
      if (log_.skipped_lines++ == 0) log_.first_skipped = log_.lines;
    }
    return {};
  }

  void take_directive(std::string_view content, std::string_view line) {
    const std::size_t equals = content.find('=');
    if (equals == std::string_view::npos) return;
    const std::string_view key = text::trim(content.substr(1, equals - 1));
    const std::string_view value = text::trim(content.substr(equals + 1));
    const auto column = static_cast<std::size_t>(content.data() - line.data()) + 1;
    log_.directives.push_back({key, value, {log_.lines, column}});
    if (text::equal_ignoring_case(key, "TEST_PV")) stated_test_number_ = value;
  }

  /// Number of the variable. One mostly speaks after the same other one.
  Result<std::size_t> variable(std::string_view name) {
    if (!successors_.empty())
      if (const std::size_t guess = successors_[last_]; log_.variables[guess] == name) return last_ = guess;
    const auto [entry, is_new] = numbers_.try_emplace(name, log_.variables.size());
    if (is_new) {
      log_.variables.push_back(name);
      log_.backsteps.emplace_back();
      states_.emplace_back();
      successors_.push_back(entry->second);
      AXIOMETRY_TRY_VOID(look_for_test_number(name, entry->second));
    }
    successors_[last_] = entry->second;
    return last_ = entry->second;
  }

  Result<void> look_for_test_number(std::string_view name, std::size_t number) {
    if (stated_test_number_.empty() ? !is_test_number(name) : name != stated_test_number_) return {};
    if (log_.test_number)
      return fail(fmt::format("found the test numbers {} and {}, expected one; a first line '# TEST_PV=NAME' names it",
                              text::quoted(log_.variables[*log_.test_number]), text::quoted(name)),
                  {log_.lines, 1});
    log_.test_number = number;
    return {};
  }

  Result<void> take_value(const LogLine& line) {
    AXIOMETRY_TRY(const std::size_t number, variable(line.name));
    LogState& state = states_[number];
    const bool first = state.line == 0;
    connecting_ = connecting_ && first;
    const bool changed = first || state.value != line.value;
    if (number == log_.test_number && changed && !(first && is_initial(line))) {
      states_kept_ += states_.size();
      if (states_kept_ > states_most_)
        return fail(fmt::format("found {} changes of {} among {} variables, expected the log of one test; record fewer "
                                "variables",
                                log_.events.size() + 1, text::quoted(line.name), states_.size()),
                    {log_.lines, 1});
      log_.events.push_back({line.value, log_.lines, states_});
    }
    if (changed) {
      state.previous = state.value;
      state.value = line.value;
      state.line = log_.lines;
    }
    state.time = line.time;
    take_time(line, number, first);
    return {};
  }

  void take_time(const LogLine& line, std::size_t number, bool first) {
    if (line.time >= newest_) {
      newest_ = line.time;
      return;
    }
    LogBacksteps& steps = log_.backsteps[number];
    if (!first && steps.count++ == 0) steps = {1, log_.lines, line.time, newest_};
  }

  /// While camonitor connects, it prints the last value of each variable with the time at which it came up, which for
  /// a test number of long ago is older than what stands around it.
  bool is_initial(const LogLine& line) const { return newest_.empty() || (connecting_ && line.time < newest_); }

  Log log_;
  std::string_view stated_test_number_;
  std::unordered_map<std::string_view, std::size_t> numbers_;
  std::vector<LogState> states_;
  std::size_t states_kept_ = 0;          // states that all events together keep
  std::size_t states_most_ = 0;          // states that they may keep
  std::vector<std::size_t> successors_;  // for each variable the one that came after it
  std::size_t last_ = 0;
  bool connecting_ = true;   // no variable has spoken twice
  std::string_view newest_;  // time of all values so far
};

}  // namespace

std::optional<LogLine> log_line(std::string_view line) {
  // Searched by hand: this is where a log of gigabytes spends its time.
  const char* const begin = line.data();
  const char* const end = begin + line.size();
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  const char* name_end = begin;
  while (name_end < end && !is_blank(*name_end)) ++name_end;
  const char* time = name_end;
  while (time < end && is_blank(*time)) ++time;
  constexpr std::ptrdiff_t shortest_time = 19;  // YYYY-MM-DD hh:mm:ss
  if (name_end == begin || *begin == '#' || end - time <= shortest_time) return std::nullopt;
  if (time[4] != '-' || time[7] != '-' || time[10] != ' ' || time[13] != ':' || time[16] != ':') return std::nullopt;
  const char* time_end = time + shortest_time;
  while (time_end < end && !is_blank(*time_end)) ++time_end;
  const char* value = time_end;
  while (value < end && is_blank(*value)) ++value;
  const char* value_end = value;
  while (value_end < end && !is_blank(*value_end)) ++value_end;
  if (value_end == value) return std::nullopt;
  return LogLine{{begin, name_end}, {time, time_end}, {value, value_end}};
}

Result<Log> read_log(std::string_view text) { return Pass().read(text); }

std::optional<std::string> time_running_backwards(const Log& log, std::initializer_list<std::size_t> variables) {
  LogBacksteps sum;
  for (std::size_t k : variables) {
    const LogBacksteps& steps = log.backsteps[k];
    const std::size_t count = sum.count + steps.count;
    if (steps.count > 0 && (sum.count == 0 || steps.line < sum.line)) sum = steps;
    sum.count = count;
  }
  if (sum.count == 0) return std::nullopt;
  return fmt::format(
      "found time running backwards: {} with a time before that of a line above, the first on line {} ({} below {}); "
      "values were taken in the order of the log",
      counted(sum.count, "line"), sum.line, sum.time, sum.time_above);
}

}  // namespace axiometry::formats
