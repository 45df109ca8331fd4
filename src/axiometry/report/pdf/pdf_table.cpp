// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/pdf/pdf_table.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "axiometry/report/pdf/pdf_palette.h"

namespace axiometry::report::pdf {

namespace {

constexpr double caption_size = 9.0;
constexpr double note_size = 7.5;
constexpr double undivided_table = 0.45 * body_height;
constexpr double rows_at_least = 5.0;                          // at the foot of a page
constexpr double notes_with_the_last_row = 0.2 * body_height;  // longer ones may begin a page
constexpr double smallest_size = 4.5;
constexpr double narrowest_text_column = 70.0;
constexpr std::size_t ruled_rows = 5;  // a darker line below every fifth row guides the eye through many

/// Sizes that go with the size of the type.
struct Measure {
  double size = 8.5;
  double padding = 4.0;    ///< beside every column
  double group_gap = 8.0;  ///< more room before a column that opens a group
  double row_gap = 3.0;    ///< above and below the text of a row
  double digit = 0.0;
  double mark = 0.0;
};

Measure sizes(const Table& table, double scale) {
  Measure m;
  m.size = scale * (table.dense ? 7.2 : 8.5);
  m.padding = scale * (table.dense ? 2.2 : 4.0);
  m.group_gap = scale * (table.dense ? 5.0 : 8.0);
  m.row_gap = scale * (table.dense ? 1.6 : 2.1);
  return m;
}

Measure measure_for(const Table& table, double scale, const Typesetter& typesetter) {
  Measure m = sizes(table, scale);
  m.digit = typesetter.width(plain("00000"), {m.size}) / 5.0;
  m.mark = typesetter.width(plain("....."), {m.size}) / 5.0;
  return m;
}

/// What a number lacks behind its last digit to end where the longest of its column ends.
double padding_right(const TableCell& cell, std::size_t longest, const Measure& m) {
  const std::string text = plain_text(cell.text);
  if (!is_number(text)) return 0.0;
  const std::size_t own = fraction_length(text);
  const double lacking_mark = own == 0 && longest > 0 ? m.mark : 0.0;
  const std::size_t lacking_digits = longest - own - (lacking_mark > 0.0 ? 1 : 0);
  return lacking_mark + static_cast<double>(lacking_digits) * m.digit;
}

/// Where the columns stand and how wide they are.
struct Grid {
  Measure measure;
  std::vector<double> left;           ///< of the content, from the page's edge
  std::vector<double> width;          ///< width of the content of each column
  std::vector<std::size_t> fraction;  ///< longest_fraction() of each column
};

/// Room for the head of each group above its columns.
void widen_for_groups(const Table& table, const Measure& m, const Typesetter& typesetter, std::vector<double>& widths) {
  std::size_t first = 0;
  for (const ColumnGroup& group : table.groups) {
    const std::span columns = std::span(widths).subspan(first, group.columns);
    const double between = 2.0 * m.padding * static_cast<double>(columns.size() - 1);
    const double own = std::accumulate(columns.begin(), columns.end(), between);
    const double lacking = group.head.empty() ? 0.0 : typesetter.width(group.head, {m.size, true}) - own;
    if (lacking > 0.0)
      for (double& width : columns) width += lacking / static_cast<double>(columns.size());
    first += group.columns;
  }
}

std::vector<double> natural_widths(const Table& table, const Measure& m, const Typesetter& typesetter) {
  std::vector<double> widths;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    const std::size_t fraction = column.align == Align::decimal ? longest_fraction(table, c) : 0;
    double widest = typesetter.width(column.head, {m.size, true});
    for (const auto& row : table.rows) {
      const double own = typesetter.width(row[c].text, {m.size});
      widest = std::max(widest, own + (column.align == Align::decimal ? padding_right(row[c], fraction, m) : 0.0));
    }
    widths.push_back(widest + 0.5);  // so that rounding wraps no line
  }
  widen_for_groups(table, m, typesetter, widths);
  return widths;
}

double gaps(const Table& table, const Measure& m) {
  double all = 0.0;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (c > 0) all += 2.0 * m.padding;
    if (c > 0 && table.columns[c].opens_group) all += m.group_gap;
  }
  return all;
}

/// Shares `room` among the columns of running text: those that need less than their part keep what
/// they need, the others get equal parts of the rest.
void share_among_text(const Table& table, std::vector<double>& widths, double room) {
  std::vector<std::size_t> open;
  for (std::size_t c = 0; c < widths.size(); ++c)
    if (table.columns[c].takes_space) open.push_back(c);
  std::ranges::sort(open, {}, [&](std::size_t c) { return widths[c]; });
  for (std::size_t k = 0; k < open.size(); ++k) {
    const double part = room / static_cast<double>(open.size() - k);
    widths[open[k]] = std::min(widths[open[k]], part);
    room -= widths[open[k]];
  }
}

/// Fits the widths into `room`; false when the columns that may not wrap are too wide for it.
bool fit(const Table& table, std::vector<double>& widths, double room) {
  const double total = std::accumulate(widths.begin(), widths.end(), 0.0);
  const auto text_columns = std::ranges::count(table.columns, true, &Column::takes_space);
  if (total <= room) {
    const double extra = (room - total) / static_cast<double>(text_columns > 0 ? text_columns : std::ssize(widths));
    for (std::size_t c = 0; c < widths.size(); ++c)
      if (text_columns == 0 || table.columns[c].takes_space) widths[c] += extra;
    return true;
  }
  double rigid = 0.0;
  for (std::size_t c = 0; c < widths.size(); ++c)
    if (!table.columns[c].takes_space) rigid += widths[c];
  if (text_columns == 0 || room - rigid < narrowest_text_column * static_cast<double>(text_columns)) return false;
  share_among_text(table, widths, room - rigid);
  return true;
}

Grid grid_for(const Table& table, const Typesetter& typesetter) {
  Grid grid;
  for (double scale = 1.0;; scale *= 0.94) {
    grid.measure = measure_for(table, scale, typesetter);
    grid.width = natural_widths(table, grid.measure, typesetter);
    if (fit(table, grid.width, body_width - gaps(table, grid.measure)) || grid.measure.size < smallest_size) break;
  }
  double x = margin_side;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (c > 0) x += 2.0 * grid.measure.padding + (table.columns[c].opens_group ? grid.measure.group_gap : 0.0);
    grid.left.push_back(x);
    x += grid.width[c];
    grid.fraction.push_back(table.columns[c].align == Align::decimal ? longest_fraction(table, c) : 0);
  }
  return grid;
}

double aligned(Align align, double left, double width, double text, double right_padding) {
  if (align == Align::start) return left;
  const double spare = width - text - right_padding;
  return left + (align == Align::centre ? spare / 2.0 : spare);
}

std::vector<PlacedText> head_cells(const Table& table, const Grid& grid, const Typesetter& typesetter) {
  std::vector<PlacedText> cells;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const TextBlock text = typesetter.set(table.columns[c].head, {grid.measure.size, true, ink}, std::nullopt);
    cells.push_back({text, aligned(table.columns[c].align, grid.left[c], grid.width[c], text.width(), 0.0)});
  }
  return cells;
}

/// Group heads, each with a line over its columns.
void place_groups(const Table& table, const Grid& grid, const Typesetter& typesetter, PageFlow& flow) {
  std::vector<PlacedText> cells;
  std::vector<std::pair<double, double>> lines;
  std::size_t c = 0;
  for (const ColumnGroup& group : table.groups) {
    const std::size_t last = c + group.columns - 1;
    const double left = grid.left[c];
    const double width = grid.left[last] + grid.width[last] - left;
    if (!group.head.empty()) {
      const TextBlock text = typesetter.set(group.head, {grid.measure.size, true, accent});
      cells.push_back({text, aligned(Align::centre, left, width, text.width(), 0.0)});
      lines.emplace_back(left, width);
    }
    c = last + 1;
  }
  place_row(flow, cells);
  flow.advance(grid.measure.row_gap / 2.0);
  for (const auto& [left, width] : lines) place_rule(flow, left, width, 0.5, rule);
}

void place_head(const Table& table, const Grid& grid, const Typesetter& typesetter, PageFlow& flow) {
  place_rule(flow, margin_side, body_width, 1.0, ink);
  flow.advance(grid.measure.row_gap);
  if (!table.groups.empty()) {
    place_groups(table, grid, typesetter, flow);
    flow.advance(grid.measure.row_gap);
  }
  place_row(flow, head_cells(table, grid, typesetter));
  flow.advance(grid.measure.row_gap);
  place_rule(flow, margin_side, body_width, 0.6, ink);
}

std::vector<PlacedText> row_cells(const Table& table, std::size_t row, const Grid& grid, const Typesetter& typesetter) {
  std::vector<PlacedText> cells;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const TableCell& cell = table.rows[row][c];
    const Column& column = table.columns[c];
    const auto width = column.takes_space ? std::optional(grid.width[c]) : std::nullopt;
    TextBlock text = typesetter.set(cell.text, {grid.measure.size, false, tone_colours(cell.tone).text}, width);
    const double right = column.align == Align::decimal ? padding_right(cell, grid.fraction[c], grid.measure) : 0.0;
    const double x = aligned(column.align, grid.left[c], grid.width[c], text.width(), right);
    cells.push_back({std::move(text), x});
  }
  return cells;
}

double notes_height(const Table& table, const Typesetter& typesetter) {
  double height = table.notes.empty() ? 0.0 : 4.0;
  for (const RichText& note : table.notes)
    height += typesetter.set(note, {note_size, false, quiet}, body_width).height() + 1.5;
  return height;
}

void place_notes(const Table& table, const Typesetter& typesetter, PageFlow& flow) {
  flow.advance(4.0);
  for (const RichText& note : table.notes) {
    place_row(flow, {{typesetter.set(note, {note_size, false, quiet}, body_width), margin_side}});
    flow.advance(1.5);
  }
}

}  // namespace

double beginning_height(const Table& table, const Typesetter& typesetter) {
  const Measure m = sizes(table, 1.0);
  const double row = 1.2 * m.size + 2.0 * m.row_gap;
  const double head = 2.0 * caption_size + (table.groups.empty() ? 1.5 : 3.0) * row;
  const double all = head + static_cast<double>(table.rows.size()) * row;
  if (all >= undivided_table) return head + rows_at_least * row;
  const double notes = notes_height(table, typesetter);
  return notes < notes_with_the_last_row ? all + notes : all;
}

void set_table(const Table& table, const Typesetter& typesetter, PageFlow& flow) {
  const Grid grid = grid_for(table, typesetter);
  const Measure& m = grid.measure;
  flow.need(beginning_height(table, typesetter));
  if (!table.caption.empty()) {
    place_row(flow, {{typesetter.set(table.caption, {caption_size, true, ink}, body_width), margin_side}});
    flow.advance(5.0);
  }
  const auto head = [&] { place_head(table, grid, typesetter, flow); };
  head();
  const double notes = notes_height(table, typesetter);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    std::vector<PlacedText> cells = row_cells(table, row, grid, typesetter);
    const bool has_notes_below = row + 1 == table.rows.size() && notes < notes_with_the_last_row;
    const double height = row_height(cells) + 2.0 * m.row_gap + (has_notes_below ? notes : 0.0);
    const bool last_of_page = height > flow.room() && height <= 0.8 * body_height;
    if (row > 0 && !last_of_page) {
      const bool guide = table.dense && row % ruled_rows == 0;
      place_rule(flow, margin_side, body_width, 0.4, guide ? rule : hairline);
    }
    if (last_of_page) {
      place_rule(flow, margin_side, body_width, 0.6, ink);
      flow.new_page();
      head();
    }
    flow.advance(m.row_gap);
    place_row(flow, cells, head);
    flow.advance(m.row_gap);
  }
  place_rule(flow, margin_side, body_width, 1.0, ink);
  place_notes(table, typesetter, flow);
}

}  // namespace axiometry::report::pdf
