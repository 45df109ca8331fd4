// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/compensation_curves.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/report/figures/parts/chart.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/range.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using iso230_2::Evaluation;
using plot::Chart;
namespace ink = plot::ink;

constexpr double before_alpha = 0.38;
constexpr double corrected_band_alpha = 0.16;
constexpr double corrected_coverage = 2.0;
constexpr std::array compensated_directions{Direction::up, Direction::down};

/// A line through some points, in the ink of its direction.
struct CurveOfDirection {
  Direction direction = Direction::up;
  std::vector<Point> points;  // position, value
  bool faint = false;
  bool as_dots = false;
  std::string words;
  std::vector<double> u{};  // standard uncertainty of each value; empty: no band
};

Stroke stroke_of(const CurveOfDirection& curve) {
  Stroke stroke = ink::mean_line(curve.direction);
  if (curve.faint) stroke.colour = ink::faint(stroke.colour, before_alpha);
  return stroke;
}

std::vector<Point> means_of(const Evaluation& evaluation, Direction direction) {
  std::vector<Point> points;
  for (const iso230_2::PositionResult& p : evaluation.positions)
    if (const auto& mean = direction == Direction::up ? p.mean_up : p.mean_down)
      points.push_back({p.target.in_native(), mean->in_native()});
  return points;
}

std::vector<Point> nodes_of_table(const AxisCorrection& correction, Direction direction) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < correction.positions().size(); ++k)
    points.push_back({correction.positions()[k], correction.values(direction)[k]});
  return points;
}

/// A table holds its last values beyond its ends.
std::vector<Point> held_to(std::vector<Point> points, double first, double last) {
  if (points.front().x > first) points.insert(points.begin(), {first, points.front().y});
  if (points.back().x < last) points.push_back({last, points.back().y});
  return points;
}

plot::LegendEntry entry_of(const CurveOfDirection& curve, const Options& options) {
  plot::LegendEntry entry{
      .line = curve.as_dots ? std::nullopt : std::optional(stroke_of(curve)),
      .band = std::nullopt,
      .mark = curve.as_dots ? std::optional(Disc{.centre = {}, .radius = 1.9, .fill = ink::of(curve.direction)})
                            : std::nullopt,
      .text = {plot::plain(translated(curve.words, options))}};
  if (curve.u.empty()) return entry;
  entry.band = ink::faint(ink::of(curve.direction), corrected_band_alpha);
  for (TextRun& run : std::vector<TextRun>{plot::plain(", ±"), plot::italic("U"), plot::plain(" ("), plot::italic("k"),
                                           plot::plain(" = 2)")})
    entry.text.push_back(std::move(run));
  return entry;
}

/// The band of ±U about a curve: there and back.
Path band_of(const CurveOfDirection& curve, const Chart& chart) {
  Path band{.closed = true,
            .stroke = ink::solid(ink::faint(ink::of(curve.direction), 0.4), 0.4),
            .fill = ink::faint(ink::of(curve.direction), corrected_band_alpha)};
  const auto place = [&](std::size_t k, double share) {
    return Point{chart.x(curve.points[k].x), chart.y(curve.points[k].y + share * corrected_coverage * curve.u[k])};
  };
  for (std::size_t k = 0; k < curve.points.size(); ++k) band.points.push_back(place(k, 1.0));
  for (std::size_t k = curve.points.size(); k-- > 0;) band.points.push_back(place(k, -1.0));
  return band;
}

Figure drawn(std::span<const CurveOfDirection> curves, AxisKind kind, const char* value_title, const Options& options,
             double height, Figure figure) {
  std::vector<plot::LegendEntry> entries;
  plot::Range along, values;
  for (const CurveOfDirection& curve : curves) {
    if (!curve.words.empty()) entries.push_back(entry_of(curve, options));
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      const double half = curve.u.empty() ? 0.0 : corrected_coverage * curve.u[k];
      along.see(curve.points[k].x);
      values.see(curve.points[k].y - half), values.see(curve.points[k].y + half);
    }
  }
  values.see(0.0);
  const double top =
      plot::draw_legend(figure.operations, entries, {plot::header_left, 0.0}, plot::plate_width - plot::header_left) +
      4.0;
  figure.width = plot::plate_width;
  figure.height = top + height + 34.0;
  const plot::ChartRange across = plot::with_room({along.low, along.high}, 0.02);
  const plot::ChartRange up = plot::with_room({values.low, values.high});
  const Chart chart = plot::draw_chart(figure.operations,
                                       {.low = across.low,
                                        .high = across.high,
                                        .unit = {1.0, {plot::plain(std::string(position_unit(kind)))}},
                                        .title = translated("Position", options)},
                                       {.low = up.low,
                                        .high = up.high,
                                        .unit = {1.0, {plot::plain(std::string(deviation_unit(kind)))}},
                                        .title = translated(value_title, options)},
                                       top, figure.height, options.numbers);
  for (const CurveOfDirection& curve : curves)
    if (!curve.u.empty()) figure.operations.push_back(band_of(curve, chart));
  for (const CurveOfDirection& curve : curves) {
    std::vector<Point> places;
    for (const Point& p : curve.points) places.push_back({chart.x(p.x), chart.y(p.y)});
    if (curve.as_dots) {
      for (const Point& p : places)
        figure.operations.push_back(Disc{.centre = p, .radius = 1.9, .fill = ink::of(curve.direction)});
    } else if (places.size() > 1) {
      figure.operations.push_back(plot::polyline(std::move(places), stroke_of(curve)));
    }
  }
  return figure;
}

std::string with_arrow(const char* words, Direction direction) {
  return std::string(words) + " " + std::string(arrow(direction));
}

/// The positions of a table as dots, where they do not run into each other.
void add_nodes(const AxisCorrection& table, std::vector<CurveOfDirection>& curves) {
  constexpr std::size_t most = 60;
  if (table.positions().size() > most) return;
  for (const Direction direction : compensated_directions)
    curves.push_back({direction, nodes_of_table(table, direction), false, true, ""});
}

Figure added_to_command(std::span<const CurveOfDirection> curves, AxisKind kind, const Options& options) {
  return drawn(curves, kind, "Added to the command", options, 150.0,
               {.title = "What the control adds",
                .description = "What the control adds to the commanded position, in both directions of approach."});
}

}  // namespace

Figure before_and_predicted_figure(const CompensationSubject& subject, const Options& options) {
  std::vector<CurveOfDirection> curves;
  const auto add = [&](const Evaluation& evaluation, const char* words, bool faint, bool as_dots) {
    for (const Direction direction : compensated_directions)
      if (auto points = means_of(evaluation, direction); !points.empty())
        curves.push_back({direction, std::move(points), faint, as_dots, with_arrow(words, direction)});
  };
  add(subject.before, "before", true, false);
  add(subject.predicted, "predicted", false, false);
  if (subject.retest) add(*subject.retest, "re-test", false, true);
  return drawn(curves, subject.test.metadata.axis.kind, "Mean deviation", options, 210.0,
               {.title = "Mean deviations before and with the table",
                .description = "Mean deviations of every target and direction as they were measured, and as they would "
                               "be with the table in the control."});
}

Figure correction_figure(const CompensationSubject& subject, const Options& options) {
  const double first = subject.test.series.targets().front().in_native();
  const double last = subject.test.series.targets().back().in_native();
  std::vector<CurveOfDirection> curves;
  const auto add = [&](const AxisCorrection& correction, const char* words, bool faint) {
    for (const Direction direction : compensated_directions)
      curves.push_back({direction, held_to(nodes_of_table(correction, direction), first, last), faint, false,
                        with_arrow(words, direction)});
  };
  if (subject.existing) add(*subject.existing, "table so far", true);
  add(subject.applied, "new table", false);
  add_nodes(subject.applied, curves);
  return added_to_command(curves, subject.applied.kind(), options);
}

Figure corrected_line_figure(const CorrectedLine& line, const Options& options) {
  std::vector<CurveOfDirection> curves;
  const auto add = [&](const DisplacementsOfLine& found, Direction direction) {
    CurveOfDirection before{.direction = direction, .faint = true};
    CurveOfDirection with{.direction = direction, .u = {found.u_um.begin(), found.u_um.end()}};
    before.words = line.has_directions ? with_arrow("without the table", direction) : "without the table";
    with.words = line.has_directions ? with_arrow("with the table", direction) : "with the table";
    for (std::size_t k = 0; k < line.positions_mm.size(); ++k) {
      const double position = line.positions_mm[k];
      before.points.push_back({position, found.values_um[k]});
      with.points.push_back({position, found.values_um[k] + line.applied.at(position, direction)});
    }
    curves.push_back(std::move(before));
    curves.push_back(std::move(with));
  };
  add(line.up, Direction::up);
  if (line.has_directions) add(line.down, Direction::down);
  return drawn(curves, AxisKind::linear, "Displacement", options, 200.0,
               {.title = "Displacement on the line without and with the table",
                .description = "Displacement of the tool point along the line through the middle of the volume, "
                               "without the table and with it, with the band of its uncertainty."});
}

Figure line_correction_figure(const CorrectedLine& line, const Options& options) {
  const double first = line.positions_mm.front(), last = line.positions_mm.back();
  std::vector<CurveOfDirection> curves;
  for (const Direction direction : compensated_directions)
    curves.push_back({direction, held_to(nodes_of_table(line.applied, direction), first, last), false, false,
                      with_arrow("new table", direction)});
  add_nodes(line.applied, curves);
  return added_to_command(curves, AxisKind::linear, options);
}

}  // namespace axiometry::report
