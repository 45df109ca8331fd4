// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/tolerance_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include "axiometry/app/files/source.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::app {
namespace {

using formats::CsvCell;
using iso230_2::ParameterInfo;

constexpr std::size_t largest_file = std::size_t{1} << 20;
constexpr double largest_number = 1e6;  // of travels in mm or ° and limits in µm or ″, as in a test's file
constexpr std::string_view fixed_columns[] = {"name", "kind", "travel_up_to", "unit", "rule"};
constexpr std::string_view needed_columns[] = {"name", "kind", "travel_up_to", "unit"};

/// Coordinates of targets are decimal fractions, so that a travel of 500 mm may come out as 500.00000000000006:
/// rounding of two coordinates up to 1e6 is below 1e-9, and no band means a nanometre.
constexpr double travel_slack = 1e-6;

/// What a column of the header holds: one of fixed_columns, or the limits of a parameter.
struct TableColumn {
  std::string_view fixed;
  const ParameterInfo* parameter = nullptr;
};

const ParameterInfo* parameter_named(std::string_view head) {
  if (const ParameterInfo* exact = iso230_2::find_parameter(head)) return exact;
  const auto* found = std::ranges::find_if(
      iso230_2::parameters, [&](const ParameterInfo& p) { return text::equal_ignoring_case(p.key, head); });
  return found == std::end(iso230_2::parameters) ? nullptr : found;
}

Result<TableColumn> column_from(std::string_view head, TextPosition at) {
  for (std::string_view fixed : fixed_columns)
    if (text::equal_ignoring_case(fixed, head)) return TableColumn{fixed, nullptr};
  if (const ParameterInfo* parameter = parameter_named(head)) return TableColumn{{}, parameter};
  std::vector<std::string_view> known(std::begin(fixed_columns), std::end(fixed_columns));
  for (const ParameterInfo& p : iso230_2::parameters) known.push_back(p.key);
  const auto near = text::nearest(head, known);
  return fail(fmt::format("found the column {}, expected {}", text::quoted(head),
                          near ? fmt::format("perhaps {}", *near) : fmt::format("one of {}", fmt::join(known, ", "))),
              at);
}

struct Header {
  std::vector<TableColumn> columns;
  formats::RowShape shape;
};

Result<Header> read_header(std::string_view line, std::size_t number) {
  Header header;
  header.shape = {.header_line = number, .delimiter = formats::delimiter_of(line)};
  AXIOMETRY_TRY(auto cells, formats::split_row(line, header.shape.delimiter, number));
  while (!cells.empty() && cells.back().text.empty()) cells.pop_back();
  for (const CsvCell& cell : cells) {
    AXIOMETRY_TRY(const TableColumn column, column_from(cell.text, {number, cell.column}));
    const auto same = [&](const TableColumn& c) { return c.fixed == column.fixed && c.parameter == column.parameter; };
    if (std::ranges::any_of(header.columns, same))
      return fail(fmt::format("found the column {} a second time, expected each once", text::quoted(cell.text)),
                  {number, cell.column});
    header.columns.push_back(column);
  }
  for (std::string_view needed : needed_columns)
    if (std::ranges::find(header.columns, needed, &TableColumn::fixed) == header.columns.end())
      return fail(fmt::format("found no column {}, expected a header with name, kind, travel_up_to, unit and one "
                              "column per parameter",
                              needed),
                  {number, 1});
  if (std::ranges::all_of(header.columns, [](const TableColumn& c) { return c.parameter == nullptr; }))
    return fail("found no column of limits, expected one per parameter such as A, E, R_up", {number, 1});
  header.shape.expected = header.columns.size();
  for (std::size_t c = 0; c < header.columns.size(); ++c)
    if (std::ranges::find(needed_columns, header.columns[c].fixed) != std::end(needed_columns))
      header.shape.needed = c + 1;
  return header;
}

/// The cells of one row by their columns.
class Row {
 public:
  Row(const Header& header, const std::vector<CsvCell>& cells, std::size_t line)
      : header_(header), cells_(cells), line_(line) {}

  CsvCell cell(std::string_view fixed) const {
    for (std::size_t c = 0; c < std::min(cells_.size(), header_.columns.size()); ++c)
      if (header_.columns[c].fixed == fixed && !fixed.empty()) return cells_[c];
    return {};
  }
  TextPosition at(const CsvCell& cell) const { return {line_, cell.column}; }
  std::size_t line() const { return line_; }
  std::span<const TableColumn> columns() const {
    return std::span(header_.columns).first(std::min(cells_.size(), header_.columns.size()));
  }
  const CsvCell& operator[](std::size_t c) const { return cells_[c]; }

 private:
  const Header& header_;
  const std::vector<CsvCell>& cells_;
  std::size_t line_;
};

Result<AxisKind> kind_from(const Row& row) {
  const CsvCell cell = row.cell("kind");
  for (AxisKind kind : {AxisKind::linear, AxisKind::rotary})
    if (text::equal_ignoring_case(cell.text, axis_kind_name(kind))) return kind;
  return fail(fmt::format("found the kind {}, expected linear or rotary", text::quoted(cell.text)), row.at(cell));
}

Result<std::optional<Position>> travel_from(const Row& row, formats::NumberReader& numbers) {
  const CsvCell cell = row.cell("travel_up_to");
  if (cell.text.empty()) return std::optional<Position>();
  AXIOMETRY_TRY(const double travel, numbers.read(cell.text, row.at(cell)));
  if (travel <= 0 || travel > largest_number)
    return fail(fmt::format("found the travel {}, expected a number above 0, at most {}, or an empty cell for any "
                            "travel",
                            text::quoted(cell.text), format_exact(largest_number)),
                row.at(cell));
  return std::optional(Position::native(travel));
}

Result<const formats::Unit*> unit_from(const Row& row, AxisKind kind) {
  const CsvCell cell = row.cell("unit");
  const formats::Unit* unit = formats::find_unit(cell.text);
  if (unit != nullptr && unit->kind == kind) return unit;
  return fail(fmt::format("found the unit {} for a {} axis, expected {}", text::quoted(cell.text), axis_kind_name(kind),
                          kind == AxisKind::linear ? "um, mm or nm" : "arcsec or deg"),
              row.at(cell));
}

Result<std::optional<RuleText>> rule_from(const Row& row, AxisKind kind) {
  const CsvCell cell = row.cell("rule");
  if (cell.text.empty()) return std::optional<RuleText>();
  AXIOMETRY_TRY(const RuleText rule, formats::placed(parse_rule(cell.text), row.at(cell)));
  AXIOMETRY_TRY_VOID(formats::placed(rule_for(kind, rule), row.at(cell)));
  return std::optional(rule);
}

Result<std::vector<iso230_2::Tolerance>> band_limits_from(const Row& row, const formats::Unit& unit,
                                                          formats::NumberReader& numbers) {
  std::vector<iso230_2::Tolerance> limits;
  for (std::size_t c = 0; c < row.columns().size(); ++c) {
    const ParameterInfo* parameter = row.columns()[c].parameter;
    if (parameter == nullptr || row[c].text.empty()) continue;
    AXIOMETRY_TRY(const double value, numbers.read(row[c].text, row.at(row[c])));
    const Deviation limit = formats::deviation_in(unit, value);
    if (limit.in_native() <= 0 || limit.in_native() > largest_number)
      return fail(
          fmt::format("found the limit {} of {}, expected a number above 0, at most {} {}", text::quoted(row[c].text),
                      parameter->key, format_exact(largest_number), deviation_unit_key(unit.kind)),
          row.at(row[c]));
    limits.push_back({parameter, limit, iso230_2::ToleranceSource::table});
  }
  if (limits.empty()) return fail("found a row without a limit, expected at least one", {row.line(), 1});
  return limits;
}

Result<ToleranceBand> band_from(const Row& row, formats::NumberReader& numbers) {
  ToleranceBand band;
  band.line = row.line();
  const CsvCell name = row.cell("name");
  if (name.text.empty()) return fail("found an empty name, expected that of a tolerance table", row.at(name));
  band.name = name.text;
  AXIOMETRY_TRY(band.kind, kind_from(row));
  AXIOMETRY_TRY(band.travel_max, travel_from(row, numbers));
  AXIOMETRY_TRY(const formats::Unit* unit, unit_from(row, band.kind));
  AXIOMETRY_TRY(band.rule, rule_from(row, band.kind));
  AXIOMETRY_TRY(band.limits, band_limits_from(row, *unit, numbers));
  return band;
}

Result<void> check_new(const std::vector<ToleranceBand>& bands, const ToleranceBand& band) {
  const auto twin = std::ranges::find_if(bands, [&](const ToleranceBand& b) {
    return text::equal_ignoring_case(b.name, band.name) && b.kind == band.kind && b.travel_max == band.travel_max;
  });
  if (twin == bands.end()) return {};
  return fail(fmt::format("found a second row of {} for {} axes, {}, expected only that on line {}",
                          text::quoted(band.name), axis_kind_name(band.kind), travel_text(band), twin->line),
              {band.line, 1});
}

bool is_comment(std::string_view line) {
  const std::string_view content = text::trim(line);
  return content.empty() || content.starts_with('#') || content.starts_with("\"#");
}

}  // namespace

std::string travel_text(const ToleranceBand& band) {
  if (!band.travel_max) return "any travel";
  const bool linear = band.kind == AxisKind::linear;
  return fmt::format("up to {}{}", format_exact(band.travel_max->in_native()), linear ? " mm" : "°");
}

Result<ToleranceTable> read_tolerance_table(std::string_view bytes, const std::string& file) {
  constexpr std::string_view expected =
      "found no limits, expected a header such as name,kind,travel_up_to,unit,A,E and rows of limits";
  if (text::trim(bytes).empty()) return fail(std::string(expected));
  AXIOMETRY_TRY(const std::string_view content, formats::utf8_text(bytes));
  ToleranceTable table{file, sha256(bytes), {}};
  std::optional<Header> header;
  formats::NumberReader numbers(',');
  std::size_t number = 0;
  for (std::string_view line : text::split(content, '\n')) {
    ++number;
    if (is_comment(line)) continue;
    if (!header) {
      AXIOMETRY_TRY(header, read_header(line, number));
      numbers = formats::NumberReader(header->shape.delimiter);
      continue;
    }
    AXIOMETRY_TRY(const auto cells, formats::split_row(text::trim(line), header->shape.delimiter, number));
    header->shape.line = number;
    AXIOMETRY_TRY_VOID(formats::check_cell_count(cells, header->shape));
    AXIOMETRY_TRY(ToleranceBand band, band_from(Row(*header, cells, number), numbers));
    AXIOMETRY_TRY_VOID(check_new(table.bands, band));
    table.bands.push_back(std::move(band));
  }
  if (table.bands.empty()) return fail(std::string(expected));
  return table;
}

Result<ToleranceTable> open_tolerance_table(const std::string& file) {
  const auto in_file = [&](Error error) {
    error.file = file == "-" ? "(standard input)" : file;
    return std::unexpected(std::move(error));
  };
  auto source = Source::open(file);
  if (!source) return in_file(std::move(source).error());
  auto bytes = source->read_all(largest_file);
  if (!bytes) return in_file(std::move(bytes).error());
  auto table = read_tolerance_table(*bytes, file);
  if (!table) return in_file(std::move(table).error());
  return table;
}

ToleranceTableName parse_table_name(const std::string& text) {
  std::error_code ignored;
  if (std::filesystem::exists(text, ignored)) return {text, ""};
  for (std::size_t colon = text.find(':'); colon != std::string::npos; colon = text.find(':', colon + 1))
    if (std::filesystem::exists(text.substr(0, colon), ignored)) return {text.substr(0, colon), text.substr(colon + 1)};
  return {text, ""};
}

Result<const ToleranceBand*> select_band(const ToleranceTable& table, std::string_view name, AxisKind kind,
                                         const Series& series) {
  std::vector<std::string_view> names;
  for (const ToleranceBand& band : table.bands)
    if (std::ranges::none_of(names, [&](auto n) { return text::equal_ignoring_case(n, band.name); }))
      names.push_back(band.name);
  const auto known = std::ranges::find_if(names, [&](auto n) { return text::equal_ignoring_case(n, name); });
  if (name.empty() && names.size() > 1)
    return fail(fmt::format("found no name of a tolerance table, expected one of those in {}: {}", table.file,
                            fmt::join(names, "; ")));
  if (!name.empty() && known == names.end())
    return fail(fmt::format("found the tolerance table {}, expected one of those in {}: {}", text::quoted(name),
                            table.file, fmt::join(names, "; ")));
  const std::string_view chosen = name.empty() ? names.front() : *known;
  const double travel = series.travel_native();
  const ToleranceBand* best = nullptr;
  const ToleranceBand* widest = nullptr;
  const auto reach = [](const ToleranceBand& b) { return b.travel_max ? b.travel_max->in_native() : INFINITY; };
  for (const ToleranceBand& band : table.bands) {
    if (!text::equal_ignoring_case(band.name, chosen) || band.kind != kind) continue;
    if (widest == nullptr || reach(band) > reach(*widest)) widest = &band;
    if (travel <= reach(band) + travel_slack && (best == nullptr || reach(band) < reach(*best))) best = &band;
  }
  if (best != nullptr) return best;
  if (widest == nullptr)
    return fail(fmt::format("found a {} axis, expected one that the tolerance table {} in {} has limits for",
                            axis_kind_name(kind), text::quoted(chosen), table.file));
  return fail(fmt::format(
      "found a measured travel of {:.7g}{}, expected one that the tolerance table {} in {} has "
      "limits for: {}",
      travel, kind == AxisKind::linear ? " mm" : "°", text::quoted(chosen), table.file, travel_text(*widest)));
}

}  // namespace axiometry::app
