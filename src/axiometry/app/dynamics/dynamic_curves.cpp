// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <ranges>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "axiometry/report/figures/parts/thinned.h"

namespace axiometry::app {
namespace {

using json::Value;
using report::Point;

constexpr double figure_width = 400.0;                // thinned() keeps the extremes of 1000 columns of it
constexpr double steps_across = 1e9, steps_up = 1e6;  // finer than any screen
constexpr std::size_t strayings_most = 8;

/// The numbers with no more digits than their span has steps.
Value rounded_list(const std::vector<Point>& points, double Point::*member, double steps) {
  double low = 0.0, high = 0.0;
  if (!points.empty()) {
    const auto [least, most] = std::ranges::minmax(points | std::views::transform(member));
    low = least, high = most;
  }
  const double largest = std::max({high - low, std::abs(low) / steps, std::abs(high) / steps});
  const double per_unit = largest > 0.0 ? std::pow(10.0, std::ceil(std::log10(steps / largest))) : 1.0;
  Value list = Value::array();
  for (const Point& point : points) {
    const double rounded = std::round(point.*member * per_unit) / per_unit;
    list.push(std::isfinite(rounded) ? rounded : point.*member);
  }
  return list;
}

/// x must not fall.
Value curve_to_json(std::vector<Point> points, std::string_view x_name) {
  const double first = points.empty() ? 0.0 : points.front().x;
  const double span = points.empty() ? 0.0 : points.back().x - first;
  const double scale = span > 0.0 ? figure_width / span : 1.0;
  for (Point& point : points) point.x = (point.x - first) * scale;
  points = report::plot::thinned(std::move(points));
  for (Point& point : points) point.x = first + point.x / scale;
  Value curve = Value::object();
  curve.add(std::string(x_name), rounded_list(points, &Point::x, steps_across));
  curve.add("value", rounded_list(points, &Point::y, steps_up));
  return curve;
}

Value over_time_to_json(const DynamicMotion& m, const std::vector<double>& values) {
  std::vector<Point> points;
  points.reserve(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) points.push_back({m.record.time_s(k), values[k]});
  return curve_to_json(std::move(points), "time_s");
}

/// The longest, in order of time.
std::vector<const capture::UniformStretch*> told_stretches(const DynamicMotion& m) {
  std::vector<const capture::UniformStretch*> stretches;
  for (const capture::UniformStretch& s : m.stretches) stretches.push_back(&s);
  std::ranges::stable_sort(stretches, std::ranges::greater{}, [](const auto* s) { return s->count(); });
  stretches.resize(std::min(stretches.size(), strayings_most));
  std::ranges::sort(stretches, {}, [](const auto* s) { return s->first; });
  return stretches;
}

Value straying_to_json(const DynamicMotion& m) {
  Value list = Value::array();
  for (const capture::UniformStretch* s : told_stretches(m)) {
    const std::vector<double> residuals = capture::residuals_of(m.record, *s);
    std::vector<Point> points;
    points.reserve(residuals.size());
    for (std::size_t i = 0; i < residuals.size(); ++i)
      points.push_back({m.record.positions[s->first + i], residuals[i] * deviation_per_position(m.kind)});
    std::ranges::stable_sort(points, {}, &Point::x);
    Value curve = Value::object();
    curve.add("begin_s", m.record.time_s(s->first));
    const Value told = curve_to_json(std::move(points), "position");
    for (const auto& [name, member] : told.members()) curve.add(name, member);
    list.push(std::move(curve));
  }
  return list;
}

Value amplitudes_to_json(const DynamicMotion& m) {
  std::vector<Point> points;
  points.reserve(m.spectrum.amplitudes.size());
  for (std::size_t k = 0; k < m.spectrum.amplitudes.size(); ++k)
    points.push_back({static_cast<double>(k) * m.spectrum.step_hz, m.spectrum.amplitudes[k]});
  return curve_to_json(std::move(points), "frequency_hz");
}

}  // namespace

Value curves_to_json(const DynamicMotion& m) {
  Value curves = Value::object();
  curves.add("position", over_time_to_json(m, m.record.positions));
  curves.add("velocity_per_s", over_time_to_json(m, m.course.velocity));
  curves.add("acceleration_per_s2", over_time_to_json(m, m.course.acceleration));
  curves.add("straying", straying_to_json(m));
  curves.add("spectrum", amplitudes_to_json(m));
  return curves;
}

}  // namespace axiometry::app
