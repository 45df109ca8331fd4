// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/chart.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/report/figures/parts/axis_measures.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/plate.h"

namespace axiometry::report::plot {
namespace {

constexpr double right_room = 12.0;  // for half a label of the x axis
constexpr double above_plot = 4.0;

/// Decimals of ticks that each have their own: 0.05, 0.1, 20.
constexpr int of_each = -1;

std::string label_of(double tick, const Ticks& ticks, NumberStyle style) {
  constexpr int most = 9;
  if (ticks.decimals != of_each) return tick_label(tick, ticks.decimals, style);
  return tick_label(tick, std::clamp(static_cast<int>(-std::floor(std::log10(tick) + 1e-9)), 0, most), style);
}

double width_of(double tick, const Ticks& ticks, NumberStyle style) {
  return text_width({plain(label_of(tick, ticks, style))}, ink::tick_text_size);
}

double widest(const Ticks& ticks, NumberStyle style) {
  double width = 0.0;
  for (const double tick : ticks.major) width = std::max(width, width_of(tick, ticks, style));
  return width;
}

/// 1, 2, 5 times powers of ten; where that gives too few, equal steps.
Ticks logarithmic_ticks(double low, double high) {
  Ticks ticks;
  for (int decade = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, decade) <= high; ++decade)
    for (int digit = 1; digit <= 9; ++digit) {
      const double tick = digit * std::pow(10.0, decade);
      if (tick < low * (1.0 - 1e-9) || tick > high * (1.0 + 1e-9)) continue;
      const bool major = digit == 1 || digit == 2 || digit == 5;
      (major ? ticks.major : ticks.minor).push_back(tick);
    }
  ticks.decimals = of_each;
  constexpr std::size_t fewest = 3;
  return ticks.major.size() >= fewest ? ticks : divide(low, high, 6.0, Division::decimal);
}

Ticks ticks_of(const ChartAxis& axis, double wanted) {
  const double low = axis.low / axis.unit.native, high = axis.high / axis.unit.native;
  return axis.logarithmic ? logarithmic_ticks(low, high) : divide(low, high, wanted, axis.division);
}

/// About as many as are wanted, and two at least: one number alone is no scale.
Ticks upwards(const ChartAxis& axis, double wanted) {
  constexpr double most = 8.0;  // a step below a quarter of the range: two of its multiples lie within
  Ticks ticks = ticks_of(axis, wanted);
  while (ticks.major.size() < 2 && wanted < most) ticks = ticks_of(axis, ++wanted);
  return ticks;
}

/// As many as leave room between their labels.
Ticks across(const Chart& chart, NumberStyle style) {
  constexpr double gap = 10.0;
  const auto room = [&](const Ticks& ticks) {
    for (std::size_t k = 1; k < ticks.major.size(); ++k) {
      const double pitch =
          chart.x(ticks.major[k] * chart.x_axis.unit.native) - chart.x(ticks.major[k - 1] * chart.x_axis.unit.native);
      const double needed =
          (width_of(ticks.major[k], ticks, style) + width_of(ticks.major[k - 1], ticks, style)) / 2.0 + gap;
      if (pitch < needed) return false;
    }
    return true;
  };
  constexpr double most = 11.0;
  for (double wanted = most; wanted > 1.0; wanted -= 1.0)
    if (Ticks ticks = ticks_of(chart.x_axis, wanted); room(ticks)) return ticks;
  Ticks ticks = ticks_of(chart.x_axis, 1.0);
  if (!room(ticks)) {  // many decades: powers of ten alone
    std::vector<double> kept;
    for (const double tick : ticks.major)
      if (std::abs(std::remainder(std::log10(tick), 1.0)) < 1e-6) kept.push_back(tick);
    ticks.major = kept;
  }
  return ticks;
}

void draw_grid(Operations& operations, const Chart& chart, const Ticks& x, const Ticks& y) {
  const auto horizontal = [&](double at, const Stroke& stroke) {
    operations.push_back(line({chart.left, at}, {chart.right, at}, stroke));
  };
  const auto vertical = [&](double at, const Stroke& stroke) {
    operations.push_back(line({at, chart.top}, {at, chart.bottom}, stroke));
  };
  const auto on_x = [&](double tick) { return chart.x(tick * chart.x_axis.unit.native); };
  const auto on_y = [&](double tick) { return chart.y(tick * chart.y_axis.unit.native); };
  for (const double tick : y.minor) horizontal(on_y(tick), ink::solid(ink::minor_grid_grey, 0.3));
  for (const double tick : x.minor) vertical(on_x(tick), ink::solid(ink::minor_grid_grey, 0.3));
  for (const double tick : y.major) horizontal(on_y(tick), ink::solid(ink::grid_grey, 0.4));
  for (const double tick : x.major) vertical(on_x(tick), ink::solid(ink::grid_grey, 0.4));
  if (!chart.y_axis.logarithmic && chart.y_axis.low < 0.0 && chart.y_axis.high > 0.0)
    horizontal(chart.y(0.0), ink::solid(ink::grey, 0.6));
}

void draw_axes(Operations& operations, const Chart& chart, const Ticks& x, const Ticks& y, NumberStyle style) {
  const Stroke stroke = ink::solid(ink::black, axis_width);
  operations.push_back(
      Path{.points = {{chart.left, chart.top}, {chart.left, chart.bottom}, {chart.right, chart.bottom}},
           .closed = false,
           .stroke = stroke,
           .fill = ink::none});
  for (const double tick : y.major) {
    const double at = chart.y(tick * chart.y_axis.unit.native);
    operations.push_back(line({chart.left - tick_length, at}, {chart.left, at}, stroke));
    operations.push_back(label({plain(label_of(tick, y, style))},
                               {chart.left - tick_length - 2.0, at + 0.35 * ink::tick_text_size}, ink::tick_text_size,
                               Anchor::end));
  }
  for (const double tick : x.major) {
    const double at = chart.x(tick * chart.x_axis.unit.native);
    operations.push_back(line({at, chart.bottom}, {at, chart.bottom + tick_length}, stroke));
    operations.push_back(label({plain(label_of(tick, x, style))}, {at, chart.bottom + tick_length + 8.0},
                               ink::tick_text_size, Anchor::middle));
  }
  const auto title = [](const ChartAxis& axis) { return joined({plain(axis.title + " / ")}, axis.unit.name); };
  operations.push_back(label(title(chart.x_axis), {(chart.left + chart.right) / 2.0, chart.bottom + 24.5},
                             ink::text_size, Anchor::middle));
  // Beside the middle of the axis, or as far up as all of it lies in the figure.
  const double half = text_width(title(chart.y_axis), ink::text_size) / 2.0;
  const double middle = std::max((chart.top + chart.bottom) / 2.0, chart.top - above_plot + half);
  Text upright = label(title(chart.y_axis), {9.5, middle}, ink::text_size, Anchor::middle);
  upright.degrees = 90.0;
  operations.push_back(std::move(upright));
}

}  // namespace

double Chart::place(const ChartAxis& axis, double native, double from, double to) {
  const auto scale = [&](double x) { return axis.logarithmic ? std::log(x) : x; };
  return from + (scale(native) - scale(axis.low)) / (scale(axis.high) - scale(axis.low)) * (to - from);
}

Chart draw_chart(Operations& operations, const ChartAxis& x, const ChartAxis& y, double top, double bottom,
                 NumberStyle style) {
  AXIOMETRY_CONTRACT(std::isfinite(x.low) && std::isfinite(x.high) && x.low < x.high && y.low < y.high);
  AXIOMETRY_CONTRACT(!x.logarithmic || x.low > 0.0);
  constexpr double y_pitch = 24.0;  // points between labels, about
  const double wanted = std::max((bottom - below_plot - top) / y_pitch, 2.0);
  Chart chart{.left = 0.0,
              .right = plate_width - right_room,
              .top = top + above_plot,
              .bottom = bottom - below_plot,
              .x_axis = x,
              .y_axis = y};
  const Ticks up = upwards(y, wanted);
  chart.left = figure_edge + title_room + widest(up, style) + tick_and_gap;
  const Ticks along = across(chart, style);
  draw_grid(operations, chart, along, up);
  draw_axes(operations, chart, along, up, style);
  return chart;
}

ChartRange with_room(ChartRange range, double share) {
  double size = range.high - range.low;
  const double magnitude = std::max(std::abs(range.low), std::abs(range.high));
  if (size <= 1e-9 * magnitude || size <= 0.0) {
    const double half = magnitude > 0.0 ? 0.5 * magnitude : 1.0;
    return {range.low - half, range.high + half};
  }
  return {range.low - share * size, range.high + share * size};
}

}  // namespace axiometry::report::plot
