// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "axiometry/report/figures/layout/layout_scene.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/scale.h"
#include "axiometry/report/tracking.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using plot::Operations;
using plot::Projection;
using plot::Sight;
using plot::Window;
namespace ink = plot::ink;

constexpr double frame_margin = 3.0;
constexpr double view_beside = 62.0;  // of the parallel projection, for labels
constexpr double view_above = 22.0;   // of it, above and below
constexpr double view_tallest = 250.0;
constexpr double plans_left = 52.0;  // for upright dimension lines
constexpr double plans_right = 24.0;
constexpr double plans_tallest = 265.0;  // the tallest plans, without the gaps
constexpr double between_x = 40.0;
constexpr double between_y = 34.0;    // holds the name of the lower view
constexpr double plan_margin = 9.0;   // about what a view shows
constexpr double below_plans = 42.0;  // two rows of dimension lines
constexpr double first_row = 14.0;    // of a dimension line from the view
constexpr double dimension_row_pitch = 13.0;
constexpr double name_size = 7.0;
constexpr double number_size = 6.5;
constexpr double smallest_view = 24.0;  // height or width of what is flat, points

/// A window that is not flat, so that it has a scale.
Window roomy(Window window, double least) {
  const auto widen = [&](double& low, double& high) {
    if (high - low >= least) return;
    const double middle = (low + high) / 2.0;
    low = middle - least / 2.0;
    high = middle + least / 2.0;
  };
  widen(window.left, window.right);
  widen(window.low, window.high);
  return window;
}

/// Points per mm at which two views, of which none is drawn smaller than `smallest_view`, fill `room` points together.
double scale_of_two(double a_mm, double b_mm, double room) {
  const double large = std::max({a_mm, b_mm, 1e-6}), small = std::min(a_mm, b_mm);
  const double scale = room / (large + small);
  return small * scale < smallest_view ? (room - smallest_view) / large : scale;
}

std::string shown_mm(double mm, const Options& options) {
  const bool whole = std::abs(mm - std::round(mm)) < 0.05 || std::abs(mm) >= 1e5;
  return plot::tick_label(std::round(mm * 10.0) / 10.0 + 0.0, whole ? 0 : 1, options.numbers);
}

/// What the dimension lines measure: the travels, or else what there is.
TravelBox measured_box(const Layout& layout) {
  if (layout.box) return *layout.box;
  const Window xy = window_of(layout, plot::from_above), xz = window_of(layout, plot::from_front);
  return {{xy.left, xy.low, xz.low}, {xy.right, xy.high, xz.high}};
}

Text upright_text(std::string text, Point at) {
  return {.runs = {plot::plain(text)},
          .at = at,
          .size = number_size,
          .colour = ink::black,
          .anchor = Anchor::middle,
          .degrees = 90.0};
}

Text level_text(std::string text, Point at, double size, Colour colour, Anchor anchor) {
  return {.runs = {plot::plain(text)}, .at = at, .size = size, .colour = colour, .anchor = anchor, .degrees = 0.0};
}

class LayoutDrawing {
 public:
  LayoutDrawing(const Layout& layout, const Options& options)
      : layout_(plot::drawable(layout)), options_(options), measured_(measured_box(layout_)) {}

  Figure draw() {
    double y = draw_axonometric(0.0);
    y = draw_plans(y);
    y += plot::draw_legend(operations_, legend(), {plans_left, y}, plot::plate_width - plans_left - plans_right);
    return {.width = plot::plate_width,
            .height = y + frame_margin,
            .title = layout_.title,
            .description = layout_.description,
            .operations = std::move(operations_)};
  }

 private:
  double draw_axonometric(double top) {
    const Sight sight = plot::clearest_sight(layout_);
    const Window window = plot::window_of(layout_, sight);
    const double size = std::max({window.width(), window.height(), 1e-6});
    const Window shown = roomy(window, 0.05 * size);
    const double width = plot::plate_width - 2.0 * view_beside;
    const double scale = std::min(width / shown.width(), view_tallest / shown.height());
    const double height = std::max(shown.height() * scale, 60.0) + 2.0 * view_above;
    const Projection view{
        .sight = sight,
        .window = shown,
        .corner = {(plot::plate_width - shown.width() * scale) / 2.0, top + (height - shown.height() * scale) / 2.0},
        .points_per_mm = scale};
    const Box frame{frame_margin, top + frame_margin, plot::plate_width - frame_margin, top + height - frame_margin};
    plot::LabelPlaces labels(frame);
    draw_triad(labels, sight, {32.0, top + height - 28.0});
    plot::draw_scene(operations_, labels, layout_, view, {.stands = true, .station = translated("station", options_)});
    return top + height;
  }

  /// Where X, Y and Z point to.
  void draw_triad(plot::LabelPlaces& labels, const Sight& sight, Point origin) {
    constexpr double length = 24.0;
    constexpr std::string_view names[] = {"X", "Y", "Z"};
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3 axis;
      axis[k] = 1.0;
      const Point along{dot(axis, sight.right), -dot(axis, sight.up)};
      const Point tip{origin.x + length * along.x, origin.y + length * along.y};
      operations_.push_back(plot::line(origin, tip, ink::solid(ink::black, 0.8)));
      const double size = std::hypot(along.x, along.y);
      const Point at{tip.x + 6.0 * along.x / size, tip.y + 6.0 * along.y / size + 2.5};
      labels.take(operations_, Text{.runs = {plot::italic(names[k])},
                                    .at = at,
                                    .size = ink::text_size,
                                    .colour = ink::black,
                                    .anchor = Anchor::middle,
                                    .degrees = 0.0});
    }
    labels.block({origin.x - 4.0, origin.y - length, origin.x + length, origin.y + 8.0});
  }

  /// The views along the axes, each where it belongs: from above over the one from the front, beside it from the right.
  double draw_plans(double top) {
    const Window xy = window_of(layout_, plot::from_above), xz = window_of(layout_, plot::from_front);
    const double dx = xy.width(), dy = xy.height(), dz = xz.height();
    const double width = plot::plate_width - plans_left - plans_right - between_x - 4.0 * plan_margin;
    const double scale = std::min(scale_of_two(dx, dy, width), scale_of_two(dy, dz, plans_tallest));
    const double least = smallest_view / scale;
    const Window above = roomy(xy, least), front = roomy(xz, least),
                 right = roomy(window_of(layout_, plot::from_right), least);
    const double x1 = plans_left + plan_margin, x2 = x1 + above.width() * scale + 2.0 * plan_margin + between_x;
    const double y1 = top + 12.0 + plan_margin;
    const double y2 = y1 + above.height() * scale + 2.0 * plan_margin + between_y;
    const double bottom = y2 + front.height() * scale + plan_margin + below_plans;
    const Box frame{frame_margin, top, plot::plate_width - frame_margin, bottom};
    plot::LabelPlaces numbers(frame);
    draw_plan({plot::from_above, above, {x1, y1}, scale}, "From above (XY)", {1}, {}, numbers);
    draw_plan({plot::from_front, front, {x1, y2}, scale}, "From the front (XZ)", {2}, {0}, numbers);
    draw_plan({plot::from_right, right, {x2, y2}, scale}, "From the right (YZ)", {}, {1}, numbers);
    name_station(frame, {x2 - plan_margin, y1 - plan_margin + 7.0});
    return bottom;
  }

  /// In the quarter that the three views leave free: where the one station stands.
  void name_station(const Box& frame, Point at) {
    constexpr double row = 11.0, least_room = 90.0;
    if (layout_.stations_mm.size() != 1 || frame.right - at.x < least_room) return;
    const Vector3 station = layout_.stations_mm.front();
    const auto write = [&](double x, std::string text, Anchor anchor) {
      operations_.push_back(level_text(std::move(text), {x, at.y}, name_size, ink::black, anchor));
    };
    operations_.push_back(level_text(translated("Station", options_), at, name_size, ink::grey, Anchor::start));
    constexpr std::string_view names[] = {"X", "Y", "Z"};
    for (std::size_t k = 0; k < 3; ++k) {
      at.y += row;
      write(at.x, std::string(names[k]), Anchor::start);
      write(at.x + least_room - 10.0, plot::tick_label(station[k], 3, options_.numbers), Anchor::end);
    }
  }

  /// `upright` and `level` are the axes along which it has dimension lines.
  void draw_plan(const Projection& view, std::string_view name, std::optional<std::size_t> upright,
                 std::optional<std::size_t> level, plot::LabelPlaces& numbers) {
    const double width = view.window.width() * view.points_per_mm, height = view.window.height() * view.points_per_mm;
    const Box frame{view.corner.x - plan_margin, view.corner.y - plan_margin, view.corner.x + width + plan_margin,
                    view.corner.y + height + plan_margin};
    numbers.take(operations_, level_text(translated(name, options_), {frame.left, frame.top - 4.0}, name_size,
                                         ink::grey, Anchor::start));
    operations_.push_back(Path{.points = {{frame.left, frame.top},
                                          {frame.right, frame.top},
                                          {frame.right, frame.bottom},
                                          {frame.left, frame.bottom}},
                               .closed = true,
                               .stroke = ink::solid(ink::grid_grey, 0.4),
                               .fill = ink::none});
    plot::LabelPlaces labels(frame);
    plot::draw_scene(
        operations_, labels, layout_, view,
        {.ball = 2.8, .pen = 0.9, .text = 6.5, .labels_most = 14.0, .station = translated("station", options_)});
    if (upright) draw_upright(view, frame, *upright, numbers);
    if (level) draw_level(view, frame, *level, numbers);
  }

  bool station_is_measured(std::size_t axis) const {
    constexpr double too_near = 1e-3;
    if (layout_.stations_mm.size() != 1 || !layout_.box) return false;
    const double off = layout_.stations_mm.front()[axis] - measured_.lowest_mm[axis];
    return std::abs(off) > too_near * std::abs(measured_.highest_mm[axis] - measured_.lowest_mm[axis]);
  }

  void draw_level(const Projection& view, const Box& frame, std::size_t axis, plot::LabelPlaces& numbers) {
    double y = frame.bottom + first_row;
    const auto row = [&](Vector3 from_mm, Vector3 to_mm) {
      const Point a = view(from_mm), b = view(to_mm);
      const double left = std::min(a.x, b.x), right = std::max(a.x, b.x);
      for (const Point& p : {a, b})
        operations_.push_back(
            plot::line({p.x, std::max(p.y, frame.bottom)}, {p.x, y + 2.0}, ink::solid(ink::extension_grey, 0.3)));
      plot::draw_dimension_line(operations_, plot::LevelDimensionLine{.y = y, .left = left, .right = right});
      const std::string text = shown_mm(std::abs(to_mm[axis] - from_mm[axis]), options_);
      const Text within = level_text(text, {(left + right) / 2.0, y - 2.0}, number_size, ink::black, Anchor::middle);
      const Box box = text_box(within);
      if (box.right - box.left < right - left - 4.0)
        numbers.take(operations_, within);
      else
        numbers.take(operations_, level_text(text, {right + plot::outside_arrow_length + 2.0, y + 2.3}, number_size,
                                             ink::black, Anchor::start));
    };
    if (station_is_measured(axis)) {
      row(measured_.lowest_mm, layout_.stations_mm.front());
      y += dimension_row_pitch;
    }
    row(measured_.lowest_mm, measured_.highest_mm);
    for (Vector3 end : {measured_.lowest_mm, measured_.highest_mm})
      numbers.take(operations_, level_text(shown_mm(end[axis], options_), {view(end).x, y + 9.0}, number_size - 0.5,
                                           ink::grey, Anchor::middle));
  }

  void draw_upright(const Projection& view, const Box& frame, std::size_t axis, plot::LabelPlaces& numbers) {
    double x = frame.left - first_row;
    const auto column = [&](Vector3 from_mm, Vector3 to_mm) {
      const Point a = view(from_mm), b = view(to_mm);
      const double top = std::min(a.y, b.y), bottom = std::max(a.y, b.y);
      for (const Point& p : {a, b})
        operations_.push_back(
            plot::line({x - 2.0, p.y}, {std::min(p.x, frame.left), p.y}, ink::solid(ink::extension_grey, 0.3)));
      plot::draw_dimension_line(operations_, plot::DimensionLine{.x = x, .top = top, .bottom = bottom});
      const std::string text = shown_mm(std::abs(to_mm[axis] - from_mm[axis]), options_);
      const Text within = upright_text(text, {x - 2.0, (top + bottom) / 2.0});
      const Box box = text_box(within);
      if (box.bottom - box.top < bottom - top - 4.0)
        numbers.take(operations_, within);
      else
        numbers.take(operations_, upright_text(text, {x + 2.3, top - plot::outside_arrow_length - 2.0 -
                                                                   (box.bottom - box.top) / 2.0}));
    };
    if (station_is_measured(axis)) {
      column(measured_.lowest_mm, layout_.stations_mm.front());
      x -= dimension_row_pitch;
    }
    column(measured_.lowest_mm, measured_.highest_mm);
    for (Vector3 end : {measured_.lowest_mm, measured_.highest_mm}) {
      Text number = upright_text(shown_mm(end[axis], options_), {x - 10.0, view(end).y});
      number.size = number_size - 0.5;
      number.colour = ink::grey;
      numbers.take(operations_, std::move(number));
    }
  }

  std::vector<plot::LegendEntry> legend() const {
    std::vector<plot::LegendEntry> entries;
    const auto add = [&](bool present, std::optional<Stroke> stroke, std::optional<Disc> mark, std::string_view text) {
      if (present)
        entries.push_back({std::move(stroke), std::nullopt, mark, {plot::plain(translated(text, options_))}});
    };
    const auto has = [&](auto predicate) { return std::ranges::any_of(layout_.lines, predicate); };
    const auto beam = [](const Layout::Item& item) { return !item.lost && item.beam; };
    const auto axis = [](const Layout::Item& item) { return !item.lost && !item.beam && !plot::is_diagonal(item); };
    const auto diagonal = [](const Layout::Item& item) { return !item.lost && !item.beam && plot::is_diagonal(item); };
    const auto lost = [](const Layout::Item& item) { return item.lost; };
    const auto points = layout_.points_mm.size();
    add(has(axis), ink::solid(ink::blue, 1.3), std::nullopt, "line of one axis");
    add(has(diagonal), ink::solid(ink::vermilion, 1.3), std::nullopt, "diagonal");
    add(has(beam), ink::solid(ink::vermilion, 0.8), std::nullopt, "beam");
    add(has(lost), Stroke{.colour = ink::extension_grey, .width = 0.9, .dashes = {3.5, 2.2}}, std::nullopt,
        "cannot be measured");
    add(layout_.box.has_value(), ink::solid(ink::grey, 0.6), std::nullopt, "travels of the reflector");
    add(layout_.safe_radius_mm.has_value() && !layout_.stations_mm.empty(),
        Stroke{.colour = ink::grey, .width = 0.5, .dashes = {2.5, 1.8}}, std::nullopt, "to be kept clear");
    add(points > 0, std::nullopt, Disc{.centre = {}, .radius = 1.6, .fill = ink::black, .stroke = {.width = 0.0}},
        points > plot::most_points_drawn ? fmt::format("some of {} points", points) : "point");
    add(layout_.way_mm.size() > 1, ink::solid(ink::extension_grey, 0.5), std::nullopt, "way of the reflector");
    entries.push_back({std::nullopt, std::nullopt, std::nullopt, {plot::plain(translated("lengths in mm", options_))}});
    return entries;
  }

  Layout layout_;
  const Options& options_;
  TravelBox measured_;
  Operations operations_;
};

}  // namespace

Figure layout_figure(const Layout& layout, const Options& options) { return LayoutDrawing(layout, options).draw(); }

}  // namespace axiometry::report
