// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"

/// What a log of EPICS camonitor holds, in one pass over its bytes. Everything points into the text of the log.
namespace axiometry::formats {

/// What a variable last said before some moment.
struct LogState {
  std::string_view value;
  std::string_view time;      ///< "2022-04-06 12:48:22.148376"
  std::string_view previous;  ///< the last value that differed; empty when there was none
  std::size_t line = 0;       ///< line of its last change; 0 when it has said nothing yet
};

/// A change of the test number, and what all variables had said before it.
struct LogEvent {
  std::string_view code;
  std::size_t line = 0;
  std::vector<LogState> states;  ///< states by the number of the variable; later variables are missing
};

/// A line `# KEY=value`, by which a user states what a log leaves out.
struct LogDirective {
  std::string_view key;
  std::string_view value;
  TextPosition at;
};

/// Values of one variable whose time lies before that of a line above them, those aside that camonitor prints while it
/// connects.
struct LogBacksteps {
  std::size_t count = 0;
  std::size_t line = 0;         ///< line of the first
  std::string_view time;        ///< time of the first
  std::string_view time_above;  ///< the newest above it
};

struct Log {
  std::vector<std::string_view> variables;  ///< names, in the order of their appearance
  std::vector<LogBacksteps> backsteps;      ///< steps back by the number of the variable
  std::optional<std::size_t> test_number;   ///< the variable whose changes are the events
  std::vector<LogEvent> events;
  std::vector<LogDirective> directives;
  std::size_t lines = 0;
  std::size_t skipped_lines = 0;  ///< lines that are no value at a time: lost connections, messages of the shell
  std::size_t first_skipped = 0;  ///< line
};

/// One line "NAME  YYYY-MM-DD hh:mm:ss.ffffff value [severity words]".
struct LogLine {
  std::string_view name;
  std::string_view time;
  std::string_view value;
};

/// Nothing for any other line.
std::optional<LogLine> log_line(std::string_view line);

/// Reads a whole log. The events are those of the variable whose name holds "TestNumber", in any case, or which a
/// line `# TEST_PV=NAME` above its first value names. A value repeated is no event, nor is the value that camonitor
/// prints for each variable when it connects. Fails when two variables are test numbers, naming them, and when all
/// events together keep more than four million states: their memory grows with the product of events and variables.
Result<Log> read_log(std::string_view text);

/// A remark when values of one of these variables have a time before that of a line above them.
std::optional<std::string> time_running_backwards(const Log& log, std::initializer_list<std::size_t> variables);

}  // namespace axiometry::formats
