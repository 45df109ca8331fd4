// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/curves.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/thinned.h"
#include "axiometry/report/translated.h"

namespace axiometry::report::plot {
namespace {

/// Beyond this many readings single dots show nothing that the band does not, and make files of many MB.
constexpr std::size_t most_readings_drawn = 20000;

bool draws_readings(const Plate& plate) {
  return plate.test.series.reading_count() <= most_readings_drawn && plate.test.series.run_count() > 1;
}

bool marks_means(const Plate& plate) { return plate.evaluation.positions.size() <= most_points_shown; }

bool has_band(const Plate& plate, Direction direction) {
  return std::ranges::any_of(plate.evaluation.positions,
                             [&](const auto& p) { return standard_deviation(p, direction).has_value(); });
}

/// Neighbouring targets that all have a value.
using Stretch = std::vector<Point>;

template <typename Value>
std::vector<Stretch> stretches(const Plate& plate, const PlateLayout& layout, Value value) {
  std::vector<Stretch> result;
  bool open = false;
  for (std::size_t i = 0; i < plate.evaluation.positions.size(); ++i) {
    const std::optional<double> native = value(plate.evaluation.positions[i]);
    if (!native) {
      open = false;
      continue;
    }
    if (!open) result.emplace_back();
    open = true;
    result.back().push_back({layout.target_x[i], layout.y(*native)});
  }
  for (Stretch& stretch : result) stretch = thinned(std::move(stretch));
  return result;
}

std::vector<Stretch> mean_stretches(const Plate& plate, const PlateLayout& layout, Direction direction) {
  return stretches(plate, layout, [&](const iso230_2::PositionResult& p) -> std::optional<double> {
    const auto m = mean(p, direction);
    return m ? std::optional(m->in_native()) : std::nullopt;
  });
}

/// mean + `sign`·2 s.
std::vector<Stretch> boundary_stretches(const Plate& plate, const PlateLayout& layout, Direction direction,
                                        double sign) {
  return stretches(plate, layout, [&](const iso230_2::PositionResult& p) -> std::optional<double> {
    if (!standard_deviation(p, direction)) return std::nullopt;
    return mean(p, direction)->in_native() + sign * half_band(p, direction);
  });
}

void draw_bands(Operations& operations, const Plate& plate, const PlateLayout& layout, Direction direction) {
  const auto upper = boundary_stretches(plate, layout, direction, 1.0);
  const auto lower = boundary_stretches(plate, layout, direction, -1.0);
  for (std::size_t k = 0; k < upper.size(); ++k) {
    if (upper[k].size() == 1) {  // a band without width
      operations.push_back(line(upper[k].front(), lower[k].front(), ink::boundary_line(direction)));
      continue;
    }
    Stretch outline = upper[k];
    outline.insert(outline.end(), lower[k].rbegin(), lower[k].rend());
    operations.push_back(Path{.points = std::move(outline),
                              .closed = true,
                              .stroke = ink::solid(ink::none, 0.0),
                              .fill = ink::faint(ink::of(direction), ink::band_alpha)});
    operations.push_back(polyline(upper[k], ink::boundary_line(direction)));
    operations.push_back(polyline(lower[k], ink::boundary_line(direction)));
  }
}

Disc reading_dot(Direction direction, double radius) {
  return {.centre = {}, .radius = radius, .fill = ink::faint(ink::of(direction), ink::reading_alpha)};
}

/// Filled for ↑, open for ↓: told apart in grey as well.
Disc mean_mark(Direction direction, double radius) {
  const bool up = direction == Direction::up;
  return {.centre = {},
          .radius = radius,
          .fill = up ? ink::of(direction) : ink::white,
          .stroke = up ? ink::solid(ink::none, 0.0) : ink::solid(ink::of(direction), 0.7)};
}

constexpr double full_mark_radius = 1.7;
constexpr double full_dot_radius = 0.95;

double mark_radius(const PlateLayout& layout) { return std::clamp(0.3 * layout.target_pitch, 0.6, full_mark_radius); }
double dot_radius(const PlateLayout& layout) { return std::clamp(0.2 * layout.target_pitch, 0.4, full_dot_radius); }

void draw_readings(Operations& operations, const Plate& plate, const PlateLayout& layout, Direction direction) {
  Disc dot = reading_dot(direction, dot_radius(layout));
  for (std::size_t i = 0; i < layout.target_x.size(); ++i) {
    for (const double reading : plate.test.series.cell(i, direction)) {
      if (std::isnan(reading)) continue;
      dot.centre = {layout.target_x[i], layout.y(reading)};
      operations.push_back(dot);
    }
  }
}

void draw_means(Operations& operations, const Plate& plate, const PlateLayout& layout, Direction direction) {
  const auto means = mean_stretches(plate, layout, direction);
  for (const Stretch& stretch : means) {
    if (stretch.size() > 1) operations.push_back(polyline(stretch, ink::mean_line(direction)));
  }
  Disc mark = mean_mark(direction, mark_radius(layout));
  for (const Stretch& stretch : means) {
    if (!marks_means(plate) && stretch.size() > 1) continue;
    for (const Point& point : stretch) {
      mark.centre = point;
      operations.push_back(mark);
    }
  }
}

void draw_bidirectional_mean(Operations& operations, const Plate& plate, const PlateLayout& layout) {
  const auto means = stretches(plate, layout, [](const iso230_2::PositionResult& p) {
    return p.mean ? std::optional(p.mean->in_native()) : std::nullopt;
  });
  for (const Stretch& stretch : means) {
    if (stretch.size() > 1) {
      operations.push_back(polyline(stretch, ink::bidirectional_mean_line()));
    } else {
      const double reach = mark_radius(layout);
      const Point p = stretch.front();
      operations.push_back(line({p.x - reach, p.y}, {p.x + reach, p.y}, ink::bidirectional_mean_line()));
    }
  }
}

}  // namespace

void draw_curves(Operations& operations, const Plate& plate, const PlateLayout& layout) {
  for (const Direction direction : plate.directions) draw_bands(operations, plate, layout, direction);
  if (draws_readings(plate)) {
    for (const Direction direction : plate.directions) draw_readings(operations, plate, layout, direction);
  }
  if (plate.bidirectional_mean) draw_bidirectional_mean(operations, plate, layout);
  for (const Direction direction : plate.directions) draw_means(operations, plate, layout, direction);
}

std::vector<LegendEntry> legend_of(const Plate& plate) {
  std::vector<LegendEntry> entries;
  for (const Direction direction : plate.directions) {
    const Runs mean_symbol = {barred("x"), index_letter("i"), plain(arrow(direction))};
    entries.push_back(
        {.line = ink::mean_line(direction),
         .band = std::nullopt,
         .mark = marks_means(plate) ? std::optional(mean_mark(direction, full_mark_radius)) : std::nullopt,
         .text = mean_symbol});
    if (!has_band(plate, direction)) continue;
    const Runs band = {plain(" ± 2"), italic("s"), index_letter("i"), plain(arrow(direction))};
    entries.push_back({.line = ink::boundary_line(direction),
                       .band = ink::faint(ink::of(direction), ink::band_alpha),
                       .mark = std::nullopt,
                       .text = joined(mean_symbol, band)});
  }
  if (plate.bidirectional_mean) {
    entries.push_back({.line = ink::bidirectional_mean_line(),
                       .band = std::nullopt,
                       .mark = std::nullopt,
                       .text = {barred("x"), index_letter("i")}});
  }
  if (draws_readings(plate)) {
    entries.push_back({.line = std::nullopt,
                       .band = std::nullopt,
                       .mark = reading_dot(plate.directions.front(), full_dot_radius),
                       .text = {plain(translated("readings", plate.options) + " "), italic("x"), index_letter("ij")}});
  }
  return entries;
}

}  // namespace axiometry::report::plot
