// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/pdf/pdf_flow.h"

#include <cairo.h>

#include <algorithm>

namespace axiometry::report::pdf {

void draw(const Drawing& drawing, cairo_t* cairo) {
  if (const auto* lines = std::get_if<PlacedLines>(&drawing))
    lines->text.draw(cairo, lines->first_baseline, lines->first, lines->last);
  else
    std::get<1>(drawing)(cairo);
}

void PageFlow::new_page() {
  pages_.emplace_back();
  y_ = margin_top;
}

void PageFlow::need(double height) {
  if (!at_top() && room() < std::min(height, body_height)) new_page();
}

void PageFlow::skip(double height) {
  if (at_top()) return;
  y_ = std::min(y_ + height, page_height - margin_bottom);
}

namespace {

double first_ascent(const std::vector<PlacedText>& cells) {
  double ascent = 0.0;
  for (const PlacedText& cell : cells) ascent = std::max(ascent, cell.text.lines().front().baseline);
  return ascent;
}

/// The lines of one cell that fit into `room`, at least one on an empty page.
std::size_t lines_that_fit(const TextBlock& text, std::size_t first, double room, bool at_top) {
  const auto& lines = text.lines();
  std::size_t last = first;
  while (last < lines.size() && lines[last].bottom - lines[first].top <= room) ++last;
  return at_top ? std::max(last, std::min(first + 1, lines.size())) : last;
}

}  // namespace

double row_height(const std::vector<PlacedText>& cells) {
  const double ascent = first_ascent(cells);
  double height = 0.0;
  for (const PlacedText& cell : cells)
    height = std::max(height, ascent - cell.text.lines().front().baseline + cell.text.height());
  return height;
}

void place_row(PageFlow& flow, const std::vector<PlacedText>& cells, const std::function<void()>& on_new_page) {
  const auto begin_page = [&] {
    flow.new_page();
    if (on_new_page) on_new_page();
  };
  const double height = row_height(cells);
  if (height > flow.room() && (height <= 0.8 * body_height || flow.room() < 0.2 * body_height)) begin_page();

  const double ascent = first_ascent(cells);
  std::vector<std::size_t> next(cells.size(), 0);
  for (bool beginning = true;; beginning = false) {
    double used = 0.0;
    bool complete = true;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const TextBlock& text = cells[c].text;
      const std::size_t first = next[c];
      if (first == text.lines().size()) continue;
      const double drop = beginning ? ascent - text.lines().front().baseline : 0.0;
      const std::size_t last = lines_that_fit(text, first, flow.room() - drop, !beginning || flow.at_top());
      if (last > first) {
        const Point at{cells[c].x, flow.y() + drop + text.lines()[first].baseline - text.lines()[first].top};
        flow.place(PlacedLines{text, at, first, last});
        used = std::max(used, drop + text.lines()[last - 1].bottom - text.lines()[first].top);
      }
      next[c] = last;
      complete = complete && last == text.lines().size();
    }
    flow.advance(used);
    if (complete) return;
    begin_page();
  }
}

void place_rule(PageFlow& flow, double x, double width, double thickness, Colour colour) {
  const double y = flow.y();
  flow.place([=](cairo_t* cairo) {
    cairo_set_source_rgb(cairo, colour.r, colour.g, colour.b);
    cairo_rectangle(cairo, x, y - thickness / 2.0, width, thickness);
    cairo_fill(cairo);
  });
}

}  // namespace axiometry::report::pdf
