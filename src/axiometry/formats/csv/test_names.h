// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace axiometry::formats {

/// The names of tests already read and the lines they began on, exactly, in memory that does not grow
/// with a file whose tests are numbered: names that count up with the same number of lines each ("T001"
/// on line 2, "T002" on line 112, …) take one entry together. Any other name takes one of its own.
class TestNames {
 public:
  /// Remembers a name. When it was there before: the line it stood on then.
  std::optional<std::size_t> add(std::string_view name, std::size_t line);

  /// Entries held, for the proof that it stays small.
  std::size_t entry_count() const;

 private:
  /// Names first … last with the same text before the number, on evenly spaced lines.
  struct Run {
    std::uint64_t last = 0;
    std::size_t first_line = 0;
    std::size_t lines_each = 0;  // 0 while the run has one name
  };
  using Runs = std::map<std::uint64_t, Run>;  // runs by first number

  static std::optional<std::size_t> add_to(Runs& runs, std::uint64_t number, std::size_t line);

  std::map<std::string, Runs, std::less<>> numbered_;  // runs by the text before the number and the digits' width
  std::unordered_map<std::string, std::size_t> others_;
};

}  // namespace axiometry::formats
