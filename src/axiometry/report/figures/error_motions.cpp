// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/error_motions.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "axiometry/report/figures/parts/axis_measures.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/pane.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/translated.h"
#include "axiometry/volumetric/field/curve_nodes.h"

namespace axiometry::report {
namespace {

using plot::Pane;
using plot::Range;
using volumetric::CurveNode;
using volumetric::ErrorMotion;
namespace ink = plot::ink;

constexpr std::size_t motion_columns = 3;
constexpr double motion_row_height = 92.0;
constexpr double coverage_factor = 2.0;
constexpr double pane_gap = 15.0;
constexpr double motion_band_alpha = 0.18;

using Nodes = std::vector<CurveNode>;

class MotionDrawing {
 public:
  MotionDrawing(const volumetric::ErrorModel& model, std::size_t axis, const Options& options)
      : axis_(axis), options_(options), has_directions_(model.coefficients().reversal() != volumetric::Reversal::none) {
    across_.see(model.observed().lowest_mm[axis]);
    across_.see(model.observed().highest_mm[axis]);
    for (std::size_t m = 0; m < nodes_.size(); ++m) nodes_[m] = volumetric::curve_nodes(model, {axis, m}, 61);
  }

  Figure draw() {
    figure_.width = plot::plate_width;
    figure_.title = fmt::format("Error motions of {}", "XYZ"[axis_]);
    figure_.description =
        "The three displacements and the three rotations of the axis over its position, with the bands in which they "
        "lie.";
    const double legend = plot::draw_legend(figure_.operations, entries(), {plot::header_left, 0.0},
                                            plot::plate_width - plot::header_left);
    const std::array<Range, 2> up = {range_of(0), range_of(1)};
    const double labels = std::max(plot::pane_label_width(up[0], motion_row_height, options_.numbers),
                                   plot::pane_label_width(up[1], motion_row_height, options_.numbers));
    left_ = plot::figure_edge + plot::title_room + labels;
    double top = legend + 4.0 + plot::pane_title_room;
    for (std::size_t row = 0; row < 2; ++row) {
      draw_row(row, up[row], top);
      top += motion_row_height + plot::pane_label_room + plot::pane_title_room + 4.0;
    }
    const double bottom = top - plot::pane_label_room - plot::pane_title_room - 4.0;
    figure_.operations.push_back(plot::label({plot::plain(translated("Position", options_) + " / mm")},
                                             {(left_ + right_edge()) / 2.0, bottom + plot::pane_axis_room - 1.5},
                                             ink::text_size, Anchor::middle));
    figure_.height = bottom + plot::pane_axis_room + 2.0;
    return std::move(figure_);
  }

 private:
  static double right_edge() { return plot::plate_width - 10.0; }

  std::vector<plot::LegendEntry> entries() const {
    std::vector<plot::LegendEntry> entries;
    entries.push_back(
        {.line = ink::solid(has_directions_ ? ink::black : ink::blue, has_directions_ ? 0.7 : 1.15),
         .band = std::nullopt,
         .mark = std::nullopt,
         .text = {plot::plain(translated(has_directions_ ? "mean of both directions" : "error", options_))}});
    if (has_directions_) {
      entries.push_back({.line = ink::mean_line(Direction::up),
                         .band = std::nullopt,
                         .mark = std::nullopt,
                         .text = {plot::plain(translated("moving up", options_))}});
      entries.push_back({.line = ink::mean_line(Direction::down),
                         .band = std::nullopt,
                         .mark = std::nullopt,
                         .text = {plot::plain(translated("moving down", options_))}});
    }
    entries.push_back(
        {.line = ink::solid(ink::faint(ink::blue, 0.4), 0.4),
         .band = ink::faint(ink::blue, motion_band_alpha),
         .mark = std::nullopt,
         .text = {plot::plain("±"), plot::italic("U"), plot::plain(" ("), plot::italic("k"), plot::plain(" = 2)")}});
    return entries;
  }

  /// Of three panes, so that their sizes can be compared.
  Range range_of(std::size_t row) const {
    Range range;
    for (std::size_t column = 0; column < motion_columns; ++column)
      for (const CurveNode& node : nodes_[row * motion_columns + column]) {
        range.see(node.mean.value - coverage_factor * node.mean.u);
        range.see(node.mean.value + coverage_factor * node.mean.u);
        for (const auto& own : {node.up, node.down})
          if (own) range.see(own->value);
      }
    if (!range.any()) return {-1.0, 1.0};
    const double room = std::max(0.06 * range.size(), 1e-3);
    return {range.low - room, range.high + room};
  }

  void draw_row(std::size_t row, const Range& up, double top) {
    const double width = (right_edge() - left_ - pane_gap * (motion_columns - 1)) / motion_columns;
    for (std::size_t column = 0; column < motion_columns; ++column) {
      const double left = left_ + static_cast<double>(column) * (width + pane_gap);
      const Pane pane{left, left + width, top, top + motion_row_height, across_, up, true, column == 0};
      const ErrorMotion error{axis_, row * motion_columns + column};
      plot::draw_pane(figure_.operations, pane, options_.numbers);
      TextRun name = plot::plain(volumetric::error_name(error) + "  ");
      name.bold = true;
      plot::draw_pane_title(figure_.operations, pane,
                            {name, plot::plain(translated(std::string(volumetric::error_kind(error)), options_))});
      if (nodes_[error.motion].empty())
        plot::draw_pane_remark(figure_.operations, pane, translated("not told", options_));
      else
        draw_curve(pane, nodes_[error.motion]);
    }
    const std::string title =
        row == 0 ? translated("Displacement", options_) + " / µm" : translated("Rotation", options_) + " / µrad";
    plot::draw_upright_title(figure_.operations, {plot::plain(title)}, {9.5, top + motion_row_height / 2.0});
  }

  void draw_curve(const Pane& pane, const Nodes& nodes) {
    std::vector<Point> band, mean, up, down;
    for (const CurveNode& n : nodes) {
      band.push_back(pane.at(n.position_mm, n.mean.value + coverage_factor * n.mean.u));
      mean.push_back(pane.at(n.position_mm, n.mean.value));
      if (n.up) up.push_back(pane.at(n.position_mm, n.up->value));
      if (n.down) down.push_back(pane.at(n.position_mm, n.down->value));
    }
    for (auto n = nodes.rbegin(); n != nodes.rend(); ++n)
      band.push_back(pane.at(n->position_mm, n->mean.value - coverage_factor * n->mean.u));
    figure_.operations.push_back(Path{.points = std::move(band),
                                      .closed = true,
                                      .stroke = ink::solid(ink::faint(ink::blue, 0.4), 0.4),
                                      .fill = ink::faint(ink::blue, motion_band_alpha)});
    figure_.operations.push_back(plot::polyline(
        std::move(mean), ink::solid(has_directions_ ? ink::black : ink::blue, has_directions_ ? 0.7 : 1.15)));
    if (up.size() == nodes.size())
      figure_.operations.push_back(plot::polyline(std::move(up), ink::mean_line(Direction::up)));
    if (down.size() == nodes.size())
      figure_.operations.push_back(plot::polyline(std::move(down), ink::mean_line(Direction::down)));
  }

  std::size_t axis_;
  const Options& options_;
  bool has_directions_;
  Range across_;
  std::array<Nodes, volumetric::motion_count> nodes_;
  double left_ = 0.0;
  Figure figure_;
};

}  // namespace

Figure error_motion_figure(const volumetric::ErrorModel& model, std::size_t axis, const Options& options) {
  return MotionDrawing(model, axis, options).draw();
}

}  // namespace axiometry::report
