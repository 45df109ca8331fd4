// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/plate.h"

#include <algorithm>
#include <cmath>

#include "axiometry/report/drawing/text_layout.h"
#include "axiometry/report/figures/parts/curves.h"
#include "axiometry/report/figures/parts/frame.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate_layout.h"
#include "axiometry/report/translated.h"

namespace axiometry::report::plot {
namespace {

constexpr double extension_overshoot = 2.0;  // beyond the dimension line
constexpr double extension_gap = 2.6;        // from the point that is measured
constexpr double margin_label_gap = 2.6;     // between a margin label and its line

DimensionLine dimension_line(const PlateLayout& layout, const Extent& extent, double x) {
  return {.x = x, .top = layout.deviation_y(extent.high), .bottom = layout.deviation_y(extent.low)};
}

void draw_at_targets(Operations& operations, const Plate& plate, const PlateLayout& layout) {
  for (std::size_t k = 0; k < plate.at_targets.size(); ++k) {
    const TargetDimension& dimension = plate.at_targets[k];
    const DimensionLine upright = dimension_line(layout, dimension.extent, layout.dimension_x[k]);
    const double target = layout.target_x[dimension.target()];
    const double towards = upright.x < target ? -1.0 : 1.0;
    for (const double y : {upright.top, upright.bottom}) {
      const double inner = target + towards * extension_gap;
      const double outer = upright.x + towards * extension_overshoot;
      draw_extension_line(operations, std::min(inner, outer), std::max(inner, outer), y, {});
    }
    draw_dimension_line(operations, upright);

    const CalloutPlace& place = layout.callouts[k];
    const double base_line = layout.callout_base_line(place.row);
    const double leader_top = base_line - 0.5 * ink::text_size;
    operations.push_back(line({upright.x, leader_top}, {upright.x, upper_end(upright)}, ink::solid(ink::grey, 0.35)));
    operations.push_back(Text{.runs = dimension.label,
                              .at = {place.text_left, base_line},
                              .size = ink::text_size,
                              .colour = ink::black,
                              .anchor = Anchor::start,
                              .degrees = 0.0});
  }
}

/// The extension lines that pass the label of column k: its own and those of the columns further out.
std::vector<double> lines_across(const Plate& plate, const PlateLayout& layout, std::size_t k) {
  std::vector<double> lines;
  for (; k < plate.at_margin.size(); ++k) {
    lines.push_back(layout.deviation_y(plate.at_margin[k].extent.high));
    lines.push_back(layout.deviation_y(plate.at_margin[k].extent.low));
  }
  return lines;
}

/// Middle of a label of this half length along its column: as near as possible to what it measures
/// without touching a line; where nothing is free, right there, and the lines are broken.
double margin_label_middle(const PlateLayout& layout, const Extent& extent, double half,
                           const std::vector<double>& lines) {
  constexpr double room = 2.5;
  const double wanted = (layout.deviation_y(extent.low) + layout.deviation_y(extent.high)) / 2.0;
  const double highest = layout.top + half;
  const double lowest = std::max(layout.bottom - half, highest);
  std::vector<double> candidates = {wanted};
  for (const double y : lines) candidates.insert(candidates.end(), {y - half - room, y + half + room});
  std::ranges::sort(candidates, {}, [&](double y) { return std::abs(y - wanted); });
  const auto is_free = [&](double middle) {
    return middle >= highest && middle <= lowest &&
           std::ranges::none_of(lines, [&](double y) { return std::abs(y - middle) < half + 0.9 * room; });
  };
  const auto found = std::ranges::find_if(candidates, is_free);
  return found != candidates.end() ? *found : std::clamp(wanted, highest, lowest);
}

Text margin_label(const Plate& plate, const PlateLayout& layout, std::size_t k) {
  const MarginDimension& dimension = plate.at_margin[k];
  const double half = text_width(dimension.label, ink::text_size) / 2.0;
  const double middle = margin_label_middle(layout, dimension.extent, half, lines_across(plate, layout, k));
  return {.runs = dimension.label,
          .at = {layout.margin_x[k] - margin_label_gap, middle},
          .size = ink::text_size,
          .colour = ink::black,
          .anchor = Anchor::middle,
          .degrees = 90.0};
}

void draw_at_margin(Operations& operations, const Plate& plate, const PlateLayout& layout) {
  std::vector<Text> labels;
  for (std::size_t k = 0; k < plate.at_margin.size(); ++k) labels.push_back(margin_label(plate, layout, k));
  for (std::size_t k = 0; k < plate.at_margin.size(); ++k) {
    const Extent& extent = plate.at_margin[k].extent;
    const DimensionLine upright = dimension_line(layout, extent, layout.margin_x[k]);
    const auto extend = [&](double y, std::size_t target) {
      std::vector<Gap> gaps;
      for (const Text& label : labels) {
        const Box box = text_box(label);
        if (y > box.top - 1.0 && y < box.bottom + 1.0) gaps.push_back({box.left - 1.0, box.right + 1.0});
      }
      draw_extension_line(operations, layout.target_x[target] + extension_gap, upright.x + extension_overshoot, y,
                          std::move(gaps));
    };
    extend(upright.top, extent.high_at);
    extend(upright.bottom, extent.low_at);
    draw_dimension_line(operations, upright);
  }
  for (Text& label : labels) operations.push_back(std::move(label));
}

}  // namespace

Figure draw(const Plate& plate) {
  Figure figure{.width = plate_width, .height = plate_height, .title = {}, .description = {}, .operations = {}};
  Operations& operations = figure.operations;
  double header =
      draw_label(operations, translated(plate.label, plate.options), header_left, plate_width - header_left);
  header += draw_legend(operations, legend_of(plate), {header_left, header}, plate_width - header_left);
  const PlateLayout layout = lay_out(plate, header);
  draw_grid(operations, layout);
  draw_curves(operations, plate, layout);
  draw_axes(operations, plate, layout);
  draw_at_margin(operations, plate, layout);
  draw_at_targets(operations, plate, layout);
  return figure;
}

}  // namespace axiometry::report::plot
