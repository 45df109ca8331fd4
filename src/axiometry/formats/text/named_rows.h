// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "axiometry/base/reading_limits.h"
#include "axiometry/base/result.h"
#include "axiometry/base/vector3.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/units.h"

/// Tables whose columns have names, in any order, with units in the heads of lengths and angles: what lengths of
/// several stations are written in. A role is the number of a column's meaning. Without quotes the cells of a row are
/// parts of its line, and nothing is copied.
namespace axiometry::formats {

struct ColumnWord {
  std::string_view word;  ///< as table_head() has it
  std::size_t role = 0;
};

struct TableWords {
  std::span<const std::string_view> canonical;  ///< name per role: "x_mm"
  std::span<const ColumnWord> words;
  std::size_t texts = 0;                              ///< roles before this are names, the others lengths
  std::size_t angles = static_cast<std::size_t>(-1);  ///< but from this on angles
};

struct NamedColumns {
  std::vector<std::optional<std::size_t>> at;  ///< column per role
  std::vector<const Unit*> unit;               ///< unit per role
  std::size_t count = 0;
  std::size_t needed = 0;  ///< cells up to the last one that is read
  std::size_t line = 0;
  char delimiter = ',';
  std::vector<std::string> passed_over;
  bool simulated = false;  ///< a comment says that nobody measured what stands below (simulated_note.h)

  bool has(std::size_t role) const { return at[role].has_value(); }
};

/// Fails where a role of `required` has no column, one has two, or a length or an angle has no unit of its kind.
Result<NamedColumns> named_columns(std::string_view text, std::size_t line, const TableWords& words,
                                   std::span<const std::size_t> required);

class NamedRow {
 public:
  explicit NamedRow(const NamedColumns& columns) : columns_(columns) {}

  /// Fails on broken quotes and on more or fewer cells than the header.
  Result<void> take(std::string_view line, std::size_t number, bool has_break);
  std::string_view cell(std::size_t role) const { return cells_[*columns_.at[role]].text; }
  TextPosition at(std::size_t role) const;
  std::size_t number() const { return number_; }

 private:
  struct Cell {
    std::string_view text;
    std::size_t column = 1;
  };
  Result<void> take_quoted(std::string_view line, bool has_break);
  Result<void> check(bool has_break) const;

  const NamedColumns& columns_;
  std::string_view line_;
  std::size_t number_ = 0;
  std::vector<Cell> cells_;
  std::vector<CsvCell> quoted_;
};

/// Numbers for names, in the order in which they come first. Names often come again at once or in the order before.
class NameNumbers {
 public:
  std::size_t number(std::string_view name);
  std::size_t size() const { return names_.size(); }
  std::vector<std::string> take() { return std::move(names_); }
  const std::string& operator[](std::size_t k) const { return names_[k]; }

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view s) const { return std::hash<std::string_view>{}(s); }
  };
  std::unordered_map<std::string, std::size_t, Hash, std::equal_to<>> numbers_;
  std::vector<std::string> names_;
  std::size_t last_ = 0;
};

/// What the cells of a row say.
class NamedCells {
 public:
  NamedCells(const NamedColumns& columns, const TableWords& words) : columns_(columns), words_(words) {}

  /// Fails where there is none.
  Result<std::string_view> name(const NamedRow& row, std::size_t role) const;
  /// In mm. Fails on anything but a finite number up to largest_stated.
  Result<double> length(const NamedRow& row, std::size_t role);
  /// In °. Likewise, up to 1e9°.
  Result<double> angle(const NamedRow& row, std::size_t role);
  /// Three lengths of neighbouring roles.
  Result<Vector3> place(const NamedRow& row, std::size_t first_role);

 private:
  Result<double> number(const NamedRow& row, std::size_t role);

  const NamedColumns& columns_;
  const TableWords& words_;
  std::optional<NumberReader> numbers_;
};

/// Calls take(row) for every row below the header, which is put into `columns`; lines that begin with # are comments.
/// Fails as `take` does and where there is no header, showing `example`.
Result<void> for_named_rows(std::string_view text, NamedColumns& columns, const TableWords& words,
                            std::span<const std::size_t> required, std::string_view example,
                            const std::function<Result<void>(const NamedRow&)>& take);

}  // namespace axiometry::formats
