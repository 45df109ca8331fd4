// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/residuals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using plot::Chart;
using plot::ChartAxis;
namespace ink = plot::ink;

constexpr double farthest = 6.0;
constexpr double histogram_height = 170.0;
constexpr double below_chart = 30.0;
const Stroke bell_line = ink::solid(ink::black, 1.0);

double density(double x) { return std::exp(-0.5 * x * x) / std::sqrt(2.0 * std::numbers::pi); }

struct Bars {
  double width = 0.5;
  double half = 4.0;           // half of the range shown
  std::vector<double> shares;  // share of all that lies in each bar, in %
  bool outermost_hold_more = false;

  double begin(std::size_t k) const { return -half + width * static_cast<double>(k); }
};

Bars bars_of(const std::vector<double>& values) {
  Bars bars;
  double most = 0.0;
  for (double x : values) most = std::max(most, std::abs(x));
  bars.half = std::clamp(std::ceil(most), 4.0, farthest);
  bars.outermost_hold_more = most > bars.half;
  bars.width = values.size() < 100 ? 1.0 : values.size() < 2000 ? 0.5 : 0.25;
  const auto count = static_cast<std::size_t>(std::lround(2.0 * bars.half / bars.width));
  bars.shares.assign(count, 0.0);
  for (double x : values) {
    const double at = std::clamp((x + bars.half) / bars.width, 0.0, static_cast<double>(count) - 0.5);
    bars.shares[static_cast<std::size_t>(at)] += 100.0 / static_cast<double>(values.size());
  }
  return bars;
}

}  // namespace

std::optional<Figure> residual_figure(std::span<const double> normalised, const Options& options) {
  std::vector<double> values;
  for (double x : normalised)
    if (x != 0.0) values.push_back(x);
  if (values.size() < 10) return std::nullopt;
  const Bars bars = bars_of(values);
  const double bell = 100.0 * bars.width * density(0.0);

  Figure figure{.width = plot::plate_width,
                .height = 0.0,
                .title = "Residuals over their own standard uncertainty",
                .description =
                    "A histogram of all residuals that other readings check, and the normal distribution "
                    "that they follow when the stated uncertainty is right.",
                .operations = {}};
  const char* readings =
      bars.outermost_hold_more ? "readings, with all that lie beyond in the outermost bars" : "readings";
  const std::vector<plot::LegendEntry> legend = {{.line = ink::solid(ink::blue, 0.6),
                                                  .band = ink::faint(ink::blue, 0.3),
                                                  .mark = std::nullopt,
                                                  .text = {plot::plain(translated(readings, options))}},
                                                 {.line = bell_line,
                                                  .band = std::nullopt,
                                                  .mark = std::nullopt,
                                                  .text = {plot::plain(translated("as stated", options))}}};
  const double top =
      plot::draw_legend(figure.operations, legend, {plot::header_left, 0.0}, plot::plate_width - plot::header_left) +
      8.0;
  figure.height = top + histogram_height + below_chart;
  const ChartAxis x{.low = -bars.half,
                    .high = bars.half,
                    .unit = {1.0, {plot::plain(translated("standard uncertainty", options))}},
                    .title = translated("Residual", options)};
  const ChartAxis y{.low = 0.0,
                    .high = 1.06 * std::max(bell, *std::ranges::max_element(bars.shares)),
                    .unit = {1.0, {plot::plain("%")}},
                    .title = translated("Readings", options)};
  const Chart chart = plot::draw_chart(figure.operations, x, y, top, figure.height, options.numbers);
  for (std::size_t k = 0; k < bars.shares.size(); ++k) {
    if (bars.shares[k] == 0.0) continue;
    const double left = chart.x(bars.begin(k)), right = chart.x(bars.begin(k + 1)), high = chart.y(bars.shares[k]);
    figure.operations.push_back(
        Path{.points = {{left, chart.bottom}, {left, high}, {right, high}, {right, chart.bottom}},
             .closed = true,
             .stroke = ink::solid(ink::blue, 0.6),
             .fill = ink::faint(ink::blue, 0.3)});
  }
  Path curve{.points = {}, .closed = false, .stroke = bell_line, .fill = ink::none};
  constexpr int parts = 120;
  for (int k = 0; k <= parts; ++k) {
    const double at = -bars.half + 2.0 * bars.half * k / parts;
    curve.points.push_back({chart.x(at), chart.y(100.0 * bars.width * density(at))});
  }
  figure.operations.push_back(std::move(curve));
  return figure;
}

}  // namespace axiometry::report
