// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/crowd.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/periodic.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using iso230_2::PeriodicDirection;
using iso230_2::PeriodicPoint;
using plot::Chart;
using plot::ChartAxis;
using plot::ChartRange;
using plot::header_left;
using plot::LegendEntry;
using plot::Operations;
using plot::polyline;
using plot::Range;
namespace ink = plot::ink;

constexpr double figure_height = 205.0;
constexpr double legend_gap = 2.0;
constexpr std::size_t most_dots = 20000;  // beyond, a line or bands show as much and make no file of many MB

const Stroke removed_line{.colour = ink::black, .width = 0.9, .dashes = {5.0, 2.2}};
const Stroke curve_line = ink::solid(ink::black, 1.0);
const Stroke level_line{.colour = ink::grey, .width = 0.7, .dashes = {3.0, 1.8}};
const Stroke marked_line = ink::solid(ink::black, 0.7);

/// The figures of one direction.
class PeriodicDrawing {
 public:
  PeriodicDrawing(const PeriodicSubject& subject, const PeriodicDirection& direction, const Options& options)
      : subject_(subject), d_(direction), options_(options), kind_(subject.test.metadata.axis.kind) {}

  Figure deviations() const {
    Range x, y;
    for (const PeriodicPoint& p : d_.points) {
      x.see(p.target.in_native());
      y.see(p.deviation.in_native());
      y.see(p.line.in_native());
    }
    Figure figure = sheet();
    const Chart chart =
        begin(figure, {means_entry(true), line_entry()}, position_axis(x), deviation_axis(y, "Deviation"));
    figure.operations.push_back(polyline({on_line(chart, x.low), on_line(chart, x.high)}, removed_line));
    draw_dots(figure.operations, true, [&](const PeriodicPoint& p) {
      return Point{chart.x(p.target.in_native()), chart.y(p.deviation.in_native())};
    });
    return named(std::move(figure), "Deviations and the straight line that is removed",
                 "Positioning deviations at {} target positions and the straight line through them.");
  }

  Figure residuals() const {
    Range x, y;
    for (const PeriodicPoint& p : d_.points) {
      x.see(p.target.in_native());
      y.see(without_line(p));
    }
    const auto curve = sampled_curve(x.low, x.high);
    for (const Point& p : curve) y.see(p.y);
    Figure figure = sheet();
    const Chart chart = begin(figure, entries_of_dots(), position_axis(x), deviation_axis(y, "Deviation less line"));
    figure.operations.push_back(polyline(on_paper(chart, curve), thin_where_dense(chart)));
    draw_dots(figure.operations, false, [&](const PeriodicPoint& p) {
      return Point{chart.x(p.target.in_native()), chart.y(without_line(p))};
    });
    return named(std::move(figure), "Deviations less the line, with the periodic curve",
                 "Deviations at {} target positions after the straight line was removed, and the fitted curve.");
  }

  Figure folded() const {
    const double period = d_.period.value.in_native();
    const double first = d_.origin.in_native();
    Range y;
    for (const PeriodicPoint& p : d_.points) y.see(without_line(p));
    const auto curve = sampled_curve(first, first + period);
    for (const Point& p : curve) y.see(p.y);
    Figure figure = sheet();
    ChartAxis x{.low = 0.0,
                .high = period,
                .unit = plot::position_axis_unit(kind_, period),
                .title = word("Position within the period, from the first target")};
    const Chart chart = begin(figure, entries_of_dots(), x, deviation_axis(y, "Deviation less line"));
    std::vector<Point> moved = curve;
    for (Point& p : moved) p.x -= first;
    draw_dots(figure.operations, false, [&](const PeriodicPoint& p) {
      return Point{chart.x(std::min(p.phase_deg / 360.0 * period, period)), chart.y(without_line(p))};
    });
    figure.operations.push_back(polyline(on_paper(chart, moved), curve_line));
    return named(std::move(figure), "One period: all targets folded into it, with the curve",
                 "Deviations at {} target positions folded into one period, and the fitted curve.");
  }

  Figure spectrum() const {
    const auto& lines = d_.spectrum;
    const double shortest = lines.back().period.in_native(), longest = lines.front().period.in_native();
    // Beyond the travel a sinusoid and the line are nearly the same, and its amplitude may be anything.
    const double travel = d_.points.back().target.in_native() - d_.points.front().target.in_native();
    Range y;
    y.see(0.0);
    const double amplitude = d_.harmonics.front().amplitude.value.in_native();
    y.see(amplitude);
    y.see(d_.noise_level.in_native());
    for (const auto& line : lines)
      if (line.period.in_native() <= travel) y.see(line.amplitude.in_native());
    if (y.high <= 0.0) y.see(1.0);
    ChartAxis across{.low = shortest,
                     .high = longest,
                     .unit = plot::position_axis_unit(kind_, longest),
                     .title = word("Period"),
                     .logarithmic = true};
    ChartAxis up = deviation_axis(y, "Amplitude");
    up.low = 0.0;
    up.high = 1.15 * y.high;  // room for the label of the period above the peak
    Figure figure = sheet();
    const Chart chart = begin(figure, spectrum_legend(), across, up);
    const double level = chart.y(d_.noise_level.in_native());
    figure.operations.push_back(plot::line({chart.left, level}, {chart.right, level}, level_line));
    figure.operations.push_back(polyline(spectrum_points(chart), ink::solid(ink::of(d_.direction), 0.8)));
    mark_period(figure.operations, chart, amplitude);
    return named(std::move(figure), "Spectrum: amplitude of a sinusoid of each period beside a line",
                 "Amplitude over period of the deviations at {} target positions, with the chosen period marked.");
  }

 private:
  std::string word(std::string_view english) const { return translated(english, options_); }

  double without_line(const PeriodicPoint& p) const { return p.deviation.in_native() - p.line.in_native(); }

  Figure sheet() const {
    return {.width = plot::plate_width, .height = figure_height, .title = {}, .description = {}, .operations = {}};
  }

  Chart begin(Figure& figure, const std::vector<LegendEntry>& legend, const ChartAxis& x, const ChartAxis& y) const {
    double top =
        plot::draw_label(figure.operations, word(subject_.result.label), header_left, plot::plate_width - header_left);
    top += plot::draw_legend(figure.operations, legend, {header_left, top}, plot::plate_width - header_left);
    return plot::draw_chart(figure.operations, x, y, top + legend_gap, figure_height, options_.numbers);
  }

  ChartAxis position_axis(const Range& x) const {
    const std::string& name = subject_.test.metadata.axis.name;
    const ChartRange range = plot::with_room({x.low, x.high}, 0.02);
    return {.low = range.low,
            .high = range.high,
            .unit = plot::position_axis_unit(kind_, x.magnitude()),
            .title =
                name.empty() ? word("Position") : word("Position") + " " + plot::shortened(name, 220.0, ink::text_size),
            .division = kind_ == AxisKind::rotary ? plot::Division::angular : plot::Division::decimal};
  }

  ChartAxis deviation_axis(const Range& y, std::string_view title) const {
    const ChartRange range = plot::with_room({y.low, y.high});
    return {.low = range.low,
            .high = range.high,
            .unit = plot::deviation_axis_unit(kind_, options_.unit, y.magnitude()),
            .title = word(title)};
  }

  Point on_line(const Chart& chart, double position) const {
    return {chart.x(position), chart.y(d_.line_native(position))};
  }

  std::vector<Point> sampled_curve(double from, double to) const {
    constexpr double per_period = 48.0, most = 12000.0;
    const double count =
        std::clamp(std::ceil((to - from) / d_.period.value.in_native() * per_period), per_period, most);
    std::vector<Point> points;
    for (double k = 0.0; k <= count; k += 1.0) {
      const double position = from + (to - from) * k / count;
      points.push_back({position, d_.curve_native(position)});
    }
    return points;
  }

  static std::vector<Point> on_paper(const Chart& chart, std::vector<Point> points) {
    for (Point& p : points) p = {std::clamp(chart.x(p.x), chart.left, chart.right), chart.y(p.y)};
    return points;
  }

  /// Where periods stand close a heavy line would hide the dots.
  Stroke thin_where_dense(const Chart& chart) const {
    const double pitch = (chart.right - chart.left) / std::max(d_.periods_covered, 1.0);
    Stroke stroke = curve_line;
    stroke.width = std::clamp(pitch / 12.0, 0.25, stroke.width);
    return stroke;
  }

  double dot_radius() const {
    constexpr double most = 1.6, least = 0.5;
    return std::clamp(0.35 * plot::plate_width / static_cast<double>(d_.points.size()), least, most);
  }

  Disc dot(double radius) const {
    const bool up = d_.direction == Direction::up;
    return {.centre = {},
            .radius = radius,
            .fill = up ? ink::of(d_.direction) : ink::white,
            .stroke = up ? ink::solid(ink::none, 0.0) : ink::solid(ink::of(d_.direction), 0.6)};
  }

  template <typename Place>
  void draw_dots(Operations& operations, bool joined_up, const Place& place) const {
    std::vector<Point> points;
    for (const PeriodicPoint& p : d_.points) points.push_back(place(p));
    const bool too_many = points.size() > most_dots;
    if (too_many && !joined_up) {
      plot::Crowd shown = plot::crowd(std::move(points));
      plot::draw_stretches(operations, shown.stretches, crowd_band());
      points = std::move(shown.dots);
    }
    if (joined_up) operations.push_back(polyline(points, ink::solid(ink::faint(ink::of(d_.direction), 0.5), 0.5)));
    if (too_many && joined_up) return;
    Disc mark = dot(dot_radius());
    for (const Point& point : points) {
      mark.centre = point;
      operations.push_back(mark);
    }
  }

  /// The highest line of every half point of paper, so that no peak is lost and files stay small.
  std::vector<Point> spectrum_points(const Chart& chart) const {
    std::vector<Point> points;
    for (const auto& line : d_.spectrum) {
      const Point point{chart.x(line.period.in_native()), std::max(chart.y(line.amplitude.in_native()), chart.top)};
      constexpr double pitch = 0.25;
      if (!points.empty() && std::abs(points.back().x - point.x) < pitch)
        points.back().y = std::min(points.back().y, point.y);
      else
        points.push_back({std::clamp(point.x, chart.left, chart.right), point.y});
    }
    if (points.size() == 1) points.push_back(points.front());
    return points;
  }

  void mark_period(Operations& operations, const Chart& chart, double amplitude) const {
    const double x = std::clamp(chart.x(d_.period.value.in_native()), chart.left, chart.right);
    const double y = chart.y(amplitude);
    operations.push_back(plot::line({x, y}, {x, chart.bottom}, marked_line));
    operations.push_back(Disc{.centre = {x, y}, .radius = 2.0, .fill = ink::black});
    const bool on_left = x > (chart.left + chart.right) / 2.0;
    const auto rows = periodic_rows(d_, kind_, options_);
    const std::string unit = rows.front().unit == "°" ? "°" : "\u2009" + rows.front().unit;
    operations.push_back(Text{.runs = {plot::italic("λ"), plot::plain(" = " + rows.front().value + unit)},
                              .at = {x + (on_left ? -5.0 : 5.0), std::max(y - 4.0, chart.top + 7.0)},
                              .size = ink::text_size,
                              .colour = ink::black,
                              .anchor = on_left ? Anchor::end : Anchor::start,
                              .degrees = 0.0});
  }

  LegendEntry means_entry(bool joined_up) const {
    const std::string what = word(d_.runs > 1 ? fmt::format("mean of {} runs", d_.runs) : "reading");
    return {.line = joined_up ? std::optional(ink::solid(ink::faint(ink::of(d_.direction), 0.5), 0.5)) : std::nullopt,
            .band = std::nullopt,
            .mark = dot(1.6),
            .text = {plot::italic("x"), plot::index_letter("i"),
                     plot::plain(fmt::format("{} {}", arrow(d_.direction), what))}};
  }
  Colour crowd_band() const { return ink::faint(ink::of(d_.direction), 0.32); }
  std::vector<LegendEntry> entries_of_dots() const {
    std::vector<LegendEntry> entries = {means_entry(false), curve_entry()};
    if (d_.points.size() > most_dots)
      entries.push_back(plot::crowd_entry(crowd_band(), {plot::plain(word(plot::crowd_words))}));
    return entries;
  }
  LegendEntry line_entry() const {
    return {
        .line = removed_line, .band = std::nullopt, .mark = std::nullopt, .text = {plot::plain(word("straight line"))}};
  }
  LegendEntry curve_entry() const {
    std::string orders;
    for (const auto& h : d_.harmonics)
      if (h.order > 1 && h.significant) orders += fmt::format(" + {}", h.order);
    const std::string text = orders.empty() ? "sinusoid" : fmt::format("curve, harmonics 1{}", orders);
    return {.line = curve_line, .band = std::nullopt, .mark = std::nullopt, .text = {plot::plain(word(text))}};
  }
  std::vector<LegendEntry> spectrum_legend() const {
    return {{.line = ink::solid(ink::of(d_.direction), 0.8),
             .band = std::nullopt,
             .mark = std::nullopt,
             .text = {plot::plain(fmt::format("{} {}", word("amplitude"), arrow(d_.direction)))}},
            {.line = marked_line,
             .band = std::nullopt,
             .mark = Disc{.centre = {}, .radius = 2.0, .fill = ink::black},
             .text = {plot::plain(word(d_.period_known ? "period as given" : "period found"))}},
            {.line = level_line,
             .band = std::nullopt,
             .mark = std::nullopt,
             .text = {plot::plain(word("exceeded somewhere by noise alone in 1 % of tests"))}}};
  }

  Figure named(Figure figure, std::string_view title, std::string_view description) const {
    const bool both = subject_.result.directions.size() > 1;
    figure.title = both ? fmt::format("{} ({})", title, arrow(d_.direction)) : std::string(title);
    figure.description = fmt::format(fmt::runtime(description), d_.points.size());
    return figure;
  }

  const PeriodicSubject& subject_;
  const PeriodicDirection& d_;
  const Options& options_;
  AxisKind kind_;
};

}  // namespace

std::vector<Figure> periodic_figures(const PeriodicSubject& subject, const Options& options) {
  std::vector<Figure> figures;
  for (const PeriodicDirection& direction : subject.result.directions) {
    const PeriodicDrawing drawing(subject, direction, options);
    for (Figure figure : {drawing.deviations(), drawing.residuals(), drawing.folded(), drawing.spectrum()}) {
      figure.title = fmt::format("Figure {}. {}", figures.size() + 1, figure.title);
      figures.push_back(std::move(figure));
    }
  }
  return figures;
}

}  // namespace axiometry::report
