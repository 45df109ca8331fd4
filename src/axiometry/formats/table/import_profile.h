// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/text/units.h"
#include "axiometry/model/series.h"

/// How a table of numbers that no format describes is to be read: every decision that such a file leaves open, as a
/// value that people can read, change and keep (docs/howto/import-any-file.md).
namespace axiometry::formats {

inline constexpr std::string_view profile_format_name = "axiometry-import-profile/1";

enum class TextEncoding { automatic, utf8, utf16, gbk, windows_1252, latin1 };
enum class Delimiter { comma, semicolon, tab, blanks };

enum class TableLayout {
  long_rows,   ///< one reading per row, or one per direction
  wide,        ///< one column per run, one row per target
  transposed,  ///< one row per run; the targets stand across, in the header
};

enum class ImportRole {
  ignore,
  target,
  deviation,  ///< actual minus target, times the profile's sign
  position,   ///< measured position, times the profile's sign
  direction,  ///< direction of approach, in words or as +1 and −1
  run,        ///< number of the run
  time,       ///< seconds, or clock times
  label,      ///< name of a row of a transposed table: run, direction or both, as "Run 2 up"
};

enum class DirectionRule {
  column,      ///< a column says it
  names,       ///< names of columns, or labels of rows, say it
  motion,      ///< the sign of the step from the target before; rows stand in the order of the measurement
  visits,      ///< visits to a target (transposed: rows) alternate between the directions
  run_parity,  ///< runs are counted one way each: the first, third, … go in one direction, the others back
  up,          ///< all approaches are ↑
  down,        ///< all approaches are ↓
};

enum class RunRule {
  column,      ///< a column, or the label of a row, says it
  names,       ///< names of columns say it
  repetition,  ///< approaches to a target from one direction count themselves in the order of the rows
};

struct ImportColumn {
  ImportRole role = ImportRole::ignore;
  std::string name{};                    ///< its name in the header; empty: not compared
  const Unit* unit = nullptr;            ///< unit of its readings; null: the profile's reading_unit
  std::optional<Direction> direction{};  ///< direction in which all its readings were taken
  std::optional<std::size_t> run{};      ///< run in which all its readings were taken, from 1
};

/// What is null or nothing here has not been decided; reading then fails, naming the member that decides it.
struct ImportProfile {
  TextEncoding encoding = TextEncoding::automatic;
  Delimiter delimiter = Delimiter::comma;
  /// '.' or ','. Where the delimiter is a comma as well, every number without quotes has a comma of its own: "0,5,1,25"
  /// are two.
  char decimal_mark = '.';
  std::string comment = "#";     ///< lines that begin with it are passed over; empty: none are
  std::size_t skip_lines = 0;    ///< how many lines are passed over before anything is looked at
  std::size_t header_lines = 1;  ///< lines from the names of the columns (transposed: the targets) on; 0: no header
  std::string end{};             ///< a line that begins with it ends the table; empty: the file does
  TableLayout layout = TableLayout::long_rows;
  /// From left to right. In a transposed table the last one stands for all that follow.
  std::vector<ImportColumn> columns{};
  const Unit* target_unit = nullptr;
  const Unit* reading_unit = nullptr;
  std::optional<DirectionRule> direction{};
  Direction first_direction = Direction::up;  ///< direction that comes first under the rules visits and run_parity
  std::vector<std::string> up_words{};        ///< words for ↑ beside those that every file may use
  std::vector<std::string> down_words{};
  RunRule runs = RunRule::repetition;
  std::size_t first_run = 1;  ///< number of the first run in a column: 0 or 1
  double sign = 1.0;          ///< 1 or −1
};

/// Ends with a line break; read_profile(write_profile(p)) gives p. What has not been decided is null.
std::string write_profile(const ImportProfile& profile);
/// The same as an object.
json::Value profile_to_json(const ImportProfile& profile);

/// Fails, with line and column, on what is no JSON, on members that are unknown or of another kind, and on columns that
/// make no table: no target (but in a transposed one), no reading, a role twice that may stand once. A null is "not
/// decided".
Result<ImportProfile> read_profile(std::string_view bytes);

/// JSON Schema of the above, with a line break at its end.
std::string profile_schema();

/// The words of the JSON format: "comma", "run-parity", "deviation".
std::string_view word_of(TextEncoding encoding);
std::string_view word_of(Delimiter delimiter);
std::string_view word_of(TableLayout layout);
std::string_view word_of(ImportRole role);
std::string_view word_of(DirectionRule rule);
std::string_view word_of(RunRule rule);

}  // namespace axiometry::formats
