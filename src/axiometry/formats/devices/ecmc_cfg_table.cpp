// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/devices/ecmc_cfg_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>
#include <span>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/moment.h"
#include "axiometry/formats/series/approaches.h"
#include "axiometry/formats/text/text_lines.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace {

using Names = std::span<const std::string_view>;

// Newer versions of the tool call the readings before its own gain and offset raw; only these are measured.
constexpr std::string_view error_names[] = {"raw ref err", "raw ref error", "ref err", "ref error"};
constexpr std::string_view mean_names[] = {"raw ref mean", "raw reference mean", "ref mean", "reference mean"};

std::optional<std::size_t> find_column(const std::vector<CsvCell>& header, std::string_view name) {
  const auto column = std::ranges::find_if(header, [&](const CsvCell& cell) { return plain_name(cell.text) == name; });
  if (column == header.end()) return std::nullopt;
  return static_cast<std::size_t>(column - header.begin());
}

/// The first of the names that is a column.
std::optional<std::size_t> find_column(const std::vector<CsvCell>& header, Names names) {
  for (std::string_view name : names)
    if (const auto column = find_column(header, name)) return column;
  return std::nullopt;
}

struct Columns {
  std::size_t cycle = 0;
  std::size_t direction = 0;
  std::size_t target = 0;
  std::size_t error = 0;
  std::optional<std::size_t> mean;
  std::optional<std::size_t> time;
  std::optional<std::size_t> reference;
  std::size_t needed = 0;  ///< number of cells up to the last of the first four
};

Result<Columns> columns_of(const CfgRow& header) {
  const auto cycle = find_column(header.cells, "cycle");
  const auto direction = find_column(header.cells, "direction");
  const auto target = find_column(header.cells, "target");
  const auto error = find_column(header.cells, error_names);
  if (!cycle || !direction || !target || !error)
    return fail("found a table without one of cycle, direction, target and ref_error, expected them all",
                {header.line, 1});
  return Columns{.cycle = *cycle,
                 .direction = *direction,
                 .target = *target,
                 .error = *error,
                 .mean = find_column(header.cells, mean_names),
                 .time = find_column(header.cells, "timestamp"),
                 .reference = find_column(header.cells, "selected reference pv"),
                 .needed = std::max({*cycle, *direction, *target, *error}) + 1};
}

/// Half a unit of the last digit that a number shows. One without a decimal mark is exact: targets are often whole, and
/// nobody rounds to millimetres.
double half_digit(std::string_view number) {
  const std::size_t point = number.find_first_of(".,");
  if (number.find_first_of("eE") != std::string_view::npos) return 0.0;
  if (point == std::string_view::npos) return 0.0;
  return 0.5 * std::pow(10.0, -static_cast<double>(number.size() - point - 1));
}

class Rows {
 public:
  Rows(const CfgTable& table, Columns columns) : table_(table), columns_(columns) {}

  Result<void> take(const CfgRow& row) {
    if (row.cells.size() < columns_.needed)
      return fail(fmt::format("found {}, expected {} as in the header on line {}", counted(row.cells.size(), "field"),
                              table_.header.cells.size(), table_.header.line),
                  {row.line, row.cells.empty() ? 1 : row.cells.back().column});
    const CsvCell& direction_cell = row.cells[columns_.direction];
    const auto direction = direction_from(direction_cell.text);
    if (!direction)
      return fail(fmt::format("found {}, expected the direction forward or reverse", text::quoted(direction_cell.text)),
                  {row.line, direction_cell.column});
    ListedReading approach{.direction = *direction, .at = {row.line, row.cells[columns_.error].column}};
    AXIOMETRY_TRY(const double target, number(row, columns_.target));
    AXIOMETRY_TRY(approach.run,
                  run_number(row.cells[columns_.cycle].text, {row.line, row.cells[columns_.cycle].column}));
    if (is_missing(row.cells[columns_.error].text)) return {};
    AXIOMETRY_TRY(const double error, number(row, columns_.error));
    const ReadingRule rule{Measured::deviation, find_unit("mm")};
    approach.target = Position::native(target);
    AXIOMETRY_TRY(const double deviation, placed(native_deviation(rule, approach.target, error), approach.at));
    approach.deviation = Deviation::native(deviation);
    take_time(row, approach);
    take_reference(row);
    AXIOMETRY_TRY_VOID(compare_with_mean(row, target, error));
    approaches_.push_back(approach);
    return {};
  }

  Result<Test> test() {
    if (approaches_.empty())
      return fail(
          fmt::format("found no readings below the header on line {}, expected one per row", table_.header.line));
    AXIOMETRY_TRY(GatheredSeries result, gathered(approaches_));
    Test test{Metadata{}, std::move(result.series), Provenance{}};
    test.times_s = std::move(result.times_s);
    test.metadata.conditions.date = date_;
    auto& remarks = test.provenance.remarks;
    remarks.push_back({false, "found lengths without a unit; they were taken in mm"});
    if (references_.size() == 1) test.metadata.conditions.comment = fmt::format("Reference {}", *references_.begin());
    if (references_.size() > 1)
      remarks.push_back({false, fmt::format("found readings of {} references ({}); each was taken as its row says",
                                            references_.size(), named_references())});
    if (largest_difference_ > 0.0)
      remarks.push_back({false, fmt::format("found errors of the reference that differ from its mean minus the target "
                                            "by up to {:.4g} mm; the errors were taken",
                                            largest_difference_)});
    if (result.remark) remarks.push_back(*std::move(result.remark));
    return test;
  }

 private:
  Result<double> number(const CfgRow& row, std::size_t column) {
    return numbers_.read(row.cells[column].text, {row.line, row.cells[column].column});
  }

  static const CsvCell* cell_at(const CfgRow& row, std::optional<std::size_t> column) {
    return column && *column < row.cells.size() ? &row.cells[*column] : nullptr;
  }

  void take_time(const CfgRow& row, ListedReading& approach) {
    const CsvCell* cell = cell_at(row, columns_.time);
    const auto time_s = cell == nullptr ? std::nullopt : time_stamp_s(cell->text);
    if (!time_s) return;
    approach.time_s = *time_s;
    const std::string date = cell->text.substr(0, 10);
    if (date_.empty() || date < date_) date_ = date;
  }

  void take_reference(const CfgRow& row) {
    const CsvCell* cell = cell_at(row, columns_.reference);
    if (cell == nullptr || cell->text.empty()) return;
    references_.insert(cell->text);
  }

  std::string named_references() const {
    constexpr std::size_t named_at_most = 5;
    auto end = references_.begin();
    std::advance(end, std::min(references_.size(), named_at_most));
    return fmt::format("{}{}", fmt::join(references_.begin(), end, ", "), end == references_.end() ? "" : ", …");
  }

  /// Both are in the file; that they agree to the digits shown proves that the columns mean what they are taken for.
  Result<void> compare_with_mean(const CfgRow& row, double target, double error) {
    const CsvCell* cell = cell_at(row, columns_.mean);
    if (cell == nullptr || is_missing(cell->text)) return {};
    AXIOMETRY_TRY(const double mean, number(row, *columns_.mean));
    const double rounding = half_digit(cell->text) + half_digit(row.cells[columns_.target].text) +
                            half_digit(row.cells[columns_.error].text) + 1e-12 * (std::abs(mean) + std::abs(target));
    const double difference = std::abs(mean - target - error);
    if (difference > rounding) largest_difference_ = std::max(largest_difference_, difference);
    return {};
  }

  const CfgTable& table_;
  Columns columns_;
  NumberReader numbers_{','};
  std::vector<ListedReading> approaches_;
  std::set<std::string> references_;
  std::string date_;
  double largest_difference_ = 0.0;
};

}  // namespace

bool is_cfg_header(const std::vector<CsvCell>& header) {
  return find_column(header, "cycle") && find_column(header, "direction") && find_column(header, "target") &&
         find_column(header, error_names);
}

Result<Test> cfg_test(const CfgTable& table) {
  AXIOMETRY_TRY(const Columns columns, columns_of(table.header));
  Rows rows(table, columns);
  for (const CfgRow& row : table.rows) AXIOMETRY_TRY_VOID(rows.take(row));
  return rows.test();
}

}  // namespace axiometry::formats
