// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/tracking/field_slices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/report/figures/parts/axis_measures.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/pane.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/scale.h"
#include "axiometry/report/translated.h"
#include "axiometry/volumetric/field/field_rows.h"
#include "axiometry/volumetric/field/volume_statistics.h"

namespace axiometry::report {
namespace {

using plot::Operations;
using plot::Pane;
using plot::Range;
using volumetric::FieldSlice;
namespace ink = plot::ink;

constexpr std::size_t cells = 24;  // cells of colour along each axis
constexpr std::size_t arrows = 9;  // along each axis
constexpr double slice_height = 118.0;
constexpr double between_slices = 34.0;
constexpr double bar_width = 150.0;
constexpr double bar_height = 6.0;

/// From white over yellow and orange to dark red, darker all the way, so that a grey print keeps the order.
Colour heat(double share) {
  static constexpr std::array<Colour, 5> ramp = {
      {{1.0, 1.0, 0.93}, {1.0, 0.93, 0.63}, {0.996, 0.77, 0.42}, {0.95, 0.56, 0.33}, {0.84, 0.34, 0.28}}};
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(ramp.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(at), ramp.size() - 2);
  const double f = at - static_cast<double>(k);
  const auto mix = [&](double a, double b) { return a + f * (b - a); };
  return {mix(ramp[k].r, ramp[k + 1].r), mix(ramp[k].g, ramp[k + 1].g), mix(ramp[k].b, ramp[k + 1].b), 1.0};
}

void fill(Operations& operations, Point low, Point high, Colour colour) {
  operations.push_back(Path{.points = {low, {high.x, low.y}, high, {low.x, high.y}},
                            .closed = true,
                            .stroke = ink::solid(colour, 0.25),
                            .fill = colour});
}

void draw_arrow(Operations& operations, Point from, Point to) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  const Stroke pen = ink::solid(ink::black, 0.55);
  if (length < 0.6) {
    operations.push_back(Disc{.centre = from, .radius = 0.5, .fill = ink::black});
    return;
  }
  const double head = std::min(2.6, 0.5 * length), x = dx / length, y = dy / length;
  operations.push_back(plot::line(from, to, pen));
  operations.push_back(Path{.points = {to,
                                       {to.x - head * x + 0.4 * head * y, to.y - head * y - 0.4 * head * x},
                                       {to.x - head * x - 0.4 * head * y, to.y - head * y + 0.4 * head * x}},
                            .closed = true,
                            .stroke = ink::solid(ink::black, 0.1),
                            .fill = ink::black});
}

class SliceDrawing {
 public:
  SliceDrawing(const volumetric::ErrorModel& model, std::size_t tool, const Options& options)
      : tool_(model.machine().tools[tool].offset_mm), options_(options) {
    const Vector3 middle = volumetric::place_in(model.observed(), {0.5, 0.5, 0.5});
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t fixed = 2 - k;
      colours_[k] = volumetric::field_slice(model, tool_, fixed, middle[fixed], cells + 1);
      arrows_[k] = volumetric::field_slice(model, tool_, fixed, middle[fixed], arrows);
      for (const auto& error : colours_[k].error_um)
        if (error) largest_ = std::max(largest_, norm(*error));
    }
    figure_.width = plot::plate_width;
    figure_.title = "Error of the tool point on the planes through the middle of the volume";
    figure_.description =
        "Three planes of the volume: colours show how large the error of the tool point is, arrows where it points "
        "within the plane.";
  }

  Figure draw() {
    draw_scale();
    const double left = plot::figure_edge + 30.0, right = plot::plate_width - 10.0, top = 40.0;
    const double width = (right - left - 2.0 * between_slices) / 3.0;
    for (std::size_t k = 0; k < 3; ++k)
      draw_slice(k, left + static_cast<double>(k) * (width + between_slices), width, top);
    figure_.height = top + slice_height + plot::pane_axis_room + 3.0;
    return std::move(figure_);
  }

 private:
  /// A step along each axis is as long as the longest arrow.
  double points_per_um(double pitch) const { return largest_ > 0.0 ? 0.95 * pitch / largest_ : 0.0; }

  void draw_scale() {
    const double left = 32.0, top = 4.0;
    constexpr int steps = 50;
    for (int k = 0; k < steps; ++k)
      fill(figure_.operations, {left + bar_width * k / steps, top},
           {left + bar_width * (k + 1) / steps, top + bar_height}, heat((k + 0.5) / steps));
    const double most = largest_ > 0.0 ? largest_ : 1.0;
    const plot::Ticks ticks = plot::divide(0.0, most, 4.0, plot::Division::decimal);
    for (const double tick : ticks.major)
      figure_.operations.push_back(plot::label({plot::plain(plot::tick_label(tick, ticks.decimals, options_.numbers))},
                                               {left + bar_width * tick / most, top + bar_height + 8.0},
                                               ink::tick_text_size, Anchor::middle));
    figure_.operations.push_back(plot::label({plot::plain("|"), plot::italic("δ"), plot::plain("| / µm")},
                                             {left + bar_width + 10.0, top + bar_height}, ink::text_size,
                                             Anchor::start));
  }

  void draw_slice(std::size_t k, double left, double width, double top) {
    const FieldSlice& s = colours_[k];
    const Pane pane{left,
                    left + width,
                    top,
                    top + slice_height,
                    {s.across_mm.front(), s.across_mm.back()},
                    {s.up_mm.front(), s.up_mm.back()},
                    true,
                    true};
    draw_colours(pane, s);
    plot::draw_pane(figure_.operations, pane, options_.numbers);
    const double pitch = std::min(width, slice_height) / static_cast<double>(arrows - 1);
    draw_arrows(pane, arrows_[k], points_per_um(pitch));
    plot::draw_pane_title(figure_.operations, pane,
                          {plot::plain(fmt::format("{}{}, {} = {} mm", "XYZ"[s.across_axis], "XYZ"[s.up_axis],
                                                   "XYZ"[s.fixed_axis], format_fixed(s.at_mm, 0, options_.numbers)))});
    figure_.operations.push_back(plot::label({plot::plain(fmt::format("{} / mm", "XYZ"[s.across_axis]))},
                                             {left + width / 2.0, pane.bottom + plot::pane_axis_room - 1.5},
                                             ink::text_size, Anchor::middle));
  }

  /// A cell has the mean of its corners.
  void draw_colours(const Pane& pane, const FieldSlice& s) {
    const std::size_t n = s.across_mm.size();
    for (std::size_t j = 0; j + 1 < n; ++j)
      for (std::size_t i = 0; i + 1 < n; ++i) {
        double sum = 0.0;
        bool told = true;
        for (const std::size_t at : {j * n + i, j * n + i + 1, (j + 1) * n + i, (j + 1) * n + i + 1}) {
          told = told && s.error_um[at].has_value();
          if (told) sum += norm(*s.error_um[at]) / 4.0;
        }
        if (told && largest_ > 0.0)
          fill(figure_.operations, pane.at(s.across_mm[i], s.up_mm[j]), pane.at(s.across_mm[i + 1], s.up_mm[j + 1]),
               heat(sum / largest_));
      }
    if (std::ranges::none_of(s.error_um, [](const auto& e) { return e.has_value(); }))
      plot::draw_pane_remark(figure_.operations, pane, translated("not told", options_));
  }

  /// The middle of an arrow is at its node.
  void draw_arrows(const Pane& pane, const FieldSlice& s, double points_per_um) {
    for (std::size_t j = 0; j < s.up_mm.size(); ++j)
      for (std::size_t i = 0; i < s.across_mm.size(); ++i) {
        const auto& error = s.error_um[j * s.across_mm.size() + i];
        if (!error) continue;
        const Point node = pane.at(s.across_mm[i], s.up_mm[j]);
        const double dx = points_per_um * (*error)[s.across_axis], dy = -points_per_um * (*error)[s.up_axis];
        draw_arrow(figure_.operations, {node.x - dx / 2.0, node.y - dy / 2.0}, {node.x + dx / 2.0, node.y + dy / 2.0});
      }
  }

  Vector3 tool_;
  const Options& options_;
  std::array<FieldSlice, 3> colours_, arrows_;
  double largest_ = 0.0;
  Figure figure_;
};

}  // namespace

Figure field_slice_figure(const volumetric::ErrorModel& model, std::size_t tool, const Options& options) {
  return SliceDrawing(model, tool, options).draw();
}

}  // namespace axiometry::report
