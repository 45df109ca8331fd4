// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/tracking/length_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/figures/parts/series_pens.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using plot::Chart;
using plot::ChartAxis;
using plot::ChartRange;
using plot::header_left;
using plot::LegendEntry;
using plot::Operations;
using plot::Range;
namespace ink = plot::ink;

constexpr double distance_chart_height = 190.0;
constexpr double between = 8.0;
constexpr double largest = 1e12;         // µm or °: beyond it a diagram would say nothing
constexpr double fewest_decades = 1e-5;  // of the highest value, shown at most
const Stroke instrument_line{.colour = ink::grey, .width = 0.9, .dashes = {2.0, 1.6}};

bool can_be_drawn(double distance, double value) {
  return std::isfinite(distance) && distance > 0.0 && std::isfinite(value) && std::abs(value) < largest;
}

template <typename Use>
void for_each_value(const DistanceSubject& subject, const Use& use) {
  for (const DistanceCurve& curve : subject.curves)
    for (std::size_t k = 0; k < std::min(curve.values.size(), subject.distances_mm.size()); ++k)
      if (can_be_drawn(subject.distances_mm[k], curve.values[k])) use(subject.distances_mm[k], curve.values[k]);
}

/// A logarithmic range with a little room.
ChartRange decades(ChartRange range) {
  if (range.high <= range.low * 1.2) return {range.low / 2.0, range.high * 2.0};
  const double room = std::pow(range.high / range.low, 0.04);
  return {range.low / room, range.high * room};
}

ChartAxis distance_axis(const DistanceSubject& subject, const Options& options) {
  Range seen;
  for_each_value(subject, [&](double distance, double) { seen.see(distance); });
  const ChartRange range = seen.any() ? decades(ChartRange{seen.low, seen.high}) : ChartRange{10.0, 1000.0};
  return {.low = range.low,
          .high = range.high,
          .unit = plot::position_axis_unit(AxisKind::linear, range.high),
          .title = translated("Distance from the station", options),
          .logarithmic = true};
}

/// Of magnitudes, which may be 0 at the reference: what lies below the range is not drawn.
ChartAxis magnitude_axis(const DistanceSubject& subject, std::string title) {
  Range seen;
  for_each_value(subject, [&](double, double value) {
    if (value != 0.0) seen.see(std::abs(value));
  });
  ChartRange range = seen.any() ? ChartRange{seen.low, seen.high} : ChartRange{0.01, 1.0};
  range.low = std::max(range.low, range.high * fewest_decades);
  range = decades(range);
  return {.low = range.low,
          .high = range.high,
          .unit = plot::deviation_axis_unit(AxisKind::linear, DisplayUnit::native, range.high),
          .title = std::move(title),
          .logarithmic = true};
}

/// A curve through what can be drawn, with its points; `value_of` says what of a value is shown, NaN for nothing.
template <typename Shown>
void draw_curve(Operations& operations, const Chart& chart, const DistanceSubject& subject, std::size_t number,
                const Shown& shown) {
  const Stroke pen = plot::series_pen(number);
  const DistanceCurve& curve = subject.curves[number];
  Path path{.points = {}, .closed = false, .stroke = pen, .fill = ink::none};
  std::vector<Point> points;
  const auto end_path = [&] {
    if (path.points.size() > 1) operations.push_back(path);
    path.points.clear();
  };
  for (std::size_t k = 0; k < std::min(curve.values.size(), subject.distances_mm.size()); ++k) {
    const double value = can_be_drawn(subject.distances_mm[k], curve.values[k])
                             ? shown(curve.values[k])
                             : std::numeric_limits<double>::quiet_NaN();
    if (!(value >= chart.y_axis.low && value <= chart.y_axis.high)) {
      end_path();
      continue;
    }
    path.points.push_back({chart.x(subject.distances_mm[k]), chart.y(value)});
    points.push_back(path.points.back());
  }
  end_path();
  constexpr std::size_t most_marks = 60;
  if (points.size() > most_marks) return;
  for (const Point& point : points)
    operations.push_back(Disc{.centre = point, .radius = 1.3, .fill = pen.colour, .stroke = {.width = 0.0}});
}

std::vector<LegendEntry> legend(const DistanceSubject& subject) {
  std::vector<LegendEntry> entries;
  for (std::size_t k = 0; k < subject.curves.size(); ++k) {
    const Stroke pen = plot::series_pen(k);
    entries.push_back({.line = pen,
                       .band = std::nullopt,
                       .mark = Disc{.centre = {}, .radius = 1.3, .fill = pen.colour, .stroke = {.width = 0.0}},
                       .text = {plot::plain(plot::shortened(subject.curves[k].label, 160.0, ink::text_size))}});
  }
  return entries;
}

Figure begun(const DistanceSubject& subject) {
  return {.width = plot::plate_width,
          .height = 0.0,
          .title = subject.title,
          .description = subject.description,
          .operations = {}};
}

double magnitude(double value) { return value == 0.0 ? std::numeric_limits<double>::quiet_NaN() : std::abs(value); }

/// a + b·d, where the diagram shows it.
void draw_instrument(Operations& operations, const Chart& chart, const RangingUncertainty& ranging) {
  constexpr int parts = 64;
  Path path{.points = {}, .closed = false, .stroke = instrument_line, .fill = ink::none};
  for (int k = 0; k <= parts; ++k) {
    const double distance = chart.x_axis.low * std::pow(chart.x_axis.high / chart.x_axis.low, 1.0 * k / parts);
    const double U = 2.0 * Length::mm(ranging.standard_mm(distance)).in_um();
    if (U >= chart.y_axis.low && U <= chart.y_axis.high) path.points.push_back({chart.x(distance), chart.y(U)});
  }
  if (path.points.size() > 1) operations.push_back(std::move(path));
}

}  // namespace

Figure station_angle_figure(const DistanceSubject& subject, const Options& options) {
  Figure figure = begun(subject);
  double top =
      plot::draw_legend(figure.operations, legend(subject), {header_left, 0.0}, plot::plate_width - header_left);
  ChartAxis angle = magnitude_axis(subject, translated("Angle α", options));
  angle.unit = {1.0, {plot::plain("°")}};
  figure.height = top + between + distance_chart_height + 30.0;
  const Chart chart = plot::draw_chart(figure.operations, distance_axis(subject, options), angle, top + between,
                                       figure.height, options.numbers);
  for (std::size_t k = 0; k < subject.curves.size(); ++k) draw_curve(figure.operations, chart, subject, k, magnitude);
  return figure;
}

Figure length_difference_figure(const DistanceSubject& subject, const std::optional<RangingUncertainty>& ranging,
                                const Options& options) {
  Figure figure = begun(subject);
  std::vector<LegendEntry> entries = legend(subject);
  if (ranging)
    entries.push_back({.line = instrument_line,
                       .band = std::nullopt,
                       .mark = std::nullopt,
                       .text = translated({plot::italic("U"), plot::plain(" of the instrument")}, options)});
  double top = plot::draw_legend(figure.operations, entries, {header_left, 0.0}, plot::plate_width - header_left);
  top += between;

  Range seen;
  seen.see(0.0);
  for_each_value(subject, [&](double, double value) { seen.see(value); });
  const ChartRange range = plot::with_room(ChartRange{seen.low, seen.high});
  const double most = std::max(std::abs(range.low), std::abs(range.high));
  const ChartAxis linear{.low = range.low,
                         .high = range.high,
                         .unit = plot::deviation_axis_unit(AxisKind::linear, options.unit, most),
                         .title = translated("Length difference Δd", options)};
  const ChartAxis distance = distance_axis(subject, options);
  const Chart upper =
      plot::draw_chart(figure.operations, distance, linear, top, top + distance_chart_height, options.numbers);
  for (std::size_t k = 0; k < subject.curves.size(); ++k)
    draw_curve(figure.operations, upper, subject, k, [](double value) { return value; });
  top += distance_chart_height + between;

  figure.height = top + distance_chart_height + 30.0;
  const Chart lower =
      plot::draw_chart(figure.operations, distance, magnitude_axis(subject, translated("Magnitude |Δd|", options)), top,
                       figure.height, options.numbers);
  if (ranging) draw_instrument(figure.operations, lower, *ranging);
  for (std::size_t k = 0; k < subject.curves.size(); ++k) draw_curve(figure.operations, lower, subject, k, magnitude);
  return figure;
}

}  // namespace axiometry::report
