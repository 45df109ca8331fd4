// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/frame.h"

#include <algorithm>
#include <cmath>

#include "axiometry/report/drawing/text_layout.h"
#include "axiometry/report/figures/parts/axis_measures.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report::plot {
namespace {

constexpr double number_gap = 2.5;  // between numbers of targets

void draw_tick_labels(Operations& operations, const Plate& plate, const PlateLayout& layout) {
  const NumberStyle style = plate.options.numbers;
  const Stroke stroke = ink::solid(ink::black, axis_width);
  for (const double tick : layout.y_ticks.major) {
    const double y = layout.tick_y(tick);
    operations.push_back(line({layout.left - tick_length, y}, {layout.left, y}, stroke));
    operations.push_back(label({plain(tick_label(tick, layout.y_ticks.decimals, style))},
                               {layout.left - tick_length - 2.0, y + 0.35 * ink::tick_text_size}, ink::tick_text_size,
                               Anchor::end));
  }
  for (const double tick : layout.x_ticks.major) {
    const double x = layout.x(tick);
    operations.push_back(line({x, layout.bottom}, {x, layout.bottom + tick_length}, stroke));
    operations.push_back(label({plain(tick_label(tick, layout.x_ticks.decimals, style))},
                               {x, layout.bottom + tick_length + 8.0}, ink::tick_text_size, Anchor::middle));
  }
}

void draw_titles(Operations& operations, const Plate& plate, const PlateLayout& layout) {
  constexpr double longest_name = 220.0;
  constexpr double base_line = 24.5;
  const std::string& name = plate.test.metadata.axis.name;
  const std::string what =
      translated(is_diagonal(plate.test.metadata.axis) ? "Position along the diagonal" : "Position", plate.options);
  const std::string position = name.empty() ? what : what + " " + shortened(name, longest_name, ink::text_size);
  operations.push_back(label(joined({plain(position + " / ")}, layout.x_unit.name),
                             {(layout.left + layout.right) / 2.0, layout.bottom + base_line}, ink::text_size,
                             Anchor::middle));
  Text deviation = label(joined({plain(translated("Deviation", plate.options) + " / ")}, layout.y_unit.name),
                         {9.5, (layout.top + layout.bottom) / 2.0}, ink::text_size, Anchor::middle);
  deviation.degrees = 90.0;
  operations.push_back(std::move(deviation));
}

/// Numbers of the targets, placed in order of importance while there is room.
class TargetNumbers {
 public:
  TargetNumbers(const Plate& plate, const PlateLayout& layout) : plate_(plate), layout_(layout) {}

  void draw(Operations& operations) {
    for (const TargetDimension& dimension : plate_.at_targets) place(dimension.target(), Must::stand);
    place(0, Must::fit);
    place(count() - 1, Must::fit);
    for (const std::size_t stride : {1000, 100, 50, 10, 5, 1}) {
      if (!place_multiples(stride)) break;
    }
    for (const Text& number : numbers_) operations.push_back(number);
    draw_marks(operations);
    operations.push_back(
        label({italic("i")}, {layout_.right + 2.0, base_line()}, ink::index_text_size + 0.5, Anchor::start, ink::grey));
  }

 private:
  enum class Must { stand, fit };

  /// A short stroke at every target, where they can be told apart.
  void draw_marks(Operations& operations) const {
    constexpr double closest = 1.5;
    if (layout_.target_pitch < closest) return;
    const Stroke mark = ink::solid(ink::grey, 0.4);
    for (const double x : layout_.target_x) {
      operations.push_back(line({x, layout_.top}, {x, layout_.top + tick_length}, mark));
    }
  }

  std::size_t count() const { return layout_.target_x.size(); }
  double base_line() const { return layout_.top - 2.5; }

  /// All multiples that fit; none, and false, where so many do not that the row would look ragged.
  bool place_multiples(std::size_t stride) {
    constexpr std::size_t few_targets = 25;
    constexpr std::size_t few_numbers = 4;
    const std::vector<Text> before = numbers_;
    std::size_t wanted = 0;
    std::size_t placed = 0;
    for (std::size_t number = stride; number <= count(); number += stride) {
      ++wanted;
      if (place(number - 1, Must::fit)) ++placed;
    }
    const double enough = stride == 1 ? 0.75 : 0.5;
    const bool looks_even = static_cast<double>(placed) >= enough * static_cast<double>(wanted);
    if (count() <= few_targets || wanted <= few_numbers || looks_even) return true;
    numbers_ = before;
    return false;
  }

  bool place(std::size_t target, Must must) {
    const Text number = label({plain(std::to_string(target + 1))}, {layout_.target_x[target], base_line()},
                              ink::index_text_size, Anchor::middle, ink::grey);
    Box box = text_box(number);
    box.left -= number_gap;
    box.right += number_gap;
    const bool there_already = std::ranges::any_of(
        numbers_, [&](const Text& other) { return other.runs.front().text == number.runs.front().text; });
    if (there_already) return true;
    const bool touches = std::ranges::any_of(numbers_, [&](const Text& o) { return overlap(box, text_box(o)); });
    const bool on_leader =
        std::ranges::any_of(layout_.dimension_x, [&](double x) { return x > box.left + 1.5 && x < box.right - 1.5; });
    if (touches || (on_leader && must == Must::fit)) return false;
    numbers_.push_back(number);
    return true;
  }

  const Plate& plate_;
  const PlateLayout& layout_;
  std::vector<Text> numbers_;
};

}  // namespace

void draw_grid(Operations& operations, const PlateLayout& layout) {
  const auto horizontal = [&](double y, const Stroke& stroke) {
    operations.push_back(line({layout.left, y}, {layout.right, y}, stroke));
  };
  const auto vertical = [&](double x, const Stroke& stroke) {
    operations.push_back(line({x, layout.top}, {x, layout.bottom}, stroke));
  };
  const Stroke minor = ink::solid(ink::minor_grid_grey, 0.3);
  const Stroke major = ink::solid(ink::grid_grey, 0.4);
  for (const double tick : layout.y_ticks.minor) horizontal(layout.tick_y(tick), minor);
  for (const double tick : layout.x_ticks.minor) vertical(layout.x(tick), minor);
  for (const double tick : layout.y_ticks.major) horizontal(layout.tick_y(tick), major);
  for (const double tick : layout.x_ticks.major) vertical(layout.x(tick), major);
  if (layout.y.value_low < 0.0 && layout.y.value_high > 0.0) horizontal(layout.y(0.0), ink::solid(ink::grey, 0.6));
}

void draw_axes(Operations& operations, const Plate& plate, const PlateLayout& layout) {
  operations.push_back(
      Path{.points = {{layout.left, layout.top}, {layout.left, layout.bottom}, {layout.right, layout.bottom}},
           .closed = false,
           .stroke = ink::solid(ink::black, axis_width),
           .fill = ink::none});
  draw_tick_labels(operations, plate, layout);
  draw_titles(operations, plate, layout);
  TargetNumbers(plate, layout).draw(operations);
}

}  // namespace axiometry::report::plot
