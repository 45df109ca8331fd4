// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/legend.h"

#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report::plot {
namespace {

constexpr double row_height = 12.0;
constexpr double sample_width = 22.0;
constexpr double dot_sample_width = 5.0;
constexpr double sample_gap = 4.0;
constexpr double entry_gap = 15.0;
constexpr double band_half_height = 3.2;

double width_of_sample(const LegendEntry& entry) { return entry.line ? sample_width : dot_sample_width; }

void draw_sample(Operations& operations, const LegendEntry& entry, Point left) {
  const double width = width_of_sample(entry);
  const double right = left.x + width;
  if (entry.band) {
    const double top = left.y - band_half_height;
    const double bottom = left.y + band_half_height;
    operations.push_back(Path{.points = {{left.x, top}, {right, top}, {right, bottom}, {left.x, bottom}},
                              .closed = true,
                              .stroke = ink::solid(ink::none, 0.0),
                              .fill = *entry.band});
    if (entry.line) {
      operations.push_back(line({left.x, top}, {right, top}, *entry.line));
      operations.push_back(line({left.x, bottom}, {right, bottom}, *entry.line));
    }
  } else if (entry.line) {
    operations.push_back(line(left, {right, left.y}, *entry.line));
  }
  if (entry.mark) {
    Disc mark = *entry.mark;
    mark.centre = {left.x + width / 2.0, left.y};
    operations.push_back(mark);
  }
}

}  // namespace

double draw_legend(Operations& operations, const std::vector<LegendEntry>& entries, Point top_left, double width) {
  double x = top_left.x;
  double base_line = top_left.y + 8.5;
  for (const LegendEntry& entry : entries) {
    const double text_start = width_of_sample(entry) + sample_gap;
    const double entry_width = text_start + text_width(entry.text, ink::text_size);
    if (x > top_left.x && x + entry_width > top_left.x + width) {
      x = top_left.x;
      base_line += row_height;
    }
    draw_sample(operations, entry, {x, base_line - 0.33 * ink::text_size});
    operations.push_back(Text{.runs = entry.text,
                              .at = {x + text_start, base_line},
                              .size = ink::text_size,
                              .colour = ink::black,
                              .anchor = Anchor::start,
                              .degrees = 0.0});
    x += entry_width + entry_gap;
  }
  return entries.empty() ? 0.0 : base_line - top_left.y + 4.5;
}

double draw_label(Operations& operations, std::string_view label, double left, double width) {
  if (label.empty()) return 0.0;
  constexpr double bold_is_wider = 1.1;
  operations.push_back(Text{.runs = {{.text = shortened(label, width / bold_is_wider, ink::text_size), .bold = true}},
                            .at = {left, 9.0},
                            .size = ink::text_size,
                            .colour = ink::black,
                            .anchor = Anchor::start,
                            .degrees = 0.0});
  return 13.0;
}

}  // namespace axiometry::report::plot
