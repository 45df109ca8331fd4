// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/drift_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/dimension_line.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/iso230_2/monte_carlo/environment_recording.h"

namespace axiometry::report {
namespace {

using plot::Chart;
using plot::ChartAxis;
using plot::ChartRange;
using plot::LegendEntry;
using plot::Operations;
using plot::Range;
namespace ink = plot::ink;

constexpr double time_height = 165.0;
constexpr double spectrum_height = 165.0;
constexpr double charts_apart = 12.0;
constexpr double under_legend = 2.0;
constexpr Colour widest_band = ink::faint(ink::vermilion, 0.12);
const Stroke values_line = ink::solid(ink::blue, 0.8);
const Stroke length_line{.colour = ink::black, .width = 0.7, .dashes = {4.0, 2.2}};

/// Seconds, minutes or hours: what keeps labels short.
plot::AxisUnit time_axis_unit(double longest_s) {
  constexpr double minute = 60.0, hour = 3600.0;
  if (longest_s < 5.0 * minute) return {1.0, {plot::plain("s")}};
  if (longest_s < 5.0 * hour) return {minute, {plot::plain("min")}};
  return {hour, {plot::plain("h")}};
}

class RecordingDrawing {
 public:
  RecordingDrawing(const Subject& subject, const RecordedEnvironment& found, const Options& options)
      : subject_(subject),
        found_(found),
        options_(options),
        kind_(subject.test.metadata.axis.kind),
        values_(subject.test.metadata.gum.drift_recording),
        step_s_(subject.test.metadata.gum.drift_interval->in_s()) {}

  Figure operator()() const {
    Figure figure{.width = plot::plate_width, .height = 0.0, .title = {}, .description = {}, .operations = {}};
    const double first = draw_values(figure.operations);
    figure.height = draw_spectrum(figure.operations, first + charts_apart);
    figure.title = "Recording at standstill (A.2.5): over time, and the sinusoids that it is made of";
    figure.description = fmt::format(
        "{} values over {:.4g} s; over {:.4g} s, as long as is looked at for a test, they range over {} {} at most.",
        values_.size(), step_s_ * double(values_.size() - 1), found_.length_s, shown_range(), scale().unit);
    return figure;
  }

 private:
  std::string word(std::string_view english) const { return translated(english, options_); }
  ParameterScale scale() const { return parameter_scale(kind_, options_.unit); }
  std::string shown_range() const { return shown_uncertainty(Deviation::native(found_.range), scale(), options_); }

  double legend(Operations& operations, const std::vector<LegendEntry>& entries, double top) const {
    return top +
           plot::draw_legend(operations, entries, {plot::header_left, top}, plot::plate_width - plot::header_left) +
           under_legend;
  }

  ChartAxis deviation_axis(ChartRange range, double magnitude, std::string_view title) const {
    return {.low = range.low,
            .high = range.high,
            .unit = plot::deviation_axis_unit(kind_, options_.unit, magnitude),
            .title = word(title)};
  }

  double draw_values(Operations& operations) const {
    Range y;
    for (double value : values_) y.see(value);
    const double end_s = step_s_ * double(values_.size() - 1);
    const double under_label =
        plot::draw_label(operations, word(subject_.assessment.label), plot::header_left, plot::plate_width);
    const std::string widest =
        fmt::format("{} {} {}", word("widest over the time of a test:"), shown_range(), scale().unit);
    const double top =
        legend(operations,
               {{.line = values_line,
                 .band = std::nullopt,
                 .mark = std::nullopt,
                 .text = {plot::plain(word("readings at standstill"))}},
                {.line = std::nullopt, .band = widest_band, .mark = std::nullopt, .text = {plot::plain(widest)}}},
               under_label);
    const ChartAxis x{.low = 0.0, .high = end_s, .unit = time_axis_unit(end_s), .title = word("Time")};
    const Chart chart =
        plot::draw_chart(operations, x, deviation_axis(plot::with_room({y.low, y.high}), y.magnitude(), "Deviation"),
                         top, top + time_height, options_.numbers);
    const double from = chart.x(found_.widest_from_s), to = chart.x(found_.widest_from_s + found_.length_s);
    operations.push_back(Path{.points = {{from, chart.top}, {to, chart.top}, {to, chart.bottom}, {from, chart.bottom}},
                              .closed = true,
                              .stroke = ink::solid(ink::none, 0.0),
                              .fill = widest_band});
    std::vector<Point> points;
    for (std::size_t k = 0; k < values_.size(); ++k)
      points.push_back({chart.x(step_s_ * double(k)), chart.y(values_[k])});
    operations.push_back(plot::polyline(std::move(points), values_line));
    return top + time_height;
  }

  double draw_spectrum(Operations& operations, double above) const {
    const auto sinusoids = recorded_spectrum(subject_.test.metadata);
    Range y;
    y.see(0.0);
    for (const RecordedSinusoid& sinusoid : sinusoids) y.see(sinusoid.amplitude);
    const double longest = sinusoids.front().period_s, shortest = sinusoids.back().period_s;
    const double top = legend(
        operations,
        {{.line = values_line, .band = std::nullopt, .mark = std::nullopt, .text = {plot::plain(word("amplitude"))}},
         {.line = length_line,
          .band = std::nullopt,
          .mark = std::nullopt,
          .text = {plot::plain(word("time of a test"))}}},
        above);
    const ChartAxis x{.low = shortest,
                      .high = longest,
                      .unit = time_axis_unit(longest),
                      .title = word("Period"),
                      .logarithmic = true};
    const ChartRange up{0.0, y.high > 0.0 ? 1.06 * y.high : 1.0};
    const Chart chart = plot::draw_chart(operations, x, deviation_axis(up, up.high, "Amplitude"), top,
                                         top + spectrum_height, options_.numbers);
    if (found_.length_s > shortest && found_.length_s < longest)
      operations.push_back(
          plot::line({chart.x(found_.length_s), chart.top}, {chart.x(found_.length_s), chart.bottom}, length_line));
    std::vector<Point> points;
    for (const RecordedSinusoid& sinusoid : sinusoids)
      points.push_back({std::clamp(chart.x(sinusoid.period_s), chart.left, chart.right), chart.y(sinusoid.amplitude)});
    operations.push_back(plot::polyline(std::move(points), values_line));
    return top + spectrum_height;
  }

  const Subject& subject_;
  const RecordedEnvironment& found_;
  const Options& options_;
  AxisKind kind_;
  const std::vector<double>& values_;
  double step_s_;
};

}  // namespace

std::optional<Figure> drift_recording_figure(const Subject& subject, const Options& asked) {
  const auto found = recorded_environment(subject.test.metadata, course_of(subject.test));
  if (!found) return std::nullopt;
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  return RecordingDrawing(subject, *found, options)();
}

}  // namespace axiometry::report
