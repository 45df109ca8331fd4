// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/ranges_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <span>
#include <unordered_map>

#include "axiometry/base/number_text.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/table_heads.h"

namespace axiometry::formats {
namespace {

enum Role : std::size_t { role_point, role_station, role_segment, role_length, role_x, role_y, role_z, role_count };
constexpr std::array<std::string_view, role_count> canonical = {"point", "station", "segment", "length_mm",
                                                                "x_mm",  "y_mm",    "z_mm"};
struct Word {
  std::string_view word;
  Role role;
};
constexpr Word words[] = {{"point", role_point},
                          {"p", role_point},
                          {"point id", role_point},
                          {"station", role_station},
                          {"s", role_station},
                          {"station id", role_station},
                          {"tracker", role_station},
                          {"segment", role_segment},
                          {"beam", role_segment},
                          {"length", role_length},
                          {"range", role_length},
                          {"distance", role_length},
                          {"l", role_length},
                          {"x", role_x},
                          {"y", role_y},
                          {"z", role_z}};
constexpr bool is_text(std::size_t role) { return role <= role_segment; }

struct Columns {
  std::array<std::optional<std::size_t>, role_count> at;
  std::array<const Unit*, role_count> unit{};
  std::size_t count = 0;
  std::size_t needed = 0;  ///< up to the last one that is read
  std::size_t line = 0;
  char delimiter = ',';
  std::vector<std::string> passed_over;

  bool has(std::size_t role) const { return at[role].has_value(); }
};

/// Those of `needed` must be there.
Result<Columns> columns_of(std::string_view text, std::size_t line, std::span<const Role> needed) {
  Columns columns;
  columns.line = line;
  columns.delimiter = delimiter_of(text);
  AXIOMETRY_TRY(const std::vector<CsvCell> heads, split_row(text, columns.delimiter, line));
  columns.count = heads.size();
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const TableHead named = table_head(heads[k].text);
    const auto word = std::ranges::find(words, named.name, &Word::word);
    if (word == std::end(words)) {
      if (!heads[k].text.empty()) columns.passed_over.push_back(heads[k].text);
      continue;
    }
    if (columns.has(word->role))
      return fail(fmt::format("found {} a second time, expected one column of it", text::quoted(heads[k].text)),
                  {line, heads[k].column});
    columns.at[word->role] = k;
    columns.needed = k + 1;
    if (!is_text(word->role)) {
      AXIOMETRY_TRY(columns.unit[word->role], length_unit(heads[k], named, canonical[word->role], line));
    }
  }
  std::vector<std::string_view> names;
  for (Role role : needed) names.push_back(canonical[role]);
  for (Role role : needed)
    if (!columns.has(role))
      return fail(fmt::format("found no column {}, expected a header with {}", canonical[role], fmt::join(names, ", ")),
                  {line, 1});
  const std::size_t coordinates = columns.has(role_x) + columns.has(role_y) + columns.has(role_z);
  if (coordinates != 0 && coordinates != 3)
    return fail(fmt::format("found {} of the columns x_mm, y_mm, z_mm, expected all of them or none", coordinates),
                {line, 1});
  return columns;
}

/// The cells of a row; without quotes they are parts of the line, and nothing is copied.
class Row {
 public:
  explicit Row(const Columns& columns) : columns_(columns) {}

  Result<void> take(std::string_view line, std::size_t number, bool has_break) {
    line_ = line;
    number_ = number;
    if (line.find('"') != std::string_view::npos) return take_quoted(line, has_break);
    cells_.clear();
    for (std::size_t begin = 0;;) {
      const std::size_t end = std::min(line.find(columns_.delimiter, begin), line.size());
      cells_.push_back({text::trim(line.substr(begin, end - begin)), begin + 1});
      if (end == line.size()) break;
      begin = end + 1;
      if (cells_.size() == read_budget::row_cells) return fail_row_cells({number, begin + 1});
    }
    return check(has_break);
  }
  std::string_view cell(std::size_t role) const { return cells_[*columns_.at[role]].text; }
  TextPosition at(std::size_t role) const {
    const Cell& cell = cells_[*columns_.at[role]];
    const bool inside = cell.text.data() >= line_.data() && cell.text.data() <= line_.data() + line_.size();
    return {number_,
            inside && !cell.text.empty() ? static_cast<std::size_t>(cell.text.data() - line_.data()) + 1 : cell.column};
  }
  std::size_t number() const { return number_; }

 private:
  struct Cell {
    std::string_view text;
    std::size_t column = 1;
  };

  Result<void> take_quoted(std::string_view line, bool has_break) {
    AXIOMETRY_TRY(quoted_, split_row(line, columns_.delimiter, number_));
    cells_.clear();
    for (const CsvCell& cell : quoted_) cells_.push_back({cell.text, cell.column});
    return check(has_break);
  }
  Result<void> check(bool has_break) const {
    if (cells_.size() == columns_.count) return {};
    std::vector<CsvCell> cells;
    for (const Cell& cell : cells_) cells.push_back({std::string(cell.text), cell.column});
    return check_cell_count(cells,
                            {columns_.count, columns_.needed, columns_.line, number_, columns_.delimiter, !has_break});
  }

  const Columns& columns_;
  std::string_view line_;
  std::size_t number_ = 0;
  std::vector<Cell> cells_;
  std::vector<CsvCell> quoted_;
};

/// Numbers for names, in the order in which they come first. Names often come again at once or in the order before.
class Names {
 public:
  std::size_t number(std::string_view name) {
    for (const std::size_t guess : {last_, last_ + 1})
      if (guess < names_.size() && names_[guess] == name) return last_ = guess;
    const auto found = numbers_.find(name);
    if (found != numbers_.end()) return last_ = found->second;
    numbers_.emplace(name, names_.size());
    names_.emplace_back(name);
    return last_ = names_.size() - 1;
  }
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

class Cells {
 public:
  explicit Cells(const Columns& columns) : columns_(columns) {}

  Result<std::string_view> name(const Row& row, std::size_t role) const {
    const std::string_view name = row.cell(role);
    if (!name.empty()) return name;
    return fail(fmt::format("found no {}, expected its name or number", canonical[role]), row.at(role));
  }
  Result<double> length(const Row& row, std::size_t role) {
    const std::string_view cell = row.cell(role);
    double value = 0.0;
    if (!numbers_) numbers_.emplace(columns_.delimiter);  // the header has been read by now
    const auto plain = numbers_->mark() == '.' ? parse_number(cell) : std::nullopt;
    if (plain) {
      value = *plain;
    } else {
      AXIOMETRY_TRY(value, numbers_->read(cell, row.at(role)));
    }
    return length_in_mm(*columns_.unit[role], value, cell, row.at(role));
  }
  Result<Vector3> place(const Row& row) {
    Vector3 at;
    AXIOMETRY_TRY(at.x, length(row, role_x));
    AXIOMETRY_TRY(at.y, length(row, role_y));
    AXIOMETRY_TRY(at.z, length(row, role_z));
    return at;
  }

 private:
  const Columns& columns_;
  std::optional<NumberReader> numbers_;
};

/// Calls take(row) for every row below the header.
template <typename Take>
Result<void> for_rows(std::string_view text, Columns& columns, std::span<const Role> needed, const Take& take) {
  Row row(columns);
  AXIOMETRY_TRY_VOID(for_table_lines(text, [&](const TableLine& line) -> Result<void> {
    if (line.content.starts_with('#')) return {};
    if (columns.count == 0) {
      AXIOMETRY_TRY(columns, columns_of(line.text, line.number, needed));
      return {};
    }
    AXIOMETRY_TRY_VOID(row.take(line.text, line.number, line.has_break));
    return take(row);
  }));
  if (columns.count != 0) return {};
  return fail("found no header, expected one as point,station,length_mm");
}

std::string place_text(Vector3 p) {
  return fmt::format("({}, {}, {})", format_exact(p.x), format_exact(p.y), format_exact(p.z));
}

/// Reads rows into a RangesFile.
class RangesReader {
 public:
  Result<RangesFile> read(std::string_view text) {
    constexpr Role needed[] = {role_point, role_station, role_length};
    AXIOMETRY_TRY_VOID(for_rows(text, columns_, needed, [&](const Row& row) { return add(row); }));
    if (file_.readings.empty()) return fail("found a header and no lengths below it, expected one in each row");
    file_.points = points_.take();
    file_.stations = stations_.take();
    for (Names& names : segments_) file_.segments.push_back(names.take());
    if (!columns_.passed_over.empty()) file_.remarks.push_back(passed_over(columns_.passed_over));
    if (missing_ > 0)
      file_.remarks.push_back(fmt::format("passed over {} row{} without a length", missing_, missing_ == 1 ? "" : "s"));
    return std::move(file_);
  }

 private:
  Result<void> add(const Row& row) {
    AXIOMETRY_TRY(const std::string_view point, cells_.name(row, role_point));
    AXIOMETRY_TRY(const std::string_view station, cells_.name(row, role_station));
    if (is_missing(row.cell(role_length))) {
      ++missing_;
      return {};
    }
    RangeReading reading;
    AXIOMETRY_TRY(reading.length_mm, cells_.length(row, role_length));
    const std::size_t points_before = points_.size();
    reading.point = points_.number(point);
    reading.station = stations_.number(station);
    if (reading.station == segments_.size()) segments_.emplace_back();
    reading.segment =
        segments_[reading.station].number(columns_.has(role_segment) ? row.cell(role_segment) : std::string_view());
    const bool is_new = points_.size() > points_before;
    if (is_new) file_.lines.push_back(row.number());
    if (columns_.has(role_x)) AXIOMETRY_TRY_VOID(add_place(row, reading.point, is_new));
    file_.readings.push_back(reading);
    file_.reading_lines.push_back(row.number());
    return {};
  }

  Result<void> add_place(const Row& row, std::size_t point, bool is_new) {
    AXIOMETRY_TRY(const Vector3 at, cells_.place(row));
    if (is_new) {
      file_.nominal_mm.push_back(at);
      return {};
    }
    if (file_.nominal_mm[point] == at) return {};
    return fail(fmt::format("found point {} at {}, expected {} as on line {}: nominal places do not change",
                            points_[point], place_text(at), place_text(file_.nominal_mm[point]), file_.lines[point]),
                row.at(role_x));
  }

  Columns columns_;
  Cells cells_{columns_};
  Names points_, stations_;
  std::vector<Names> segments_;
  std::size_t missing_ = 0;
  RangesFile file_;
};

}  // namespace

Result<RangesFile> read_ranges(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(RangesFile file, RangesReader().read(decoded.text));
  for (const SourceRemark& remark : encoding_remarks(decoded)) file.remarks.push_back(remark.message);
  return file;
}

Result<NamedPoints> read_named_points(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  constexpr Role needed[] = {role_point, role_x, role_y, role_z};
  Columns columns;
  Cells cells(columns);
  Names names;
  NamedPoints points;
  std::vector<std::size_t> lines;
  AXIOMETRY_TRY_VOID(for_rows(decoded.text, columns, needed, [&](const Row& row) -> Result<void> {
    AXIOMETRY_TRY(const std::string_view name, cells.name(row, role_point));
    const std::size_t k = names.number(name);
    if (k < lines.size())
      return fail(fmt::format("found point {} a second time, expected it once as on line {}", name, lines[k]),
                  row.at(role_point));
    lines.push_back(row.number());
    AXIOMETRY_TRY(points.at_mm.emplace_back(), cells.place(row));
    return {};
  }));
  if (points.at_mm.empty()) return fail("found a header and no points below it, expected one in each row");
  points.names = names.take();
  if (!columns.passed_over.empty()) points.remarks.push_back(passed_over(columns.passed_over));
  for (const SourceRemark& remark : encoding_remarks(decoded)) points.remarks.push_back(remark.message);
  return points;
}

}  // namespace axiometry::formats
