// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/csv/csv_preamble.h"
#include "axiometry/formats/csv/row_memory.h"
#include "axiometry/formats/csv/test_names.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/series/target_index.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/thousands.h"

namespace axiometry::formats {

/// Column numbers of a long CSV file: one reading per row.
struct LongLayout {
  std::size_t target = 0;
  std::size_t direction = 0;
  std::optional<std::size_t> run;  ///< absent: approaches to a target count themselves in the order of the rows
  std::size_t reading = 0;
  std::optional<std::size_t> test;  ///< names the test when the file holds many
  const Unit* target_unit = nullptr;
  std::optional<std::size_t> beside;  ///< measured position beside a deviation: not read, only compared with it
  ReadingRule rule;
  ReadingRule rule_beside;
  AxisKind kind = AxisKind::linear;
};

/// The layout of a header; checks columns and units, adding those stated for the whole file.
Result<LongLayout> long_layout(Preamble& preamble);

/// Reads the rows below the header, one test after the other, in bounded memory. Plain rows (plain numbers,
/// labels met before, no quotes) are read byte by byte, and those whose beginning repeats the test before by
/// comparison; all others cell by cell. All must agree; csv_long_rows_test.cpp feeds them the same text.
class LongRows {
 public:
  enum class Path { fast, general_only };  ///< general_only is the oracle of the tests

  LongRows(Preamble preamble, LongLayout layout, NamedTestSink sink, Path path = Path::fast);

  /// Whole lines; the last one may lack its line break only at the end of the file. Bytes up to
  /// `readable_end` may be looked at.
  Result<void> take(std::string_view lines, const char* readable_end);

  /// After the last line.
  Result<void> finish();

  /// What was found in the tests so far and not acted upon.
  const std::vector<SourceRemark>& remarks() const { return remarks_; }

 private:
  /// Deviations beside measured positions, in native units.
  struct Comparison {
    std::size_t count = 0;
    double apart = 0.0;     // largest difference from measured minus target
    double mirrored = 0.0;  // largest difference from target minus measured
    double largest = 0.0;   // deviation
    double last_digits = 0.0;
  };

  struct RowReading {
    double deviation;
    std::size_t line;
    std::uint32_t target;
    std::uint16_t run;  // number of the run, from 0
    std::uint8_t direction;
  };

  /// A direction as it is written in this file, so that plain rows need no search among the words.
  struct Label {
    std::uint64_t bytes = 0;
    std::uint64_t mask = 0;
    std::size_t size = 0;  // 0 until it was met
  };

  const char* plain_row(const char* p, const char* readable_end);
  const char* repeated_row(const char* p, const char* readable_end);
  const char* plain_cell(const char* p, ColumnRole role, int mark, PlainRow& row) const;
  int mark() const;
  bool doubts_thousands() const;
  bool add_plain(const PlainRow& row);
  Result<void> general_row(std::string_view line);
  Result<void> comment_row(std::string_view line);
  Result<void> enter_test(std::string_view name, TextPosition at);
  Result<void> add_cells(const std::vector<CsvCell>& cells);
  Result<std::uint16_t> run_of(const std::vector<CsvCell>& cells, const RowReading& row);
  std::size_t& approaches_to(const RowReading& row);
  Result<Direction> direction_of(const CsvCell& cell);
  void compare_with_position(const std::vector<CsvCell>& cells, Position target, double deviation);
  Result<void> check_comparison(TextPosition at);
  Result<void> check_positions(TextPosition at) const;
  void remark_swapped_labels();
  Result<void> end_test();
  Result<std::vector<double>> dense(std::size_t runs);
  std::unexpected<Error> second_reading(const RowReading& row) const;

  Preamble preamble_;
  LongLayout layout_;
  NamedTestSink sink_;
  Path path_;
  NumberReader numbers_;
  ThousandsDoubt thousands_{2};  // of targets and readings
  std::size_t rows_doubted_ = 0;
  std::optional<Metadata> metadata_;  // read when the first test ends: then the decimal mark is known
  bool native_targets_;
  bool native_readings_;
  std::array<Label, 2> labels_;
  std::vector<ColumnRole> roles_;  // the role of each column
  bool rows_repeat_;               // the test comes first and the reading last, so that what is between may repeat
  RowMemory memory_;

  std::size_t line_;  // line of the row at hand
  bool in_test_ = false;
  std::string test_name_;
  std::string row_begin_;  // beginning of every plain row of the test: its name and a delimiter
  std::size_t test_line_ = 0;
  TestNames names_;
  TargetIndex targets_;
  std::vector<RowReading> readings_;
  Comparison comparison_;
  std::vector<SourceRemark> told_;  // of every test
  std::vector<SourceRemark> remarks_;
  std::vector<std::size_t> approaches_;  // approaches so far by target and direction, where no column states the run
};

}  // namespace axiometry::formats
