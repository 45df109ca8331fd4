// SPDX-License-Identifier: Apache-2.0
//
// Reading after a profile: rows to readings, then directions and runs by the profile's rules, then the series.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "axiometry/base/counted.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/series/approaches.h"
#include "axiometry/formats/series/series_order.h"
#include "axiometry/formats/series/sweep_directions.h"
#include "axiometry/formats/series/target_index.h"
#include "axiometry/formats/table/generic_delimited.h"
#include "axiometry/formats/table/generic_table.h"
#include "axiometry/formats/text/head_words.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/model/swapped_labels.h"

namespace axiometry::formats {
namespace {

using namespace generic;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// One cell with a reading, or the place of a missing one: it counts as an approach all the same.
struct Entry {
  std::uint32_t target = 0;            ///< number in order of appearance
  std::optional<Direction> direction;  ///< where column, name or label say it
  std::optional<std::size_t> run;      ///< from 1, likewise
  double deviation = none;             ///< native units
  double time_s = none;
  std::size_t row = 0;  ///< index among the rows
  TextPosition at;
};

Result<void> check_decided(const ImportProfile& p) {
  const auto open = [](std::string_view member, std::string_view question) {
    return fail(fmt::format("found no {} in the profile, expected {}", member, question));
  };
  if (p.columns.empty()) return open("columns", "the roles of the columns");
  if (p.target_unit == nullptr) return open("target_unit", "the unit of the targets");
  const bool every_unit = std::ranges::all_of(p.columns, [](const ImportColumn& c) {
    return (c.role != ImportRole::deviation && c.role != ImportRole::position) || c.unit != nullptr;
  });
  if (p.reading_unit == nullptr && !every_unit) return open("reading_unit", "the unit of the readings");
  if (!p.direction) return open("direction", "where the direction of approach comes from");
  const auto has = [&](ImportRole role) {
    return std::ranges::find(p.columns, role, &ImportColumn::role) != p.columns.end();
  };
  if (*p.direction == DirectionRule::column && !has(ImportRole::direction))
    return fail("found direction by column in the profile, expected a column of the role direction");
  const bool run_needed = p.runs == RunRule::column || *p.direction == DirectionRule::run_parity;
  const bool by_label = p.layout == TableLayout::transposed && has(ImportRole::label);
  if (run_needed && p.runs != RunRule::names && !has(ImportRole::run) && !by_label)
    return fail("found runs by column in the profile, expected a column of the role run");
  if (*p.direction == DirectionRule::motion && p.layout == TableLayout::transposed)
    return fail("found direction by motion in a transposed table, expected another rule: its rows hold whole runs");
  return {};
}

class TableReader {
 public:
  TableReader(const ImportProfile& profile, const TableRegion& region) : profile_(profile), region_(region) {}

  Result<void> read_rows() {
    AXIOMETRY_TRY_VOID(read_header());
    for (const PlainLine& line : region_.rows) {
      AXIOMETRY_TRY(const std::vector<CsvCell> cells, cells_of(line, row_rule(profile_)));
      if (std::ranges::all_of(cells, [](const CsvCell& c) { return c.text.empty(); })) continue;
      AXIOMETRY_TRY_VOID(check_count(cells, line.number));
      AXIOMETRY_TRY_VOID(read_row(cells, line.number));
      ++row_count_;
    }
    if (entries_.empty())
      return fail("found no rows of the table, expected readings",
                  {region_.header.empty() ? 1 : region_.header.front().number, 1});
    return {};
  }

  Result<void> settle() {
    turn_newest_first();
    AXIOMETRY_TRY_VOID(settle_directions());
    return settle_runs();
  }

  Result<Test> test() {
    const TextPosition at{region_.rows.front().number, 0};
    std::vector<ListedReading> approaches;
    std::vector<bool> measured(targets_.targets().size(), false);
    for (const Entry& e : entries_) {
      if (std::isnan(e.deviation)) continue;
      measured[e.target] = true;
      approaches.push_back({Position::native(targets_.targets()[e.target]), *e.direction, *e.run,
                            Deviation::native(e.deviation), e.time_s, e.at});
    }
    for (std::size_t k = 0; k < measured.size(); ++k)
      if (!measured[k])
        return fail(
            fmt::format("found no reading at target {}, expected at least one", format_exact(targets_.targets()[k])),
            at);
    AXIOMETRY_TRY(GatheredSeries gathered_series, placed(gathered(approaches), at));
    if (!measured_)
      AXIOMETRY_TRY_VOID(placed(check_deviations(gathered_series.series, profile_.target_unit->kind), at));
    Test test{{}, std::move(gathered_series.series), {}};
    test.times_s = std::move(gathered_series.times_s);
    if (gathered_series.remark) test.provenance.remarks.push_back(*std::move(gathered_series.remark));
    return test;
  }

  std::optional<SourceRemark> turned() const {
    if (!turned_) return std::nullopt;
    return SourceRemark{false, "the rows of the table begin with the newest reading and were turned round"};
  }

  /// Labels ↑ and ↓ against the way the targets run.
  std::optional<SourceRemark> swapped_labels() {
    if (*profile_.direction != DirectionRule::column || profile_.layout == TableLayout::transposed) return std::nullopt;
    const Motion motion = motion_by_rows();
    if (!motion.is_sweeps || !motion.has_up || !motion.has_down) return std::nullopt;
    constexpr double most = 0.9;
    const auto against = static_cast<double>(
        std::ranges::count_if(entries_, [&](const Entry& e) { return *e.direction != motion.directions[e.row]; }));
    if (against < most * static_cast<double>(entries_.size())) return std::nullopt;
    return swapped_labels_remark();
  }

 private:
  Result<void> read_header() {
    if (profile_.layout != TableLayout::transposed) {
      width_ = profile_.columns.size();
      return {};
    }
    if (region_.header.empty()) return fail("found no line of targets, expected it above the rows");
    const PlainLine& line = region_.header.front();
    AXIOMETRY_TRY(std::vector<CsvCell> cells, cells_of(line, row_rule(profile_)));
    while (!cells.empty() && cells.back().text.empty()) cells.pop_back();
    width_ = cells.size();
    const std::size_t labels = profile_.columns.size() - 1;
    for (std::size_t c = labels; c < width_; ++c) {
      AXIOMETRY_TRY(const double x, number_at(cells[c], profile_.decimal_mark, line.number));
      AXIOMETRY_TRY_VOID(check_target(x, {line.number, cells[c].column}));
      const std::uint32_t number = targets_.number(position_in(*profile_.target_unit, x).in_native());
      if (std::ranges::find(across_, number) != across_.end())
        return fail(fmt::format("found the target {} a second time, expected each once", cells[c].text),
                    {line.number, cells[c].column});
      across_.push_back(number);
    }
    if (across_.size() < 2) return fail("found fewer than 2 targets across, expected more", {line.number, 1});
    return {};
  }

  Result<void> check_target(double x, TextPosition at) {
    if (std::abs(position_in(*profile_.target_unit, x).in_native()) <= largest_stated) return {};
    return fail(fmt::format("found the target {}, expected a magnitude up to 1e9", format_exact(x)), at);
  }

  const ImportColumn& column_of(std::size_t c) const {
    return profile_.columns[std::min(c, profile_.columns.size() - 1)];
  }

  Result<void> check_count(const std::vector<CsvCell>& cells, std::size_t line) const {
    std::size_t found = cells.size();
    while (found > width_ && cells[found - 1].text.empty()) --found;
    std::size_t needed = width_;
    while (needed > 0 && column_of(needed - 1).role == ImportRole::ignore) --needed;
    if (found <= width_ && found >= needed) return {};
    const std::size_t place = found > width_ ? cells[width_].column : cells.back().column;
    return fail(fmt::format("found {}, expected {} as in the rest of the table", counted(found, "field"), width_),
                {line, place});
  }

  struct RowSays {
    std::optional<Direction> direction;
    std::optional<std::size_t> run;
    std::optional<std::uint32_t> target;
    double time_s = none;
  };

  Result<void> take_cell(RowSays& row, const ImportColumn& column, const CsvCell& cell, std::size_t line) {
    const TextPosition at{line, cell.column};
    switch (column.role) {
      case ImportRole::target: {
        AXIOMETRY_TRY(const double x, number_at(cell, profile_.decimal_mark, line));
        AXIOMETRY_TRY_VOID(check_target(x, at));
        row.target = targets_.number(position_in(*profile_.target_unit, x).in_native());
        return {};
      }
      case ImportRole::direction:
        if (*profile_.direction != DirectionRule::column) return {};
        row.direction = direction_of(cell.text);
        if (row.direction) return {};
        return fail(fmt::format("found {}, expected a direction: {}, or up_words and down_words of the profile",
                                text::quoted(cell.text), direction_words),
                    at);
      case ImportRole::run: {
        AXIOMETRY_TRY(row.run, run_in(cell, line));
        return {};
      }
      case ImportRole::label: {
        const Head head = head_of(cell.text);
        row.direction = head.direction;
        if (head.run) row.run = *head.run + 1 - profile_.first_run;
        return {};
      }
      case ImportRole::time:
        if (is_missing(cell.text)) return {};
        if (const auto seconds = clock_seconds(cell.text, profile_.decimal_mark)) {
          row.time_s = *seconds;
          return {};
        }
        return fail(fmt::format("found {}, expected seconds or a time such as 12:30:05", text::quoted(cell.text)), at);
      case ImportRole::ignore:
      case ImportRole::deviation:
      case ImportRole::position: return {};
    }
    return {};
  }

  Result<void> read_row(const std::vector<CsvCell>& cells, std::size_t line) {
    RowSays row;
    for (std::size_t c = 0; c < std::min(cells.size(), width_); ++c)
      AXIOMETRY_TRY_VOID(take_cell(row, column_of(c), cells[c], line));
    for (std::size_t c = 0; c < std::min(cells.size(), width_); ++c) {
      const ImportColumn& column = column_of(c);
      if (column.role != ImportRole::deviation && column.role != ImportRole::position) continue;
      const bool transposed = profile_.layout == TableLayout::transposed;
      Entry entry{.target = transposed ? across_[c + 1 - profile_.columns.size()] : *row.target,
                  .direction = column.direction ? column.direction : row.direction,
                  .run = column.run ? column.run : row.run,
                  .time_s = row.time_s,
                  .row = row_count_,
                  .at = {line, cells[c].column}};
      if (!is_missing(cells[c].text)) {
        AXIOMETRY_TRY(entry.deviation, deviation_of(column, entry.target, cells[c], line));
      }
      entries_.push_back(entry);
    }
    return {};
  }

  Result<double> deviation_of(const ImportColumn& column, std::uint32_t target, const CsvCell& cell, std::size_t line) {
    AXIOMETRY_TRY(const double value, number_at(cell, profile_.decimal_mark, line));
    measured_ = column.role == ImportRole::position;
    const ReadingRule rule{measured_ ? Measured::position : Measured::deviation,
                           column.unit != nullptr ? column.unit : profile_.reading_unit};
    const TextPosition at{line, cell.column};
    AXIOMETRY_TRY_VOID(placed(kind_of(*profile_.target_unit, *rule.unit), at));
    return placed(native_deviation(rule, Position::native(targets_.targets()[target]), profile_.sign * value), at);
  }

  std::optional<Direction> direction_of(std::string_view cell) const {
    if (text::is_one_of(cell, profile_.up_words)) return Direction::up;
    if (text::is_one_of(cell, profile_.down_words)) return Direction::down;
    return direction_word(cell);
  }

  /// "3", "3.0" and "Run 3", counted from 1.
  Result<std::size_t> run_in(const CsvCell& cell, std::size_t line) const {
    auto number = number_in(cell.text, profile_.decimal_mark);
    if (!number)
      if (const auto named = head_of(cell.text).run) number = static_cast<double>(*named);
    const auto first = static_cast<double>(profile_.first_run);
    if (number && *number >= first && *number < first + static_cast<double>(read_budget::runs) &&
        std::floor(*number) == *number)
      return static_cast<std::size_t>(*number) + 1 - profile_.first_run;
    return fail(fmt::format("found the run {}, expected a whole number from {} to {}{}", text::quoted(cell.text),
                            profile_.first_run, read_budget::runs + profile_.first_run - 1,
                            number && *number == 0 ? "; first_run in the profile says where runs begin to count" : ""),
                {line, cell.column});
  }

  /// Directions by motion and by visits, and repetitions, follow from the order of the measurement.
  void turn_newest_first() {
    if (profile_.layout == TableLayout::transposed) return;
    std::vector<double> times(row_count_, none);
    for (const Entry& e : entries_) times[e.row] = e.time_s;
    turned_ = is_newest_first(times);
    if (!turned_) return;
    for (Entry& e : entries_) e.row = row_count_ - 1 - e.row;
    std::ranges::stable_sort(entries_, {}, &Entry::row);
  }

  Motion motion_by_rows() {
    std::vector<std::uint32_t> ranks(row_count_);
    for (const Entry& e : entries_) ranks[e.row] = targets_.ranks()[e.target];
    return motion_of(ranks, targets_.targets().size());
  }

  static Direction other(Direction d) { return d == Direction::up ? Direction::down : Direction::up; }

  Result<void> settle_directions() {
    const Direction first = profile_.first_direction;
    Motion motion;
    if (*profile_.direction == DirectionRule::motion) {
      motion = motion_by_rows();
      if (!motion.is_sweeps)
        return fail(
            "found targets in another order than sweeps along the axis, expected a rule for the direction other "
            "than motion",
            {region_.rows.front().number, 0});
    }
    std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> visits;  // of a target, in a column of its own
    const bool transposed = profile_.layout == TableLayout::transposed;
    for (Entry& e : entries_) {
      switch (*profile_.direction) {
        case DirectionRule::column: break;
        case DirectionRule::names:
          if (!e.direction)
            return fail("found a reading without a direction in its column's name or row's label, expected one", e.at);
          break;
        case DirectionRule::motion: e.direction = motion.directions[e.row]; break;
        case DirectionRule::visits: {
          const std::size_t visit = transposed ? e.row : visits[{e.target, 0}]++;
          e.direction = visit % 2 == 0 ? first : other(first);
          break;
        }
        case DirectionRule::run_parity:
          if (!e.run) return fail("found a reading without a run, expected one to tell its direction by", e.at);
          e.direction = *e.run % 2 == 1 ? first : other(first);
          e.run = (*e.run + 1) / 2;
          break;
        case DirectionRule::up: e.direction = Direction::up; break;
        case DirectionRule::down: e.direction = Direction::down; break;
      }
    }
    return {};
  }

  Result<void> settle_runs() {
    std::map<std::pair<std::uint32_t, Direction>, std::size_t> approaches;
    for (Entry& e : entries_) {
      if (profile_.runs == RunRule::repetition && *profile_.direction != DirectionRule::run_parity) {
        e.run = ++approaches[{e.target, *e.direction}];
        if (*e.run > read_budget::runs)
          return fail(fmt::format("found more than {} approaches to one target, expected fewer", read_budget::runs),
                      e.at);
      }
      if (!e.run || *e.run == 0 || *e.run > read_budget::runs)
        return fail("found a reading without a number of its run, expected one", e.at);
    }
    return {};
  }

  const ImportProfile& profile_;
  const TableRegion& region_;
  TargetIndex targets_;
  std::vector<std::uint32_t> across_;  // targets of a transposed table, by column
  std::vector<Entry> entries_;
  std::size_t width_ = 0;
  std::size_t row_count_ = 0;
  bool measured_ = false;
  bool turned_ = false;
};

}  // namespace

Result<Test> read_with(const ImportProfile& profile, std::string_view bytes) {
  AXIOMETRY_TRY_VOID(check_decided(profile));
  AXIOMETRY_TRY(const DecodedText decoded, decode(bytes, profile.encoding));
  const std::vector<PlainLine> lines = lines_of(decoded.text);
  AXIOMETRY_TRY(const TableRegion region, find_table(profile, lines));
  TableReader reader(profile, region);
  AXIOMETRY_TRY_VOID(reader.read_rows());
  AXIOMETRY_TRY_VOID(reader.settle());
  AXIOMETRY_TRY(Test test, reader.test());
  const LinesAbove above = read_lines_above(region.above, profile.target_unit->kind, profile.decimal_mark);
  AXIOMETRY_TRY(test.metadata, metadata_of(above.preamble, profile.target_unit->kind, profile.decimal_mark));
  auto& remarks = test.provenance.remarks;
  std::ranges::move(encoding_remarks(decoded), std::back_inserter(remarks));
  if (auto remark = above.passed_over.remark()) remarks.push_back(*std::move(remark));
  if (auto turned = reader.turned()) remarks.push_back(std::move(*turned));
  if (auto swapped = reader.swapped_labels()) remarks.push_back(std::move(*swapped));
  return test;
}

}  // namespace axiometry::formats
