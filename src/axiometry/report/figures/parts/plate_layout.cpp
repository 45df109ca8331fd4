// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/plate_layout.h"

#include <algorithm>
#include <cmath>

#include "axiometry/report/figures/parts/axis_measures.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/range.h"

namespace axiometry::report::plot {
namespace {

constexpr double index_row = 9.0;
constexpr double callout_row = 11.0;
constexpr double target_inset = 16.0;       // of the first and last target, for their dimension lines
constexpr double dimension_offset = 8.0;    // of a dimension line from its target, about
constexpr double first_margin_line = 17.0;  // from the plot
constexpr double margin_pitch = 17.0;
constexpr double margin_edge = 7.0;
constexpr double y_tick_count = 8.0;
constexpr double data_inset = 10.0;  // points between the data and the plot's upper and lower edge

Range deviation_range(const Plate& plate) {
  Range range;
  const auto& positions = plate.evaluation.positions;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (const Direction direction : plate.directions) {
      for (const double reading : plate.test.series.cell(i, direction)) {
        if (!std::isnan(reading)) range.see(reading);
      }
      if (const auto m = mean(positions[i], direction)) {
        const double half = half_band(positions[i], direction);
        range.see(m->in_native() - half);
        range.see(m->in_native() + half);
      }
    }
  }
  return range;
}

/// Zero belongs to the picture unless it would squeeze the data into less than half of it; data
/// without a range get one.
Range shown_range(Range range) {
  constexpr double flat = 1e-9;  // of the magnitude: far below any measurement, far above rounding
  const bool is_flat = range.size() <= flat * range.magnitude();
  const double to_zero = range.low > 0.0 ? range.low : range.high < 0.0 ? -range.high : 0.0;
  if (is_flat || to_zero <= range.size()) range.see(0.0);
  if (range.size() <= 0.0) range = {-1.0, 1.0};
  return range;
}

/// As many ticks as leave room between their labels.
Ticks position_ticks(double low, double high, double paper, Division division, NumberStyle style) {
  constexpr double label_gap = 18.0;
  constexpr double most = 11.0;
  for (double wanted = most; wanted > 1.0; wanted -= 1.0) {
    Ticks ticks = divide(low, high, wanted, division);
    const double pitch = ticks.major.size() < 2 ? paper : paper * (ticks.major[1] - ticks.major[0]) / (high - low);
    if (widest_label(ticks, style) + label_gap <= pitch) return ticks;
  }
  return divide(low, high, 1.0, division);
}

void lay_out_positions(PlateLayout& layout, const Plate& plate) {
  const auto targets = plate.test.series.targets();
  const AxisKind kind = plate.test.metadata.axis.kind;
  const double first = targets.front().in_native();
  const double last = targets.back().in_native();
  layout.x_unit = position_axis_unit(kind, std::max(std::abs(first), std::abs(last)));
  const auto shown = [&](Position p) { return p.in_native() / layout.x_unit.native; };

  double low = shown(targets.front());
  double high = shown(targets.back());
  // Neighbouring doubles may meet after the division.
  const double least = 1e-13 * std::max({std::abs(low), std::abs(high), 1e-280});
  if (high - low < least) high = low + least;
  const double paper = layout.right - layout.left - 2.0 * target_inset;
  layout.x = {low, high, layout.left + target_inset, layout.right - target_inset};
  for (const Position target : targets) layout.target_x.push_back(std::min(layout.x(shown(target)), layout.right));

  const double overhang = (high - low) * (target_inset - 2.0) / paper;
  layout.x_ticks =
      position_ticks(low - overhang, high + overhang, layout.right - layout.left,
                     kind == AxisKind::rotary ? Division::angular : Division::decimal, plate.options.numbers);
  layout.target_pitch = paper / static_cast<double>(targets.size() - 1);
}

/// Where targets stand close, between two of them rather than upon the next one.
double offset_from_target(double target_pitch) {
  constexpr double least = 3.5;
  if (target_pitch >= 2.0 * dimension_offset || target_pitch < least / 2.0) return dimension_offset;
  const double halfway = target_pitch * (std::round(dimension_offset / target_pitch - 0.5) + 0.5);
  return std::max(halfway, least);
}

/// Returns the number of rows.
int lay_out_callouts(PlateLayout& layout, const Plate& plate) {
  const double offset = offset_from_target(layout.target_pitch);
  std::vector<CalloutRequest> requests;
  for (const TargetDimension& dimension : plate.at_targets) {
    const bool on_left = dimension.side == TargetDimension::Side::left;
    const double x = layout.target_x[dimension.target()] + (on_left ? -offset : offset);
    layout.dimension_x.push_back(x);
    requests.push_back({x, text_width(dimension.label, ink::text_size), on_left});
  }
  layout.callouts = place_callouts(requests, layout.left - title_room, plate_width - figure_edge);
  int rows = 0;
  for (const CalloutPlace& place : layout.callouts) rows = std::max(rows, place.row + 1);
  return rows;
}

}  // namespace

double PlateLayout::callout_base_line(int row) const { return top - index_row - 3.5 - row * callout_row; }

PlateLayout lay_out(const Plate& plate, double header_height) {
  PlateLayout layout;
  const Range data = shown_range(deviation_range(plate));
  layout.y_unit = deviation_axis_unit(plate.test.metadata.axis.kind, plate.options.unit, data.magnitude());
  const double y_native = layout.y_unit.native;
  const Ticks first_ticks = divide(data.low / y_native, data.high / y_native, y_tick_count, Division::decimal);
  layout.left = figure_edge + title_room + widest_label(first_ticks, plate.options.numbers) + tick_and_gap;
  layout.right = plate_width - figure_edge;
  if (!plate.at_margin.empty()) {
    const double lines = static_cast<double>(plate.at_margin.size() - 1);
    layout.right = plate_width - margin_edge - first_margin_line - lines * margin_pitch;
  }
  for (std::size_t k = 0; k < plate.at_margin.size(); ++k) {
    layout.margin_x.push_back(layout.right + first_margin_line + static_cast<double>(k) * margin_pitch);
  }

  lay_out_positions(layout, plate);
  const int rows = lay_out_callouts(layout, plate);
  layout.top = header_height + rows * callout_row + index_row + 3.0;
  layout.bottom = plate_height - below_plot;
  const double inset = data.size() * data_inset / (layout.bottom - layout.top - 2.0 * data_inset);
  layout.y = {data.low - inset, data.high + inset, layout.bottom, layout.top};
  layout.y_ticks =
      divide(layout.y.value_low / y_native, layout.y.value_high / y_native, y_tick_count, Division::decimal);
  return layout;
}

}  // namespace axiometry::report::plot
