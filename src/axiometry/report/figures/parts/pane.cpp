// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/pane.h"

#include <algorithm>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/report/figures/parts/axis_measures.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/scale.h"

namespace axiometry::report::plot {
namespace {

constexpr double y_pitch = 18.0;  // points between labels, about
constexpr double x_pitch = 24.0;

Ticks upright_ticks(const Range& up, double height) {
  return divide(up.low, up.high, std::max(height / y_pitch, 2.0), Division::decimal);
}

}  // namespace

double pane_label_width(const Range& up, double height, NumberStyle style) {
  return widest_label(upright_ticks(up, height), style) + tick_and_gap;
}

void draw_pane(Operations& operations, const Pane& pane, NumberStyle style) {
  AXIOMETRY_CONTRACT(pane.across.low < pane.across.high && pane.up.low < pane.up.high);
  const Ticks up = upright_ticks(pane.up, pane.bottom - pane.top);
  Ticks along;
  if (pane.x_ticks)
    along =
        divide(pane.across.low, pane.across.high, std::max((pane.right - pane.left) / x_pitch, 2.0), Division::decimal);
  const Stroke grid = ink::solid(ink::grid_grey, 0.4), axis = ink::solid(ink::black, axis_width);
  for (const double tick : up.major)
    operations.push_back(line(pane.at(pane.across.low, tick), pane.at(pane.across.high, tick), grid));
  for (const double tick : along.major)
    operations.push_back(line(pane.at(tick, pane.up.low), pane.at(tick, pane.up.high), grid));
  if (pane.up.low < 0.0 && pane.up.high > 0.0)
    operations.push_back(
        line(pane.at(pane.across.low, 0.0), pane.at(pane.across.high, 0.0), ink::solid(ink::grey, 0.6)));
  operations.push_back(polyline({{pane.left, pane.top}, {pane.left, pane.bottom}, {pane.right, pane.bottom}}, axis));
  for (const double tick : up.major) {
    const double y = pane.y(tick);
    operations.push_back(line({pane.left - tick_length, y}, {pane.left, y}, axis));
    if (pane.y_labels)
      operations.push_back(label({plain(tick_label(tick, up.decimals, style))},
                                 {pane.left - tick_length - 2.0, y + 0.35 * ink::tick_text_size}, ink::tick_text_size,
                                 Anchor::end));
  }
  for (const double tick : along.major) {
    const double x = pane.x(tick);
    operations.push_back(line({x, pane.bottom}, {x, pane.bottom + tick_length}, axis));
    if (pane.x_labels)
      operations.push_back(label({plain(tick_label(tick, along.decimals, style))}, {x, pane.bottom + tick_length + 8.0},
                                 ink::tick_text_size, Anchor::middle));
  }
}

void draw_pane_title(Operations& operations, const Pane& pane, Runs runs) {
  operations.push_back(label(std::move(runs), {pane.left, pane.top - 4.0}, ink::text_size, Anchor::start));
}

void draw_pane_remark(Operations& operations, const Pane& pane, std::string text) {
  const Runs runs = {plain(std::move(text))};
  const Point middle = {(pane.left + pane.right) / 2.0, (pane.top + pane.bottom) / 2.0};
  const double half_width = text_width(runs, ink::text_size) / 2.0 + 3.0;
  const double half_height = ink::text_size * 0.75;
  operations.push_back(Path{.points = {{middle.x - half_width, middle.y - half_height},
                                       {middle.x + half_width, middle.y - half_height},
                                       {middle.x + half_width, middle.y + half_height},
                                       {middle.x - half_width, middle.y + half_height}},
                            .closed = true,
                            .stroke = {.width = 0.0},
                            .fill = ink::white});
  operations.push_back(label(runs, middle, ink::text_size, Anchor::middle, ink::grey));
}

void draw_upright_title(Operations& operations, Runs runs, Point middle) {
  Text upright = label(std::move(runs), middle, ink::text_size, Anchor::middle);
  upright.degrees = 90.0;
  operations.push_back(std::move(upright));
}

}  // namespace axiometry::report::plot
