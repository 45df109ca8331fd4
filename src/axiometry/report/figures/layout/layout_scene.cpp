// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/layout/layout_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/report/figures/layout/layout_solids.h"
#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report::plot {
namespace {

constexpr double label_room = 90.0;  // longest name, points

/// Grows while places are added.
class Reach {
 public:
  explicit Reach(const Sight& sight) : sight_(sight) {}
  void add(Vector3 p, double radius = 0.0) {
    const double x = dot(p, sight_.right), y = dot(p, sight_.up);
    window_ = {std::min(window_.left, x - radius), std::max(window_.right, x + radius),
               std::min(window_.low, y - radius), std::max(window_.high, y + radius)};
    any_ = true;
  }
  Window window() const { return any_ ? window_ : Window{-0.5, 0.5, -0.5, 0.5}; }

 private:
  static constexpr double far = std::numeric_limits<double>::infinity();
  Sight sight_;
  Window window_{far, -far, far, -far};
  bool any_ = false;
};

class Scene {
 public:
  Scene(Operations& operations, LabelPlaces& labels, const Layout& layout, const Projection& view,
        const SceneStyle& style)
      : operations_(operations), labels_(labels), layout_(layout), view_(view), style_(style) {}

  void draw() {
    if (layout_.box) draw_box(operations_, *layout_.box, view_);
    draw_obstacles();
    draw_stands();
    draw_safe_spheres();
    draw_way();
    draw_lines();
    draw_points();
    draw_stations();
    name_lines();
    name_points();
    name_stations();
    name_obstacles();
  }

 private:
  void draw_obstacles() {
    std::vector<const Obstacle*> far_first;
    for (const Obstacle& obstacle : layout_.obstacles) far_first.push_back(&obstacle);
    std::ranges::stable_sort(far_first, {},
                             [&](const Obstacle* obstacle) { return view_.depth(centre_of(*obstacle)); });
    for (const Obstacle* obstacle : far_first) draw_solid(operations_, *obstacle, view_);
  }

  double floor() const { return layout_.box ? layout_.box->lowest_mm.z : std::numeric_limits<double>::infinity(); }

  /// A post that carries the instrument, so that one sees how high it stands.
  void draw_stands() {
    if (!style_.stands) return;
    for (Vector3 station : layout_.stations_mm) {
      const Vector3 foot{station.x, station.y, floor()};
      const Point top = view_(station), bottom = view_(foot);
      if (!std::isfinite(foot.z) || foot.z >= station.z || bottom.y - top.y < 2.0 * style_.ball) continue;
      const double radius = 1.5 * style_.ball / view_.points_per_mm;
      draw_ring(operations_, foot, radius, view_, ink::solid(ink::grey, 0.5), ink::faint(ink::grey, 0.25));
      operations_.push_back(line(top, bottom, ink::solid(ink::faint(ink::grey, 0.55), 2.2)));
      operations_.push_back(line(top, bottom, ink::solid(ink::white, 1.0)));
      labels_.avoid(top, bottom, 0.7);
    }
  }

  void draw_safe_spheres() {
    if (!layout_.safe_radius_mm) return;
    for (Vector3 station : layout_.stations_mm)
      draw_sphere(operations_, station, *layout_.safe_radius_mm, view_,
                  {.colour = ink::grey, .width = 0.5, .dashes = {2.5, 1.8}}, ink::faint(ink::grey, 0.07));
  }

  void draw_way() {
    if (layout_.way_mm.size() < 2) return;
    Path path{.points = {}, .closed = false, .stroke = ink::solid(ink::extension_grey, 0.5), .fill = ink::none};
    for (Vector3 p : layout_.way_mm) path.points.push_back(view_(p));
    for (std::size_t k = 1; k < path.points.size() && k < 200; ++k)
      labels_.avoid(path.points[k - 1], path.points[k], 0.5);
    operations_.push_back(std::move(path));
  }

  /// Lost lines first, so that they cover nothing that can be measured.
  void draw_lines() {
    for (const bool lost : {true, false})
      for (const Layout::Item& item : layout_.lines)
        if (item.lost == lost) draw_line(item);
  }

  void draw_line(const Layout::Item& item) {
    const Point from = view_(item.begin_mm), to = view_(item.end_mm);
    const Stroke stroke = line_stroke(item, style_.pen);
    if (layout_.stations_mm.size() == 1) {
      const Point station = view_(layout_.stations_mm.front());
      operations_.push_back(line(station, from, {.colour = stroke.colour, .width = 0.4, .dashes = {1.0, 1.5}}));
      labels_.avoid(station, from);
    }
    labels_.avoid(from, to, 2.0);
    operations_.push_back(line(from, to, stroke));
    if (item.lost || item.beam) return;
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (length > 3.0 * style_.ball) draw_head(from, to, length, stroke.colour);
    operations_.push_back(
        Disc{.centre = from, .radius = 0.9 * style_.pen, .fill = stroke.colour, .stroke = {.width = 0.0}});
  }

  void draw_head(Point from, Point to, double length, Colour colour) {
    const Point along{(to.x - from.x) / length, (to.y - from.y) / length};
    const double size = 1.4 * style_.ball, half = 0.3 * size;
    const Point base{to.x - size * along.x, to.y - size * along.y};
    operations_.push_back(Path{.points = {to,
                                          {base.x - half * along.y, base.y + half * along.x},
                                          {base.x + half * along.y, base.y - half * along.x}},
                               .closed = true,
                               .stroke = ink::solid(colour, 0.0),
                               .fill = colour});
  }

  std::size_t stride() const { return 1 + (layout_.points_mm.size() - 1) / most_points_drawn; }
  /// Of so many points from here on, another one each time: every tenth of a raster could be one of its planes alone.
  std::size_t one_of(std::size_t begin, std::size_t count) const {
    const double turn = std::fmod(std::numbers::phi * static_cast<double>(begin / stride()), 1.0);
    return begin + std::min(static_cast<std::size_t>(turn * static_cast<double>(count)), count - 1);
  }
  double point_radius() const { return layout_.points_mm.size() > 200 ? 0.7 : 0.4 * style_.ball; }

  void draw_points() {
    const std::size_t points = layout_.points_mm.size();
    for (std::size_t begin = 0; begin < points; begin += stride())
      operations_.push_back(Disc{.centre = view_(layout_.points_mm[one_of(begin, std::min(stride(), points - begin))]),
                                 .radius = point_radius(),
                                 .fill = ink::black,
                                 .stroke = {.width = 0.0}});
  }

  void draw_stations() {
    const double r = style_.ball;
    for (Vector3 station : layout_.stations_mm) {
      const Point at = view_(station);
      operations_.push_back(Disc{.centre = at, .radius = r, .fill = ink::white, .stroke = ink::solid(ink::black, 0.8)});
      operations_.push_back(Disc{.centre = at, .radius = 0.3 * r, .fill = ink::black, .stroke = {.width = 0.0}});
      labels_.block({at.x - r, at.y - r, at.x + r, at.y + r});
    }
  }

  void name(std::string_view text, Point at, Point away, Colour colour, double gap, double size) {
    const std::string cut = shortened(text, label_room, size);
    if (cut.empty()) return;
    labels_.place(operations_, {.runs = {plain(cut)},
                                .size = size,
                                .colour = colour,
                                .at = at,
                                .away = away,
                                .gap = gap,
                                .most = style_.labels_most});
  }

  /// At their tips; lines that one looks along have none.
  void name_lines() {
    for (const bool lost : {false, true})
      for (const Layout::Item& item : layout_.lines) {
        if (item.lost != lost) continue;
        const Point from = view_(item.begin_mm), to = view_(item.end_mm);
        const Point along{to.x - from.x, to.y - from.y};
        if (std::hypot(along.x, along.y) < 2.0) continue;
        name(item.label, to, along, item.lost ? ink::grey : line_stroke(item, 1.0).colour, 2.5, style_.text);
      }
  }

  void name_points() {
    if (layout_.points_mm.size() > most_points_numbered) return;
    for (std::size_t k = 0; k < layout_.points_mm.size(); ++k)
      name(named(layout_.point_names, layout_.points_mm.size(), k, ""), view_(layout_.points_mm[k]), {1.0, -1.0},
           ink::black, point_radius() + 1.0, style_.text - 0.5);
  }

  static std::string named(std::span<const std::string> names, std::size_t count, std::size_t k,
                           std::string_view letter) {
    return names.size() == count ? names[k] : fmt::format("{}{}", letter, k + 1);
  }

  void name_stations() {
    const bool several = layout_.stations_mm.size() > 1;
    if (layout_.stations_mm.size() > most_points_numbered) return;
    for (std::size_t k = 0; k < layout_.stations_mm.size(); ++k)
      name(several ? named(layout_.station_names, layout_.stations_mm.size(), k, "S") : style_.station,
           view_(layout_.stations_mm[k]), {-1.0, 0.6}, ink::black, style_.ball + 1.5, style_.text - 0.5);
  }

  void name_obstacles() {
    for (const Obstacle& obstacle : layout_.obstacles)
      name(obstacle.name, view_(centre_of(obstacle)), {0.0, -1.0}, ink::grey, 0.0, style_.text - 0.5);
  }

  Operations& operations_;
  LabelPlaces& labels_;
  const Layout& layout_;
  const Projection& view_;
  const SceneStyle& style_;
};

/// Smallest angle on paper between lines that leave the station, rad; and none may be seen end on.
double separation(const Layout& layout, const Sight& sight) {
  constexpr double shortest = 0.35;  // of its length, that a line should keep
  std::vector<double> angles;
  double least = std::numbers::pi;
  for (const Layout::Item& item : layout.lines) {
    const Vector3 along = item.end_mm - item.begin_mm;
    const double x = dot(along, sight.right), y = dot(along, sight.up), length = norm(along);
    if (length == 0.0) continue;
    least = std::min(least, std::hypot(x, y) / length / shortest);
    const double angle = std::atan2(y, x);
    for (double other : angles) least = std::min(least, std::abs(std::remainder(angle - other, 2 * std::numbers::pi)));
    angles.push_back(angle);
  }
  return least;
}

}  // namespace

Stroke line_stroke(const Layout::Item& item, double width) {
  if (item.lost) return {.colour = ink::extension_grey, .width = 0.7 * width, .dashes = {3.5, 2.2}};
  if (item.beam) return ink::solid(ink::vermilion, 0.6 * width);
  return ink::solid(is_diagonal(item) ? ink::vermilion : ink::blue, width);
}

bool is_diagonal(const Layout::Item& item) {
  const Vector3 along = item.end_mm - item.begin_mm;
  int moving = 0;
  for (std::size_t k = 0; k < 3; ++k) moving += std::abs(along[k]) > 1e-9 * norm(along) ? 1 : 0;
  return moving > 1;
}

Layout drawable(const Layout& layout) {
  constexpr double farthest = 1e9;
  const auto sound = [](Vector3 p) { return is_finite(p) && norm(p) < farthest; };
  Layout kept = layout;
  if (kept.box && !(sound(kept.box->lowest_mm) && sound(kept.box->highest_mm))) kept.box.reset();
  if (kept.safe_radius_mm && !(*kept.safe_radius_mm > 0.0 && *kept.safe_radius_mm < farthest))
    kept.safe_radius_mm.reset();
  const auto unsound = [&](Vector3 p) { return !sound(p); };
  if (std::erase_if(kept.stations_mm, unsound) > 0) kept.station_names.clear();
  if (std::erase_if(kept.points_mm, unsound) > 0) kept.point_names.clear();
  std::erase_if(kept.way_mm, unsound);
  std::erase_if(kept.lines, [&](const Layout::Item& item) { return !sound(item.begin_mm) || !sound(item.end_mm); });
  std::erase_if(kept.obstacles,
                [&](const Obstacle& obstacle) { return std::ranges::any_of(corners_of(obstacle), unsound); });
  return kept;
}

Window window_of(const Layout& layout, const Sight& sight) {
  Reach reach(sight);
  if (layout.box)
    for (Vector3 corner : corners_of(*layout.box)) reach.add(corner);
  for (Vector3 station : layout.stations_mm) reach.add(station, layout.safe_radius_mm.value_or(0.0));
  for (const Layout::Item& item : layout.lines) {
    reach.add(item.begin_mm);
    reach.add(item.end_mm);
  }
  for (Vector3 p : layout.points_mm) reach.add(p);
  for (Vector3 p : layout.way_mm) reach.add(p);
  for (const Obstacle& obstacle : layout.obstacles)
    for (Vector3 corner : corners_of(obstacle)) reach.add(corner);
  return reach.window();
}

Sight clearest_sight(const Layout& layout) {
  constexpr double deg = std::numbers::pi / 180.0;
  constexpr std::array<std::array<double, 2>, 5> usual = {{{15, 35}, {25, 28}, {32, 35}, {-15, 35}, {-25, 28}}};
  constexpr double worth_turning = 1.15;  // the first is what people are used to
  Sight best = axonometric(usual[0][0] * deg, usual[0][1] * deg);
  double most = separation(layout, best) * worth_turning;
  for (const auto& [turn, raise] : usual) {
    const Sight sight = axonometric(turn * deg, raise * deg);
    if (const double apart = separation(layout, sight); apart > most + 1e-6) {
      most = apart;
      best = sight;
    }
  }
  return best;
}

void draw_scene(Operations& operations, LabelPlaces& labels, const Layout& layout, const Projection& view,
                const SceneStyle& style) {
  Scene(operations, labels, layout, view, style).draw();
}

}  // namespace axiometry::report::plot
