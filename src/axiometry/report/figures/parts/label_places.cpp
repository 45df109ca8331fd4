// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/label_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report::plot {
namespace {

constexpr int directions = 24;
constexpr double ring = 4.0;             // points between the circles on which places are tried
constexpr double leader_from = 7.0;      // beyond which a label needs one
constexpr double air = 1.0;              // between labels
constexpr double cost_of_ring = 0.6;     // as much as so many crossed lines
constexpr double cost_of_turning = 1.2;  // for standing on the opposite side of where it was wanted

Box grown(Box box, double by) { return {box.left - by, box.top - by, box.right + by, box.bottom + by}; }

bool within(const Box& box, const Box& frame) {
  return box.left >= frame.left && box.top >= frame.top && box.right <= frame.right && box.bottom <= frame.bottom;
}

/// The base line that puts the middle of the label at `centre`.
Text centred(const LabelWish& wish, Point centre) {
  Text text{.runs = wish.runs,
            .at = centre,
            .size = wish.size,
            .colour = wish.colour,
            .anchor = Anchor::middle,
            .degrees = 0.0};
  const Box box = text_box(text);
  text.at.y += centre.y - (box.top + box.bottom) / 2.0;
  return text;
}

/// Distance from the middle of a box of this size to its edge in a direction.
double reach(double half_width, double half_height, Point direction) {
  const double x = std::abs(direction.x), y = std::abs(direction.y);
  return std::min(x > 1e-9 ? half_width / x : 1e9, y > 1e-9 ? half_height / y : 1e9);
}

}  // namespace

bool crosses(Point from, Point to, const Box& box) {
  double begin = 0.0, end = 1.0;
  const auto clip = [&](double start, double change, double low, double high) {
    if (std::abs(change) < 1e-12) return start >= low && start <= high;
    double a = (low - start) / change, b = (high - start) / change;
    if (a > b) std::swap(a, b);
    begin = std::max(begin, a);
    end = std::min(end, b);
    return begin <= end;
  };
  return clip(from.x, to.x - from.x, box.left, box.right) && clip(from.y, to.y - from.y, box.top, box.bottom);
}

bool LabelPlaces::is_free(const Box& box) const {
  return within(box, frame_) && std::ranges::none_of(blocked_, [&](const Box& other) { return overlap(box, other); });
}

double LabelPlaces::cost_of(const Box& box) const {
  double cost = 0.0;
  for (const Line& line : lines_)
    if (crosses(line.from, line.to, box)) cost += line.cost;
  return cost;
}

bool LabelPlaces::take(Operations& operations, Text text) {
  const Box box = grown(text_box(text), air);
  if (!is_free(box)) return false;
  blocked_.push_back(box);
  operations.push_back(std::move(text));
  return true;
}

bool LabelPlaces::place(Operations& operations, const LabelWish& wish) {
  const Box own = text_box(centred(wish, {0.0, 0.0}));
  const double half_width = (own.right - own.left) / 2.0, half_height = (own.bottom - own.top) / 2.0;
  const double length = std::hypot(wish.away.x, wish.away.y);
  const double wanted = length > 0.0 ? std::atan2(wish.away.y, wish.away.x) : -std::numbers::pi / 4.0;
  struct Found {
    Text text;
    double cost;
    double distance;
  };
  std::optional<Found> best;
  for (double distance = wish.gap; distance <= wish.gap + wish.most; distance += ring)
    for (int k = 0; k < directions; ++k) {
      const double turn = std::remainder(2.0 * std::numbers::pi * k / directions, 2.0 * std::numbers::pi);
      const Point direction{std::cos(wanted + turn), std::sin(wanted + turn)};
      const double off = distance + reach(half_width, half_height, direction);
      Text text = centred(wish, {wish.at.x + off * direction.x, wish.at.y + off * direction.y});
      const Box box = grown(text_box(text), air);
      if (!is_free(box)) continue;
      const double cost = cost_of(box) + cost_of_ring * (distance - wish.gap) / ring +
                          cost_of_turning * std::abs(turn) / std::numbers::pi;
      if (!best || cost < best->cost - 1e-9) best = Found{std::move(text), cost, distance};
    }
  if (!best) return false;
  const Box box = text_box(best->text);
  if (best->distance > wish.gap + leader_from) {
    const Point to{std::clamp(wish.at.x, box.left, box.right), std::clamp(wish.at.y, box.top, box.bottom)};
    operations.push_back(line(wish.at, to, ink::solid(ink::faint(wish.colour, 0.5), 0.3)));
    lines_.push_back({wish.at, to, 1.0});
  }
  blocked_.push_back(grown(box, air));
  // A veil lets the label be read where it stands on lines all the same.
  operations.push_back(
      Path{.points = {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}},
           .closed = true,
           .stroke = ink::solid(ink::none, 0.0),
           .fill = ink::faint(ink::white, 0.75)});
  operations.push_back(std::move(best->text));
  return true;
}

}  // namespace axiometry::report::plot
