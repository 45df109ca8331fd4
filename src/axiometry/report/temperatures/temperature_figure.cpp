// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/temperatures/temperatures.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

namespace ink = plot::ink;

constexpr double chart_height = 210.0;
constexpr double hour_s = 3600.0;
constexpr std::size_t most_stretches = 600;  // of the width of the figure
constexpr std::size_t most_named = 12;       // sensors in the legend
constexpr Colour test_band = ink::faint(ink::grey, 0.14);
const Stroke limit_line{.colour = ink::black, .width = 0.7, .dashes = {4.0, 2.2}};

Colour colour_of(std::string_view role) {
  if (role == "air") return ink::blue;
  return role == "machine" ? ink::vermilion : ink::black;
}

/// Sensors of one role are told apart by their dashes.
Stroke stroke_of(const TemperatureLog& log, std::size_t k) {
  static const std::vector<double> dashes[] = {{}, {5.0, 2.0}, {1.5, 1.5}, {6.0, 1.8, 1.0, 1.8}, {9.0, 3.0}};
  const auto& role = log.sensors[k].role;
  const auto before = std::ranges::count(log.sensors.begin(), log.sensors.begin() + static_cast<std::ptrdiff_t>(k),
                                         role, &TemperatureCourse::role);
  return {
      .colour = colour_of(role), .width = 0.9, .dashes = dashes[static_cast<std::size_t>(before) % std::size(dashes)]};
}

/// Lines between readings that belong together, thinned so that every extreme stays.
void draw_course(plot::Operations& operations, const plot::Chart& chart, const TemperatureCourse& course,
                 const Stroke& stroke) {
  const double width = (chart.right - chart.left) / static_cast<double>(most_stretches);
  std::vector<Point> line;
  const auto end_line = [&] {
    if (line.size() == 1) line.push_back(line.front());
    if (!line.empty()) operations.push_back(plot::polyline(std::exchange(line, {}), stroke));
  };
  std::size_t k = 0;
  while (k < course.times_s.size()) {
    if (k > 0 && course.times_s[k] - course.times_s[k - 1] > longest_unrecorded_s) end_line();
    const std::size_t first = k;
    std::size_t lowest = k, highest = k;
    const double from = chart.x(course.times_s[first]);
    for (++k; k < course.times_s.size(); ++k) {
      const bool apart = course.times_s[k] - course.times_s[k - 1] > longest_unrecorded_s;
      if (apart || chart.x(course.times_s[k]) - from > width) break;
      if (course.celsius[k] < course.celsius[lowest]) lowest = k;
      if (course.celsius[k] > course.celsius[highest]) highest = k;
    }
    for (const std::size_t at : {std::min(lowest, highest), std::max(lowest, highest)}) {
      if (at == lowest && at == highest && !line.empty() && line.back().x == chart.x(course.times_s[at])) continue;
      line.push_back({chart.x(course.times_s[at]), chart.y(course.celsius[at])});
    }
  }
  end_line();
}

std::vector<plot::LegendEntry> legend_of(const TemperatureSubject& subject, const Options& options, bool limits) {
  std::vector<plot::LegendEntry> entries;
  const auto& sensors = subject.log.sensors;
  for (std::size_t k = 0; k < std::min(sensors.size(), most_named); ++k)
    entries.push_back({.line = stroke_of(subject.log, k),
                       .band = std::nullopt,
                       .mark = std::nullopt,
                       .text = {TextRun{.text = sensors[k].location, .verbatim = true},
                                plot::plain(fmt::format(" ({})", translated(sensors[k].role, options)))}});
  if (sensors.size() > most_named)
    entries.push_back({.line = std::nullopt,
                       .band = std::nullopt,
                       .mark = std::nullopt,
                       .text = {plot::plain(translated(
                           sensors.size() - most_named == 1
                               ? std::string("1 more sensor is not named here")
                               : fmt::format("{} more sensors are not named here", sensors.size() - most_named),
                           options))}});
  if (subject.test)
    entries.push_back({.line = std::nullopt,
                       .band = test_band,
                       .mark = std::nullopt,
                       .text = {plot::plain(translated("time of the test", options))}});
  if (limits)
    entries.push_back({.line = limit_line,
                       .band = std::nullopt,
                       .mark = std::nullopt,
                       .text = {plot::plain(translated("agreed limit", options))}});
  return entries;
}

}  // namespace

Figure temperature_figure(const TemperatureSubject& subject, const Options& options) {
  Figure figure{.width = plot::plate_width, .title = "Temperatures before and during the test"};
  plot::Range y;
  std::size_t readings = 0;
  for (const TemperatureCourse& course : subject.log.sensors) {
    for (const double celsius : course.celsius) y.see(celsius);
    readings += course.celsius.size();
  }
  figure.description =
      fmt::format("{} readings of temperature sensors, from {:.1f} to {:.1f} °C.", readings, y.low, y.high);
  std::vector<double> limits;
  for (const iso230_2::EnvironmentItem& item : subject.environment.items)
    if (item.agreed && (item.key == "lowest_C" || item.key == "highest_C")) limits.push_back(*item.agreed);
  for (const double limit : limits) y.see(limit);
  const TimeStretch log = stretch_of(subject.log.sensors);
  plot::Range x;
  for (const double end : {log.begin_s, log.end_s}) x.see(end);
  if (subject.test)
    for (const double end : {subject.test->begin_s, subject.test->end_s}) x.see(end);
  const double zero = subject.test ? subject.test->begin_s : log.begin_s;
  if (!(x.size() > 0.0)) x.see(x.low + hour_s);
  if (!(y.size() > 0.5)) y.see(y.low - 0.25), y.see(y.low + 0.5);
  const double top = plot::draw_legend(figure.operations, legend_of(subject, options, !limits.empty()),
                                       {plot::header_left, 0.0}, plot::plate_width - plot::header_left) +
                     4.0;
  const plot::ChartRange up = plot::with_room({y.low, y.high});
  const std::string_view from =
      subject.test ? "Time from the beginning of the test" : "Time from the beginning of the log";
  const plot::ChartAxis time{.low = x.low - zero,
                             .high = x.high - zero,
                             .unit = {hour_s, {plot::plain("h")}},
                             .title = translated(from, options)};
  const plot::ChartAxis temperature{
      .low = up.low, .high = up.high, .unit = {1.0, {plot::plain("°C")}}, .title = translated("Temperature", options)};
  plot::Chart chart = plot::draw_chart(figure.operations, time, temperature, top, top + chart_height, options.numbers);
  chart.x_axis.low += zero;  // from here on in the time of the log
  chart.x_axis.high += zero;
  if (subject.test) {
    const double left = chart.x(subject.test->begin_s), right = std::max(left + 0.5, chart.x(subject.test->end_s));
    figure.operations.push_back(
        Path{.points = {{left, chart.top}, {right, chart.top}, {right, chart.bottom}, {left, chart.bottom}},
             .closed = true,
             .stroke = ink::solid(ink::none, 0.0),
             .fill = test_band});
  }
  for (const double limit : limits)
    figure.operations.push_back(plot::line({chart.left, chart.y(limit)}, {chart.right, chart.y(limit)}, limit_line));
  for (std::size_t k = 0; k < subject.log.sensors.size(); ++k)
    draw_course(figure.operations, chart, subject.log.sensors[k], stroke_of(subject.log, k));
  figure.height = top + chart_height;
  return figure;
}

}  // namespace axiometry::report
